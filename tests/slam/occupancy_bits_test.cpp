#include "slam/weight/occupancy_bits.hpp"

#include <gmock/gmock.h>

#include "core/rng.hpp"

namespace cogslam {
namespace {

/// Slow twin: cells to the nearest occupied one in direction `step`, by going there.
int cells_to_occupied(const Grid<float>& grid, int x, int y, int step, int reach) {
  for (int d = 0; d <= reach; ++d) {
    const Cell c{x + step * d, y};
    if (grid.frame().contains(c) && grid[c] > kOccupiedLogOdds) return d;
  }
  return OccupancyBits::kFarthest + 1;
}

/// Levels of 0.4, so that both kinds of map say the same.
Grid<std::int8_t> random_levels(Rng& rng) {
  const GridFrame frame{.cell_size = 0.1,
                        .lattice_min = {-7, 2},
                        .width = static_cast<int>(rng.below(200)) + 1,
                        .height = static_cast<int>(rng.below(6)) + 1};
  Grid<std::int8_t> levels(frame);
  for (std::int8_t& level : levels.values()) {
    level = static_cast<std::int8_t>(rng.below(20) == 0 ? rng.below(9) : 0U - rng.below(6));
  }
  return levels;
}

TEST(OccupancyBits, FindTheNearestOccupiedCellOfARow) {
  for (std::uint32_t round = 0; round < 60; ++round) {
    Rng rng({.seed = 71, .purpose = Purpose::kWorld, .entity = round});
    const Grid<std::int8_t> levels = random_levels(rng);
    Grid<float> log_odds(levels.frame());
    for (std::size_t i = 0; i < levels.values().size(); ++i) {
      log_odds.values()[i] = 0.4F * static_cast<float>(levels.values()[i]);
    }
    OccupancyBits from_levels, from_floats;
    from_levels.read(levels, 0.4);
    from_floats.read(log_odds);
    const int reach = static_cast<int>(rng.below(64));
    bool any = false;
    for (int y = 0; y < levels.frame().height; ++y) {
      for (int x = 0; x < levels.frame().width; ++x) {
        const int right = cells_to_occupied(log_odds, x, y, 1, reach),
                  left = cells_to_occupied(log_odds, x, y, -1, reach);
        for (const OccupancyBits* bits : {&from_levels, &from_floats}) {
          const OccupancyBits::InRow found = bits->nearest_in_row(x, y, reach);
          ASSERT_EQ(found.right, right) << "round " << round << " cell " << x << " " << y;
          ASSERT_EQ(found.left, left) << "round " << round << " cell " << x << " " << y;
          ASSERT_EQ(bits->known({x, y}), !is_unknown(log_odds[{x, y}]));
        }
        any = any || right == 0;
      }
    }
    EXPECT_EQ(from_levels.any_occupied(), any);
    EXPECT_FALSE(from_levels.known({-1, 0}));
    EXPECT_FALSE(from_levels.known({0, levels.frame().height}));
  }
}

}  // namespace
}  // namespace cogslam
