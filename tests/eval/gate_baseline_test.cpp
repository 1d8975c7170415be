#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eval/gate/baseline_file.hpp"
#include "eval/gate/gate_settings.hpp"
#include "tests/support/error_text.hpp"
#include "tests/support/short_scenario.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cogslam {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

GateMeasurement two_seeds() {
  return {.program = "cogslam 0.1.0",
          .scenario = "short",
          .settings = short_scenario().resolved,
          .map_hash = "1234567890123456",
          .first_seed = 5,
          .readings = {"1e5", "0123456789abcdef"},
          .figures = {{"og", 0.1, "path_mse_m2", {0.1 + 0.2, 1e-300}}, {"no \"plain\" name", 0.05, "bytes", {1, 2}}}};
}

TEST(GateBaseline, ReadsBackWhatItWrote) {
  const GateMeasurement m = two_seeds(), back = read_baseline(baseline_text(m), "b.yaml");
  EXPECT_EQ(baseline_text(back), baseline_text(m));
  EXPECT_EQ(back.settings, m.settings);
  EXPECT_EQ(back.map_hash, m.map_hash);
  EXPECT_EQ(back.readings, m.readings);
  EXPECT_EQ(back.first_seed, 5u);
  ASSERT_EQ(back.figures.size(), 2u);
  EXPECT_EQ(back.figures[0].values, m.figures[0].values) << "to the last bit";
  EXPECT_NE(back.find("no \"plain\" name", 0.05, "bytes"), nullptr);
  EXPECT_EQ(back.find("og", 0.2, "path_mse_m2"), nullptr);
}

TEST(GateBaseline, LeavesOutFiguresThatSomeSeedDidNotGive) {
  GateMeasurement m = two_seeds();
  m.figures[1] = {"og", 0.1, "grid_mse", {0.1}, 1};
  EXPECT_EQ(read_baseline(baseline_text(m), "b.yaml").figures.size(), 1u);
  m.figures.erase(m.figures.begin());
  EXPECT_THAT(read_baseline(baseline_text(m), "b.yaml").figures, IsEmpty());
}

TEST(GateBaseline, SaysWhatIsWrongWithAFile) {
  const auto complaint = [](const std::string& text) {
    return error_text([&] { (void)read_baseline(text, "b.yaml"); });
  };
  EXPECT_EQ(complaint("schema: 2\n"), "b.yaml:1:1: schema: expected 1, found 2: make the baseline anew with --update");
  EXPECT_EQ(complaint("schema: 1\nreadings: a\n"),
            "b.yaml:2:1: readings: expected a hash for each of at least two seeds");
  const std::string head = "schema: 1\nreadings: a b\nfigures:\n  - variant: og\n    metric: bytes\n    values: ";
  EXPECT_EQ(complaint(head + "[1, 2, 3]\n"), "b.yaml:6:5: values: expected one for each of 2 seeds, found 3");
  EXPECT_EQ(complaint(head + "[1, 0]\n"), "b.yaml:6:17: values: expected a number above 0, found '0'");
  EXPECT_EQ(complaint("schema: 1\nreadings: a b\nsede: 1\n"),
            "b.yaml:3:1: unknown key 'sede'; known here: schema, program, scenario, map_hash, first_seed, readings, "
            "figures, settings");
  std::string cut = baseline_text(two_seeds());
  cut.resize(cut.find("metric: bytes"));
  EXPECT_NE(complaint(cut), "");
}

TEST(GateBaseline, KnowsThatThereIsNone) {
  const TemporaryFolder folder;
  EXPECT_FALSE(load_baseline(folder.path() / "none.yaml"));
  EXPECT_FALSE(load_baseline(folder.path() / "no" / "folder.yaml"));
  EXPECT_TRUE(load_baseline(folder.file("there.yaml", baseline_text(two_seeds()))));
}

std::vector<std::string> texts(const std::vector<SettingChange>& changes) {
  std::vector<std::string> all;
  for (const SettingChange& change : changes) all.push_back(change.text());
  return all;
}

TEST(GateSettings, TellsTheTaskFromTheFilter) {
  const std::string before =
      "name: a\nseed: 1\nduration_s: 60\nsensors:\n  lidar:\n    rate_hz: 40\nslam:\n  particles: 100\nodometry:\n"
      "  source: visual\nvariants:\n  - name: og\nslammer: 1\n";
  const std::string after =
      "name: b\nseed: 2\nduration_s: 30\nsensors:\n  lidar:\n    rate_hz: 20\nslam:\n  particles: 50\nodometry:\n"
      "  source: wheel\nvariants:\n  - name: og2\nslammer: 2\n";
  const SettingChanges changes = setting_changes(before, after, "b.yaml");
  EXPECT_THAT(texts(changes.task),
              ElementsAre("duration_s: 60 -> 30", "sensors.lidar.rate_hz: 40 -> 20", "slammer: 1 -> 2"));
  EXPECT_THAT(texts(changes.filter), ElementsAre("odometry.source: visual -> wheel", "slam.particles: 100 -> 50",
                                                 "variants.0.name: og -> og2"));
  EXPECT_THAT(changes.known, IsEmpty());
}

TEST(GateSettings, TakesNewKeysForThoseOfANewVersionButNotItemsOfLists) {
  const std::string before = "old: 1\ndrive:\n  waypoints:\n    - x_m: 1\n";
  const std::string after = "drive:\n  waypoints:\n    - x_m: 1\n    - x_m: 2\nfaults:\n  late: 0\n";
  const SettingChanges changes = setting_changes(before, after, "b.yaml");
  EXPECT_THAT(texts(changes.task), ElementsAre("drive.waypoints.1.x_m: nothing -> 2"));
  EXPECT_THAT(texts(changes.known), ElementsAre("old: 1 -> nothing", "faults.late: nothing -> 0"));
}

TEST(GateSettings, FindsNoDifferenceWhereThereIsNone) {
  const std::string text = short_scenario().resolved;
  const SettingChanges changes = setting_changes(text, text, "b.yaml");
  EXPECT_THAT(changes.task, IsEmpty());
  EXPECT_THAT(changes.filter, IsEmpty());
}

}  // namespace
}  // namespace cogslam
