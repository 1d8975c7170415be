#pragma once

#include <optional>
#include <vector>

namespace cogslam {

/// What a solver hands back. One that stops early still returns its best x, and says so here.
struct Recovered {
  std::vector<double> x;   ///< the recovered coefficients, or the map for total variation
  bool converged = false;  ///< the solver's own stopping rule was met
  int iterations = 0;
  double residual = 0.0;                ///< ||A x - y||_2, in the units of y
  std::optional<double> duality_gap{};  ///< relative: (objective - lower bound) / objective, where there is a bound
};

}  // namespace cogslam
