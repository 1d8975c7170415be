#pragma once

#include <span>

#include "slam/recover/map_view.hpp"
#include "slam/recover/recovered.hpp"

namespace cogslam {

/// Compressed sensing recovery (sec. 4.2, eq. 36): min ||x||_1 subject to ||A x - y||_2 <= eps, by NESTA (Becker,
/// Bobin, Candes 2011): Nesterov's method on |x| made smooth (Huber), continued over shrinking smoothing widths mu.
/// Asks for orthonormal rows, on which its closed-form projection rests.
///
/// The answer is feasible. It comes with a duality gap: lambda = A grad f_mu bounds the optimum from below by
/// (y . lambda - eps ||lambda||_2) / max(1, ||A' lambda||_inf).
struct Nesta {
  double eps = 0.0;             ///< radius of the constraint, units of y, >= 0
  double mu_final = 1e-6;       ///< last smoothing width, as a fraction of max|A' y|; at most 0.9; 0: from the gap
  int continuation = 8;         ///< number of smoothing widths, >= 1
  double tolerance = 1e-9;      ///< last relative change of the smoothed norm that ends a width, > 0
  double stop_at_gap = 0.0;     ///< ends the whole run at this relative duality gap; until then, the last width is
                                ///< halved again and again. 0: widths and tolerance alone end it
  bool restart = false;         ///< drops the momentum when the smoothed norm rises (O'Donoghue and Candes 2015)
  int max_iterations = 100000;  ///< over all widths

  /// Runs to a relative duality gap > 0, by the fastest parameters found (bench/recover.cpp). As the smoothing costs up
  /// to n mu / 2, the last width follows from the gap: gap times the mean of |A' y|.
  static Nesta to_gap(double gap, double eps = 0.0);
};

/// `y`: a.rows() values. converged: the gap asked for was reached, or every width ended by its tolerance.
[[nodiscard]] Recovered recover(const Nesta& nesta, const MapView& a, std::span<const double> y);

}  // namespace cogslam
