#include "worlds/floor_texture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace cogslam {
namespace {

constexpr int kSize = FloorTexture::kSize;

struct Spread {
  double mean = 0.0;
  double deviation = 0.0;
};

Spread spread_of(const FloorTexture& texture) {
  double sum = 0.0, squares = 0.0;
  for (const std::uint8_t grey : texture.grey) sum += grey, squares += static_cast<double>(grey) * grey;
  const auto n = static_cast<double>(texture.grey.size());
  return {sum / n, std::sqrt(squares / n - (sum / n) * (sum / n))};
}

/// Mean absolute step of grey between the neighbouring columns (or rows) `a` and `a + 1`, wrapping.
double column_step(const FloorTexture& texture, int column) {
  double sum = 0.0;
  for (int row = 0; row < kSize; ++row) {
    const double step = texture.at((column + 1) % kSize, row) - texture.at(column, row);
    sum += std::abs(step) / kSize;
  }
  return sum;
}
double row_step(const FloorTexture& texture, int row) {
  double sum = 0.0;
  for (int column = 0; column < kSize; ++column) {
    const double step = texture.at(column, (row + 1) % kSize) - texture.at(column, row);
    sum += std::abs(step) / kSize;
  }
  return sum;
}

TEST(FloorTexture, HasTheStatedContrast) {
  EXPECT_NEAR(spread_of(paint_floor({.kind = FloorKind::kCarpet})).deviation, 25.0, 4.0);
  EXPECT_NEAR(spread_of(paint_floor({.kind = FloorKind::kWood})).deviation, 11.0, 3.0);
  EXPECT_NEAR(spread_of(paint_floor({.kind = FloorKind::kConcrete})).deviation, 8.0, 2.0);
  EXPECT_NEAR(spread_of(paint_floor({.kind = FloorKind::kTile})).deviation, 12.0, 3.0);
  EXPECT_EQ(spread_of(paint_floor({.kind = FloorKind::kPlain})).deviation, 0.0);
}

TEST(FloorTexture, ContrastScalesTheDistanceFromMidGrey) {
  const FloorTexture full = paint_floor({.kind = FloorKind::kConcrete, .contrast = 1.0});
  const FloorTexture half = paint_floor({.kind = FloorKind::kConcrete, .contrast = 0.5});
  const FloorTexture none = paint_floor({.kind = FloorKind::kConcrete, .contrast = 0.0});
  for (std::size_t i = 0; i < full.grey.size(); i += 997) {
    EXPECT_NEAR(half.grey[i] - 128.0, 0.5 * (full.grey[i] - 128.0), 1.0);
    EXPECT_EQ(none.grey[i], 128);
  }
}

TEST(FloorTexture, DependsOnTheSeedAlone) {
  const Floor first{.kind = FloorKind::kTile, .seed = 5}, other{.kind = FloorKind::kTile, .seed = 6};
  EXPECT_EQ(paint_floor(first).grey, paint_floor(first).grey);
  EXPECT_NE(paint_floor(first).grey, paint_floor(other).grey);
}

TEST(FloorTexture, RepeatsWithoutASeam) {
  // Carpet and concrete look the same everywhere, so the step over the seam must look like any other. The fine cells of
  // concrete's noise are 2 and 4 texels wide; the steps compared lie on the border of such cells, as the seam does.
  for (const FloorKind kind : {FloorKind::kCarpet, FloorKind::kConcrete}) {
    const FloorTexture texture = paint_floor({.kind = kind});
    double column = 0.0, row = 0.0;
    for (int i = 255; i < kSize - 1; i += 256)
      column += column_step(texture, i) / 7.0, row += row_step(texture, i) / 7.0;
    EXPECT_NEAR(column_step(texture, kSize - 1) / column, 1.0, 0.2);
    EXPECT_NEAR(row_step(texture, kSize - 1) / row, 1.0, 0.2);
  }
}

TEST(FloorTexture, WoodRunsAlongX) {
  const FloorTexture wood = paint_floor({.kind = FloorKind::kWood});
  double along = 0.0, across = 0.0;
  for (int i = 20; i < 100; ++i) along += column_step(wood, i), across += row_step(wood, i);
  EXPECT_LT(1.3 * along, across);
}

}  // namespace
}  // namespace cogslam
