#include "slam/map/lattice.hpp"

#include <gmock/gmock.h>

namespace cogslam {
namespace {

TEST(Lattice, TakesTheUsualModelInLevels) {
  const LatticeModel levels = lattice_model({}, 0.4);
  EXPECT_EQ(levels.hit, 2);
  EXPECT_EQ(levels.free, -1);
  EXPECT_EQ(levels.min, -5);
  EXPECT_EQ(levels.max, 8);
}

TEST(Lattice, FollowsTheFloatModelCellByCell) {
  const LogOddsModel floats;
  for (const double unit : {0.4, 0.05}) {
    const LatticeModel levels = lattice_model(floats, unit);
    float value = 0.0F;
    std::int8_t level = 0;
    for (int step = 0; step < 200; ++step) {
      const bool hit = step % 7 < 2 || step > 150;
      value = floats.after(value, hit ? floats.hit : floats.free);
      level = levels.after(level, hit ? levels.hit : levels.free);
      ASSERT_NEAR(log_odds_of(level, unit), value, 1e-4F) << step;
      ASSERT_EQ(level_of(value, unit), level);
    }
  }
}

TEST(Lattice, GivesEveryLevelBackFromItsLogOdds) {
  for (int level = -127; level <= 127; ++level) {
    for (const double unit : {0.4, 0.05, 0.013}) {
      EXPECT_EQ(level_of(log_odds_of(static_cast<std::int8_t>(level), unit), unit), level);
    }
  }
}

TEST(Lattice, NamesTheKeyThatIsOffIt) {
  const auto key_of = [](const LogOddsModel& model, double unit) {
    const auto trouble = lattice_trouble(model, unit);
    return trouble ? trouble->key : "";
  };
  EXPECT_EQ(key_of({}, 0.4), "");
  EXPECT_EQ(key_of({.hit = 0.7F}, 0.4), "hit");
  EXPECT_EQ(key_of({.free = -0.5F}, 0.4), "free");
  EXPECT_EQ(key_of({.min = -2.1F}, 0.4), "min");
  EXPECT_EQ(key_of({.max = 3.0F}, 0.4), "max");
  EXPECT_EQ(key_of({.clamped = false}, 0.4), "clamped");
  EXPECT_EQ(key_of({}, 0.02), "max");  // 160 levels
  EXPECT_EQ(lattice_trouble({.hit = 0.7F}, 0.4)->message,
            "expected a multiple of the store's lattice_unit 0.4, found 0.7");
}

}  // namespace
}  // namespace cogslam
