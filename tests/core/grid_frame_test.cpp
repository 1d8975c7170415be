#include "core/grid_frame.hpp"

#include <gtest/gtest.h>

#include "core/check.hpp"
#include "core/grid.hpp"
#include "core/rng.hpp"

namespace cogslam {
namespace {

GridFrame random_frame(Rng& rng) {
  constexpr double kSizes[] = {0.05, 0.1, 0.2, 0.3, 0.5, 1.0, 0.07};
  const auto offset = [&] { return static_cast<int>(rng.below(20001)) - 10000; };
  const double cell_size = kSizes[rng.below(7)];
  return {.cell_size = cell_size,
          .lattice_min = {offset(), offset()},
          .width = 1 + static_cast<int>(rng.below(500)),
          .height = 1 + static_cast<int>(rng.below(500))};
}

TEST(GridFrame, CentreOfACellLiesInThatCell) {
  Rng rng({.seed = 20, .purpose = Purpose::kWorld});
  for (int i = 0; i < 500; ++i) {
    const GridFrame frame = random_frame(rng);
    for (int k = 0; k < 50; ++k) {
      const Cell c{static_cast<int>(rng.below(static_cast<std::uint32_t>(frame.width))),
                   static_cast<int>(rng.below(static_cast<std::uint32_t>(frame.height)))};
      ASSERT_EQ(frame.cell_of(frame.centre_of(c)), c) << frame.cell_size << " " << c.x << " " << c.y;
    }
  }
}

TEST(GridFrame, FramesOfOneCellSizeShareOneLattice) {
  Rng rng({.seed = 21, .purpose = Purpose::kWorld});
  for (int i = 0; i < 500; ++i) {
    const GridFrame a = random_frame(rng);
    GridFrame b = random_frame(rng);
    b.cell_size = a.cell_size;
    const Eigen::Vector2d p(rng.uniform(-100, 100), rng.uniform(-100, 100));
    const Cell in_a = a.cell_of(p), in_b = b.cell_of(p);
    EXPECT_EQ(in_a.x + a.lattice_min.x, in_b.x + b.lattice_min.x);
    EXPECT_EQ(in_a.y + a.lattice_min.y, in_b.y + b.lattice_min.y);
    EXPECT_EQ(a.centre_of(in_a), b.centre_of(in_b));
  }
}

TEST(GridFrame, NumbersCellsRowByRow) {
  const GridFrame frame{.cell_size = 0.5, .lattice_min = {-2, 4}, .width = 3, .height = 2};
  EXPECT_EQ(frame.size(), 6U);
  EXPECT_EQ(frame.index({0, 0}), 0U);
  EXPECT_EQ(frame.index({2, 0}), 2U);
  EXPECT_EQ(frame.index({0, 1}), 3U);
  EXPECT_EQ(frame.origin(), Eigen::Vector2d(-1.0, 2.0));
  EXPECT_EQ(frame.cell_of({-1.0, 2.0}), (Cell{0, 0}));
  EXPECT_EQ(frame.cell_of({-1.1, 3.1}), (Cell{-1, 2}));
  EXPECT_TRUE(frame.contains(Cell{2, 1}));
  EXPECT_FALSE(frame.contains(Cell{3, 1}));
  EXPECT_FALSE(frame.contains(Cell{0, -1}));
}

TEST(GridFrame, CoveringIsTheSmallestCover) {
  const GridFrame exact = GridFrame::covering({{-1.0, 0.0}, {1.0, 1.5}}, 0.5);
  EXPECT_EQ(exact, (GridFrame{.cell_size = 0.5, .lattice_min = {-2, 0}, .width = 4, .height = 3}));
  const GridFrame margin = GridFrame::covering({{-1.0, 0.0}, {1.0, 1.5}}, 0.5, 2);
  EXPECT_EQ(margin, (GridFrame{.cell_size = 0.5, .lattice_min = {-4, -2}, .width = 8, .height = 7}));
  const GridFrame room = GridFrame::covering({{0.0, 0.0}, {3.048, 3.6576}}, 0.1);
  EXPECT_EQ(room.width, 31);
  EXPECT_EQ(room.height, 37);
}

TEST(GridFrame, CoversARectangleWithinAMicron) {
  Rng rng({.seed = 22, .purpose = Purpose::kWorld});
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector2d low(rng.uniform(-50, 50), rng.uniform(-50, 50));
    const Rectangle area{low, low + Eigen::Vector2d(rng.uniform(0.01, 30), rng.uniform(0.01, 30))};
    const double cell = rng.uniform(0.05, 1.0);
    const GridFrame frame = GridFrame::covering(area, cell);
    const Eigen::Vector2d far = frame.origin() + cell * Eigen::Vector2d(frame.width, frame.height);
    EXPECT_TRUE((frame.origin().array() <= area.min.array() + 1e-9).all());
    EXPECT_TRUE((far.array() >= area.max.array() - 1.001e-6).all());
    EXPECT_TRUE(((frame.origin().array() + cell) > area.min.array()).all());
    EXPECT_TRUE(((far.array() - cell) < area.max.array()).all());
  }
}

TEST(GridFrame, RejectsACellWithoutSize) {
  EXPECT_THROW(GridFrame::covering({{0, 0}, {1, 1}}, 0.0), ContractViolation);
}

TEST(Grid, HoldsAValuePerCell) {
  Grid<int> grid({.cell_size = 1.0, .width = 3, .height = 2}, 7);
  grid[{2, 1}] = 9;
  EXPECT_EQ(grid.values(), (std::vector<int>{7, 7, 7, 7, 7, 9}));
  grid.reset({.cell_size = 1.0, .width = 2, .height = 1}, 4);
  EXPECT_EQ(grid.values(), (std::vector<int>{4, 4}));
}

}  // namespace
}  // namespace cogslam
