#include "worlds/clearance.hpp"

#include <algorithm>
#include <limits>

#include "core/check.hpp"
#include "core/grid.hpp"
#include "worlds/free_space.hpp"
#include "worlds/polygon.hpp"

namespace cogslam {
namespace {

double nearest(const std::vector<Segment>& surfaces, const Eigen::Vector2d& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& s : surfaces) least = std::min(least, distance(s, p));
  return least;
}

/// Counts the cells of `standing` that eight-neighbour steps connect to `start`; uses `standing` up.
std::size_t flood(Grid<std::uint8_t>& standing, Cell start) {
  std::size_t reached = 0;
  std::vector<Cell> front;
  const auto enter = [&](Cell c) {
    if (!standing.frame().contains(c) || !standing[c]) return;
    standing[c] = 0;
    ++reached;
    front.push_back(c);
  };
  enter(start);
  while (!front.empty()) {
    const Cell c = front.back();
    front.pop_back();
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) enter({c.x + dx, c.y + dy});
    }
  }
  return reached;
}

}  // namespace

double clearance(const World& world, const Eigen::Vector2d& p_map) { return nearest(world.segments(), p_map); }

double clearance(const World& world, const Segment& way) {
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& s : world.segments()) least = std::min(least, distance(s, way));
  return least;
}

Reach reach(const World& world, double radius, double step) {
  EXPECTS(radius >= 0.0 && step > 0.0);
  const FreeSpace free_space(world);
  EXPECTS(free_space.is_closed());
  const std::vector<Segment> surfaces = world.segments();
  Grid<std::uint8_t> standing(GridFrame::covering(world.bounds(), step));
  const GridFrame& frame = standing.frame();
  std::size_t free_points = 0, standing_points = 0;
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const Eigen::Vector2d p = frame.centre_of({x, y});
      if (!free_space.contains(p)) continue;
      ++free_points;
      if (nearest(surfaces, p) < radius) continue;
      ++standing_points;
      standing[{x, y}] = 1;
    }
  }
  const std::size_t reachable_points = flood(standing, frame.cell_of(world.start.position()));
  const double area = step * step;
  return {area * static_cast<double>(free_points), area * static_cast<double>(standing_points),
          area * static_cast<double>(reachable_points)};
}

}  // namespace cogslam
