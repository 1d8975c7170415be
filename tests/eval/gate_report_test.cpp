#include "eval/gate/gate_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/rng.hpp"
#include "eval/gate/gate_output.hpp"
#include "tests/support/short_scenario.hpp"

namespace cogslam {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double kFalseAlarm = 0.001;

GateConfig config() {
  return {.demands = {{"path_mse_m2", GatePoses::kEstimated, 0.02, 0.25},
                      {"grid_mse", GatePoses::kTrue, 0.01, 0.05},
                      {"bytes", GatePoses::kAny, 0.01, 0.05}}};
}

/// Of the scenario with two seeds' worth of cells: path near 3e-4, map near 0.013, bytes near 8000, as measured.
GateMeasurement measured(std::uint32_t first_seed, std::size_t seeds) {
  GateMeasurement m{.program = "cogslam 1", .scenario = "short", .settings = short_scenario().resolved};
  m.first_seed = first_seed;
  for (std::size_t i = 0; i < seeds; ++i) m.readings.push_back(std::to_string(first_seed + i));
  for (const VariantConfig& variant : short_scenario().variants) {
    for (const GateDemand& demand : config().demands) {
      if (!applies(demand, variant)) continue;
      const bool path = demand.metric == "path_mse_m2", bytes = demand.metric == "bytes";
      GateFigure figure{variant.name, variant.slam.cell_size, demand.metric};
      for (std::size_t i = 0; i < seeds; ++i) {
        Rng rng({.seed = first_seed + static_cast<std::uint32_t>(i),
                 .entity = static_cast<std::uint32_t>(m.figures.size())});
        figure.values.push_back((path    ? 3e-4
                                 : bytes ? 8000
                                         : 0.013) *
                                std::exp((path    ? 0.14
                                          : bytes ? 0.017
                                                  : 0.003) *
                                         rng.normal()));
      }
      m.figures.push_back(figure);
    }
  }
  return m;
}

GateResult compared(const GateMeasurement& baseline, const GateMeasurement& now) {
  return compare(baseline, now, short_scenario(), config(), kFalseAlarm);
}

GateFigure& figure_of(GateMeasurement& m, const std::string& metric) {
  for (GateFigure& figure : m.figures) {
    if (figure.metric == metric) return figure;
  }
  throw std::logic_error("no " + metric);
}

GateReport report_of(const GateResult& result) {
  return {.gate = "a <gate> & \"file\"",
          .program = "cogslam 1",
          .false_alarm = 0.01,
          .power = 0.8,
          .tests = 8,
          .results = {result}};
}

TEST(Gate, PassesTheSameProgramWithFreshSeeds) {
  const GateMeasurement baseline = measured(1, 60);
  for (std::uint32_t run = 0; run < 50; ++run) {
    const GateResult result = compared(baseline, measured(1000 + 24 * run, 24));
    EXPECT_EQ(result.verdict(), Verdict::kPass) << gate_table(report_of(result));
    EXPECT_EQ(result.rows.size(), 8u);
    EXPECT_FALSE(result.paired);
  }
}

TEST(Gate, FailsOnePlantedRegressionAndNamesIt) {
  for (const auto& [metric, factor] : {std::pair{"path_mse_m2", 1.4}, {"grid_mse", 1.05}, {"bytes", 1.05}}) {
    GateMeasurement now = measured(61, 24);
    for (double& v : figure_of(now, metric).values) v *= factor;
    const GateResult result = compared(measured(1, 60), now);
    EXPECT_EQ(result.verdict(), Verdict::kFail) << metric;
    EXPECT_EQ(report_of(result).count(Verdict::kFail), 1u) << metric;
    for (const GateRow& row : result.rows) {
      if (row.verdict == Verdict::kFail) {
        EXPECT_EQ(row.metric, metric);
      }
    }
    EXPECT_THAT(gate_table(report_of(result)), HasSubstr("  FAIL\n"));
    EXPECT_THAT(gate_junit(report_of(result)), HasSubstr("failures=\"1\" errors=\"0\""));
  }
}

TEST(Gate, ComparesTheBaselinesOwnSeedsInPairs) {
  const GateMeasurement baseline = measured(1, 60);
  GateMeasurement now = measured(11, 20);
  GateResult result = compared(baseline, now);
  EXPECT_TRUE(result.paired);
  EXPECT_EQ(result.verdict(), Verdict::kPass);
  for (const GateRow& row : result.rows) EXPECT_EQ(row.change->change, 0.0) << "the same seeds, the same figures";
  EXPECT_TRUE(result.notes.empty());
  now.readings[3] = "other";
  for (double& v : figure_of(now, "path_mse_m2").values) v *= 1.03;
  result = compared(baseline, now);
  EXPECT_EQ(result.verdict(), Verdict::kFail) << "a certain 3 %";
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_THAT(result.notes[0], HasSubstr("other readings than the baseline's with 1 of 20 seeds"));
}

TEST(Gate, SaysWhatWasNotMeasured) {
  GateMeasurement now = measured(61, 24), baseline = measured(1, 60);
  GateFigure& path = figure_of(now, "path_mse_m2");
  path.values.pop_back();
  path.missing = 1;
  GateResult result = compared(baseline, now);
  EXPECT_EQ(result.verdict(), Verdict::kNotMeasured);
  EXPECT_EQ(result.rows[0].reason, "no figure with 1 of 24 seeds");
  EXPECT_THAT(gate_table(report_of(result)), HasSubstr("not measured: no figure with 1 of 24 seeds\n"));
  EXPECT_THAT(gate_junit(report_of(result)), HasSubstr("<error type=\"not measured\" message=\"no figure with 1"));
  baseline.figures.erase(baseline.figures.begin());
  result = compared(baseline, measured(61, 24));
  EXPECT_THAT(result.rows[0].reason, HasSubstr("the baseline has no such figure"));
  result = compared(measured(1, 60), measured(61, 5));
  EXPECT_EQ(result.verdict(), Verdict::kNotMeasured);
  EXPECT_THAT(result.rows[0].reason, HasSubstr("not +25.0 %: run more"));
  EXPECT_EQ(GateReport{}.verdict(), Verdict::kNotMeasured) << "nothing at all is no pass";
}

TEST(Gate, NoticesAVariantThatIsGone) {
  Scenario less = short_scenario();
  less.variants.pop_back();
  const GateResult result = compare(measured(1, 60), measured(61, 24), less, config(), kFalseAlarm);
  EXPECT_EQ(result.verdict(), Verdict::kNotMeasured);
  EXPECT_THAT(result.rows.back().reason, HasSubstr("the scenario no longer has this variant"));
}

TEST(Gate, ComparesOnlyWhatCanBeCompared) {
  const Scenario scenario = short_scenario();
  const GateMeasurement baseline = measured(1, 60);
  EXPECT_EQ(why_not_comparable(baseline, scenario, {61, 24}, "b.yaml"), "");
  EXPECT_EQ(why_not_comparable(baseline, scenario, {1, 60}, "b.yaml"), "");
  EXPECT_EQ(why_not_comparable(std::nullopt, scenario, {1, 60}, "b.yaml"),
            "no baseline: make b.yaml with --update, look at it and commit it");
  EXPECT_EQ(why_not_comparable(baseline, scenario, {50, 24}, "b.yaml"),
            "seeds 50 to 73: some are the baseline's (1 to 60) and some not; expected all or none");
  EXPECT_THAT(why_not_comparable(measured(5, 20), scenario, {1, 60}, "b.yaml"), HasSubstr("some not"));
  Scenario other = scenario;
  other.resolved.replace(other.resolved.find("duration_s: 2"), 13, "duration_s: 3");
  EXPECT_EQ(why_not_comparable(baseline, other, {61, 24}, "b.yaml"),
            "not the baseline's scenario: duration_s: 2 -> 3; if that is meant, make b.yaml anew with --update");
  GateMeasurement of_map = baseline;
  of_map.map_hash = "0";
  EXPECT_THAT(why_not_comparable(of_map, scenario, {61, 24}, "b.yaml"), HasSubstr("not the map of the baseline's"));
}

TEST(Gate, TellsOfOtherSettingsOfTheFilterAndComparesAllTheSame) {
  GateMeasurement baseline = measured(1, 60);
  const std::size_t at = baseline.settings.find("  particles: 4\n");
  baseline.settings.replace(at, 15, "  particles: 9\n");
  const GateResult result = compared(baseline, measured(61, 24));
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_THAT(result.notes[0], HasSubstr("other settings than the baseline's: slam.particles: 9 -> 4"));
  EXPECT_EQ(result.verdict(), Verdict::kPass);
}

TEST(GateOutput, IsJsonWithNothingForWhatIsNotKnown) {
  GateMeasurement now = measured(61, 24);
  now.figures[0].missing = 1;
  const auto json = nlohmann::json::parse(gate_json(report_of(compared(measured(1, 60), now))));
  EXPECT_EQ(json["verdict"], "not measured");
  const auto& figures = json["results"][0]["figures"];
  ASSERT_EQ(figures.size(), 8u);
  EXPECT_TRUE(figures[0]["now"].is_null());
  EXPECT_EQ(figures[0]["reason"], "no figure with 1 of 24 seeds");
  EXPECT_EQ(figures[1]["verdict"], "pass");
  EXPECT_TRUE(figures[1]["reason"].is_null());
  EXPECT_GT(figures[1]["now"], 0.0);
}

TEST(GateOutput, CountsAScenarioWithoutBaselineAsOneFailure) {
  const GateReport report = report_of({.scenario = "short", .problem = "no baseline: <make> one"});
  EXPECT_EQ(report.verdict(), Verdict::kFail);
  EXPECT_EQ(report.count(Verdict::kFail), 1u);
  const std::string xml = gate_junit(report);
  EXPECT_THAT(xml, HasSubstr("<testsuite name=\"short\" tests=\"1\" failures=\"1\" errors=\"0\">"));
  EXPECT_THAT(xml, HasSubstr("message=\"no baseline: &lt;make&gt; one\""));
  EXPECT_THAT(xml, HasSubstr("name=\"cogslam gate a &lt;gate&gt; &amp; &quot;file&quot;\""));
  EXPECT_THAT(gate_table(report), HasSubstr("short: no baseline: <make> one\n"));
}

}  // namespace
}  // namespace cogslam
