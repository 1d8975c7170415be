#include "slam/codec/row_sample.hpp"

#include <algorithm>

#include "core/check.hpp"
#include "slam/codec/hadamard.hpp"

namespace cogslam {

void HadamardTransform::forward(std::span<const double> values, std::span<double> out) {
  if (values.data() != out.data()) std::copy(values.begin(), values.end(), out.begin());
  walsh_hadamard(out);
}

RowSample::RowSample(RowTransform transform, std::vector<std::uint32_t> rows, std::size_t n)
    : transform_(std::move(transform)), rows_(std::move(rows)), full_(n) {}

void RowSample::apply(std::span<const double> x, std::span<double> out) {
  EXPECTS(x.size() == cols() && out.size() == rows());
  std::visit([&](auto& transform) { transform.forward(x, full_); }, transform_);
  for (std::size_t i = 0; i < rows_.size(); ++i) out[i] = full_[rows_[i]];
}

void RowSample::apply_transpose(std::span<const double> y, std::span<double> out) {
  EXPECTS(y.size() == rows() && out.size() == cols());
  std::fill(full_.begin(), full_.end(), 0.0);
  for (std::size_t i = 0; i < rows_.size(); ++i) full_[rows_[i]] = y[i];
  std::visit([&](auto& transform) { transform.inverse(full_, out); }, transform_);
}

}  // namespace cogslam
