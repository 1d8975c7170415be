#include "slam/mobile_sensing/nearest_sample.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/check.hpp"

namespace cogslam {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

int row_of(const CellSamples& samples, std::uint32_t sample) {
  return static_cast<int>(samples.cells[sample]) / samples.width;
}

/// Nearest samples of each cell within its own column; kNone in columns without any.
std::vector<std::uint32_t> nearest_in_columns(const CellSamples& samples) {
  std::vector<std::uint32_t> nearest(samples.field_size(), kNone);
  for (std::uint32_t k = 0; k < samples.cells.size(); ++k) nearest[samples.cells[k]] = k;
  const auto width = static_cast<std::size_t>(samples.width);
  const auto inherit = [&](std::size_t to, std::size_t from, int row) {
    if (nearest[from] == kNone) return;
    const bool nearer = nearest[to] == kNone ||
                        std::abs(row_of(samples, nearest[from]) - row) < std::abs(row_of(samples, nearest[to]) - row);
    if (nearer) nearest[to] = nearest[from];
  };
  for (std::size_t i = width; i < nearest.size(); ++i) inherit(i, i - width, static_cast<int>(i / width));
  for (std::size_t i = nearest.size() - width; i-- > 0;) inherit(i, i + width, static_cast<int>(i / width));
  return nearest;
}

}  // namespace

NearestSamples nearest_samples(const CellSamples& samples) {
  EXPECTS(!samples.cells.empty());
  const std::vector<std::uint32_t> in_column = nearest_in_columns(samples);
  NearestSamples nearest{std::vector<std::uint32_t>(in_column.size()), std::vector<double>(in_column.size())};
  for (int y = 0; y < samples.height; ++y) {
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(samples.width);
    for (int x = 0; x < samples.width; ++x) {
      long least = std::numeric_limits<long>::max();
      for (int u = 0; u < samples.width; ++u) {
        const std::uint32_t sample = in_column[row + static_cast<std::size_t>(u)];
        if (sample == kNone) continue;
        const long dx = u - x, dy = row_of(samples, sample) - y, squared = dx * dx + dy * dy;
        if (squared >= least) continue;
        least = squared;
        nearest.sample[row + static_cast<std::size_t>(x)] = sample;
      }
      nearest.distance[row + static_cast<std::size_t>(x)] = std::sqrt(static_cast<double>(least));
    }
  }
  return nearest;
}

}  // namespace cogslam
