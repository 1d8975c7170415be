#include "slam/mobile_sensing/partial_map.hpp"

#include <algorithm>
#include <cmath>

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/rng.hpp"
#include "slam/mobile_sensing/cell_samples.hpp"
#include "slam/mobile_sensing/field_recovery.hpp"

namespace cogslam {
namespace {

bool is_known(double occupancy) { return std::abs(occupancy - kUnchanged) > kKnownMargin; }

bool is_beside_a_wall(const Grid<double>& occupancy, Cell c) {
  for (int y = std::max(c.y - 1, 0); y <= std::min(c.y + 1, occupancy.frame().height - 1); ++y) {
    for (int x = std::max(c.x - 1, 0); x <= std::min(c.x + 1, occupancy.frame().width - 1); ++x) {
      if (occupancy[{x, y}] > kUnchanged + kKnownMargin) return true;
    }
  }
  return false;
}

}  // namespace

GridFrame PartialMapConfig::frame() const {
  return {
      .cell_size = cell_size_m, .lattice_min = {0, -across_cells / 2}, .width = ahead_cells, .height = across_cells};
}

std::string PartialMapConfig::check() const {
  if (across_cells < 1) return "across_cells: expected at least 1, found " + std::to_string(across_cells);
  if (ahead_cells < 1) return "ahead_cells: expected at least 1, found " + std::to_string(ahead_cells);
  if (!(cell_size_m > 0.0)) return "cell_size_m: expected more than 0";
  return model.check();
}

PartialMap partial_map(const PartialMapConfig& config, const Scan& scan) {
  EXPECTS(config.check().empty());
  return with_weights(scan_occupancy(config.model, scan, {}, config.frame()));
}

PartialMap with_weights(Grid<double> occupancy) {
  Grid<double> weight(occupancy.frame());
  const GridFrame& frame = occupancy.frame();
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      weight[{x, y}] = is_known(occupancy[{x, y}]) || is_beside_a_wall(occupancy, {x, y}) ? 1.0 : 0.0;
    }
  }
  return {std::move(occupancy), std::move(weight)};
}

PartialMap recover_from_samples(const PartialMap& map, int samples, std::uint32_t seed, std::uint32_t index) {
  const GridFrame& frame = map.occupancy.frame();
  const std::size_t n = frame.size();
  if (samples < 1 || static_cast<std::size_t>(samples) > n) {
    throw InputError("samples: expected 1 to " + std::to_string(n) + ", the cells of a partial map, found " +
                     std::to_string(samples));
  }
  if (static_cast<std::size_t>(samples) == n) return map;
  const std::uint32_t drawn = Rng({.seed = seed, .purpose = Purpose::kCompression, .entity = index}).bits();
  const CellSamples sensed = sense_random_cells(frame.width, frame.height, static_cast<std::size_t>(samples), drawn,
                                                [&map](std::uint32_t cell) { return map.occupancy.values()[cell]; });
  Grid<double> recovered(frame);
  recovered.values() = recover_field({.stop_at_gap = 1e-2, .max_iterations = 2000}, sensed).field;
  return with_weights(std::move(recovered));
}

}  // namespace cogslam
