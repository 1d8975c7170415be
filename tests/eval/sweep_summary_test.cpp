#include "eval/sweep/summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eval/sweep/columns.hpp"

namespace cogslam {
namespace {

using testing::HasSubstr;

struct TestRow {
  std::string variant, baseline;
  std::int64_t seed;
  double path_mse;
};

EpisodeTable table_of(const std::vector<TestRow>& rows) {
  EpisodeTable table{.columns = {"world", "cell_size_m", "variant", "baseline", "seed"}, .rows = {}};
  for (const EpisodeColumn& column : episode_columns()) {
    if (column.kind == ColumnKind::kScore) table.columns.emplace_back(column.name);
  }
  for (const TestRow& row : rows) {
    std::vector<TableValue> values{std::string("room"), 0.1, row.variant, row.baseline, row.seed, row.path_mse};
    if (row.baseline.empty()) values[3] = std::monostate{};
    values.resize(table.columns.size());
    table.rows.push_back(std::move(values));
  }
  return table;
}

TEST(SweepSummary, PairsBySeedAndSaysHowMany) {
  const auto summary = summarize(table_of({{"og", "", 1, 1.0},
                                           {"og", "", 2, 2.0},
                                           {"og", "", 3, 6.0},
                                           {"cog", "og", 3, 6.5},
                                           {"cog", "og", 1, 1.5},
                                           {"cog", "og", 9, 100.0}}));
  ASSERT_EQ(summary.size(), 2U);
  EXPECT_EQ(summary[0].count, 3U);
  EXPECT_EQ(summary[0].find("path_mse_m2")->mean.mean, 3.0);
  EXPECT_FALSE(summary[0].find("path_mse_m2")->against_baseline);
  EXPECT_EQ(summary[0].find("grid_mse"), nullptr) << "nobody measured it";
  const FigureSummary& cog = *summary[1].find("path_mse_m2");
  EXPECT_EQ(cog.mean.count, 3U);
  ASSERT_TRUE(cog.against_baseline);
  EXPECT_EQ(cog.against_baseline->difference.count, 2U) << "the baseline has no seed 9";
  EXPECT_EQ(cog.against_baseline->difference.mean, 0.5);
  EXPECT_NEAR(cog.against_baseline->correlation.value(), 1.0, 1e-12);
}

TEST(SweepSummary, WritesWhatItKnowsAndLeavesOpenWhatItDoesNot) {
  const auto summary = summarize(table_of({{"og", "", 1, 0.25}, {"cog", "og", 1, 0.5}}));
  EXPECT_THAT(summary_csv(summary), HasSubstr("\nroom,0.1,og,,path_mse_m2,1,0.25,,0,,,,,\n"));
  EXPECT_THAT(summary_csv(summary), HasSubstr("\nroom,0.1,cog,og,path_mse_m2,1,0.5,,1,0.25,,,,\n"));
  EXPECT_THAT(summary_table(summary), HasSubstr("2500.000")) << "one seed: no interval";
}

}  // namespace
}  // namespace cogslam
