#include "slam/resampling.hpp"

#include <algorithm>
#include <cmath>

#include "core/check.hpp"

namespace cogslam {

std::vector<double> normalised_weights(const std::vector<double>& log_weights) {
  EXPECTS(!log_weights.empty());
  EXPECTS(std::all_of(log_weights.begin(), log_weights.end(), [](double l) { return std::isfinite(l); }));
  const double top = *std::max_element(log_weights.begin(), log_weights.end());
  std::vector<double> weights;
  double sum = 0.0;
  for (const double l : log_weights) {
    weights.push_back(std::exp(l - top));
    sum += weights.back();
  }
  for (double& w : weights) w /= sum;
  return weights;
}

double effective_sample_size(const std::vector<double>& weights) {
  double squares = 0.0;
  for (const double w : weights) squares += w * w;
  return 1.0 / squares;
}

std::vector<std::size_t> systematic_resample(const std::vector<double>& weights, double offset) {
  EXPECTS(offset > 0.0 && offset < 1.0 && !weights.empty());
  const auto n = static_cast<double>(weights.size());
  std::vector<std::size_t> chosen;
  std::size_t j = 0;
  double cumulative = weights[0];
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double point = (static_cast<double>(i) + offset) / n;
    while (cumulative < point && j + 1 < weights.size()) cumulative += weights[++j];
    chosen.push_back(j);
  }
  return chosen;
}

}  // namespace cogslam
