#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace cogslam {

/// A LinearMap that stores its matrix, row-major: for maps without structure, such as Gaussian ones, and for tests.
/// Measures its own traits: orthonormal if no entry of A A' - I exceeds 1e-10, a selection if every row is one 1 in
/// zeros.
class MatrixMap {
 public:
  /// `entries`: rows * cols values.
  MatrixMap(std::vector<double> entries, std::size_t rows, std::size_t cols);

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t cols() const { return cols_; }
  [[nodiscard]] bool orthonormal_rows() const { return orthonormal_rows_; }
  [[nodiscard]] bool is_selection() const { return is_selection_; }
  [[nodiscard]] std::span<const double> entries() const { return entries_; }

  void apply(std::span<const double> x, std::span<double> out) const;
  void apply_transpose(std::span<const double> y, std::span<double> out) const;

 private:
  std::vector<double> entries_;
  std::size_t rows_;
  std::size_t cols_;
  bool orthonormal_rows_ = false;
  bool is_selection_ = false;
};

}  // namespace cogslam
