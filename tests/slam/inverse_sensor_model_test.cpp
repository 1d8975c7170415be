#include "slam/map/inverse_sensor_model.hpp"

#include <gmock/gmock.h>

#include "core/rng.hpp"
#include "tests/support/drawn_grid.hpp"
#include "tests/support/slow_map_update.hpp"

namespace cogslam {
namespace {

using slow::Verdict;
using testing::ElementsAre;

Rng test_rng(std::uint32_t entity) { return Rng({.seed = 41, .purpose = Purpose::kWorld, .entity = entity}); }

Beam beam_between(const Eigen::Vector2d& origin, const Eigen::Vector2d& end, bool hit) {
  return {.origin = origin, .end = end, .range = static_cast<float>((end - origin).norm()), .hit = hit};
}

std::vector<Beam> random_sweep(Rng& rng, int beams, double reach) {
  std::vector<Beam> sweep;
  for (int i = 0; i < beams; ++i) {
    const Eigen::Vector2d origin(rng.uniform(-0.2, 0.2), rng.uniform(-0.2, 0.2));
    const Eigen::Vector2d end(rng.uniform(-reach, reach), rng.uniform(-reach, reach));
    sweep.push_back(beam_between(origin, end, rng.uniform() < 0.7));
  }
  return sweep;
}

/// Runs a sweep over an empty grid of 8 x 5 cells of 1 m and draws the result.
std::vector<std::string> drawn(const std::vector<Beam>& sweep, const LogOddsModel& model) {
  Grid<float> grid(GridFrame{.cell_size = 1.0, .width = 8, .height = 5});
  MapUpdater().integrate(sweep, Pose2{}, model, grid);
  return drawing_of(grid);
}

TEST(MapUpdater, DrawsOneBeamWithItsHitAtTheEnd) {
  EXPECT_THAT(drawn({beam_between({0.5, 2.5}, {6.5, 2.5}, true)}, {}),
              ElementsAre("        ",  //
                          "        ",  //
                          "......# ",  //
                          "        ",  //
                          "        "));
}

TEST(MapUpdater, FreesTheLastCellTooWhereNothingWasHit) {
  EXPECT_THAT(drawn({beam_between({0.5, 0.4}, {2.6, 2.5}, false)}, {}),
              ElementsAre("        ",  //
                          "        ",  //
                          "  .     ",  //
                          " ..     ",  //
                          "..      "));
}

TEST(MapUpdater, LetsAHitBeatAMissThatComesLaterOrEarlier) {
  const Beam across = beam_between({0.5, 2.5}, {6.5, 2.5}, true);
  const Beam down = beam_between({4.5, 4.5}, {4.5, 2.5}, true);  // ends on the way of `across`
  for (const auto& sweep : {std::vector{across, down}, std::vector{down, across}}) {
    EXPECT_THAT(drawn(sweep, {}), ElementsAre("    .   ",  //
                                              "    .   ",  //
                                              "....#.# ",  //
                                              "        ",  //
                                              "        "));
  }
}

TEST(MapUpdater, LetsTheLastBeamWinByOption) {
  const LogOddsModel as_printed{.rule = CellRule::kLastBeam};
  const Beam across = beam_between({0.5, 2.5}, {6.5, 2.5}, true);
  const Beam down = beam_between({4.5, 4.5}, {4.5, 2.5}, true);
  EXPECT_EQ(drawn({down, across}, as_printed)[2], "......# ");
  EXPECT_EQ(drawn({across, down}, as_printed)[2], "....#.# ");
}

TEST(MapUpdater, ChangesACellOnceHoweverManyBeamsMeetInIt) {
  for (const CellRule rule : {CellRule::kHitBeatsMiss, CellRule::kLastBeam}) {
    Grid<float> grid(GridFrame{.cell_size = 1.0, .width = 3, .height = 1});
    MapUpdater().integrate(std::vector<Beam>(50, beam_between({0.5, 0.5}, {2.5, 0.5}, true)), Pose2{},
                           LogOddsModel{.hit = 0.75F, .free = -0.25F, .rule = rule}, grid);
    EXPECT_THAT(grid.values(), ElementsAre(-0.25F, -0.25F, 0.75F));
  }
}

TEST(MapUpdater, ClampsOrDoesNot) {
  Grid<float> clamped(GridFrame{.cell_size = 1.0, .width = 2, .height = 1}), unclamped = clamped;
  const std::vector<Beam> sweep{beam_between({0.5, 0.5}, {1.5, 0.5}, true)};
  MapUpdater updater;
  const LogOddsModel model{.hit = 0.5F, .free = -0.5F, .min = -2.0F, .max = 3.25F};
  LogOddsModel unbounded = model;
  unbounded.clamped = false;
  for (int i = 0; i < 100; ++i) {
    updater.integrate(sweep, Pose2{}, model, clamped);
    updater.integrate(sweep, Pose2{}, unbounded, unclamped);
  }
  EXPECT_THAT(clamped.values(), ElementsAre(-2.0F, 3.25F));
  EXPECT_THAT(unclamped.values(), ElementsAre(-50.0F, 50.0F));
}

TEST(MapUpdater, SaysNothingOfAnEmptySweep) {
  Grid<float> grid(GridFrame{.cell_size = 1.0, .width = 2, .height = 2}, 1.0F);
  EXPECT_TRUE(MapUpdater().integrate({}, Pose2{}, {}, grid).empty());
  EXPECT_THAT(grid.values(), testing::Each(1.0F));
}

TEST(MapUpdater, EqualsAlgorithm4OverRandomSweepsPosesAndCellSizes) {
  MapUpdater updater;  // one for all, so that marks of earlier calls and other frames must not be seen
  std::size_t unclear = 0, compared = 0;
  for (std::uint32_t round = 0; round < 300; ++round) {
    Rng rng = test_rng(round);
    const double cell_size = std::array{0.05, 0.1, 0.2, 0.5, 1.0}[rng.below(5)];
    const double reach = 12.0 * cell_size;
    const Pose2 T_map_base{rng.uniform(-3.0, 3.0), rng.uniform(-3.0, 3.0), rng.uniform(-3.1, 3.1)};
    // The frame lies off the middle and is too small for the sweep: cells outside are left out.
    const Cell middle = GridFrame{.cell_size = cell_size}.cell_of(T_map_base.position());
    const GridFrame frame{.cell_size = cell_size,
                          .lattice_min = {middle.x - static_cast<int>(rng.below(20)), middle.y - 9},
                          .width = 1 + static_cast<int>(rng.below(25)),
                          .height = 1 + static_cast<int>(rng.below(25))};
    const LogOddsModel model{.clamped = rng.below(2) == 0,
                             .rule = rng.below(2) == 0 ? CellRule::kHitBeatsMiss : CellRule::kLastBeam};
    const std::vector<Beam> sweep = random_sweep(rng, static_cast<int>(rng.below(30)), reach);
    Grid<float> before(frame);
    for (float& value : before.values()) value = static_cast<float>(rng.uniform(-2.0, 3.2));

    Grid<float> after = before;
    const CellWindow changed = updater.integrate(sweep, T_map_base, model, after);
    const Grid<Verdict> alpha = slow::alpha_of_sweep(sweep, T_map_base, model.rule, frame);
    CellWindow touched;
    bool all_clear = true;
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        const Cell c{x, y};
        if (alpha[c] == Verdict::kUnclear) {
          ++unclear;
          all_clear = false;
          continue;
        }
        ++compared;
        const float expected = alpha[c] == Verdict::kUntouched
                                   ? before[c]
                                   : model.after(before[c], alpha[c] == Verdict::kHit ? model.hit : model.free);
        ASSERT_EQ(after[c], expected) << "round " << round << " cell " << x << " " << y;
        if (alpha[c] != Verdict::kUntouched) touched.include({frame.lattice_min.x + x, frame.lattice_min.y + y});
      }
    }
    if (all_clear) {
      EXPECT_EQ(changed, touched) << "round " << round;
    }
  }
  EXPECT_LT(unclear, compared / 1000);
}

