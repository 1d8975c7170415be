#include "worlds/floor_texture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/check.hpp"
#include "core/rng.hpp"

namespace cogslam {
namespace {

constexpr int kSize = FloorTexture::kSize;

/// The piece of floor while it is being painted. Indices wrap, so every stroke that leaves one side enters the other.
class Canvas {
 public:
  Canvas(std::uint32_t seed, float grey) : seed_(seed), values_(static_cast<std::size_t>(kSize) * kSize, grey) {}

  float& at(int column, int row) {
    return values_[static_cast<std::size_t>(row) * kSize + static_cast<std::size_t>(column)];
  }
  float& wrapped(int column, int row) { return at(column & (kSize - 1), row & (kSize - 1)); }

  /// A stream of its own for each thing painted.
  Rng chance(std::uint64_t row = 0) { return Rng({seed_, Purpose::kFloorTexture, layer_, row}); }
  void next_layer() { ++layer_; }

  /// Adds value noise: uniform in +-amplitude at the corners of cells (powers of two), smooth in between.
  void add_noise(int cell_x, int cell_y, float amplitude) {
    const int columns = kSize / cell_x, rows = kSize / cell_y;
    std::vector<float> knots(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    Rng rng = chance();
    for (float& knot : knots) knot = amplitude * static_cast<float>(rng.uniform(-1.0, 1.0));
    std::vector<float> line(static_cast<std::size_t>(columns) + 1);
    for (int row = 0; row < kSize; ++row) {
      const int below = row / cell_y, above = (below + 1) % rows;
      const float w = smooth(row % cell_y, cell_y);
      for (int i = 0; i <= columns; ++i) {
        const auto k = static_cast<std::size_t>(i % columns), n = static_cast<std::size_t>(columns);
        line[static_cast<std::size_t>(i)] = (1.0F - w) * knots[static_cast<std::size_t>(below) * n + k] +
                                            w * knots[static_cast<std::size_t>(above) * n + k];
      }
      for (int column = 0; column < kSize; ++column) {
        const auto i = static_cast<std::size_t>(column / cell_x);
        const float u = smooth(column % cell_x, cell_x);
        at(column, row) += (1.0F - u) * line[i] + u * line[i + 1];
      }
    }
    next_layer();
  }

  /// Adds `count` round specks with radii [texel] and depths [grey] from the given ranges.
  void add_specks(int count, double radius_min, double radius_max, double depth_min, double depth_max) {
    Rng rng = chance();
    for (int i = 0; i < count; ++i) {
      const double x = rng.uniform(0.0, kSize), y = rng.uniform(0.0, kSize);
      const double radius = rng.uniform(radius_min, radius_max), depth = rng.uniform(depth_min, depth_max);
      for_disc(x, y, radius + 0.5, [&](float& value, double distance) {
        value += static_cast<float>(depth * std::clamp(radius + 0.5 - distance, 0.0, 1.0));  // soft rim, one texel wide
      });
    }
    next_layer();
  }

  /// Adds `count` strokes along x, one texel wide, with lengths [texel] and depths [grey] from the given ranges.
  void add_strokes(int count, int length_min, int length_max, double depth_min, double depth_max) {
    Rng rng = chance();
    for (int i = 0; i < count; ++i) {
      const int column = static_cast<int>(rng.below(kSize)), row = static_cast<int>(rng.below(kSize));
      const int length = length_min + static_cast<int>(rng.below(static_cast<std::uint32_t>(length_max - length_min)));
      const auto depth = static_cast<float>(rng.uniform(depth_min, depth_max));
      for (int j = 0; j < length; ++j) wrapped(column + j, row) += depth;
    }
    next_layer();
  }

  /// Calls f(value, distance) for each texel whose centre lies within `radius` of (x, y) [texel].
  template <class F>
  void for_disc(double x, double y, double radius, F&& f) {
    for (int row = static_cast<int>(std::floor(y - radius)); row <= static_cast<int>(y + radius); ++row) {
      for (int column = static_cast<int>(std::floor(x - radius)); column <= static_cast<int>(x + radius); ++column) {
        const double distance = std::hypot(column + 0.5 - x, row + 0.5 - y);
        if (distance < radius) f(wrapped(column, row), distance);
      }
    }
  }

 private:
  static float smooth(int i, int cell) {
    const float t = (static_cast<float>(i) + 0.5F) / static_cast<float>(cell);
    return t * t * (3.0F - 2.0F * t);
  }

  std::uint32_t seed_;
  std::uint32_t layer_ = 0;
  std::vector<float> values_;
};

/// Cut pile: round tufts of 5 mm, each of its own shade and dark towards its rim, over a faint large blotch.
Canvas paint_carpet(std::uint32_t seed) {
  constexpr int kPitch = 4;
  constexpr double kRadius = 3.2;
  Canvas canvas(seed, 40.0F);
  for (int row = 0; row < kSize; row += kPitch) {
    Rng rng = canvas.chance(static_cast<std::uint64_t>(row));
    for (int column = 0; column < kSize; column += kPitch) {
      const double x = column + rng.uniform(0.0, kPitch), y = row + rng.uniform(0.0, kPitch);
      const double shade = rng.uniform(80.0, 165.0);
      canvas.for_disc(x, y, kRadius, [&](float& value, double distance) {
        const double height = 1.0 - distance * distance / (kRadius * kRadius);
        value = std::max(value, static_cast<float>(40.0 + (shade - 40.0) * std::sqrt(height)));
      });
    }
  }
  canvas.next_layer();
  canvas.add_noise(256, 256, 8.0F);
  canvas.add_noise(32, 32, 8.0F);
  canvas.add_noise(1, 1, 10.0F);
  return canvas;
}

/// Boards along x, 128 mm wide and 1024 mm long, each cut from another place of one long-grained piece of wood.
Canvas paint_wood(std::uint32_t seed) {
  constexpr int kWidth = 128, kLength = 1024;
  Canvas wood(seed, 0.0F);
  wood.add_noise(512, 32, 60.0F);  // a bend of the year rings; becomes their phase
  for (int row = 0; row < kSize; ++row) {
    for (int column = 0; column < kSize; ++column) {
      const double phase = 2.0 * std::numbers::pi * row / 16.0 + 0.12 * static_cast<double>(wood.at(column, row));
      wood.at(column, row) = static_cast<float>(5.0 * std::sin(phase));
    }
  }
  wood.add_noise(256, 8, 6.0F);
  wood.add_noise(64, 2, 7.0F);
  wood.add_noise(16, 1, 5.0F);
  wood.add_strokes(60000, 2, 10, -30.0, -8.0);  // open pores, as oak has them
  Canvas floor(seed, 135.0F);
  floor.next_layer();
  for (int board = 0; board < kSize / kWidth; ++board) {
    Rng rng = wood.chance(static_cast<std::uint64_t>(board));
    const int joint = static_cast<int>(rng.below(kSize));
    const std::array<double, 2> shade{rng.uniform(-9.0, 9.0), rng.uniform(-9.0, 9.0)};
    const std::array<int, 2> cut{static_cast<int>(rng.below(kSize)), static_cast<int>(rng.below(kSize))};
    for (int row = board * kWidth; row < (board + 1) * kWidth; ++row) {
      for (int column = 0; column < kSize; ++column) {
        const int along = (column - joint) & (kSize - 1);
        const auto piece = static_cast<std::size_t>(along / kLength);
        const bool gap = row % kWidth < 2 || along % kLength < 2;
        floor.at(column, row) +=
            static_cast<float>(shade[piece]) + wood.wrapped(column + 3 * cut[piece], row + cut[piece]);
        if (gap) floor.at(column, row) -= 50.0F;
      }
    }
  }
  return floor;
}

/// Screed: faint clouds of all sizes, fine sand, and dark pores.
Canvas paint_concrete(std::uint32_t seed) {
  Canvas canvas(seed, 140.0F);
  canvas.add_noise(256, 256, 7.0F);
  canvas.add_noise(64, 64, 6.0F);
  canvas.add_noise(16, 16, 5.0F);
  canvas.add_noise(4, 4, 6.0F);
  canvas.add_noise(2, 2, 6.0F);
  canvas.add_specks(6000, 0.7, 2.2, -45.0, -15.0);
  canvas.add_specks(20000, 0.7, 1.6, -10.0, 14.0);
  return canvas;
}

/// Stoneware, 256 mm square with joints of 4 mm: tiles differ a little in shade and carry a fine speckle.
Canvas paint_tile(std::uint32_t seed) {
  constexpr int kTileSide = 256, kJoint = 4;
  Canvas canvas(seed, 150.0F);
  canvas.add_noise(64, 64, 4.0F);
  canvas.add_noise(8, 8, 4.0F);
  canvas.add_noise(2, 2, 5.0F);
  canvas.add_specks(40000, 0.7, 1.8, -28.0, 12.0);
  Canvas grout(seed + 1, 100.0F);
  grout.add_noise(2, 2, 14.0F);
  constexpr int kTiles = kSize / kTileSide;
  std::array<float, kTiles * kTiles> shades{};
  Rng rng = canvas.chance();
  for (float& shade : shades) shade = static_cast<float>(rng.uniform(-8.0, 8.0));
  for (int row = 0; row < kSize; ++row) {
    for (int column = 0; column < kSize; ++column) {
      const bool joint = row % kTileSide < kJoint || column % kTileSide < kJoint;
      canvas.at(column, row) += shades[static_cast<std::size_t>(row / kTileSide * kTiles + column / kTileSide)];
      if (joint) canvas.at(column, row) = grout.at(column, row);
    }
  }
  return canvas;
}

Canvas paint(const Floor& floor) {
  switch (floor.kind) {
    case FloorKind::kCarpet:
      return paint_carpet(floor.seed);
    case FloorKind::kWood:
      return paint_wood(floor.seed);
    case FloorKind::kConcrete:
      return paint_concrete(floor.seed);
    case FloorKind::kTile:
      return paint_tile(floor.seed);
    case FloorKind::kPlain:
      break;
  }
  return {floor.seed, 128.0F};
}

}  // namespace

FloorTexture paint_floor(const Floor& floor) {
  EXPECTS(floor.contrast >= 0.0 && floor.contrast <= 1.0);
  Canvas canvas = paint(floor);
  FloorTexture texture;
  texture.grey.reserve(static_cast<std::size_t>(kSize) * kSize);
  const auto contrast = static_cast<float>(floor.contrast);
  for (int row = 0; row < kSize; ++row) {
    for (int column = 0; column < kSize; ++column) {
      const float value = 128.0F + contrast * (canvas.at(column, row) - 128.0F);
      texture.grey.push_back(static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F)));
    }
  }
  return texture;
}

}  // namespace cogslam
