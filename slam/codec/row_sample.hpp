#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "slam/codec/dct.hpp"
#include "slam/codec/noiselet.hpp"

namespace cogslam {

/// The Walsh-Hadamard matrix / sqrt(n) as a transform.
struct HadamardTransform {
  void forward(std::span<const double> values, std::span<double> out);
  void inverse(std::span<const double> values, std::span<double> out) { forward(values, out); }
};

using RowTransform = std::variant<HadamardTransform, Dct1d, Noiselets>;

/// Chosen rows of an orthonormal n x n transform, without its matrix: one fast transform per use.
class RowSample {
 public:
  /// `rows`: each once and below n.
  RowSample(RowTransform transform, std::vector<std::uint32_t> rows, std::size_t n);

  [[nodiscard]] std::size_t rows() const { return rows_.size(); }
  [[nodiscard]] std::size_t cols() const { return full_.size(); }
  void apply(std::span<const double> x, std::span<double> out);
  void apply_transpose(std::span<const double> y, std::span<double> out);

 private:
  RowTransform transform_;
  std::vector<std::uint32_t> rows_;
  std::vector<double> full_;
};

}  // namespace cogslam
