#include "eval/metrics/timing.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <vector>

#include "core/check.hpp"

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

}  // namespace
}  // namespace cogslam
