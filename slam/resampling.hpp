#pragma once

#include <cstddef>
#include <vector>

namespace cogslam {

/// Weights [sum 1] of log-weights of any scale (log-sum-exp). The log-weights must be finite and not empty.
std::vector<double> normalised_weights(const std::vector<double>& log_weights);

/// N_eff = 1 / sum w^2, in [1, N]: how many equally weighted particles the set is worth (Kong et al. 1994).
double effective_sample_size(const std::vector<double>& weights);

/// Systematic resampling: how particle slots are filled. Slot i takes the particle whose share of the cumulative
/// weight holds (i + offset) / N; `offset` in (0, 1) is the only draw. Indices ascend, and particle j is taken
/// floor(N w_j) or ceil(N w_j) times.
std::vector<std::size_t> systematic_resample(const std::vector<double>& weights, double offset);

}  // namespace cogslam