TEST(MapUpdater, DoesNotDependOnWhereTheWindowBegins) {
  // Points on cell borders: rounding must put them on the same side in every window, or stores would disagree.
  for (std::uint32_t round = 0; round < 300; ++round) {
    Rng rng = test_rng(1000 + round);
    const double cell_size = std::array{0.05, 0.1, 0.2}[rng.below(3)];
    const auto on_border = [&] { return (static_cast<int>(rng.below(41)) - 20) * cell_size; };
    std::vector<Beam> sweep;
    for (int i = 0; i < 10; ++i) {
      const Eigen::Vector2d origin(on_border(), on_border()), end(on_border(), on_border());
      sweep.push_back(beam_between(origin, end, rng.below(2) == 0));
    }
    const Pose2 T_map_base{on_border(), on_border(), 0.0};
    const CellWindow window = window_of(sweep, T_map_base, cell_size);
    Grid<float> tight(window.frame(cell_size)), wide(window.grown(17).frame(cell_size));
    const CellWindow changed = MapUpdater().integrate(sweep, T_map_base, {}, tight);
    ASSERT_EQ(MapUpdater().integrate(sweep, T_map_base, {}, wide), changed) << "round " << round;
    for (int y = 0; y < tight.frame().height; ++y) {
      for (int x = 0; x < tight.frame().width; ++x) {
        ASSERT_EQ((tight[{x, y}]), (wide[{x + 17, y + 17}])) << "round " << round;
      }
    }
  }
}

