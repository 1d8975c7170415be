#include "eval/gate/gate_config.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cogslam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

GateConfig parsed(const std::string& text) { return read_gate_config(ConfigSection::parse(text, "gate.yaml")); }

std::string complaint(const std::string& text) {
  return error_text([&] { (void)parsed(text); });
}

TEST(GateConfig, ReadsItsFile) {
  const GateConfig config = parsed(R"(
baselines: there
seeds: 7
baseline_seeds: 30
false_alarm: 0.001
power: 0.9
scenarios:
  - {file: simple.yaml}
  - file: simple.yaml
    name: simple_30s
    set: [{key: duration_s, value: 30}, {key: slam.cell_sizes_m, value: "[0.1, 0.2]"}]
    variants: [{name: og}]
metrics:
  - {name: path_mse_m2, poses: estimated, tolerance_percent: 3, effect_percent: 20}
)");
  EXPECT_EQ(config.baselines, "there");
  EXPECT_EQ(config.seeds, 7);
  EXPECT_EQ(config.baseline_seeds, 30);
  EXPECT_EQ(config.false_alarm, 0.001);
  EXPECT_EQ(config.power, 0.9);
  ASSERT_EQ(config.scenarios.size(), 2u);
  EXPECT_EQ(config.scenarios[0].name, "simple");
  EXPECT_EQ(baseline_file(config, config.scenarios[1]), "there/simple_30s.yaml");
  EXPECT_THAT(config.scenarios[1].settings,
              ElementsAre(testing::Pair("duration_s", "30"), testing::Pair("slam.cell_sizes_m", "[0.1, 0.2]")));
  EXPECT_THAT(config.scenarios[1].variants, ElementsAre("og"));
  ASSERT_EQ(config.demands.size(), 1u);
  EXPECT_EQ(config.demands[0].poses, GatePoses::kEstimated);
  EXPECT_DOUBLE_EQ(config.demands[0].tolerance, 0.03);
  EXPECT_DOUBLE_EQ(config.demands[0].effect, 0.2);
}

TEST(GateConfig, AsksForPathMapAndBytesWhereTheFileDoesNotSay) {
  const GateConfig config = parsed("scenarios: [{file: a.yaml}]");
  std::vector<std::string> metrics;
  for (const GateDemand& demand : config.demands) metrics.push_back(demand.metric);
  EXPECT_THAT(metrics, ElementsAre("path_mse_m2", "grid_mse", "bytes"));
}

TEST(GateConfig, SaysWhatIsWrongWithAFile) {
  EXPECT_EQ(complaint("seeds: 5"), "gate.yaml:1:1: scenarios: expected at least one, as in - {file: ../simple.yaml}");
  EXPECT_THAT(complaint("scenarios: [{nmae: a}]"), HasSubstr("expected the name of a scenario file, found nothing"));
  EXPECT_THAT(complaint("scenarios: [{file: a.yaml}, {file: b/a.yaml}]"),
              HasSubstr("a second scenario called 'a', expected a name of its own"));
  EXPECT_THAT(complaint("scenarios: [{file: a.yaml, name: ../x}]"), HasSubstr("expected letters, digits"));
  EXPECT_THAT(complaint("seeds: 1\nscenarios: [{file: a.yaml}]"), HasSubstr("gate.yaml:1:8: seeds: expected a whole"));
  const std::string head = "scenarios: [{file: a.yaml}]\nmetrics: [{name: ";
  EXPECT_THAT(complaint(head + "path_mse_m}]"), HasSubstr("unknown metric 'path_mse_m'; did you mean 'path_mse_m2'?"));
  EXPECT_THAT(complaint(head + "beauty}]"), HasSubstr("unknown metric 'beauty'; expected one of path_mse_m2, "));
  EXPECT_THAT(complaint(head + "bytes, tolerance_percent: 5, effect_percent: 5}]"),
              HasSubstr("expected more than tolerance_percent, which passes"));
  EXPECT_THAT(complaint(head + "bytes, tolerance: 5}]"), HasSubstr("unknown key 'tolerance'"));
}

TEST(GateConfig, KeepsBaselinesBesideTheGateFileUnlessToldOtherwise) {
  const TemporaryFolder folder;
  const auto plain = load_gate_config(folder.file("a.yaml", "scenarios: [{file: s.yaml}]\n"));
  EXPECT_EQ(plain.baselines, folder.path() / "baselines");
  EXPECT_EQ(plain.scenarios[0].file, folder.path() / "s.yaml");
  const auto told = load_gate_config(folder.file("b.yaml", "baselines: ../x\nscenarios: [{file: s.yaml}]\n"));
  EXPECT_EQ(told.baselines, folder.path() / "../x");
}

TEST(GateConfig, ChoosesVariantsAndKnowsWhichADemandSpeaksOf) {
  GateScenario gate{.name = "s", .file = COGSLAM_SOURCE_DIR "/scenarios/simple.yaml"};
  gate.settings = {{"duration_s", "3"}, {"slam.cell_sizes_m", "[0.5]"}};
  EXPECT_EQ(load_gate_scenario(gate).variants.size(), 4u);
  gate.variants = {"og_true_poses", "cog40"};
  const Scenario scenario = load_gate_scenario(gate, {{"slam.particles", "3"}});
  ASSERT_EQ(scenario.variants.size(), 2u);
  EXPECT_EQ(scenario.variants[0].slam.particles, 3);
  const VariantConfig &filter = scenario.variants[0], &mapper = scenario.variants[1];
  EXPECT_TRUE(mapper.true_poses);
  EXPECT_TRUE(applies({.metric = "path_mse_m2"}, filter));
  EXPECT_FALSE(applies({.metric = "path_mse_m2"}, mapper)) << "its path was told";
  EXPECT_TRUE(applies({.metric = "bytes"}, mapper));
  EXPECT_FALSE(applies({.metric = "grid_mse", .poses = GatePoses::kTrue}, filter));
  EXPECT_FALSE(applies({.metric = "grid_mse", .poses = GatePoses::kEstimated}, mapper));
  gate.variants = {"cog41"};
  EXPECT_THAT(error_text([&] { (void)load_gate_scenario(gate); }),
              HasSubstr("simple.yaml: no variant 'cog41', which the gate file names"));
}

}  // namespace
}  // namespace cogslam
