#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "eval/sense/field_map.hpp"
#include "eval/sense/figure.hpp"
#include "eval/sense/map_quality.hpp"
#include "eval/sense/recovery_study.hpp"
#include "tests/support/error_text.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cogslam {
namespace {

using testing::HasSubstr;

/// 24 x 18 cells: a room with one-cell walls.
FieldMap small_map() {
  FieldMap map{.name = "small", .width = 24, .height = 18, .cells = {}};
  for (int y = 0; y < 18; ++y) {
    for (int x = 0; x < 24; ++x) map.cells.push_back(x == 3 || y == 2 || x == 20 || y == 15 ? 1.0 : 0.0);
  }
  return map;
}

TEST(MapQuality, MeasuresErrorsByHand) {
  const std::vector<double> truth{1.0, 0.0, 0.0, 1.0}, estimate{0.5, 0.25, 0.0, 0.0};
  const MapQuality q = map_quality(truth, estimate);
  EXPECT_DOUBLE_EQ(q.relative_error, std::sqrt(0.25 + 0.0625 + 1.0) / std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(q.psnr_db, -10.0 * std::log10((0.25 + 0.0625 + 1.0) / 4.0));
  EXPECT_EQ(q.accuracy, 0.75);
  EXPECT_EQ(q.wall_precision, 1.0);
  EXPECT_EQ(q.wall_recall, 0.5);
  EXPECT_DOUBLE_EQ(q.wall_f1, 2.0 / 3.0);
}

TEST(MapQuality, KnowsUnknownCellsWhereTheTruthHasThem) {
  const std::vector<double> truth{0.0, 0.5, 1.0, 1.0}, estimate{0.2, 0.3, 0.7, 0.8};
  const MapQuality q = map_quality(truth, estimate);
  EXPECT_EQ(q.accuracy, 0.75) << "0.7 is unknown here";
  EXPECT_EQ(q.wall_recall, 0.5);
  EXPECT_EQ(map_quality(std::vector{0.0, 1.0}, std::vector{0.3, 0.7}).accuracy, 1.0);
}

TEST(MapQuality, OfTheSameFieldIsPerfectAndOfAnEmptyOneDefined) {
  const std::vector<double> cells = small_map().cells, none(cells.size(), 0.0);
  const MapQuality same = map_quality(cells, cells);
  EXPECT_EQ(same.relative_error, 0.0);
  EXPECT_EQ(same.psnr_db, HUGE_VAL);
  EXPECT_EQ(same.wall_f1, 1.0);
  EXPECT_EQ(map_quality(none, none).wall_f1, 1.0);
  EXPECT_EQ(map_quality(none, none).relative_error, 0.0);
  EXPECT_EQ(map_quality(none, cells).relative_error, HUGE_VAL);
  EXPECT_EQ(map_quality(cells, none).wall_f1, 0.0);
  EXPECT_EQ(map_quality(cells, none).relative_error, 1.0);
}

TEST(MapQuality, OfAllFreeOnTheReferenceHallwayLooksGoodButFindsNoWall) {
  SKIP_WITHOUT_GOLDEN();
  const std::vector<double> map = golden::read("maps/hallway154x249_binary.csv");
  const MapQuality q = map_quality(map, std::vector<double>(map.size(), 0.0));
  EXPECT_NEAR(q.accuracy, 0.926, 5e-4);
  EXPECT_EQ(q.wall_f1, 0.0);
}

TEST(FieldMap, NamesWhatIsWrongWithAFile) {
  const TemporaryFolder folder;
  const std::string good = folder.file("good.csv", "0,0.5,1\n1,0,0\n");
  EXPECT_EQ(read_field_map(good).cells, (std::vector{0.0, 0.5, 1.0, 1.0, 0.0, 0.0}));
  EXPECT_EQ(read_field_map(good).width, 3);
  EXPECT_EQ(read_field_map(good).name, "good");
  const std::string odds = folder.file("odds.csv", "0,1\n0,-2.5\n"), empty = folder.file("empty.csv", "");
  EXPECT_EQ(error_text([&] { read_field_map(odds); }),
            odds + ": row 2, value 2 is -2.5, expected 0 (free) to 1 (occupied)");
  EXPECT_EQ(error_text([&] { read_field_map(empty); }), empty + ": no values, expected a row of numbers per line");
  EXPECT_THAT(error_text([&] { read_field_map(folder.path() / "none.csv"); }), HasSubstr("none.csv"));
  const std::string ragged = folder.file("ragged.csv", "0,1\n1\n");
  EXPECT_EQ(error_text([&] { read_field_map(ragged); }),
            ragged + ":2: 1 values in this row, expected 2 as in the first");
}

TEST(FieldMap, OfTheHallwayHasThePapersSize) {
  const FieldMap map = hallway_field();
  EXPECT_EQ(map.width, 249);
  EXPECT_EQ(map.height, 154);
  EXPECT_THAT(map.cells, testing::Each(testing::AnyOf(0.0, 0.5, 1.0)));
  EXPECT_THAT(map.cells, testing::Contains(1.0).Times(testing::Gt(1000)));
}

TEST(RecoveryStudy, RefusesCountsThatNoMapHas) {
  Workers workers(1);
  const auto text = [&](std::size_t count) {
    return error_text([&] { run_recovery_study({.counts = {5, count}}, {small_map()}, workers, {}); });
  };
  EXPECT_EQ(text(433), "K = 433 is more than the 432 cells of map 'small'");
  EXPECT_EQ(text(0), "K = 0: expected at least one cell to sense");
}

/// The CSV without its last column, the time.
std::string without_times(const std::string& csv) {
  std::string text, line;
  for (std::istringstream lines(csv); std::getline(lines, line);) text += line.substr(0, line.rfind(',')) + "\n";
  return text;
}

TEST(RecoveryStudy, IsTheSameForAnyNumberOfThreads) {
  const RecoveryStudy study{
      .counts = {40, 120}, .choices = {CellChoice::kRandom, CellChoice::kUncertain, CellChoice::kRays}, .seeds = 3};
  Workers one(1), three(3);
  const auto scores = run_recovery_study(study, {small_map(), small_map()}, one, {});
  ASSERT_EQ(scores.size(), 2U * 3U * 3U * 2U);
  EXPECT_EQ(without_times(recovery_csv(scores)),
            without_times(recovery_csv(run_recovery_study(study, {small_map(), small_map()}, three, {}))));
  EXPECT_EQ(scores[3].choice, CellChoice::kRandom);
  EXPECT_EQ(scores[3].prior, FieldPrior::kDct);
  EXPECT_EQ(scores[3].count, 120U);
  EXPECT_EQ(scores[3].runs[2].seed, 3U);
  for (const RecoveryScore& score : scores) {
    EXPECT_EQ(score.converged(), 3);
    EXPECT_LE(score.largest_gap(), 1e-3);
  }
}

TEST(RecoveryStudy, RecoversEverythingFromAllCells) {
  Workers workers(1);
  const auto scores = run_recovery_study({.counts = {432}, .seeds = 1}, {small_map()}, workers, {});
  for (const RecoveryScore& score : scores) {
    EXPECT_LE(score.runs[0].quality.relative_error, 1e-12);
    EXPECT_EQ(score.runs[0].quality.wall_f1, 1.0);
  }
}

TEST(RecoveryStudy, SaysHowFarItCameWhenIterationsRunOut) {
  Workers workers(1);
  const auto scores = run_recovery_study(
      {.counts = {100}, .priors = {FieldPrior::kDct}, .seeds = 2, .max_iterations = 1}, {small_map()}, workers, {});
  EXPECT_EQ(scores[0].converged(), 0);
  EXPECT_GT(scores[0].largest_gap(), 1e-3);
  EXPECT_THAT(recovery_table(scores), HasSubstr("0/2"));
}

TEST(RecoveryStudy, WritesItsRunsAsJson) {
  Workers workers(1);
  const RecoveryStudy study{.counts = {432}, .priors = {FieldPrior::kTotalVariation}, .first_seed = 7, .seeds = 2};
  const auto json = nlohmann::json::parse(recovery_json(study, run_recovery_study(study, {small_map()}, workers, {})));
  ASSERT_EQ(json["scores"].size(), 1U);
  const auto& score = json["scores"][0];
  EXPECT_EQ(score["prior"], "tv");
  EXPECT_EQ(score["runs"][1]["seed"], 8);
  EXPECT_TRUE(score["psnr_db"]["mean"].is_null()) << "nothing differs: infinite";
  EXPECT_EQ(score["wall_f1"]["mean"], 1.0);
}

TEST(SenseFigure, KnowsItsNumbers) {
  EXPECT_EQ(sense_figure(6).number, 6);
  EXPECT_THAT(error_text([] { static_cast<void>(sense_figure(1)); }), HasSubstr("no figure 1, expected one of "));
  int before = 0;
  for (const SenseFigure& figure : sense_figures()) {
    EXPECT_GT(figure.number, before);
    before = figure.number;
  }
}

TEST(SenseFigure, OfASmallFieldHasPicturesCurvesAndNumbers) {
  Workers workers(2);
  const SenseFigureConfig config{.map = small_map(), .seeds = 2};
  for (const int number : {5, 6}) {
    const LabFigure figure = sense_figure(number).make(config, workers, {});
    EXPECT_GE(figure.sheet.charts.size(), 5U);
    EXPECT_THAT(figure.csv, HasSubstr("small,432,random,tv,86,2,"));
  }
}

}  // namespace
}  // namespace cogslam
