#include "eval/export.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "core/angle.hpp"
#include "core/check.hpp"
#include "core/error.hpp"
#include "core/text_file.hpp"
#include "eval/metrics/map_error.hpp"
#include "tests/support/temporary_folder.hpp"
#include "worlds/map_file.hpp"

namespace cogslam {
namespace {

Grid<float> small_map() {
  Grid<float> map({.cell_size = 0.1, .lattice_min = {-3, 2}, .width = 3, .height = 2});
  map.values() = {-1.0F, 0.0F, 1.0F,  // bottom row
                  2.5F,  0.1F, -0.7F};
  return map;
}

std::string bytes(std::initializer_list<int> values) {
  std::string text;
  for (const int v : values) text += static_cast<char>(v);
  return text;
}

TEST(Export, WritesTumLinesWithExactStamps) {
  const std::vector<Time> stamps{{976'052'905'167'303'001}, {1}, {-500'000'000}};
  const std::vector<Pose2> path{{1.5, -2, 0}, {0.1, 0, radians(180)}, {0, 0, radians(-90)}};
  const std::string text = tum_text(stamps, path);
  EXPECT_THAT(text, testing::StartsWith("976052905.167303001 1.5 -2 0 0 0 0 1\n0.000000001 0.1 0 0 0 0 1 6.1"));
  EXPECT_THAT(text, testing::HasSubstr("\n-0.500000000 0 0 0 0 0 -0.7071067811865"));
}

TEST(Export, KeepsFileOrderAndTheFirstOfEqualStamps) {
  const std::vector<Time> stamps{{5'000'000'000}, {3'000'000'000}, {5'000'000'000}, {4'000'000'000}};
  const std::vector<Pose2> path{{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
  EXPECT_EQ(tum_text(stamps, path),
            "5.000000000 1 0 0 0 0 0 1\n3.000000000 2 0 0 0 0 0 1\n4.000000000 4 0 0 0 0 0 1\n");
}

TEST(Export, TakesStampsThatReadAsTheSameDoubleForEqual) {
  const std::vector<Time> stamps{{976'052'905'167'303'000}, {976'052'905'167'303'001}};
  const std::vector<Pose2> path(2);
  const std::string text = tum_text(stamps, path);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
}

TEST(Export, RejectsStampsWithoutPoses) {
  const std::vector<Time> stamps(2);
  EXPECT_THROW((void)tum_text(stamps, {}), ContractViolation);
}

TEST(Export, WritesThePictureOfTheMapTopRowFirst) {
  EXPECT_EQ(map_pgm_bytes(ternary_map(small_map())), "P5\n3 2\n255\n" + bytes({0, 205, 254, 254, 205, 0}));
}

TEST(Export, DescribesThePictureAsMapServerReadsIt) {
  EXPECT_EQ(map_yaml_text(ternary_map(small_map()), "og.pgm"),
            "image: og.pgm\nmode: trinary\nresolution: 0.1\norigin: [-0.30000000000000004, 0.2, 0]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

// map_server: occupancy (255 - pixel) / 255, above occupied_thresh occupied, below free_thresh free.
TEST(Export, SurvivesMapServersThresholds) {
  const std::string pgm = map_pgm_bytes(ternary_map(small_map()));
  const std::size_t first = pgm.size() - 6;
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) {
      const auto pixel = static_cast<unsigned char>(pgm[first + static_cast<std::size_t>(3 * (1 - y) + x)]);
      const double p = (255.0 - pixel) / 255.0;
      const CellClass read = p > 0.65 ? CellClass::kOccupied : p < 0.196 ? CellClass::kFree : CellClass::kUnknown;
      EXPECT_EQ(read, classify(static_cast<double>(small_map()[{x, y}])));
    }
  }
}

TEST(Export, WritesEveryBitOfTheMapAsNumpyArray) {
  const std::string npy = map_npy_bytes(small_map());
  ASSERT_EQ(npy.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t header = static_cast<unsigned char>(npy[8]) + 256U * static_cast<unsigned char>(npy[9]);
  EXPECT_EQ((10 + header) % 64, 0U);
  EXPECT_THAT(npy.substr(10), testing::StartsWith("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3), }"));
  EXPECT_EQ(npy[10 + header - 1], '\n');
  ASSERT_EQ(npy.size(), 10 + header + 6 * sizeof(float));
  std::vector<float> values(6);
  std::memcpy(values.data(), npy.data() + 10 + header, 6 * sizeof(float));
  EXPECT_EQ(values, small_map().values());
}

TEST(Export, WritesThreeFilesForAMapWhoseNameHoldsDots) {
  const TemporaryFolder folder;
  write_map(folder.path() / "og_0.1", small_map());
  EXPECT_EQ(read_text_file(folder.path() / "og_0.1.pgm", 1000), map_pgm_bytes(ternary_map(small_map())));
  EXPECT_EQ(read_text_file(folder.path() / "og_0.1.npy", 1000), map_npy_bytes(small_map()));
  EXPECT_THAT(read_text_file(folder.path() / "og_0.1.yaml", 1000), testing::StartsWith("image: og_0.1.pgm\n"));
  EXPECT_THROW(write_map(folder.path() / "no" / "such" / "map", small_map()), InputError);
}

}  // namespace
}  // namespace cogslam
