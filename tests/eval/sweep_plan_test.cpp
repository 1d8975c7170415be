#include "eval/sweep/plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "eval/scenario.hpp"
#include "tests/support/error_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cogslam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kRoom = R"(name: room
world: {kind: simple, start: {x_m: 0, y_m: -1.3, heading_deg: 0}}
drive: {waypoints: [{x_m: 1, y_m: -1.3}]}
sensors: {camera: {enabled: false}}
slam: {particles: 20, likelihood: {field_sigma_m: 0.01}}
)";

constexpr const char* kWorlds = "worlds: [{scenario: room.yaml}]\n";
constexpr const char* kOg = "  - {name: og, slam: {store: {kind: dense}}}\n";

/// Plans a sweep file that lies beside room.yaml.
class SweepPlanTest : public testing::Test {
 protected:
  SweepPlan plan(const std::string& text) { return load_sweep(write(text)); }
  std::string error(const std::string& text) {
    const std::filesystem::path file = write(text);
    const std::string message = error_text([&] { load_sweep(file); });
    const std::size_t at = message.find("sweep.yaml");
    return at == std::string::npos ? message : message.substr(at);
  }
  void write_room(const std::string& text) { room_ = folder_.file("room.yaml", text); }

 private:
  std::filesystem::path write(const std::string& text) { return folder_.file("sweep.yaml", text); }

  TemporaryFolder folder_;
  std::filesystem::path room_ = folder_.file("room.yaml", kRoom);
};

std::vector<std::string> variants_of(const SweepPlan& plan) {
  std::vector<std::string> names;
  for (const PlannedEpisode& episode : plan.episodes) {
    if (names.empty() || names.back() != episode.variant) names.push_back(episode.variant);
  }
  return names;
}

const PlannedEpisode& find(const SweepPlan& plan, const std::string& variant, std::uint32_t seed = 1) {
  for (const PlannedEpisode& episode : plan.episodes) {
    if (episode.variant == variant && episode.seed == seed) return episode;
  }
  throw std::runtime_error("no " + variant);
}

TEST_F(SweepPlanTest, TakesEveryCombinationOfWorldsCellSizesVariantsAndSeeds) {
  const SweepPlan all = plan(R"(
name: grid
seeds: {first: 5, count: 3}
worlds:
  - scenario: room.yaml
    each: [{key: robot.friction, label: _mu, values: [0.4, 0.7]}]
cell_sizes_m: [0.5, 0.2]
true_poses: false
variants:
  - {name: og, slam: {store: {kind: dense}}}
  - name: cog
    slam: {store: {kind: coefficients}}
    each: [{key: slam.store.percent_kept, values: [10, 40]}, {key: slam.store.recovery, words: fast_l2 pinv}]
)");
  EXPECT_EQ(all.name, "grid");
  EXPECT_EQ(all.episodes.size(), 2U * 2 * 5 * 3);
  std::set<std::string> keys, readings;
  for (const PlannedEpisode& episode : all.episodes) {
    keys.insert(episode.key);
    readings.insert(episode.readings_key);
  }
  EXPECT_EQ(keys.size(), all.episodes.size());
  EXPECT_EQ(readings.size(), 2U * 3) << "readings know neither cell size nor variant";
  EXPECT_EQ(all.episodes[0].world, "room_mu0.4");
  EXPECT_EQ(all.episodes[1].seed, 6U);
  EXPECT_EQ(all.episodes[3].variant, "cog_10_fast_l2");
  EXPECT_EQ(all.episodes[6].variant, "cog_10_pinv");
  EXPECT_EQ(all.episodes[15].cell_size, 0.2);
  EXPECT_EQ(all.episodes[30].world, "room_mu0.7");
}

TEST_F(SweepPlanTest, WritesScenariosThatStandForThemselves) {
  const SweepPlan all = plan(std::string(kWorlds) + "cell_sizes_m: [0.2]\nseeds: {count: 1}\nvariants:\n" + kOg +
                             "  - {name: cog, slam: {particles: 7, store: {kind: coefficients, percent_kept: 30}}}\n");
  const Scenario scenario =
      read_scenario(ConfigSection::parse(find(all, "cog_true_poses").scenario, "resolved"), "none");
  ASSERT_EQ(scenario.variants.size(), 2U);
  EXPECT_EQ(scenario.variants[0].name, "og_true_poses");
  EXPECT_EQ(scenario.variants[1].name, "cog_true_poses");
  EXPECT_TRUE(scenario.variants[1].true_poses);
  EXPECT_EQ(scenario.variants[1].slam.store.percent_kept, 30.0);
  EXPECT_EQ(scenario.variants[1].slam.particles, 7);
  EXPECT_EQ(scenario.variants[1].slam.cell_size, 0.2);
  EXPECT_EQ(scenario.variants[1].slam.likelihood.field.sigma, 0.01) << "from the scenario's own filter";
}

