#include "eval/lab/test_signal.hpp"

#include <cmath>

#include "core/check.hpp"
#include "slam/codec/dct.hpp"

namespace cogslam {

std::vector<double> test_signal_times() {
  std::vector<double> t;
  for (std::size_t i = 0; i < kTestSignalSize; ++i) {
    t.push_back(10.0 * static_cast<double>(i) / static_cast<double>(kTestSignalSize - 1));
  }
  return t;
}

std::vector<double> test_signal() {
  std::vector<double> x;
  for (const double t : test_signal_times()) x.push_back(std::sin(t) - std::cos(2.0 * t) - 3.0 * std::sin(0.25 * t));
  return x;
}

std::vector<double> test_signal_coefficients() {
  std::vector<double> c(kTestSignalSize);
  Dct1d(kTestSignalSize).forward(test_signal(), c);
  return c;
}

double mean_squared_error(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECTS(a.size() == b.size() && !a.empty());
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum / static_cast<double>(a.size());
}

}  // namespace cogslam
