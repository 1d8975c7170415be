#include "core/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>
#include <thread>

#include "core/check.hpp"
#include "core/rng.hpp"

namespace cogslam {
namespace {

std::vector<double> draws_of(int threads, std::size_t count) {
  Workers workers(threads);
  std::vector<double> out(count);
  workers.for_each(count, [&](std::size_t i, int) {
    Rng rng({.seed = 1, .purpose = Purpose::kWorld, .entity = static_cast<std::uint32_t>(i)});
    for (int k = 0; k < 100; ++k) out[i] += rng.normal();
  });
  return out;
}

TEST(Parallel, GivesTheSameResultForAnyNumberOfThreads) {
  const std::vector<double> alone = draws_of(1, 500);
  for (int threads = 2; threads <= 8; ++threads) EXPECT_EQ(draws_of(threads, 500), alone) << threads;
}

TEST(Parallel, CallsEveryIndexOnceAndNamesTheWorker) {
  Workers workers(4);
  EXPECT_EQ(workers.threads(), 4);
  for (const std::size_t count : {0U, 1U, 2U, 3U, 1000U}) {  // one crew, many loops
    std::vector<std::atomic<int>> calls(count);
    std::atomic<bool> worker_known = true;
    workers.for_each(count, [&](std::size_t i, int worker) {
      ++calls[i];
      if (worker < 0 || worker >= 4) worker_known = false;
    });
    for (const auto& c : calls) EXPECT_EQ(c, 1);
    EXPECT_TRUE(worker_known);
  }
}

TEST(Parallel, SurvivesManyShortLoops) {
  Workers workers(3);
  std::vector<int> sums(7, 0);
  for (int round = 0; round < 5000; ++round) workers.for_each(sums.size(), [&](std::size_t i, int) { ++sums[i]; });
  EXPECT_EQ(sums, std::vector<int>(7, 5000));
}

TEST(Parallel, RethrowsTheFirstExceptionAndGoesOn) {
  for (const int threads : {1, 2, 5}) {
    Workers workers(threads);
    std::atomic<bool> later_failed = threads == 1;
    const auto body = [&](std::size_t i, int) {
      if (i == 17) later_failed = true;
      while (i == 7 && !later_failed) std::this_thread::yield();
      if (i == 7) std::this_thread::sleep_for(std::chrono::milliseconds(2));  // the later one is on record by now
      if (i % 10 == 7) throw std::runtime_error("index " + std::to_string(i));
    };
    for (int round = 0; round < 20; ++round) {
      try {
        workers.for_each(100, body);
        FAIL() << "no exception";
      } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "index 7");
      }
    }
    std::atomic<int> calls = 0;
    workers.for_each(50, [&](std::size_t, int) { ++calls; });
    EXPECT_EQ(calls, 50);
  }
}

TEST(Parallel, NeedsAtLeastTheCaller) { EXPECT_THROW(Workers(0), ContractViolation); }

}  // namespace
}  // namespace cogslam
