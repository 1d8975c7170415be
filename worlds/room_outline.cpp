#include "worlds/room_outline.hpp"

#include <cmath>

namespace cogslam {
namespace {

using Eigen::Vector2d;

/// `in` and `out` are the directions of the wall that ends at `corner` and of the one that starts there.
void add_corner(const CornerFeature& feature, const Vector2d& corner, const Vector2d& in, const Vector2d& out,
                Polygon& loop) {
  const auto point = [&](double before, double after) {
    loop.emplace_back(corner - before * feature.before * in + after * feature.after * out);
  };
  switch (feature.kind) {
    case CornerFeature::Kind::kPlain:
      return point(0.0, 0.0);
    case CornerFeature::Kind::kCut:
      return point(1.0, 0.0), point(0.0, 1.0);
    case CornerFeature::Kind::kStep:
      return point(1.0, 0.0), point(1.0, 1.0), point(0.0, 1.0);
    case CornerFeature::Kind::kStair:
      return point(1.0, 0.0), point(1.0, 0.5), point(0.5, 0.5), point(0.5, 1.0), point(0.0, 1.0);
  }
}

/// The wall runs from `start` along the unit vector `along`, one of the axes, for `length`.
void add_wall(const WallFeature& feature, const Vector2d& start, const Vector2d& along, double length, Polygon& loop) {
  if (feature.kind == WallFeature::Kind::kPlain) return;
  const Vector2d outward{along.y(), -along.x()};
  // Snapped in map coordinates, so that the sides of the feature keep off the cell borders.
  const double sense = along.x() + along.y();
  const double first = off_borders(start.dot(along) * sense + sense * (feature.at * length - 0.5 * feature.width));
  const double from = sense * first - start.dot(along);
  const auto point = [&](double share, double depth) {
    loop.emplace_back(start + (from + share * feature.width) * along + depth * feature.depth * outward);
  };
  const double sign = feature.kind == WallFeature::Kind::kPilaster ? -1.0 : 1.0;
  const double slant = feature.kind == WallFeature::Kind::kBay ? 0.25 : 0.0;
  point(0.0, 0.0), point(slant, sign), point(1.0 - slant, sign), point(1.0, 0.0);
}

/// 0.3 m to 0.6 m in whole 0.1 m.
double drawn_size(Rng& rng) { return 0.1 * (3.0 + rng.below(4)); }

}  // namespace

double off_borders(double coordinate) { return 0.1 * std::round((coordinate - 0.04) / 0.1) + 0.04; }

Polygon RoomOutline::loop() const {
  const std::array<Vector2d, 4> along{Vector2d{1, 0}, Vector2d{0, 1}, Vector2d{-1, 0}, Vector2d{0, -1}};
  const double w = 0.5 * width, l = 0.5 * length;
  const std::array<Vector2d, 4> corner{Vector2d{-w, -l}, Vector2d{w, -l}, Vector2d{w, l}, Vector2d{-w, l}};
  Polygon out;
  for (std::size_t i = 0; i < 4; ++i) {
    add_corner(corners[i], corner[i], along[(i + 3) % 4], along[i], out);
    add_wall(walls[i], corner[i], along[i], i % 2 == 0 ? width : length, out);
  }
  return out;
}

RoomOutline shipped_outline(double width, double length) {
  using C = CornerFeature::Kind;
  using W = WallFeature::Kind;
  return {.width = width,
          .length = length,
          .corners = {{{C::kStep, 0.5, 0.4}, {C::kCut, 0.6, 0.5}, {C::kStair, 0.6, 0.6}, {C::kCut, 0.4, 0.6}}},
          .walls = {{{W::kAlcove, 0.42, 0.6, 0.3},
                     {W::kPilaster, 0.55, 0.4, 0.3},
                     {W::kBay, 0.55, 0.6, 0.4},
                     {W::kAlcove, 0.52, 0.6, 0.5}}}};
}

RoomOutline drawn_outline(double width, double length, Rng& rng) {
  RoomOutline out{.width = width, .length = length};
  for (CornerFeature& c : out.corners) {
    c.kind = static_cast<CornerFeature::Kind>(1 + rng.below(3));
    c.before = drawn_size(rng);
    c.after = drawn_size(rng);
    if (c.kind == CornerFeature::Kind::kStair) c.before = c.after = 0.6;
  }
  for (WallFeature& w : out.walls) {
    w.kind = static_cast<WallFeature::Kind>(rng.below(4));
    w.at = rng.uniform(0.35, 0.65);
    w.width = drawn_size(rng);
    w.depth = drawn_size(rng);
    if (w.kind == WallFeature::Kind::kBay) w.width = 0.6;  // a narrower one is but a slit
  }
  return out;
}

}  // namespace cogslam
