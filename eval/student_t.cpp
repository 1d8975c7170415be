#include "eval/student_t.hpp"

#include <cmath>
#include <limits>

#include "core/check.hpp"

namespace cogslam {
namespace {

/// Continued fraction of the incomplete beta function, for x < (a + 1) / (a + b + 2) (Numerical Recipes, eq. 6.4.5).
double beta_fraction(double a, double b, double x) {
  constexpr double kTiny = 1e-300;
  constexpr int kMostTerms = 10000;
  const auto apart_from_zero = [](double v) { return std::abs(v) < kTiny ? kTiny : v; };
  double c = 1.0, d = 1.0 / apart_from_zero(1.0 - (a + b) * x / (a + 1.0)), value = d;
  const auto take = [&](double term) {
    d = 1.0 / apart_from_zero(1.0 + term * d);
    c = apart_from_zero(1.0 + term / c);
    value *= c * d;
  };
  for (int m = 1; m <= kMostTerms; ++m) {
    const double n = m;
    take(n * (b - n) * x / ((a + 2.0 * n - 1.0) * (a + 2.0 * n)));
    take(-(a + n) * (a + b + n) * x / ((a + 2.0 * n) * (a + 2.0 * n + 1.0)));
    if (std::abs(c * d - 1.0) < std::numeric_limits<double>::epsilon()) break;
  }
  return value;
}

/// Regularised incomplete beta function I_x(a, b); `y` = 1 - x, given since it may be too close to 1 to be taken.
double incomplete_beta(double a, double b, double x, double y) {
  if (x <= 0.0) return 0.0;
  if (y <= 0.0) return 1.0;
  const double front =
      std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log(y));
  if (x < (a + 1.0) / (a + b + 2.0)) return front * beta_fraction(a, b, x) / a;
  return 1.0 - front * beta_fraction(b, a, y) / b;
}

}  // namespace

double student_t_tail(double t, double freedom) {
  EXPECTS(freedom > 0.0 && !std::isnan(t));
  if (std::isinf(t)) return t > 0.0 ? 0.0 : 1.0;
  const double whole = freedom + t * t;
  const double tail = 0.5 * incomplete_beta(0.5 * freedom, 0.5, freedom / whole, t * t / whole);
  return t >= 0.0 ? tail : 1.0 - tail;
}

double student_t_exceeded_with(double tail, double freedom) {
  EXPECTS(tail >= 1e-12 && tail <= 0.5 && freedom >= 1.0);
  double low = 0.0, high = 1.0;
  while (student_t_tail(high, freedom) > tail) high *= 2.0;
  while (high - low > 1e-13 * high) {
    const double middle = 0.5 * (low + high);
    (student_t_tail(middle, freedom) > tail ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace cogslam
