#include "slam/map/expected_range.hpp"

#include <gmock/gmock.h>

#include "core/rng.hpp"
#include "slam/map/log_odds.hpp"
#include "tests/support/drawn_grid.hpp"
#include "tests/support/touched_cells.hpp"

namespace cogslam {
namespace {

constexpr double kStep = 0.002;  // cells

/// Slow twin: goes along the beam in small steps and looks at the cell of each point.
ExpectedRange step_along(const Grid<float>& grid, const Eigen::Vector2d& origin, const Eigen::Vector2d& end) {
  const double length = 1.5 * (end - origin).norm(), step = kStep * grid.frame().cell_size;
  const Eigen::Vector2d direction = (end - origin).normalized();
  ExpectedRange result{.known = true, .enter = length, .leave = length};
  std::optional<Cell> hit;
  for (double range = 0.0; range < length; range += step) {
    const Cell c = grid.frame().cell_of(origin + range * direction);
    if (hit && !(c == *hit)) {
      result.leave = range;
      return result;
    }
    if (hit) continue;
    if (!grid.frame().contains(c) || std::abs(grid[c]) < kUnknownLogOdds) return {false, length, length};
    if (grid[c] <= kOccupiedLogOdds) continue;
    hit = c;
    result.enter = range;
  }
  return result;
}

/// Whether a beam cuts a corner so closely that small steps may jump over it.
bool cuts_a_corner(const Grid<float>& grid, const Eigen::Vector2d& origin, const Eigen::Vector2d& end) {
  const GridFrame& frame = grid.frame();
  const Eigen::Vector2d from = (origin - frame.origin()) / frame.cell_size;
  const Eigen::Vector2d to = (origin + 1.5 * (end - origin) - frame.origin()) / frame.cell_size;
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const double length = length_inside(from, to, {x, y}, 1e-6);
      if (length >= 0.0 && length < 3.0 * kStep) return true;
    }
  }
  return false;
}

TEST(ExpectedRange, EqualsSmallStepsAlongTheBeam) {
  int compared = 0, known = 0, nothing_hit = 0;
  for (std::uint32_t round = 0; round < 400; ++round) {
    Rng rng({.seed = 48, .purpose = Purpose::kWorld, .entity = round});
    const double cell_size = std::array{0.05, 0.1, 0.5}[rng.below(3)];
    Grid<float> grid(GridFrame{.cell_size = cell_size, .lattice_min = {-9, 4}, .width = 22, .height = 17}, -1.0F);
    for (float& value : grid.values()) {
      const double draw = rng.uniform();
      if (draw < 0.05) value = 2.0F;
      if (draw > 0.99) value = 0.05F;
    }
    const Eigen::Vector2d corner = grid.frame().origin();
    const auto point = [&] {
      return Eigen::Vector2d(corner + cell_size * Eigen::Vector2d(rng.uniform(1.0, 21.0), rng.uniform(1.0, 16.0)));
    };
    const Eigen::Vector2d origin = point(), end = point();
    if (cuts_a_corner(grid, origin, end)) continue;
    const ExpectedRange fast = expected_range(grid, origin, end), slow = step_along(grid, origin, end);
    ASSERT_EQ(fast.known, slow.known) << "round " << round;
    ++compared;
    if (!slow.known) continue;
    ++known;
    nothing_hit += slow.enter == slow.leave ? 1 : 0;
    ASSERT_NEAR(fast.enter, slow.enter, 1.01 * kStep * cell_size) << "round " << round;
    ASSERT_NEAR(fast.leave, slow.leave, 1.01 * kStep * cell_size) << "round " << round;
  }
  EXPECT_GT(compared, 200);
  EXPECT_GT(known, 80);
  EXPECT_GT(nothing_hit, 10);
}

TEST(ExpectedRange, IsWhereTheBeamEntersAndLeavesTheDrawnWall) {
  const Grid<float> grid = drawn_grid({"......#", "......#", ".... .#"}, 0.5, {-2, 1});
  const Eigen::Vector2d corner = grid.frame().origin();
  const ExpectedRange ahead =
      expected_range(grid, corner + Eigen::Vector2d(0.25, 1.2), corner + Eigen::Vector2d(2.9, 1.2));
  EXPECT_TRUE(ahead.known);
  EXPECT_NEAR(ahead.enter, 2.75, 1e-12);
  EXPECT_NEAR(ahead.leave, 3.25, 1e-12);
  // The lowest row has an unknown cell before the wall.
  EXPECT_FALSE(expected_range(grid, corner + Eigen::Vector2d(0.25, 0.2), corner + Eigen::Vector2d(2.9, 0.2)).known);
  // Half as far again as the end point, and no farther.
  const ExpectedRange shorter =
      expected_range(grid, corner + Eigen::Vector2d(0.25, 1.2), corner + Eigen::Vector2d(1.25, 1.2));
  EXPECT_TRUE(shorter.known);
  EXPECT_NEAR(shorter.enter, 1.5, 1e-12);
}

TEST(ExpectedRange, IsUnknownOutsideTheGrid) {
  const Grid<float> grid = drawn_grid({"..."}, 1.0);
  EXPECT_FALSE(expected_range(grid, {0.5, 0.5}, {2.9, 0.5}).known);
  EXPECT_FALSE(expected_range(grid, {-5.0, 0.5}, {-4.0, 0.5}).known);
}

}  // namespace
}  // namespace cogslam
