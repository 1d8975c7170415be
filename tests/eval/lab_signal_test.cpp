#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "eval/lab/signal_study.hpp"
#include "eval/lab/test_signal.hpp"
#include "tests/support/error_text.hpp"

namespace cogslam {
namespace {

double energy(const std::vector<double>& v) { return std::inner_product(v.begin(), v.end(), v.begin(), 0.0); }

TEST(TestSignal, HasTheStatedEnergyInBothBases) {
  EXPECT_NEAR(energy(test_signal()), 795.441, 5e-4);
  EXPECT_NEAR(energy(test_signal_coefficients()), energy(test_signal()), 1e-9);
  EXPECT_EQ(test_signal_times().front(), 0.0);
  EXPECT_EQ(test_signal_times().back(), 10.0);
}

TEST(SignalStudy, MeetsTheClosedFormOfTheMeanL2Error) {
  const SignalStudy study{.methods = lab_methods_named({"fast_l2"}), .percents = {25, 50, 75}, .seeds = 200};
  Workers workers(1);
  const double power = energy(test_signal()) / 128.0, n = 128.0;
  for (const SignalScore& score : run_signal_study(study, workers, {})) {
    const auto m = static_cast<double>(score.m);
    const double expected = (1.0 - m / n) * power;
    const double deviation = power * std::sqrt(2.0 * m * (n - m) / (n * n * (n + 2.0)));
    EXPECT_NEAR(mean_interval(score.mse).mean, expected, 3.0 * deviation / std::sqrt(200.0)) << score.percent;
    // Not only the mean: the spread too, within what 200 draws can tell.
    const double measured = mean_interval(score.mse).half_width / student_t_975(199) * std::sqrt(200.0);
    EXPECT_NEAR(measured, deviation, 0.2 * deviation) << score.percent;
  }
}

TEST(SignalStudy, IsTheSameForAnyNumberOfThreads) {
  const SignalStudy study{.methods = lab_methods_named({"fast_l2", "pinv", "nesta", "csekf", "csekf_p_gradient"}),
                          .percents = {10, 55, 100},
                          .seeds = 3};
  Workers one(1), two(2);
  const std::string csv = signal_csv(study, run_signal_study(study, one, {}));
  EXPECT_EQ(csv, signal_csv(study, run_signal_study(study, two, {})));
  EXPECT_THAT(csv, testing::StartsWith("method,percent,m,seeds,mse_mean,mse_low95,mse_high95\nfast_l2,10,13,3,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 5 * 3);
}

TEST(SignalStudy, BringsSparseSignalsBackBetterThanL2) {
  const SignalStudy study{.methods = lab_methods_named({"fast_l2", "nesta", "csekf"}), .percents = {50}, .seeds = 3};
  Workers workers(1);
  const auto scores = run_signal_study(study, workers, {});
  const double l2 = mean_interval(scores[0].mse).mean;
  EXPECT_LT(mean_interval(scores[1].mse).mean, 1e-2 * l2);
  EXPECT_LT(mean_interval(scores[2].mse).mean, 1e-2 * l2);
}

TEST(LabMethods, SuggestsTheNameThatWasMeant) {
  EXPECT_EQ(error_text([] { lab_methods_named({"nessta"}); }), "unknown method 'nessta'; did you mean 'nesta'?");
  EXPECT_EQ(error_text([] { lab_methods_named({"magic"}); }),
            "unknown method 'magic', expected one of pinv, fast_l2, nesta, csekf, csekf_p_printed, csekf_p_gradient, "
            "csekf_p_power");
}

}  // namespace
}  // namespace cogslam
