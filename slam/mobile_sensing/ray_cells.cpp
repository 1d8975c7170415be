#include "slam/mobile_sensing/ray_cells.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/cell_walk.hpp"
#include "core/check.hpp"
#include "core/error.hpp"
#include "core/rng.hpp"

namespace cogslam {
namespace {

// Keeps these draws apart from the order of random cells under the same seed.
constexpr std::uint64_t kRayTick = 2;

class RayWalk {
 public:
  RayWalk(const RayCells& plan, int width, int height, std::uint32_t seed, const CellSensor& sensor)
      : plan_(plan),
        frame_({.cell_size = 1.0, .width = width, .height = height}),
        rng_({seed, Purpose::kCompression, 0, kRayTick}),
        sensor_(sensor),
        sensed_(frame_.size(), false) {}

  /// Casts one ray and keeps its end at a wall, and one cell crossed before.
  void cast() {
    const Eigen::Vector2d from(rng_.uniform(0.0, frame_.width), rng_.uniform(0.0, frame_.height));
    const double heading = rng_.uniform(-std::numbers::pi, std::numbers::pi);
    const Eigen::Vector2d to = from + plan_.range_cells * Eigen::Vector2d(std::cos(heading), std::sin(heading));
    std::vector<std::uint32_t> crossed;
    bool hit = false;
    walk_cells(from, to, [&](Cell cell) {
      if (!frame_.contains(cell)) return false;
      const auto index = static_cast<std::uint32_t>(frame_.index(cell));
      const double value = sensor_(index);
      if (crossed.empty() && value >= 1.0 - plan_.occupied_from) return false;  // a robot stands on free cells
      crossed.push_back(index);
      hit = value >= plan_.occupied_from;
      return !hit;
    });
    if (crossed.empty()) return;
    if (hit) {
      keep(crossed.back());
      crossed.pop_back();
    }
    keep(crossed[rng_.below(static_cast<std::uint32_t>(crossed.size()))]);
  }

  [[nodiscard]] const std::vector<std::uint32_t>& cells() const { return cells_; }

 private:
  void keep(std::uint32_t cell) {
    if (sensed_[cell]) return;
    sensed_[cell] = true;
    cells_.push_back(cell);
  }

  const RayCells& plan_;
  GridFrame frame_;
  Rng rng_;
  const CellSensor& sensor_;
  std::vector<bool> sensed_;
  std::vector<std::uint32_t> cells_;
};

}  // namespace

CellSamples sense_ray_cells(const RayCells& plan, int width, int height, std::size_t count, std::uint32_t seed,
                            const CellSensor& sensor) {
  EXPECTS(width > 0 && height > 0 && plan.range_cells > 0.0 && plan.tries_per_cell >= 1);
  EXPECTS(plan.occupied_from > 0.5 && plan.occupied_from <= 1.0);
  RayWalk walk(plan, width, height, seed, sensor);
  const std::size_t most = count * static_cast<std::size_t>(plan.tries_per_cell);
  for (std::size_t tries = 0; tries < most && walk.cells().size() < count; ++tries) walk.cast();
  std::vector<std::uint32_t> cells = walk.cells();
  if (cells.size() < count) {
    throw InputError("rays met only " + std::to_string(cells.size()) + " different cells, fewer than the " +
                     std::to_string(count) + " asked for");
  }
  cells.resize(count);
  return sense_cells(width, height, std::move(cells), sensor);
}

}  // namespace cogslam
