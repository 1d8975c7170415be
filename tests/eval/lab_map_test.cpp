#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eval/export.hpp"
#include "eval/lab/map_source.hpp"
#include "eval/lab/map_study.hpp"
#include "eval/lab/map_table.hpp"
#include "tests/support/error_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cogslam {
namespace {

using testing::HasSubstr;

TEST(LabMap, ReadsWhatTheProgramWrites) {
  const TemporaryFolder folder;
  const Grid<float> map = ideal_room_map("cluttered", 0.1);
  const Grid<float> npy = lab_map(folder.file("map.npy", map_npy_bytes(map)), 0.1);
  EXPECT_EQ(npy.values(), map.values());
  EXPECT_EQ(npy.frame().width, map.frame().width);
  const Grid<float> csv = lab_map(folder.file("map.csv", "1,-2.5,0\n4,5,6e-1\n"), 0.1);
  EXPECT_EQ(csv.values(), (std::vector<float>{1.0F, -2.5F, 0.0F, 4.0F, 5.0F, 0.6F}));
  EXPECT_EQ(csv.frame().width, 3);
}

TEST(LabMap, NamesThePlaceOfWhatIsWrong) {
  const TemporaryFolder folder;
  const std::string word = folder.file("word.csv", "1,2\n3,x\n"), ragged = folder.file("ragged.csv", "1,2\n3\n");
  EXPECT_EQ(error_text([&] { lab_map(word, 0.1); }), word + ":2:3: expected a number, found 'x'");
  EXPECT_EQ(error_text([&] { lab_map(ragged, 0.1); }), ragged + ":2: 1 values in this row, expected 2 as in the first");
  const std::string huge = folder.file("huge.csv", "1,2\n3,-1e39\n");
  EXPECT_EQ(error_text([&] { lab_map(huge, 0.1); }),
            huge + ":2:3: expected a number in the range of a float, found '-1e39'");
  const std::string cut = folder.file("cut.npy", map_npy_bytes(ideal_room_map("simple", 0.5)).substr(0, 130));
  EXPECT_THAT(error_text([&] { lab_map(cut, 0.1); }), HasSubstr("bytes of values, expected"));
  EXPECT_THAT(error_text([&] { lab_map(folder.path() / "none.csv", 0.1); }), HasSubstr("none.csv"));
  EXPECT_THAT(error_text([] { lab_map("smple", 0.1); }), HasSubstr("did you mean 'simple'?"));
}

TEST(MapStudy, LosesNothingWithEveryCoefficientAndAllRecoveriesAgreeOnTopM) {
  const Grid<float> map = ideal_room_map("simple", 0.2);
  const MapStudy study{.recoveries = {"fast_l2", "pinv", "nesta"}, .percents = {20, 100}};
  Workers workers(2);
  const auto scores = run_map_study(study, map, workers, {});
  ASSERT_EQ(scores.size(), 6U);
  for (std::size_t i = 0; i < scores.size(); ++i) {
    ASSERT_FALSE(scores[i].not_valid) << *scores[i].not_valid;
    EXPECT_NEAR(scores[i].mse_log_odds, scores[i % 2].mse_log_odds, 1e-12) << "CS keeps what top m keeps";
    EXPECT_EQ(*scores[i].bytes_u32, 8 * scores[i].m);
    EXPECT_EQ(*scores[i].bytes_u16, 6 * scores[i].m);
  }
  EXPECT_GT(scores[0].mse_log_odds, 1e-3);
  EXPECT_LT(scores[1].mse_log_odds, 1e-12);
}

TEST(MapStudy, IsTheSameForAnyNumberOfThreadsAndSaysWhatIsNotValid) {
  const Grid<float> map = ideal_room_map("simple", 0.4);
  const MapStudy study{.bases = {BasisKind::kHaar, BasisKind::kDct},
                       .compressors = {CompressorKind::kTopM, CompressorKind::kHadamard},
                       .recoveries = {"fast_l2", "tv"},
                       .percents = {30}};
  Workers one(1), two(2);
  const std::string csv = map_csv(run_map_study(study, map, one, {}));
  EXPECT_EQ(csv, map_csv(run_map_study(study, map, two, {})));
  EXPECT_THAT(csv, HasSubstr("dct,hadamard,fast_l2,30,,,,,,,,\"'hadamard' needs a power of two of coefficients"));
  EXPECT_THAT(csv, HasSubstr("it needs basis 'identity' and compressor 'selection', here 'haar' and 'top_m'"));
  EXPECT_THAT(error_text([&] { run_map_study({.recoveries = {"fast_l3"}, .percents = {30}}, map, one, {}); }),
              "unknown recovery 'fast_l3'; did you mean 'fast_l2'?");
}

TEST(MapStudy, RefusesWhatIsTooLargeInsteadOfTrying) {
  Workers workers(1);
  const auto reason = [&](const MapStudy& study, int width, int height) {
    const Grid<float> map({.width = width, .height = height});
    return run_map_study(study, map, workers, {}).front().not_valid.value_or("valid");
  };
  EXPECT_EQ(reason({.compressors = {CompressorKind::kGaussian}, .percents = {40}}, 300, 300),
            "'gaussian' stores m x n numbers, at most 16777216, here 36000 x 262144");
  EXPECT_EQ(reason({.percents = {40}}, 32769, 1),
            "'haar' takes maps of at most 32768 cells on a side, here 32769 x 1; 'haar_1d' takes any");
  EXPECT_EQ(reason({.percents = {40}}, 32768, 1), "valid");
}

}  // namespace
}  // namespace cogslam
