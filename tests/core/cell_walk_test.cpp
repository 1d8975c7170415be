#include "core/cell_walk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/rng.hpp"
#include "tests/support/touched_cells.hpp"

namespace cogslam {

inline void PrintTo(const Cell& c, std::ostream* out) { *out << "(" << c.x << ", " << c.y << ")"; }

namespace {

using testing::ElementsAre;

std::vector<Cell> walked(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  std::vector<Cell> cells;
  walk_cells(from, to, [&](Cell c) {
    cells.push_back(c);
    return true;
  });
  return cells;
}

Eigen::Vector2d random_point(Rng& rng) { return {rng.uniform(-30, 30), rng.uniform(-30, 30)}; }

TEST(CellWalk, VisitsBothEndCells) {
  EXPECT_THAT(walked({0.5, 0.5}, {2.5, 0.5}), ElementsAre(Cell{0, 0}, Cell{1, 0}, Cell{2, 0}));
  EXPECT_THAT(walked({0.5, 0.5}, {0.5, -1.5}), ElementsAre(Cell{0, 0}, Cell{0, -1}, Cell{0, -2}));
  EXPECT_THAT(walked({0.2, 0.3}, {0.2, 0.3}), ElementsAre(Cell{0, 0}));
}

TEST(CellWalk, StepsInXFirstThroughACorner) {
  EXPECT_THAT(walked({0.5, 0.5}, {1.5, 1.5}), ElementsAre(Cell{0, 0}, Cell{1, 0}, Cell{1, 1}));
}

TEST(CellWalk, StartsOnABorderInTheCellThatOwnsIt) {
  EXPECT_THAT(walked({1.0, 0.5}, {-0.5, 0.5}), ElementsAre(Cell{1, 0}, Cell{0, 0}, Cell{-1, 0}));
  EXPECT_THAT(walked({1.0, 0.5}, {2.0, 0.5}), ElementsAre(Cell{1, 0}, Cell{2, 0}));
}

TEST(CellWalk, StopsWhenToldTo) {
  int visits = 0;
  walk_cells({0.5, 0.5}, {9.5, 3.5}, [&](Cell) { return ++visits < 3; });
  EXPECT_EQ(visits, 3);
}

TEST(CellWalk, VisitsEveryCellThatTheSegmentRunsThroughAndNoOther) {
  Rng rng({.seed = 30, .purpose = Purpose::kWorld});
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d from = random_point(rng), to = random_point(rng);
    const std::vector<Cell> cells = walked(from, to);
    for (const Cell& c : touched_cells(from, to, 1e-9)) {
      ASSERT_NE(std::find(cells.begin(), cells.end(), c), cells.end()) << from.transpose() << " to " << to.transpose();
    }
    for (const Cell& c : cells) ASSERT_GE(length_inside(from, to, c, 1e-9), 0.0);
  }
}

TEST(CellWalk, TakesOneStepPerBorder) {
  Rng rng({.seed = 31, .purpose = Purpose::kWorld});
  for (int i = 0; i < 2000; ++i) {
    // Every other segment runs along borders and through corners.
    const bool whole = i % 2 == 0;
    Eigen::Vector2d from = random_point(rng), to = random_point(rng);
    if (whole) from = from.array().round(), to = to.array().round();
    const std::vector<Cell> cells = walked(from, to);
    const Cell last{static_cast<int>(std::floor(to.x())), static_cast<int>(std::floor(to.y()))};
    ASSERT_EQ(cells.back(), last);
    const auto borders = std::abs(cells.back().x - cells.front().x) + std::abs(cells.back().y - cells.front().y);
    ASSERT_EQ(cells.size(), static_cast<std::size_t>(borders) + 1);
    for (std::size_t k = 1; k < cells.size(); ++k) {
      ASSERT_EQ(std::abs(cells[k].x - cells[k - 1].x) + std::abs(cells[k].y - cells[k - 1].y), 1);
    }
  }
}

TEST(CellWalk, IsTheSameWalkBackwards) {
  Rng rng({.seed = 32, .purpose = Purpose::kWorld});
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d from = random_point(rng), to = random_point(rng);
    std::vector<Cell> back = walked(to, from);
    std::reverse(back.begin(), back.end());
    ASSERT_EQ(walked(from, to), back) << from.transpose() << " to " << to.transpose();
  }
}

}  // namespace
}  // namespace cogslam
