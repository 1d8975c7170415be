#include "worlds/map_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cogslam {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::StartsWith;

constexpr MapCell kFree = MapCell::kFree, kOccupied = MapCell::kOccupied, kUnknown = MapCell::kUnknown;

std::string bytes(std::initializer_list<int> values) {
  std::string text;
  for (const int value : values) text += static_cast<char>(value);
  return text;
}

const std::string kHead = "image: map.pgm\nresolution: 0.05\norigin: [-1, 2, 0]\n";

/// A map of what stands in map.pgm.
OccupancyMap map_of(const std::string& pgm, const std::string& yaml = kHead) {
  const TemporaryFolder folder;
  (void)folder.file("map.pgm", pgm);
  return read_map_file(folder.file("map.yaml", yaml));
}

/// The message, the folder's own name left out.
std::string message_of(const std::string& pgm, const std::string& yaml = kHead) {
  const TemporaryFolder folder;
  (void)folder.file("map.pgm", pgm);
  std::string text = error_text([&] { read_map_file(folder.file("map.yaml", yaml)); });
  const std::string name = folder.path().string() + "/";
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name)) text.erase(at, name.size());
  return text;
}

TEST(MapFile, ReadsAMapAsMapServerWritesIt) {
  const OccupancyMap map = map_of("P5\n# made by map_saver\n2 2\n255\n" + bytes({0, 205, 254, 0}),
                                  "image: map.pgm\nmode: trinary\nresolution: 0.05\norigin: [-1, 2, 0]\nnegate: 0\n"
                                  "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  EXPECT_EQ(map.width, 2);
  EXPECT_EQ(map.resolution, 0.05);
  EXPECT_EQ(map.T_map_image, (Pose2{-1, 2, 0}));
  EXPECT_THAT(map.cells, ElementsAre(kFree, kOccupied, kOccupied, kUnknown)) << "the lowest row comes first";
}

TEST(MapFile, ComparesDarknessWithTheThresholds) {
  // 205 is dark by 50/255 = 0.19608: no less than 0.196, so unknown.
  const std::string row = "P2 6 1 255\n255 206 205 90 89 0\n";
  EXPECT_THAT(map_of(row).cells, ElementsAre(kFree, kFree, kUnknown, kUnknown, kOccupied, kOccupied));
  EXPECT_THAT(map_of(row, kHead + "negate: 1\n").cells,
              ElementsAre(kOccupied, kOccupied, kOccupied, kUnknown, kUnknown, kFree));
  EXPECT_THAT(map_of(row, kHead + "occupied_thresh: 0.2\nfree_thresh: 0.2\nmode: scale\n").cells,
              ElementsAre(kFree, kFree, kFree, kOccupied, kOccupied, kOccupied));
  EXPECT_THAT(map_of("P2 2 1 255 255 0", kHead + "occupied_thresh: 1\nfree_thresh: 0\n").cells,
              ElementsAre(kUnknown, kUnknown))
      << "a threshold itself is neither free nor occupied";
  EXPECT_THAT(map_of("P2 5 1 255 0 19 50 100 101", kHead + "mode: raw\n").cells,
              ElementsAre(kFree, kFree, kUnknown, kOccupied, kUnknown));
  EXPECT_THAT(map_of("P2 2 1 1000 1000 0").cells, ElementsAre(kFree, kOccupied));
  EXPECT_THAT(map_of("P5 2 1 1000\n" + bytes({3, 0xE8, 0, 0})).cells, ElementsAre(kFree, kOccupied));
}

TEST(MapFile, ReadsPngsOfAnyKind) {
  const TemporaryFolder folder;
  std::filesystem::copy(std::filesystem::path(COGSLAM_SOURCE_DIR) / "tests/worlds/png", folder.path());
  for (const char* name : {"grey1", "grey8", "grey16", "rgb8", "palette", "interlaced"}) {
    const std::string yaml = std::string("image: ") + name + ".png\nresolution: 1\norigin: [0, 0, 0]\n";
    EXPECT_THAT(read_map_file(folder.file("map.yaml", yaml)).cells,
                ElementsAre(kOccupied, kFree, kFree, kOccupied, kFree, kFree))
        << name;
  }
  EXPECT_THAT(read_map_file(folder.file("map.yaml", "image: alpha.png\nresolution: 1\norigin: [0, 0, 0]\n")).cells,
              ElementsAre(kOccupied, kFree, kFree, kOccupied, kUnknown, kUnknown));
}

TEST(MapFile, LiesOnTheLatticeWhereItsOriginDoes) {
  const std::string pgm = "P2 2 1 255 0 255";
  const OccupancyMap on = map_of(pgm, "image: map.pgm\nresolution: 0.05\norigin: [-12.2, 3.35, 0]\n");
  ASSERT_TRUE(on.frame());
  EXPECT_EQ(on.frame()->lattice_min, (Cell{-244, 67}));
  EXPECT_EQ(on.point({1.5, 0.5}), on.frame()->centre_of({1, 0}));
  const OccupancyMap off = map_of(pgm, "image: map.pgm\nresolution: 0.05\norigin: [-12.22, 3.35, 0]\n");
  EXPECT_FALSE(off.frame());
  EXPECT_NEAR(off.point({1.5, 0.5}).x(), -12.145, 1e-12);
  const OccupancyMap turned = map_of(pgm, "image: map.pgm\nresolution: 0.5\norigin: [1, 2, 1.5707963267948966]\n");
  EXPECT_FALSE(turned.frame());
  EXPECT_NEAR((turned.point({2, 0}) - Eigen::Vector2d(1, 3)).norm(), 0.0, 1e-12);
  EXPECT_EQ(turned.cell_of({0.75, 2.75}), (Cell{1, 0}));
}

TEST(MapFile, PointsAtWhatIsWrongInTheYaml) {
  const std::string pgm = "P2 1 1 255 0";
  EXPECT_EQ(message_of(pgm, "image: none.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n"),
            "map.yaml:1:1: image: there is no none.pgm");
  EXPECT_EQ(message_of(pgm, "image: map.pgm\norigin: [0, 0, 0]\n"),
            "map.yaml:1:1: no 'resolution', expected image, resolution and origin");
  EXPECT_EQ(message_of(pgm, "image: map.pgm\nresolution: [0.05, 0.1]\norigin: [0, 0, 0]\n"),
            "map.yaml:2:13: resolution: expected a number in [0.001, 100], found a list of 2");
  EXPECT_EQ(message_of(pgm, "image: map.pgm\nresolution: 0\norigin: [0, 0, 0]\n"),
            "map.yaml:2:13: resolution: expected a number in [0.001, 100], found '0'");
  EXPECT_EQ(message_of(pgm, "image: map.pgm\nresolution: 0.05\norigin: [0, 0]\n"),
            "map.yaml:3:1: origin: expected three numbers [x, y, yaw]");
  EXPECT_EQ(message_of(pgm, kHead + "occupied_thresh: 65\n"),
            "map.yaml:4:18: occupied_thresh: expected a number in [0, 1], found '65'");
  EXPECT_EQ(message_of(pgm, kHead + "occupied_thresh: 0.2\nfree_thresh: 0.3\n"),
            "map.yaml:5:1: free_thresh: 0.3 is above occupied_thresh, expected at most 0.2");
  EXPECT_EQ(message_of(pgm, kHead + "negate: 2\n"),
            "map.yaml:4:9: negate: expected a whole number in [0, 1], found '2'");
  EXPECT_EQ(message_of(pgm, kHead + "mode: raw\nnegate: 1\n"), "map.yaml:5:1: negate: expected 0 where mode is raw");
  EXPECT_EQ(message_of(pgm, kHead + "mode: trinery\n"),
            "map.yaml:4:7: mode: expected one of trinary, scale, raw, found 'trinery'; did you mean 'trinary'?");
  EXPECT_EQ(message_of(pgm, kHead + "ocupied_thresh: 0.6\n"),
            "map.yaml:4:1: unknown key 'ocupied_thresh'; did you mean 'occupied_thresh'?");
}

TEST(MapFile, SaysWhatIsWrongWithAPgm) {
  EXPECT_EQ(message_of(""), "map.pgm: neither PGM (P2, P5) nor PNG, expected one of them");
  EXPECT_EQ(message_of("P6 1 1 255 abc"), "map.pgm: neither PGM (P2, P5) nor PNG, expected one of them");
  EXPECT_EQ(message_of("P5\n# wide\nx 3\n"), "map.pgm:3:1: width: expected a whole number up to 1000000000");
  EXPECT_EQ(message_of("P5\n3 -3\n"), "map.pgm:2:3: height: expected a whole number up to 1000000000");
  EXPECT_EQ(message_of("P5\n3.5 3\n"), "map.pgm:2:1: width: expected a whole number up to 1000000000, found '3.5'");
  EXPECT_EQ(message_of("P5 0 3 255\n"), "map.pgm: 0 x 3 pixels, expected at least one");
  EXPECT_EQ(message_of("P5 100000 100000 255\n"),
            "map.pgm: 100000 x 100000 pixels, expected at most 16384 each way and 16777216 in all");
  EXPECT_EQ(message_of("P5 2 2 70000\n"),
            "map.pgm:1:8: the value of white: expected a whole number up to 65535, found '70000'");
  EXPECT_EQ(message_of("P5 2 2 0\nabcd"), "map.pgm: the value of white is 0, expected at least 1");
  EXPECT_EQ(message_of("P5 2 2 255\nabc"), "map.pgm: cut off after 3 pixels, expected 2 x 2");
  EXPECT_EQ(message_of("P5 9 9 255\nabc"), "map.pgm: cut off after 3 pixels, expected 9 x 9");
  EXPECT_EQ(message_of("P5 2 1 255\nabc"), "map.pgm: 1 bytes follow the 2 x 1 pixels, expected the end of the file");
  EXPECT_EQ(message_of("P5 2 1 60\n" + bytes({60, 61})), "map.pgm: pixel 1 is 61, expected at most 60");
  EXPECT_EQ(message_of("P2 2 1 255\n17"), "map.pgm: cut off after 1 pixels, expected 2 x 1");
  EXPECT_EQ(message_of("P2 2 1 255\n17 256"), "map.pgm:2:4: a pixel: expected a whole number up to 255, found '256'");
  EXPECT_EQ(message_of("P2 1 1 255\n17 16"), "map.pgm: text follows the last pixel, expected the end of the file");
}

TEST(MapFile, SaysWhatIsWrongWithAPng) {
  const std::string magic = "\x89PNG\r\n\x1a\n";
  EXPECT_THAT(message_of(magic), StartsWith("map.pgm: broken PNG: cut off"));
  EXPECT_THAT(message_of(magic + std::string(12, 'x')), StartsWith("map.pgm: broken PNG: "));
  const TemporaryFolder folder;
  std::filesystem::copy(std::filesystem::path(COGSLAM_SOURCE_DIR) / "tests/worlds/png", folder.path());
  const std::string yaml = folder.file("map.yaml", "image: huge.png\nresolution: 1\norigin: [0, 0, 0]\n");
  EXPECT_THAT(error_text([&] { read_map_file(yaml); }), testing::HasSubstr("huge.png: "));
}

TEST(MapFile, SaysThatAFolderIsNoImage) {
  const TemporaryFolder folder;
  const std::string yaml = folder.file("map.yaml", "image: .\nresolution: 1\norigin: [0, 0, 0]\n");
  EXPECT_THAT(error_text([&] { read_map_file(yaml); }), EndsWith("is a folder, expected a file"));
}

}  // namespace
}  // namespace cogslam
