#include "worlds/world.hpp"

#include "core/check.hpp"
#include "worlds/glass.hpp"
#include "worlds/polygon.hpp"

namespace cogslam {

std::vector<Segment> World::segments() const {
  std::vector<Segment> out;
  for (const auto* loops : {&walls, &obstacles}) {
    for (const Polygon& loop : *loops) {
      const std::vector<Segment> sides = edges(loop);
      out.insert(out.end(), sides.begin(), sides.end());
    }
  }
  out.insert(out.end(), panes.begin(), panes.end());
  return out;
}

std::vector<Segment> World::opaque_segments() const {
  std::vector<Segment> surfaces = segments();
  surfaces.resize(surfaces.size() - panes.size());
  return opaque_parts(surfaces, panes);
}

Rectangle World::bounds() const {
  const std::vector<Segment> surfaces = segments();
  EXPECTS(!surfaces.empty());
  Rectangle out{surfaces.front().a, surfaces.front().a};
  for (const Segment& s : surfaces) {
    out.min = out.min.cwiseMin(s.a).cwiseMin(s.b);
    out.max = out.max.cwiseMax(s.a).cwiseMax(s.b);
  }
  return out;
}

}  // namespace cogslam
