#include "sensors/log/recording.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <fstream>

#include "core/error.hpp"
#include "core/rng.hpp"
#include "tests/sensors/damaged_files.hpp"

namespace cogslam {
namespace {

Recording sample_recording() {
  Recording recording{"a test", {1.0, -2.0, 0.5}, {}};
  Rng rng({3, Purpose::kWorld, 0, 0});
  for (std::uint64_t i = 0; i < 20; ++i) {
    Reading r;
    r.sequence = i;
    r.stamp = {static_cast<std::int64_t>(i) * 25'000'000 - (i == 7 ? 900'000'000 : 0)};  // stamps may jump back
    r.motion.T_before_now = {rng.normal(), rng.normal(), rng.normal()};
    r.motion.covariance << 4, 1, 0.5, 1, 3, 0.25, 0.5, 0.25, 1 + rng.uniform();
    r.motion.source = static_cast<MotionSource>(i % 3);
    r.twist = {rng.normal(), -0.0, rng.normal()};
    if (i % 2 == 0) {
      r.scan.emplace();
      r.scan->range_max = 30.0;
      r.scan->time_increment = {17361};
      r.scan->T_base_lidar = {0.1, 0.2, 0.3};
      r.scan->ranges = {1.0F, Scan::kNoReturn, Scan::kTooClose, Scan::kInvalid, std::bit_cast<float>(0x7fc12345u),
                        -0.0F};
    }
    if (i % 5 == 0) r.heading = rng.normal();
    recording.readings.push_back(r);
  }
  return recording;
}

class RecordingFile : public testing::Test {
 protected:
  std::filesystem::path file_ = temporary_file("recording");
  void TearDown() override { std::filesystem::remove(file_); }
};

TEST_F(RecordingFile, ComesBackBitByBit) {
  const Recording out = sample_recording();
  write_recording(file_, out);
  const Recording in = read_recording(file_);
  EXPECT_EQ(in.source, out.source);
  EXPECT_EQ(in.start, out.start);
  ASSERT_EQ(in.readings.size(), out.readings.size());
  EXPECT_EQ(readings_hash(in.readings), readings_hash(out.readings));
  for (std::size_t i = 0; i < out.readings.size(); ++i) {
    const Reading &a = in.readings[i], &b = out.readings[i];
    EXPECT_EQ(a.sequence, b.sequence);
    EXPECT_EQ(a.stamp, b.stamp);
    EXPECT_EQ(a.motion.T_before_now, b.motion.T_before_now);
    EXPECT_EQ(a.motion.covariance, b.motion.covariance);
    EXPECT_EQ(a.motion.source, b.motion.source);
    EXPECT_EQ(a.twist, b.twist);
    EXPECT_EQ(a.heading, b.heading);
    ASSERT_EQ(a.scan.has_value(), b.scan.has_value());
    if (!a.scan) continue;
    for (std::size_t k = 0; k < b.scan->ranges.size(); ++k)
      EXPECT_EQ(std::bit_cast<std::uint32_t>(a.scan->ranges[k]), std::bit_cast<std::uint32_t>(b.scan->ranges[k]));
    EXPECT_EQ(a.scan->T_base_lidar, b.scan->T_base_lidar);
    EXPECT_EQ(a.scan->time_increment, b.scan->time_increment);
  }
}

TEST_F(RecordingFile, MayBeEmpty) {
  write_recording(file_, {});
  EXPECT_TRUE(read_recording(file_).readings.empty());
}

TEST_F(RecordingFile, IsTheSameFileForTheSameReadings) {
  write_recording(file_, sample_recording());
  const std::string first = content_of(file_);
  write_recording(file_, sample_recording());
  EXPECT_EQ(content_of(file_), first);
}

TEST_F(RecordingFile, CutOffAnywhereNamesFileAndByte) {
  write_recording(file_, sample_recording());
  const std::string whole = content_of(file_);
  for (std::size_t size = 0; size < whole.size(); size += 1 + size / 15) {
    write_content(file_, whole.substr(0, size));
    EXPECT_THAT(error_of([&] { read_recording(file_); }), testing::StartsWith(file_.string() + ": byte ")) << size;
  }
}

TEST_F(RecordingFile, AnyChangedByteIsAnError) {
  write_recording(file_, sample_recording());
  const std::string whole = content_of(file_);
  for (std::size_t at = 0; at < whole.size(); at += 23)
    for (const char flip : {'\x01', '\xff'}) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ flip);
      write_content(file_, damaged);
      EXPECT_THAT(error_of([&] { read_recording(file_); }), testing::StartsWith(file_.string() + ": byte ")) << at;
    }
}

TEST_F(RecordingFile, SaysWhatIsWrong) {
  write_recording(file_, sample_recording());
  const std::string whole = content_of(file_);
  const auto message_after = [&](std::size_t at, const std::string& bytes) {
    std::string damaged = whole;
    damaged.replace(at, bytes.size(), bytes);
    write_content(file_, damaged);
    return error_of([&] { read_recording(file_); });
  };
  const std::string name = file_.string();
  EXPECT_EQ(message_after(0, "XX"), name + ": byte 0: wrong magic, expected a file that begins with 'COGSREAD'");
  EXPECT_EQ(message_after(8, "\x09"), name + ": byte 8: version 9, expected 1");
  EXPECT_THAT(
      message_after(13, std::string(8, '\xff')),
      testing::MatchesRegex(name + ": byte 13: a record's size is 18446744073709551615, but only [0-9]+ bytes follow"));
  EXPECT_THAT(message_after(whole.size() - 1, std::string(1, static_cast<char>(~whole.back()))),
              testing::HasSubstr("the hash does not fit the content: the file is damaged"));
  write_content(file_, whole + "x");
  EXPECT_THAT(error_of([&] { read_recording(file_); }), testing::HasSubstr("1 bytes too many"));
}

TEST_F(RecordingFile, MissingFileIsNamed) {
  EXPECT_EQ(error_of([&] { read_recording("no/such.rec"); }),
            "no/such.rec: cannot be opened: No such file or directory");
}

TEST(ReadingsHash, ChangesWithEveryField) {
  const std::vector<Reading> readings = sample_recording().readings;
  const std::string hash = readings_hash(readings);
  const auto changed = [&](auto change) {
    std::vector<Reading> copy = readings;
    change(copy[4]);
    return readings_hash(copy) != hash;
  };
  EXPECT_TRUE(changed([](Reading& r) { r.sequence += 1; }));
  EXPECT_TRUE(changed([](Reading& r) { r.stamp.ns += 1; }));
  EXPECT_TRUE(changed([](Reading& r) { r.motion.T_before_now.theta += 1e-15; }));
  EXPECT_TRUE(changed([](Reading& r) { r.motion.covariance(2, 1) += 1e-15; }));
  EXPECT_TRUE(changed([](Reading& r) { r.motion.source = MotionSource::kVisual; }));
  EXPECT_TRUE(changed([](Reading& r) { r.twist.y = 0.0; }));  // was -0
  EXPECT_TRUE(changed([](Reading& r) { r.scan->ranges[0] += 1e-6F; }));
  EXPECT_TRUE(changed([](Reading& r) { r.scan->range_max += 1; }));
  EXPECT_TRUE(changed([](Reading& r) { r.scan.reset(); }));
  EXPECT_TRUE(changed([](Reading& r) { r.heading = 0.0; }));
  EXPECT_FALSE(changed([](Reading&) {}));
  EXPECT_EQ(hash.size(), 16u);
}

}  // namespace
}  // namespace cogslam
