#include "eval/metrics/timing.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <vector>

#include "core/check.hpp"
#include "eval/metrics/stage_times.hpp"

namespace cogslam {
namespace {

/// Keeps the calling thread busy until its own CPU clock has moved on.
void burn(double seconds) {
  const Stopwatch watch(Clock::kThreadCpu);
  while (watch.seconds() < seconds) {
  }
}

TEST(Stopwatch, CountsSleepAsWallTimeOnly) {
  const Stopwatch wall(Clock::kWall), cpu(Clock::kProcessCpu);
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  EXPECT_GE(wall.seconds(), 0.06);
  EXPECT_LT(cpu.seconds(), 0.05);
}

TEST(Stopwatch, CountsTheWorkOfOtherThreadsForTheProcessOnly) {
  const Stopwatch process(Clock::kProcessCpu), own(Clock::kThreadCpu);
  std::jthread([] { burn(0.05); }).join();
  EXPECT_GE(process.seconds(), 0.05);
  EXPECT_LT(own.seconds(), 0.03);
}

TEST(StretchTimer, AddsUpWhatLiesBetweenStartAndStop) {
  StretchTimer timer(Clock::kThreadCpu);
  EXPECT_EQ(timer.seconds(), 0.0);
  for (int i = 0; i < 2; ++i) {
    timer.start();
    burn(0.02);
    timer.stop();
    burn(0.05);
  }
  EXPECT_GE(timer.seconds(), 0.04);
  EXPECT_LT(timer.seconds(), 0.06);
  EXPECT_THROW(timer.stop(), ContractViolation);
}

TEST(Memory, GrowsByWhatIsTouchedAndKeepsThePeak) {
  const auto before = rss_bytes();
  if (!before) GTEST_SKIP() << "needs /proc";
  constexpr std::size_t kBytes = 64 << 20;
  {
    const std::vector<char> block(kBytes, 1);
    EXPECT_GE(*rss_bytes(), *before + kBytes * 9 / 10 + static_cast<std::size_t>(block[kBytes / 2] - 1));
  }
  EXPECT_GE(*rss_peak_bytes(), *before + kBytes * 9 / 10);
  if (!reset_rss_peak()) GTEST_SKIP() << "the system does not let the peak start anew";
  EXPECT_LT(*rss_peak_bytes(), *before + kBytes * 5 / 10);
}

TEST(StageTimes, AddUpByStageOverThreads) {
  StageTimes times(2);
  times.enter(0, Stage::kTrack);
  burn(0.01);
  times.enter(0, Stage::kWeigh);  // ends the one before
  std::jthread([&] {
    times.enter(1, Stage::kWeigh);
    burn(0.02);
    times.leave(1);
    burn(0.01);  // of no stage
  }).join();
  burn(0.01);
  times.leave(0);
  times.leave(0);  // nothing runs
  const StageSeconds seconds = times.seconds();
  const auto of = [&](Stage stage) { return seconds[static_cast<std::size_t>(stage)]; };
  EXPECT_GE(of(Stage::kTrack), 0.01);
  EXPECT_LT(of(Stage::kTrack), 0.015);
  EXPECT_GE(of(Stage::kWeigh), 0.03);
  EXPECT_LT(of(Stage::kWeigh), 0.038);
  EXPECT_EQ(of(Stage::kLoad), 0.0);
}

}  // namespace
}  // namespace cogslam
