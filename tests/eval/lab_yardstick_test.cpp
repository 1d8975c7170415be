#include "eval/lab/yardstick.hpp"

#include <gtest/gtest.h>

#include "core/rng.hpp"
#include "eval/lab/map_source.hpp"

namespace cogslam {
namespace {

/// A map of `levels` different values in patches, of random shape.
Grid<float> random_map(std::uint32_t seed) {
  Rng rng({.seed = seed});
  const int width = 1 + static_cast<int>(rng.below(70)), height = 1 + static_cast<int>(rng.below(70));
  Grid<float> map({.width = width, .height = height});
  const std::uint32_t patch = 1 + rng.below(9);
  for (std::size_t i = 0; i < map.values().size(); ++i) {
    const bool kept = i > 0 && rng.below(patch) > 0;
    map.values()[i] = kept ? map.values()[i - 1] : static_cast<float>(rng.uniform(-4.0, 4.0));
  }
  return map;
}

Grid<float> map_of(int width, int height, std::vector<float> values) {
  Grid<float> map({.width = width, .height = height});
  map.values() = std::move(values);
  return map;
}

TEST(Yardstick, GivesLosslessMapsBackBitForBit) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const Grid<float> map = random_map(seed);
    for (const Yardstick yardstick : kYardsticks) {
      if (yardstick == Yardstick::kInt8) continue;
      EXPECT_EQ(decode_map(yardstick, encode_map(yardstick, map), map.frame()), map)
          << name_of(yardstick) << " seed " << seed;
    }
  }
}

TEST(Yardstick, RoundsInt8ToHalfAStep) {
  const Grid<float> map = random_map(3);
  const Grid<float> back = decode_map(Yardstick::kInt8, encode_map(Yardstick::kInt8, map), map.frame());
  for (std::size_t i = 0; i < map.values().size(); ++i) {
    EXPECT_NEAR(back.values()[i], map.values()[i], 0.5 * 4.0 / 127.0 + 1e-6);
  }
}

TEST(Yardstick, CountsTheBytesOfHandMadeMaps) {
  const Grid<float> flat = map_of(4, 4, std::vector<float>(16, 1.5F));
  EXPECT_EQ(encode_map(Yardstick::kFloat32, flat).size(), 64U);
  EXPECT_EQ(encode_map(Yardstick::kInt8, flat).size(), 4U + 16U);
  EXPECT_EQ(encode_map(Yardstick::kRunLength, flat).size(), 6U);
  EXPECT_EQ(encode_map(Yardstick::kQuadtree, flat).size(), 1U + 4U);

  std::vector<float> values(16, 0.0F);
  values[5] = 2.0F;  // cell (1, 1): the root and its first quarter divide, 4 + 3 leaves
  const Grid<float> dot = map_of(4, 4, values);
  EXPECT_EQ(encode_map(Yardstick::kRunLength, dot).size(), 18U);
  EXPECT_EQ(encode_map(Yardstick::kQuadtree, dot).size(), 1U + 4U * 7U);
}

TEST(Yardstick, DoesNotCountSquaresOutsideTheMap) {
  // A 5 x 1 map of one value lies in a square of 8, but is equal wherever it has cells.
  EXPECT_EQ(encode_map(Yardstick::kQuadtree, map_of(5, 1, std::vector<float>(5, 1.0F))).size(), 1U + 4U);
  // Root divides; left half is equal, the right quarter holds one cell that differs.
  EXPECT_EQ(encode_map(Yardstick::kQuadtree, map_of(5, 1, {1, 1, 1, 1, 2})).size(), 1U + 4U * 2U);
}

TEST(Yardstick, CutsRunsAtTheLongestLength) {
  const Grid<float> map = map_of(65536, 1, std::vector<float>(65536, 0.25F));
  const std::string bytes = encode_map(Yardstick::kRunLength, map);
  EXPECT_EQ(bytes.size(), 12U);
  EXPECT_EQ(decode_map(Yardstick::kRunLength, bytes, map.frame()), map);
}

}  // namespace
}  // namespace cogslam
