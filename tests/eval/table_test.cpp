#include "eval/report/table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "core/angle.hpp"

namespace cogslam {
namespace {

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}

RunRecord two_variants() {
  RunRecord record;
  VariantRecord og{.name = "og", .store = "dense", .cell_size_m = 0.1, .particles = 100};
  og.scores.path_mse_m2 = 0.0004;
  og.scores.heading_mse_rad2 = radians(0.5) * radians(0.5);
  og.scores.odometry_path_mse_m2 = 0.25;
  og.scores.grid_mse = 0.01234;
  og.scores.payload_bytes = 6560.4;
  og.scores.bytes_peak = 7000;
  og.scores.resamplings = 31;
  og.costs.cpu_ms_per_registered = 12.345;
  VariantRecord cog{.name = "cog 40 %",
                    .store = "coefficients",
                    .cell_size_m = 1.0,
                    .percent_kept = 40.0,
                    .basis = "haar",
                    .compressor = "top_m",
                    .recovery = "nesta",
                    .particles = 100};
  record.variants = {og, cog};
  return record;
}

TEST(ScoreTable, ShowsRootsDegreesAndDashes) {
  const auto rows = lines(score_table(two_variants()));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_THAT(rows[0], testing::StartsWith("variant"));
  std::istringstream og(rows[1]);
  const std::vector<std::string> cells{std::istream_iterator<std::string>(og), {}};
  EXPECT_THAT(cells, testing::ElementsAre("og", "0.1", "dense", "-", "0.0200", "0.500", "0.5000", "0.0123", "6560", "-",
                                          "-", "7000", "12.35", "-", "31"));
  EXPECT_THAT(rows[2], testing::StartsWith("cog 40 %"));
  EXPECT_THAT(rows[2], testing::ContainsRegex(" haar/top_m/nesta +40 "));
}

TEST(ScoreTable, KeepsColumnsAligned) {
  const auto rows = lines(score_table(two_variants()));
  for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
  EXPECT_EQ(rows[0].find("cell m") + 6, rows[1].find("0.1") + 3);
}

TEST(RelationsTable, IsEmptyWhereNothingWasMeasured) { EXPECT_EQ(relations_table(two_variants()), ""); }

TEST(RelationsTable, HasARowPerPathAndSplit) {
  RunRecord record = two_variants();
  record.variants[1].scores.relations_final =
      RelationErrors{.local = {1139, 0.0224, 0.0245, radians(0.93), radians(1)}, .all = {1139, 1, 2, 0, 0}};
  const auto rows = lines(relations_table(record));
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_THAT(rows[1], testing::AllOf(testing::HasSubstr("final"), testing::HasSubstr("local   1139        0.0224"),
                                      testing::HasSubstr("0.93")));
  EXPECT_THAT(rows[2], testing::HasSubstr("0             -       -             -        -"));
}

}  // namespace
}  // namespace cogslam
