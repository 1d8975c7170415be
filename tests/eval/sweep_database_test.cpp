#include "eval/sweep/database.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/text_file.hpp"
#include "eval/sweep/columns.hpp"
#include "eval/sweep/episode_result.hpp"
#include "eval/sweep/export.hpp"
#include "tests/support/error_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cogslam {
namespace {

using testing::HasSubstr;

PlannedEpisode planned(const std::string& key) { return {.key = key, .world = "room", .variant = "cog"}; }

std::string result_json(const std::string& key, double path_mse, std::uint32_t seed) {
  VariantRecord variant{.name = "cog", .store = "coefficients", .cell_size_m = 1.0, .percent_kept = 40.0};
  variant.particles = 10;
  variant.scores.path_mse_m2 = path_mse;
  variant.scores.registered = 7;
  variant.scores.grid_confusion = {{{1, 2, 3}, {4, 5, 6}}};
  variant.costs.cpu_s = 0.5;
  return to_json(EpisodeResult{.key = key,
                               .readings_key = "r",
                               .baseline = "og",
                               .program = "p",
                               .run = {.scenario = "room, large", .seed = seed, .variants = {variant}}});
}

class SweepDatabaseTest : public testing::Test {
 protected:
  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "sweep.sqlite";
};

TEST_F(SweepDatabaseTest, KeepsEveryBitInTheOrderOfThePlan) {
  const double third = 1.0 / 3.0, tiny = std::nextafter(0.1, 1.0);
  {
    SweepDatabase database(file_);
    database.set_plan({"sweep", {planned("b"), planned("a"), planned("c")}});
    database.add_episode("a", result_json("a", third, 2));
    database.add_episode("b", result_json("b", tiny, 4000000000U));
    database.add_episode("x", result_json("x", 1.0, 1));  // of another plan
  }
  const EpisodeTable table = SweepDatabase::open_to_read(file_).results();
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.text(0, "key"), "b");
  EXPECT_EQ(table.number(0, "path_mse_m2"), tiny);
  EXPECT_EQ(table.number(1, "path_mse_m2"), third);
  EXPECT_EQ(table.number(0, "seed"), 4000000000.0);
  EXPECT_EQ(table.number(0, "cell_size_m"), 1.0);
  EXPECT_EQ(table.number(0, "truth_occupied_belief_unknown"), 5.0);
  EXPECT_EQ(table.number(0, "grid_mse"), std::nullopt) << "not measured";
  EXPECT_EQ(table.number(0, "cpu_s"), 0.5);
}

TEST_F(SweepDatabaseTest, ForgetsAFailureOnceThereIsAResult) {
  SweepDatabase database(file_);
  database.set_plan({"sweep", {planned("a"), planned("b")}});
  database.note_failure("b", "fell over");
  database.note_failure("a", "no disk");
  EXPECT_THAT(database.failures(),
              testing::ElementsAre(testing::Pair("a", "no disk"), testing::Pair("b", "fell over")));
  database.add_episode("a", result_json("a", 1.0, 1));
  EXPECT_THAT(database.failures(), testing::ElementsAre(testing::Pair("b", "fell over")));
  EXPECT_TRUE(database.has_episode("a"));
  EXPECT_FALSE(database.has_episode("b"));
}

TEST_F(SweepDatabaseTest, TakesNoResultOfAnotherEpisode) {
  SweepDatabase database(file_);
  EXPECT_THAT(error_text([&] { database.add_episode("a", result_json("b", 1.0, 1)); }),
              HasSubstr("episodes/a.json: expected the result of this episode, schema 1"));
  EXPECT_THAT(error_text([&] { database.add_episode("a", result_json("a", 1.0, 1).substr(0, 300)); }),
              HasSubstr("expected the result of this episode"));
  EXPECT_FALSE(database.has_episode("a"));
}

TEST_F(SweepDatabaseTest, SaysWhatIsWrongWithAFile) {
  {
    SweepDatabase database(file_);
    database.set_plan({"sweep", {planned("a")}});
    database.add_episode("a", result_json("a", 1.0, 1));
  }
  std::string bytes = read_text_file(file_, 1'000'000);
  ASSERT_GT(bytes.size(), 8192U);
  for (std::size_t i = 4096; i < bytes.size(); ++i) bytes[i] = static_cast<char>(0x5A);
  const auto damaged = folder_.file("damaged.sqlite", bytes);
  EXPECT_THAT(error_text([&] { SweepDatabase database(damaged); }),
              testing::AllOf(HasSubstr("damaged.sqlite: "), HasSubstr("move it away and run again")));
  const auto other = folder_.file("other.sqlite", "not a database at all, but long enough to look like one ......");
  EXPECT_THAT(error_text([&] { SweepDatabase database(other); }),
              testing::AllOf(HasSubstr("other.sqlite: file is not a database"), HasSubstr("move it away")));
  EXPECT_THAT(error_text([&] { SweepDatabase::open_to_read(folder_.path() / "none.sqlite"); }),
              HasSubstr("none.sqlite: unable to open database file"));
}

TEST_F(SweepDatabaseTest, ExportsScoresApartFromCosts) {
  SweepDatabase database(file_);
  database.set_plan({"sweep", {planned("a")}});
  database.add_episode("a", result_json("a", 1.0 / 3.0, 1));
  const std::string scores = table_csv(database.results(), ColumnKind::kScore);
  EXPECT_THAT(scores, HasSubstr("\na,\"room, large\",1,cog,1,og,0,coefficients,40,,,,10,r,,,0.3333333333333333,"));
  EXPECT_THAT(scores.substr(0, scores.find('\n')), testing::Not(HasSubstr("cpu_s")));
  const std::string costs = table_csv(database.results(), ColumnKind::kCost);
  EXPECT_THAT(costs, HasSubstr(",0.5,,,,p\n"));
  EXPECT_THAT(costs, testing::Not(HasSubstr("path_mse_m2")));
}

TEST(SweepColumns, StandInTheDocumentation) {
  const std::string page = read_text_file(COGSLAM_SOURCE_DIR "/docs/sweeps.md", 1'000'000);
  for (const EpisodeColumn& column : episode_columns()) {
    EXPECT_THAT(page, HasSubstr("`" + std::string(column.name) + "`"));
  }
}

}  // namespace
}  // namespace cogslam
