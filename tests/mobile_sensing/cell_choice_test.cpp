#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "slam/mobile_sensing/field_recovery.hpp"
#include "slam/mobile_sensing/nearest_sample.hpp"
#include "slam/mobile_sensing/ray_cells.hpp"
#include "slam/mobile_sensing/uncertain_cells.hpp"
#include "tests/support/error_text.hpp"

namespace cogslam {
namespace {

constexpr int kSide = 40;

/// A room whose walls are one cell thick, divided by another one with a door.
double room(std::uint32_t cell) {
  const int x = static_cast<int>(cell) % kSide, y = static_cast<int>(cell) / kSide;
  const bool wall = x == 0 || y == 0 || x == kSide - 1 || y == kSide - 1 || (x == 17 && (y < 18 || y > 22));
  return wall ? 1.0 : 0.0;
}

double error_of(const CellSamples& samples) {
  const std::vector<double> field = recover_field({}, samples).field;
  double sum = 0.0;
  for (std::uint32_t i = 0; i < field.size(); ++i) sum += std::pow(field[i] - room(i), 2);
  return std::sqrt(sum);
}

void expect_samples_of_room(const CellSamples& samples, std::size_t count) {
  EXPECT_EQ(samples.cells.size(), count);
  EXPECT_EQ(std::set<std::uint32_t>(samples.cells.begin(), samples.cells.end()).size(), count) << "a cell came twice";
  ASSERT_EQ(samples.values.size(), count);
  for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(samples.values[i], room(samples.cells[i]));
}

TEST(NearestSamples, EqualTheNearestOfAll) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const CellSamples samples = sense_random_cells(17, 9, 1 + 3 * seed, seed, [](std::uint32_t) { return 0.0; });
    const NearestSamples nearest = nearest_samples(samples);
    const auto distance = [&](std::uint32_t a, std::uint32_t b) {
      return std::hypot(static_cast<int>(a % 17) - static_cast<int>(b % 17),
                        static_cast<int>(a / 17) - static_cast<int>(b / 17));
    };
    for (std::uint32_t i = 0; i < samples.field_size(); ++i) {
      double least = HUGE_VAL;
      for (const std::uint32_t cell : samples.cells) least = std::min(least, distance(i, cell));
      EXPECT_NEAR(nearest.distance[i], least, 1e-12);
      EXPECT_NEAR(distance(i, samples.cells[nearest.sample[i]]), least, 1e-12);
    }
  }
}

TEST(UncertainCells, AreDistinctAndBeginAsRandomOnes) {
  for (const std::size_t count : {1, 7, 200, kSide * kSide}) {
    const CellSamples samples = sense_uncertain_cells({}, kSide, kSide, count, 3, room);
    expect_samples_of_room(samples, count);
    const CellSamples random = sense_random_cells(kSide, kSide, (count + 3) / 4, 3, room);
    EXPECT_TRUE(std::equal(random.cells.begin(), random.cells.end(), samples.cells.begin()));
  }
}

TEST(UncertainCells, AreTheSameAgainAndOthersForAnotherSeed) {
  const CellSamples samples = sense_uncertain_cells({}, kSide, kSide, 200, 3, room);
  EXPECT_EQ(samples.cells, sense_uncertain_cells({}, kSide, kSide, 200, 3, room).cells);
  EXPECT_NE(samples.cells, sense_uncertain_cells({}, kSide, kSide, 200, 4, room).cells);
}

TEST(UncertainCells, RecoverMoreThanAsManyRandomOnes) {
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    EXPECT_LT(error_of(sense_uncertain_cells({}, kSide, kSide, 400, seed, room)),
              0.8 * error_of(sense_random_cells(kSide, kSide, 400, seed, room)));
  }
}

// A field that is constant but for one cell, met by the random ones: its neighbours are looked at first.
TEST(UncertainCells, LookBesideWhatStandsOut) {
  const std::uint32_t odd = sense_random_cells(20, 20, 10, 5, room).cells[2];
  const auto sensor = [odd](std::uint32_t cell) { return cell == odd ? 1.0 : 0.0; };
  const CellSamples samples = sense_uncertain_cells({.edge_share = 1.0, .rounds = 1}, 20, 20, 40, 5, sensor);
  for (const std::uint32_t neighbour : {odd - 1, odd + 1, odd - 20, odd + 20}) {
    EXPECT_THAT(samples.cells, testing::Contains(neighbour));
  }
}

TEST(UncertainCells, HalveTheDistanceBetweenSamplesThatDisagree) {
  const auto step = [](std::uint32_t cell) { return cell < 437 ? 0.0 : 1.0; };  // a border in a row of cells
  const CellSamples samples = sense_uncertain_cells({.edge_share = 0.0, .rounds = 30}, 1000, 1, 40, 1, step);
  EXPECT_THAT(samples.cells, testing::IsSupersetOf({436U, 437U})) << "found among 1000 cells with 40 samples";
}

// Stripes 50 cells wide, 40 random samples: of all pairs of neighbours that disagree the farthest apart comes first.
TEST(UncertainCells, ComeFirstBetweenTheFarthestSamplesThatDisagree) {
  const auto stripes = [](std::uint32_t cell) { return cell / 50 % 2 == 0 ? 0.0 : 1.0; };
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    std::vector<std::uint32_t> known = sense_random_cells(1000, 1, 40, seed, stripes).cells;
    const UncertainCells plan{.random_share = 40.0 / 41.0, .edge_share = 0.0, .rounds = 1};
    const std::uint32_t chosen = sense_uncertain_cells(plan, 1000, 1, 41, seed, stripes).cells.back();
    std::ranges::sort(known);
    std::uint32_t widest = 0, around = 0;
    for (std::size_t i = 1; i < known.size(); ++i) {
      if (stripes(known[i]) == stripes(known[i - 1])) continue;
      const std::uint32_t gap = known[i] - known[i - 1];
      widest = std::max(widest, gap);
      if (known[i - 1] < chosen && chosen < known[i]) around = gap;
    }
    EXPECT_GE(around + 1, widest) << "seed " << seed;  // halves of even and odd gaps tie
  }
}

TEST(RayCells, AreDistinctSeenCellsRichInWalls) {
  const CellSamples samples = sense_ray_cells({}, kSide, kSide, 200, 1, room);
  expect_samples_of_room(samples, 200);
  EXPECT_GT(std::count(samples.values.begin(), samples.values.end(), 1.0), 60) << "12 % of all cells are walls";
  EXPECT_EQ(samples.cells, sense_ray_cells({}, kSide, kSide, 200, 1, room).cells);
}

TEST(RayCells, SayWhenTooFewCellsAreSeen) {
  const auto closed = [](std::uint32_t cell) { return cell == 12 ? 0.0 : 1.0; };
  EXPECT_EQ(error_text([&] { static_cast<void>(sense_ray_cells({}, 5, 5, 12, 1, closed)); }),
            "rays met only 5 different cells, fewer than the 12 asked for");
}

}  // namespace
}  // namespace cogslam
