#include "sensors/log/truth_log.hpp"

#include <gmock/gmock.h>

#include "sensors/log/recording.hpp"
#include "tests/sensors/damaged_files.hpp"
#include "tests/support/test_worlds.hpp"

namespace cogslam {
namespace {

TruthLog sample_log() {
  TruthLog log;
  log.readings_hash = "0123456789abcdef";
  log.world = room_with_boxes(7, 2);
  log.world.start = {0.1, 0.2, 0.3};
  log.world.floor = {FloorKind::kWood, 0.7, 99};
  log.world.panes = {{{0.5, 1.0}, {0.5, 2.0}}};
  log.world.magnets = {{{1.5, -2.0}, 0.6, 0.3}};
  log.world.slip_patches = {{{1.0, 2.0}, 0.4, 0.3}, {{-1.0, 0.0}, 0.2, 0.1}};
  for (std::uint64_t i = 0; i < 30; ++i)
    log.poses.push_back({i, {static_cast<std::int64_t>(i) * 25'000'000}, {0.1 * static_cast<double>(i), 1.0, -0.3}});
  for (int i = 0; i < 5; ++i) log.references.push_back({{i * 100'000'000}, {0.4 * i, 1.0, -0.3}, 0.004});
  return log;
}

class TruthLogFile : public testing::Test {
 protected:
  std::filesystem::path file_ = temporary_file("truth");
  void TearDown() override { std::filesystem::remove(file_); }
};

TEST_F(TruthLogFile, ComesBackExactly) {
  const TruthLog out = sample_log();
  write_truth_log(file_, out);
  const TruthLog in = read_truth_log(file_);
  EXPECT_EQ(in.readings_hash, out.readings_hash);
  EXPECT_EQ(in.poses, out.poses);
  EXPECT_EQ(in.references, out.references);
  EXPECT_EQ(in.world.walls, out.world.walls);
  EXPECT_EQ(in.world.obstacles, out.world.obstacles);
  EXPECT_EQ(in.world.floor.kind, FloorKind::kWood);
  EXPECT_EQ(in.world.floor.contrast, 0.7);
  EXPECT_EQ(in.world.floor.seed, 99u);
  ASSERT_EQ(in.world.slip_patches.size(), 2u);
  EXPECT_EQ(in.world.slip_patches[1].centre, Eigen::Vector2d(-1.0, 0.0));
  EXPECT_EQ(in.world.slip_patches[1].radius, 0.2);
  EXPECT_EQ(in.world.slip_patches[1].friction, 0.1);
  ASSERT_EQ(in.world.panes.size(), 1u);
  EXPECT_EQ(in.world.panes[0].a, Eigen::Vector2d(0.5, 1.0));
  EXPECT_EQ(in.world.panes[0].b, Eigen::Vector2d(0.5, 2.0));
  ASSERT_EQ(in.world.magnets.size(), 1u);
  EXPECT_EQ(in.world.magnets[0].centre, Eigen::Vector2d(1.5, -2.0));
  EXPECT_EQ(in.world.magnets[0].reach, 0.6);
  EXPECT_EQ(in.world.magnets[0].axis, 0.3);
  EXPECT_EQ(in.world.start, out.world.start);
}

TEST_F(TruthLogFile, DamageNamesFileAndByte) {
  write_truth_log(file_, sample_log());
  const std::string whole = content_of(file_);
  for (std::size_t at = 0; at < whole.size(); at += 17) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(~damaged[at]);
    write_content(file_, damaged);
    EXPECT_THAT(error_of([&] { read_truth_log(file_); }), testing::StartsWith(file_.string() + ": byte ")) << at;
    write_content(file_, whole.substr(0, at));
    EXPECT_THAT(error_of([&] { read_truth_log(file_); }), testing::StartsWith(file_.string() + ": byte ")) << at;
  }
}

TEST_F(TruthLogFile, ARecordingIsNoTruthLog) {
  write_recording(file_, {});
  EXPECT_EQ(error_of([&] { read_truth_log(file_); }),
            file_.string() + ": byte 0: wrong magic, expected a file that begins with 'COGSTRUE'");
}

}  // namespace
}  // namespace cogslam
