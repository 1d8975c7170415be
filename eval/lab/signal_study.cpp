#include "eval/lab/signal_study.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/check.hpp"
#include "eval/lab/test_signal.hpp"
#include "eval/metrics/timing.hpp"
#include "slam/codec/compressor.hpp"
#include "slam/codec/top_m.hpp"

namespace cogslam {
namespace {

constexpr std::size_t kN = kTestSignalSize;

std::size_t rows_for(double percent) {
  EXPECTS(percent > 0.0 && percent <= 100.0);
  return std::max<std::size_t>(kept_count(kN, percent), 1);
}

/// H of m rows and what it says of the test signal.
struct Measurement {
  Compressor H;
  std::vector<double> y;

  Measurement(std::size_t m, std::uint32_t seed, const std::vector<double>& c)
      : H(make_compressor(CompressorKind::kGaussian, m, kN, seed)), y(m) {
    H.apply(c, y);
  }
};

std::uint32_t seed_number(std::size_t index) { return static_cast<std::uint32_t>(index) + 1; }

std::vector<SignalScore> empty_scores(const SignalStudy& study) {
  std::vector<SignalScore> scores;
  const auto seeds = static_cast<std::size_t>(study.seeds);
  for (std::size_t method = 0; method < study.methods.size(); ++method) {
    for (const double percent : study.percents) {
      scores.push_back({method, percent, rows_for(percent), std::vector<double>(seeds), std::vector<double>(seeds)});
    }
  }
  return scores;
}

}  // namespace

std::vector<double> twenty_percents() {
  std::vector<double> percents;
  for (int k = 1; k <= 20; ++k) percents.push_back(5.0 * k);
  return percents;
}

std::vector<SignalScore> run_signal_study(const SignalStudy& study, Workers& workers, const LabProgress& progress) {
  EXPECTS(study.seeds >= 1);
  std::vector<SignalScore> scores = empty_scores(study);
  const std::vector<double> c = test_signal_coefficients();
  for_each_seed(static_cast<std::size_t>(study.seeds), workers, progress, [&](std::size_t index) {
    for (SignalScore& score : scores) {
      Measurement measured(score.m, seed_number(index), c);
      const Stopwatch watch(Clock::kThreadCpu);
      const Recovered recovered = study.methods[score.method].recover(measured.H, measured.y);
      score.cpu_seconds[index] = watch.seconds();
      score.mse[index] = mean_squared_error(c, recovered.x);  // Parseval: that of the signal
    }
  });
  return scores;
}

std::vector<double> recovered_signal(const LabMethod& method, double percent, std::uint32_t seed) {
  const std::vector<double> c = test_signal_coefficients();
  Measurement measured(rows_for(percent), seed, c);
  const Recovered recovered = method.recover(measured.H, measured.y);
  std::vector<double> x(kN);
  Dct1d(kN).inverse(recovered.x, x);
  return x;
}

std::string signal_csv(const SignalStudy& study, const std::vector<SignalScore>& scores) {
  std::string text = "method,percent,m,seeds,mse_mean,mse_low95,mse_high95\n";
  for (const SignalScore& s : scores) {
    const MeanInterval mse = mean_interval(s.mse);
    text += fmt::format("{},{},{},{},{},{},{}\n", study.methods[s.method].name, s.percent, s.m, mse.count, mse.mean,
                        mse.low(), mse.high());
  }
  return text;
}

std::string signal_times_csv(const SignalStudy& study, const std::vector<SignalScore>& scores) {
  std::string text = "method,percent,m,seeds,cpu_ms_mean,cpu_ms_low95,cpu_ms_high95\n";
  for (const SignalScore& s : scores) {
    const MeanInterval t = mean_interval(s.cpu_seconds);
    text += fmt::format("{},{},{},{},{:.6g},{:.6g},{:.6g}\n", study.methods[s.method].name, s.percent, s.m, t.count,
                        1e3 * t.mean, 1e3 * t.low(), 1e3 * t.high());
  }
  return text;
}

std::string signal_table(const SignalStudy& study, const std::vector<SignalScore>& scores) {
  std::string text =
      fmt::format("{:<17}{:>7}{:>6}{:>14}{:>14}{:>12}\n", "method", "percent", "m", "mean MSE", "+- (95 %)", "CPU ms");
  for (const SignalScore& s : scores) {
    const MeanInterval mse = mean_interval(s.mse), t = mean_interval(s.cpu_seconds);
    text += fmt::format("{:<17}{:>7}{:>6}{:>14.4g}{:>14.2g}{:>12.4f}\n", study.methods[s.method].name, s.percent, s.m,
                        mse.mean, mse.half_width, 1e3 * t.mean);
  }
  return text;
}

}  // namespace cogslam
