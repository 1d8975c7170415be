#pragma once

namespace cogslam {

/// Probability that a Student's t variable of `freedom` > 0 degrees exceeds `t`: within 1e-12 relative to the smaller
/// tail (regularised incomplete beta function by Lentz's continued fraction; Press et al., Numerical Recipes, 6.4).
double student_t_tail(double t, double freedom);

/// The t that a Student's t variable of `freedom` >= 1 degrees exceeds with probability `tail` in [1e-12, 0.5].
double student_t_exceeded_with(double tail, double freedom);

}  // namespace cogslam
