#include "slam/mobile_sensing/cell_samples.hpp"

#include <utility>

#include "core/check.hpp"

namespace cogslam {

Compressor selection_of(const CellSamples& samples) {
  return Compressor::selection(samples.cells, samples.field_size());
}

CellSamples sense_cells(int width, int height, std::vector<std::uint32_t> cells, const CellSensor& sensor) {
  EXPECTS(width > 0 && height > 0);
  CellSamples samples{.width = width, .height = height, .cells = std::move(cells), .values = {}};
  samples.values.reserve(samples.cells.size());
  for (const std::uint32_t cell : samples.cells) {
    EXPECTS(cell < samples.field_size());
    samples.values.push_back(sensor(cell));
  }
  return samples;
}

CellSamples sense_random_cells(int width, int height, std::size_t count, std::uint32_t seed, const CellSensor& sensor) {
  EXPECTS(width > 0 && height > 0);
  const std::size_t n = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  EXPECTS(count <= n);
  std::vector<std::uint32_t> cells = random_order(n, seed);
  cells.resize(count);
  return sense_cells(width, height, std::move(cells), sensor);
}

}  // namespace cogslam
