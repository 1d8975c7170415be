#include <gmock/gmock.h>

#include "sensors/faults/faulty_stream.hpp"
#include "sensors/readings.hpp"
#include "tests/support/error_text.hpp"

namespace cogslam {
namespace {

constexpr std::int64_t kPeriod = 20'000'000;  // ns

/// Sample n says n.
CompassSample sample(std::uint64_t n) { return {{static_cast<std::int64_t>(n) * kPeriod}, static_cast<double>(n)}; }

using Arrived = std::vector<std::optional<CompassSample>>;

Arrived pass(const std::vector<StreamFault>& faults, std::uint64_t count, std::uint32_t seed = 1) {
  FaultyStream<CompassSample> stream(faults, seed);
  Arrived arrived;
  for (std::uint64_t n = 0; n < count; ++n) arrived.push_back(stream.pass(sample(n), n));
  return arrived;
}

StreamFault fault(StreamFaultKind kind, double from_s, double to_s) {
  return {.kind = kind, .span = {Time::from_seconds(from_s), Time::from_seconds(to_s)}};
}

std::vector<std::size_t> lost(const Arrived& arrived) {
  std::vector<std::size_t> at;
  for (std::size_t n = 0; n < arrived.size(); ++n) {
    if (!arrived[n]) at.push_back(n);
  }
  return at;
}

TEST(Dropout, LosesTheStatedShareWithinItsSpanAndNothingElse) {
  StreamFault dropout = fault(StreamFaultKind::kDropout, 20.0, 220.0);
  dropout.probability = 0.3;
  const std::vector<std::size_t> at = lost(pass({dropout}, 20000));
  EXPECT_NEAR(static_cast<double>(at.size()), 3000.0, 5.0 * std::sqrt(10000 * 0.3 * 0.7));
  EXPECT_GE(at.front(), 1000U);
  EXPECT_LT(at.back(), 11000U);
}

TEST(Dropout, IsDecidedBySeedPlaceInTheListAndSampleAlone) {
  StreamFault dropout = fault(StreamFaultKind::kDropout, 0.0, 1e6);
  dropout.probability = 0.5;
  StreamFault second = dropout;
  second.number = 1;
  const auto once = lost(pass({dropout}, 500));
  EXPECT_EQ(lost(pass({dropout}, 500)), once);
  EXPECT_NE(lost(pass({dropout}, 500, 2)), once);
  EXPECT_NE(lost(pass({second}, 500)), once);
  EXPECT_NEAR(static_cast<double>(lost(pass({dropout, second}, 4000)).size()), 3000.0, 5.0 * std::sqrt(4000 * 0.1875));
}

TEST(Frozen, RepeatsTheLastSampleBeforeItsSpanWithNewStamps) {
  const Arrived arrived = pass({fault(StreamFaultKind::kFrozen, 1.0, 2.0)}, 150);
  for (std::uint64_t n = 0; n < 150; ++n) {
    ASSERT_TRUE(arrived[n]);
    EXPECT_EQ(arrived[n]->stamp, sample(n).stamp);
    EXPECT_EQ(arrived[n]->heading, n >= 50 && n < 100 ? 49.0 : static_cast<double>(n));
  }
}

TEST(Frozen, FromTheStartRepeatsTheFirstSample) {
  const Arrived arrived = pass({fault(StreamFaultKind::kFrozen, 0.0, 1.0)}, 60);
  EXPECT_EQ(arrived[49]->heading, 0.0);
  EXPECT_EQ(arrived[50]->heading, 50.0);
}

TEST(Late, TellsExactlyWhatWasTrueOneLatencyAgo) {
  StreamFault late = fault(StreamFaultKind::kLate, 1.0, 2.0);
  late.latency = Duration{7 * kPeriod};
  const Arrived arrived = pass({late}, 150);
  for (std::uint64_t n = 0; n < 150; ++n) {
    ASSERT_TRUE(arrived[n]);
    EXPECT_EQ(arrived[n]->stamp, sample(n).stamp);
    EXPECT_EQ(arrived[n]->heading, static_cast<double>(n >= 50 && n < 100 ? n - 7 : n));
  }
}

TEST(Late, BetweenTwoSamplesTellsTheOlderAndNothingBeforeTheFirst) {
  StreamFault late = fault(StreamFaultKind::kLate, 0.0, 10.0);
  late.latency = Duration{2 * kPeriod + 1};
  const Arrived arrived = pass({late}, 10);
  EXPECT_THAT(lost(arrived), testing::ElementsAre(0, 1, 2));
  for (std::uint64_t n = 3; n < 10; ++n) EXPECT_EQ(arrived[n]->heading, static_cast<double>(n - 3));
}

TEST(StreamFaults, ActOneAfterTheOther) {
  StreamFault late = fault(StreamFaultKind::kLate, 0.0, 10.0);
  late.latency = Duration{kPeriod};
  const Arrived arrived = pass({late, fault(StreamFaultKind::kFrozen, 0.1, 10.0)}, 20);
  EXPECT_FALSE(arrived[0]);
  EXPECT_EQ(arrived[4]->heading, 3.0);
  EXPECT_EQ(arrived[19]->heading, 3.0) << "frozen is what was late";
}

TEST(StreamFaults, WithoutAnyTheSamplesPassUnchanged) {
  const Arrived arrived = pass({}, 5);
  for (std::uint64_t n = 0; n < 5; ++n) EXPECT_EQ(arrived[n]->heading, static_cast<double>(n));
}

std::string message_of(const std::string& text, StreamFaultKind kind) {
  return error_text([&] {
    ConfigSection section = ConfigSection::parse(text, "f.yaml");
    read_stream_fault(section, kind, 0);
    section.finish();
  });
}

TEST(StreamFaults, SayWhatIsWrongInTheFile) {
  EXPECT_EQ(message_of("{probability: 0.5}", StreamFaultKind::kDropout),
            "f.yaml:1:1: 'sensor' is missing, expected one of lidar, compass, wheels, camera");
  EXPECT_EQ(message_of("{sensor: lidar, from_s: 3, to_s: 3}", StreamFaultKind::kFrozen),
            "f.yaml:1:28: the fault ends before it begins, expected from_s < to_s");
  EXPECT_THAT(message_of("{sensor: lidar, probability: 1.5}", StreamFaultKind::kDropout),
              testing::HasSubstr("f.yaml:1:30: probability: expected a number in [0, 1], found '1.5'"));
  EXPECT_THAT(message_of("{sensor: sonar}", StreamFaultKind::kLate),
              testing::HasSubstr("sensor: expected one of lidar, compass, wheels, camera"));
  EXPECT_THAT(message_of("{sensor: lidar, latency_s: 1}", StreamFaultKind::kFrozen),
              testing::HasSubstr("f.yaml:1:17: unknown key 'latency_s'"));
}

}  // namespace
}  // namespace cogslam
