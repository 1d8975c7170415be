#pragma once

#include <Eigen/Core>
#include <concepts>
#include <cstddef>
#include <span>
#include <type_traits>

#include "slam/recover/linear_map.hpp"

namespace cogslam {

/// Any LinearMap seen through one type, so that solvers are ordinary functions. Refers to the map, which must outlive
/// it; costs one indirect call per product. Is itself a LinearMap.
class MapView {
 public:
  template <LinearMap A>
  requires(!std::same_as<std::remove_cv_t<A>, MapView> && !std::is_const_v<A>)
      MapView(A& map)  // NOLINT(google-explicit-constructor): every map may be handed to every solver
      : map_(&map),
        rows_(map.rows()),
        cols_(map.cols()),
        orthonormal_rows_(map.orthonormal_rows()),
        is_selection_(map.is_selection()),
        apply_([](void* a, std::span<const double> x, std::span<double> out) { static_cast<A*>(a)->apply(x, out); }),
        apply_transpose_([](void* a, std::span<const double> y, std::span<double> out) {
          static_cast<A*>(a)->apply_transpose(y, out);
        }) {}

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t cols() const { return cols_; }
  [[nodiscard]] bool orthonormal_rows() const { return orthonormal_rows_; }
  [[nodiscard]] bool is_selection() const { return is_selection_; }

  /// out = A x
  void apply(std::span<const double> x, std::span<double> out) const { apply_(map_, x, out); }
  /// out = A' y
  void apply_transpose(std::span<const double> y, std::span<double> out) const { apply_transpose_(map_, y, out); }

 private:
  using Product = void (*)(void*, std::span<const double>, std::span<double>);

  void* map_;
  std::size_t rows_;
  std::size_t cols_;
  bool orthonormal_rows_;
  bool is_selection_;
  Product apply_;
  Product apply_transpose_;
};

/// The rows x cols matrix of a map, one product with A' per row.
[[nodiscard]] Eigen::MatrixXd explicit_matrix(const MapView& a);

/// ||A x - y||_2
[[nodiscard]] double residual_norm(const MapView& a, std::span<const double> x, std::span<const double> y);

}  // namespace cogslam