TEST_F(SweepPlanTest, ComparesWithTheDenseVariantOfAsManyParticles) {
  const SweepPlan all = plan(std::string(kWorlds) + R"(seeds: {count: 1}
variants:
  - {name: early, slam: {store: {kind: coefficients}}}
  - {name: og, slam: {store: {kind: dense}}}
  - {name: og_few, slam: {particles: 5, store: {kind: dense}}}
  - {name: cog_few, slam: {particles: 5, store: {kind: coefficients}}}
  - {name: cog_other, slam: {particles: 6, store: {kind: coefficients}}}
)");
  EXPECT_EQ(find(all, "early").baseline, "og");
  EXPECT_EQ(find(all, "og").baseline, "");
  EXPECT_EQ(find(all, "og_few").baseline, "og");
  EXPECT_EQ(find(all, "cog_few").baseline, "og_few");
  EXPECT_EQ(find(all, "cog_other").baseline, "og");
  EXPECT_EQ(find(all, "cog_few_true_poses").baseline, "og_true_poses");
  EXPECT_EQ(find(all, "cog_few").baseline_key, find(all, "og_few").own_key);
  EXPECT_THAT(variants_of(all), testing::SizeIs(10));
}

TEST_F(SweepPlanTest, GivesAnotherKeyToWhateverChangesTheScores) {
  const std::string head = "seeds: {count: 1}\nvariants:\n" + std::string(kOg);
  const std::string cog = "  - {name: cog, slam: {store: {kind: coefficients}}}\n";
  const SweepPlan first = plan(kWorlds + head + cog);
  EXPECT_EQ(find(plan(kWorlds + head + cog), "cog").key, find(first, "cog").key);

  const SweepPlan other_filter = plan(kWorlds + head + "  - {name: cog, slam: {store: {kind: tiles}}}\n");
  EXPECT_NE(find(other_filter, "cog").key, find(first, "cog").key);
  EXPECT_EQ(find(other_filter, "cog").readings_key, find(first, "cog").readings_key);
  EXPECT_EQ(find(other_filter, "og").key, find(first, "og").key) << "it is the same as before";

  const SweepPlan other_baseline = plan(std::string(kWorlds) +
                                        "seeds: {count: 1}\nvariants:\n"
                                        "  - {name: og, slam: {store: {kind: dense}, compass: {noise_deg: 3}}}\n" +
                                        cog);
  EXPECT_NE(find(other_baseline, "cog").key, find(first, "cog").key) << "compared with something else";

  const SweepPlan other_drive =
      plan("worlds: [{scenario: room.yaml, set: [{key: duration_s, value: 9}]}]\n" + head + cog);
  EXPECT_NE(find(other_drive, "cog").readings_key, find(first, "cog").readings_key);
  EXPECT_NE(find(other_drive, "cog").key, find(first, "cog").key);
  write_room(std::string(kRoom) + "map: {margin_m: 0.5}\n");
  const SweepPlan other_map = plan(kWorlds + head + cog);
  EXPECT_NE(find(other_map, "cog").key, find(first, "cog").key);
  EXPECT_EQ(find(other_map, "cog").readings_key, find(first, "cog").readings_key);
}

TEST_F(SweepPlanTest, SaysWhatIsWrongAndWhere) {
  const std::string variants = "variants:\n" + std::string(kOg);
  EXPECT_EQ(error("seed: {count: 3}\n" + std::string(kWorlds) + variants),
            "sweep.yaml:1:1: unknown key 'seed'; did you mean 'seeds'?");
  EXPECT_EQ(error("worlds: []\n" + variants), "sweep.yaml:1:1: worlds: expected at least one `- scenario: FILE`");
  EXPECT_EQ(error(kWorlds), "sweep.yaml:1:1: variants: expected at least one");
  EXPECT_EQ(error(kWorlds + variants + kOg), "sweep.yaml:4:6: a second one called 'og', expected a name of its own");
  EXPECT_THAT(error("worlds: [{scenario: attic.yaml}]\n" + variants), HasSubstr("attic.yaml"));
  EXPECT_EQ(error("worlds: [{scenario: room.yaml, sett: []}]\n" + variants),
            "sweep.yaml:1:32: unknown key 'sett'; did you mean 'set'?");
  EXPECT_EQ(error(std::string(kWorlds) + "variants: [{name: cog, slam: {stor: {kind: tiles}}}]\n"),
            "sweep.yaml:2:31: unknown key 'stor'; did you mean 'store'?");
}

TEST_F(SweepPlanTest, SaysWhatIsWrongInAnAxis) {
  const auto with_axis = [&](const std::string& axis) {
    return error(std::string(kWorlds) +
                 "variants:\n  - name: cog\n    slam: {store: {kind: coefficients}}\n    each: [" + axis + "]\n");
  };
  EXPECT_EQ(with_axis("{key: slam.store.percent, values: [3]}"),
            "sweep.yaml:5:13: each slam.store.percent=3: unknown key 'percent'; did you mean 'percent_kept'?");
  EXPECT_THAT(with_axis("{key: slam.store.percent_kept, values: [10, 300]}"),
              HasSubstr("sweep.yaml:5:13: each slam.store.percent_kept=300: percent_kept: expected a number"));
  EXPECT_EQ(with_axis("{key: slam.particles}"),
            "sweep.yaml:5:13: slam.particles: expected either `values: [1, 2, ...]` or `words: one two ...`");
  EXPECT_EQ(with_axis("{key: slam.particles, values: [5], wrds: a}"),
            "sweep.yaml:5:47: unknown key 'wrds'; did you mean 'words'?");
}

}  // namespace
}  // namespace cogslam
