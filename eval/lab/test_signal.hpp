#pragma once

#include <vector>

namespace cogslam {

inline constexpr std::size_t kTestSignalSize = 128;

/// The t of eq. (24): 128 evenly spaced points of [0, 10], both ends included.
std::vector<double> test_signal_times();

/// f(t) = sin(t) - cos(2t) - 3 sin(0.25t) at those points, eq. (24).
std::vector<double> test_signal();

/// Its orthonormal DCT-II c = Phi^T x (fig. 1b). They fall off like 1/k^2 and are small, not zero, at the end: the
/// signal is compressible, not sparse.
std::vector<double> test_signal_coefficients();

/// Mean of the squared differences of two lists of one length.
double mean_squared_error(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace cogslam
