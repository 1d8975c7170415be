#include "eval/sense/map_quality.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/check.hpp"

namespace cogslam {
namespace {

constexpr double kLow = 0.25, kHalf = 0.5, kHigh = 0.75;

/// Values to classes: 0 free, 1 unknown, 2 occupied.
class Classes {
 public:
  explicit Classes(std::span<const double> truth) {
    if (std::ranges::any_of(truth, [](double v) { return v > kLow && v < kHigh; })) {
      free_below_ = kLow;
      occupied_from_ = kHigh;
    }
  }
  [[nodiscard]] int of(double value) const { return value < free_below_ ? 0 : value < occupied_from_ ? 1 : 2; }

 private:
  double free_below_ = kHalf;
  double occupied_from_ = kHalf;
};

double share(double part, double whole) { return whole > 0.0 ? part / whole : 1.0; }

}  // namespace

MapQuality map_quality(std::span<const double> truth, std::span<const double> estimate) {
  EXPECTS(!truth.empty() && truth.size() == estimate.size());
  const Classes classes(truth);
  double squares = 0.0, error = 0.0, right = 0.0, found = 0.0, walls = 0.0, hits = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    squares += truth[i] * truth[i];
    error += (truth[i] - estimate[i]) * (truth[i] - estimate[i]);
    const int is = classes.of(truth[i]), said = classes.of(estimate[i]);
    right += is == said ? 1.0 : 0.0;
    walls += is == 2 ? 1.0 : 0.0;
    found += said == 2 ? 1.0 : 0.0;
    hits += is == 2 && said == 2 ? 1.0 : 0.0;
  }
  const auto n = static_cast<double>(truth.size());
  const double infinite = std::numeric_limits<double>::infinity();
  return {.relative_error = squares > 0.0 ? std::sqrt(error / squares)
                            : error > 0.0 ? infinite
                                          : 0.0,
          .psnr_db = error > 0.0 ? 10.0 * std::log10(n / error) : infinite,
          .accuracy = right / n,
          .wall_precision = share(hits, found),
          .wall_recall = share(hits, walls),
          .wall_f1 = share(2.0 * hits, found + walls)};
}

std::string quality_line(const MapQuality& quality) {
  return fmt::format("error {:.3f}, PSNR {:.1f} dB, accuracy {:.3f}, wall F1 {:.3f}", quality.relative_error,
                     quality.psnr_db, quality.accuracy, quality.wall_f1);
}

}  // namespace cogslam