TEST(WindowOfSweep, HoldsEveryCellThatASweepTouches) {
  for (std::uint32_t round = 0; round < 200; ++round) {
    Rng rng = test_rng(2000 + round);
    const std::vector<Beam> sweep = random_sweep(rng, 1 + static_cast<int>(rng.below(20)), 2.0);
    const Pose2 T_map_base{rng.uniform(-3.0, 3.0), rng.uniform(-3.0, 3.0), rng.uniform(-3.1, 3.1)};
    const CellWindow window = window_of(sweep, T_map_base, 0.1);
    Grid<float> wide(window.grown(5).frame(0.1));
    EXPECT_TRUE(window.contains(MapUpdater().integrate(sweep, T_map_base, {}, wide)));
  }
  EXPECT_TRUE(window_of({}, Pose2{}, 0.1).empty());
}

TEST(MapUpdater, ChangesLevelsAsTheLogOddsTheyStandFor) {
  const LatticeModel lattice = lattice_model(LogOddsModel{}, 0.4);
  for (std::uint32_t round = 0; round < 20; ++round) {
    Rng rng({.seed = 73, .purpose = Purpose::kWorld, .entity = round});
    const GridFrame frame{.cell_size = 0.1, .lattice_min = {-30, -30}, .width = 60, .height = 60};
    Grid<float> log_odds(frame);
    Grid<std::int8_t> levels(frame);
    MapUpdater for_floats, for_levels;
    for (int scan = 0; scan < 15; ++scan) {
      std::vector<Beam> sweep;
      for (int b = 0; b < 20; ++b) {
        sweep.push_back(beam_between({0.0, 0.0}, {rng.uniform(-3.5, 3.5), rng.uniform(-3.5, 3.5)}, rng.below(3) > 0));
      }
      const Pose2 T_map_base{rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0), rng.uniform(-3.0, 3.0)};
      ASSERT_EQ(for_floats.integrate(sweep, T_map_base, LogOddsModel{}, log_odds),
                for_levels.integrate(sweep, T_map_base, lattice, levels));
    }
    for (std::size_t i = 0; i < levels.values().size(); ++i) {
      ASSERT_NEAR(log_odds.values()[i], log_odds_of(levels.values()[i], 0.4), 1e-5) << "round " << round;
    }
  }
}

}  // namespace
}  // namespace cogslam
