#include <gtest/gtest.h>
#include <png.h>

#include <limits>

#include "core/check.hpp"
#include "eval/report/map_picture.hpp"
#include "eval/report/palette.hpp"
#include "eval/report/png.hpp"
#include "eval/report/room_picture.hpp"

namespace cogslam {
namespace {

struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;

  [[nodiscard]] Colour at(int x, int y) const {
    const std::size_t i = 3 * static_cast<std::size_t>(y * width + x);
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
  }
  [[nodiscard]] int count(Colour colour) const {
    int n = 0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) n += at(x, y) == colour ? 1 : 0;
    }
    return n;
  }
};

Picture decode(const std::string& bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0);
  image.format = PNG_FORMAT_RGB;
  Picture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  picture.rgb.resize(PNG_IMAGE_SIZE(image));
  EXPECT_NE(png_image_finish_read(&image, nullptr, picture.rgb.data(), 0, nullptr), 0);
  return picture;
}

World square_room() {
  World world;
  world.walls = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
  world.obstacles = {{{1, 1}, {2, 1}, {2, 2}, {1, 2}}};
  return world;
}

TEST(Png, ReadsBackAsItWasWritten) {
  const std::vector<std::uint8_t> rgb{255, 0, 0, 1, 2, 3, 0, 0, 255, 9, 8, 7, 5, 5, 5, 0, 255, 0};
  const Picture picture = decode(png_bytes(3, 2, rgb));
  EXPECT_EQ(picture.width, 3);
  EXPECT_EQ(picture.height, 2);
  EXPECT_EQ(picture.rgb, rgb);
  EXPECT_THROW((void)png_bytes(3, 3, rgb), ContractViolation);
}

TEST(RoomPicture, ShowsEveryPathAndIsBigEnough) {
  const std::vector<Pose2> truth{{3, 1, 0}, {3, 3, 0}}, odometry{{3, 1, 0}, {3.5, 3, 0}},
      estimate{{3, 1, 0}, {2.5, 3, 0}};
  const Picture all = decode(room_picture(square_room(), {truth, odometry, estimate}));
  EXPECT_GE(std::min(all.width, all.height), 600);
  EXPECT_GT(all.count(kSkyBlue), 1000);
  EXPECT_GT(all.count(kVermilion), 300);
  EXPECT_GT(all.count(kLightGrey), 10000);  // the box
  EXPECT_GT(all.count(kBlue), 50);          // the start
  const Picture none = decode(room_picture(square_room(), {}));
  EXPECT_EQ(none.count(kSkyBlue) + none.count(kVermilion) + none.count(kBlue), 0);
}

TEST(RoomPicture, PutsTheYAxisUp) {
  World world = square_room();
  world.obstacles = {{{0.5, 2.5}, {1.5, 2.5}, {1.5, 3.5}, {0.5, 3.5}}};  // upper left
  const Picture picture = decode(room_picture(world, {}));
  EXPECT_EQ(picture.at(picture.width / 4, picture.height / 4 + 20), kLightGrey);
  EXPECT_EQ(picture.at(picture.width / 4, picture.height * 3 / 4 - 20), kWhite);
}

TEST(RoomPicture, CopesWithLogsEmptyRunsAndBrokenPoses) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Pose2> broken{{nan, nan, nan}, {0, 0, 0}, {100, 1e-3, 0}}, one{{1, 1, 1}};
  EXPECT_GT(decode(room_picture(World{}, {{}, broken, one})).count(kVermilion), 100);
  EXPECT_GE(decode(room_picture(World{}, {})).width, 600);
}

TEST(MapPicture, DrawsEveryCellOfBothMapsWithTheTopRowUp) {
  const GridFrame frame{.cell_size = 0.5, .width = 2, .height = 2};
  Grid<float> log_odds(frame);
  Grid<TruthCell> truth(frame, TruthCell::kFree);
  log_odds[{0, 1}] = 99.0F;
  log_odds[{1, 1}] = -99.0F;
  truth[{0, 1}] = TruthCell::kOccupied;
  truth[{1, 0}] = TruthCell::kUnobservable;
  const Picture picture = decode(map_picture(log_odds, truth));
  const int cell = 300, left = 24, right = left + 2 * cell + 24, top = 44 + 24;
  const auto at = [&](int panel, int column, int row) {
    return picture.at(panel + column * cell + 9, top + row * cell + 9);
  };
  EXPECT_EQ(at(left, 0, 0), kBlack);
  EXPECT_EQ(at(left, 1, 0), kWhite);
  EXPECT_EQ(at(left, 0, 1).red, 128);
  EXPECT_EQ(at(right, 0, 0), kBlack);
  EXPECT_EQ(at(right, 1, 0), kWhite);
  EXPECT_EQ(at(right, 0, 1), kWhite);
  EXPECT_EQ(at(right, 1, 1), kGrey);
}

TEST(MapPicture, ShrinksMapsTooLargeForAPixelPerCell) {
  const Picture picture = decode(map_picture(Grid<float>({.width = 6000, .height = 30}, 9.0F)));
  EXPECT_LE(picture.width, 1600);
  EXPECT_GT(picture.count({0, 0, 0}), 1000);
  EXPECT_THROW((void)map_picture(Grid<float>{}), ContractViolation);
}

}  // namespace
}  // namespace cogslam
