#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "eval/lab/method.hpp"
#include "eval/lab/seeds.hpp"
#include "eval/stats.hpp"

namespace cogslam {

/// How well, and how fast, the test signal comes back (secs. 4.1 to 4.5). For each seed H is Haar-distributed
/// orthonormal Gaussian; the rows for a smaller percentage are the first rows of those for a larger one.
struct SignalStudy {
  std::vector<LabMethod> methods;
  std::vector<double> percents;  ///< in (0, 100]; m = floor(n percent / 100 + 1/2), at least 1
  int seeds = 30;                ///< seeds 1 to `seeds`
};

/// The percentages 5, 10, ..., 100 of sec. 4.5.
std::vector<double> twenty_percents();

/// One method at one percentage, over seeds.
struct SignalScore {
  std::size_t method = 0;  ///< index into SignalStudy::methods
  double percent = 0.0;
  std::size_t m = 0;
  std::vector<double> mse;          ///< by seed, mean((x - xhat)^2); not finite where the method diverged
  std::vector<double> cpu_seconds;  ///< by seed, of the recovery alone; measured, so never the same twice
};

/// Methods in their order, for each the percentages in theirs. All but the times is the same for any number of threads.
std::vector<SignalScore> run_signal_study(const SignalStudy& study, Workers& workers, const LabProgress& progress);

/// The signal brought back by one method from `percent` of one seed's data.
std::vector<double> recovered_signal(const LabMethod& method, double percent, std::uint32_t seed);

/// "method,percent,m,seeds,mse_mean,mse_low95,mse_high95", a line per score: no measured time, so it can be compared.
std::string signal_csv(const SignalStudy& study, const std::vector<SignalScore>& scores);
/// "method,percent,m,seeds,cpu_ms_mean,cpu_ms_low95,cpu_ms_high95".
std::string signal_times_csv(const SignalStudy& study, const std::vector<SignalScore>& scores);
/// The same for people, errors and times side by side.
std::string signal_table(const SignalStudy& study, const std::vector<SignalScore>& scores);

}  // namespace cogslam
