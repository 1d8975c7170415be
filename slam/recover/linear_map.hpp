#pragma once

#include <concepts>
#include <cstddef>
#include <span>

namespace cogslam {

/// A linear map used without ever storing its matrix.
///
/// Given `A a`, vectors x of a.cols() and y of a.rows() values:
/// - `a.apply(x, out)` writes A x, `a.apply_transpose(y, out)` writes A' y; neither allocates, and `out` is written
/// whole;
/// - they are adjoint: y . (A x) == (A' y) . x up to rounding;
/// - `a.orthonormal_rows()` promises A A' = I, on which closed-form projections rest;
/// - `a.is_selection()` promises that every row picks one entry of x: then A' y is y scattered over zeros.
///
/// Maps keep scratch memory, so `apply` is not const: use one map per thread.
template <class A>
concept LinearMap = requires(A a, std::span<const double> in, std::span<double> out) {
  { a.rows() } -> std::convertible_to<std::size_t>;
  { a.cols() } -> std::convertible_to<std::size_t>;
  { a.orthonormal_rows() } -> std::convertible_to<bool>;
  { a.is_selection() } -> std::convertible_to<bool>;
  a.apply(in, out);
  a.apply_transpose(in, out);
};

}  // namespace cogslam
