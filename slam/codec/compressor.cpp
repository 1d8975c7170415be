#include "slam/codec/compressor.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/check.hpp"
#include "core/rng.hpp"

namespace cogslam {
namespace {

using Vector = Eigen::Map<Eigen::VectorXd>;
using ConstVector = Eigen::Map<const Eigen::VectorXd>;

struct Named {
  std::string_view name;
  CompressorKind kind;
};
constexpr std::array kNames{
    Named{"top_m", CompressorKind::kTopM},        Named{"selection", CompressorKind::kSelection},
    Named{"gaussian", CompressorKind::kGaussian}, Named{"hadamard", CompressorKind::kHadamard},
    Named{"dct", CompressorKind::kDct},           Named{"noiselet", CompressorKind::kNoiselet},
};

// Ticks keep the draws of one seed apart.
constexpr std::uint64_t kOrderTick = 0;
constexpr std::uint64_t kGaussianTick = 1;

Vector vector(std::span<double> values) { return {values.data(), static_cast<Eigen::Index>(values.size())}; }
ConstVector vector(std::span<const double> values) { return {values.data(), static_cast<Eigen::Index>(values.size())}; }

bool each_once_below(std::span<const std::uint32_t> positions, std::size_t n) {
  std::vector<bool> seen(n, false);
  for (const std::uint32_t position : positions) {
    if (position >= n || seen[position]) return false;
    seen[position] = true;
  }
  return true;
}

/// Rows of independent normal numbers, each made orthogonal to those before it (Gram-Schmidt, twice, which is enough:
/// Giraud et al. 2005) and normalised: the rows of Q' of a QR of their transpose with a positive diagonal of R. Row by
/// row, so that more rows never change the earlier ones.
MatrixRows gaussian_rows(std::size_t m, std::size_t n, std::uint32_t seed) {
  MatrixRows rows{.matrix{static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(n)}, .orthonormal = true};
  Eigen::VectorXd row(static_cast<Eigen::Index>(n));
  for (Eigen::Index i = 0; i < rows.matrix.rows(); ++i) {
    Rng rng({seed, Purpose::kCompression, static_cast<std::uint32_t>(i), kGaussianTick});
    for (double& value : row) value = rng.normal();
    const auto earlier = rows.matrix.topRows(i);
    for (int pass = 0; pass < 2; ++pass) {
      const Eigen::VectorXd along = earlier * row;
      row.noalias() -= earlier.transpose() * along;
    }
    rows.matrix.row(i) = row.normalized().transpose();
  }
  return rows;
}

RowTransform transform_of(CompressorKind kind, std::size_t n) {
  EXPECTS(exists_for(kind, n));
  if (kind == CompressorKind::kHadamard) return HadamardTransform{};
  if (kind == CompressorKind::kNoiselet) return Noiselets(n);
  EXPECTS(kind == CompressorKind::kDct);
  return Dct1d(n);
}

}  // namespace

std::string_view name_of(CompressorKind kind) { return std::ranges::find(kNames, kind, &Named::kind)->name; }

std::optional<CompressorKind> compressor_kind(std::string_view name) {
  const auto found = std::ranges::find(kNames, name, &Named::name);
  return found == kNames.end() ? std::nullopt : std::optional(found->kind);
}

bool exists_for(CompressorKind kind, std::size_t n) {
  return n > 0 && (std::has_single_bit(n) || (kind != CompressorKind::kHadamard && kind != CompressorKind::kNoiselet));
}

Compressor Compressor::matrix(const Eigen::MatrixXd& rows, bool orthonormal) {
  return Compressor(MatrixRows{rows, orthonormal});
}

Compressor Compressor::selection(std::vector<std::uint32_t> indices, std::size_t n) {
  EXPECTS(each_once_below(indices, n));
  return Compressor(Selection{std::move(indices), n});
}

Compressor Compressor::transform_rows(CompressorKind kind, std::vector<std::uint32_t> rows, std::size_t n) {
  EXPECTS(each_once_below(rows, n));
  return Compressor(RowSample(transform_of(kind, n), std::move(rows), n));
}

std::size_t Compressor::rows() const {
  if (const auto* dense = std::get_if<MatrixRows>(&rows_)) return static_cast<std::size_t>(dense->matrix.rows());
  if (const auto* selection = std::get_if<Selection>(&rows_)) return selection->indices.size();
  return std::get<RowSample>(rows_).rows();
}

std::size_t Compressor::cols() const {
  if (const auto* dense = std::get_if<MatrixRows>(&rows_)) return static_cast<std::size_t>(dense->matrix.cols());
  if (const auto* selection = std::get_if<Selection>(&rows_)) return selection->length;
  return std::get<RowSample>(rows_).cols();
}

bool Compressor::orthonormal_rows() const {
  const auto* dense = std::get_if<MatrixRows>(&rows_);
  return dense == nullptr || dense->orthonormal;
}

void Compressor::apply(std::span<const double> x, std::span<double> out) {
  EXPECTS(x.size() == cols() && out.size() == rows());
  if (const auto* dense = std::get_if<MatrixRows>(&rows_)) {
    vector(out).noalias() = dense->matrix * vector(x);
  } else if (const auto* selection = std::get_if<Selection>(&rows_)) {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = x[selection->indices[i]];
  } else {
    std::get<RowSample>(rows_).apply(x, out);
  }
}

void Compressor::apply_transpose(std::span<const double> y, std::span<double> out) {
  EXPECTS(y.size() == rows() && out.size() == cols());
  if (const auto* dense = std::get_if<MatrixRows>(&rows_)) {
    vector(out).noalias() = dense->matrix.transpose() * vector(y);
  } else if (const auto* selection = std::get_if<Selection>(&rows_)) {
    std::fill(out.begin(), out.end(), 0.0);
    for (std::size_t i = 0; i < y.size(); ++i) out[selection->indices[i]] = y[i];
  } else {
    std::get<RowSample>(rows_).apply_transpose(y, out);
  }
}

std::vector<std::uint32_t> random_order(std::size_t n, std::uint32_t seed) {
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0U);
  Rng rng({seed, Purpose::kCompression, 0, kOrderTick});
  for (std::size_t i = 0; i + 1 < n; ++i) {
    std::swap(order[i], order[i + rng.below(static_cast<std::uint32_t>(n - i))]);
  }
  return order;
}

Compressor make_compressor(CompressorKind kind, std::size_t m, std::size_t n, std::uint32_t seed) {
  EXPECTS(m <= n && kind != CompressorKind::kTopM && exists_for(kind, n));
  if (kind == CompressorKind::kGaussian) {
    const MatrixRows rows = gaussian_rows(m, n, seed);
    return Compressor::matrix(rows.matrix, true);
  }
  std::vector<std::uint32_t> rows = random_order(n, seed);
  rows.resize(m);
  if (kind == CompressorKind::kSelection) return Compressor::selection(std::move(rows), n);
  return Compressor::transform_rows(kind, std::move(rows), n);
}

Compressor make_top_m(std::span<const double> c, std::size_t m) {
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < c.size(); ++i) {
    if (c[i] != 0.0) kept.push_back(static_cast<std::uint32_t>(i));
  }
  const auto larger = [&](std::uint32_t a, std::uint32_t b) {
    const double size_a = std::abs(c[a]), size_b = std::abs(c[b]);
    return size_a > size_b || (size_a == size_b && a < b);
  };
  if (kept.size() > m) {
    std::nth_element(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(m), kept.end(), larger);
    kept.resize(m);
    std::sort(kept.begin(), kept.end());
  }
  return Compressor::selection(std::move(kept), c.size());
}

ForwardThenCompress::ForwardThenCompress(Basis basis, Compressor compressor)
    : basis_(std::move(basis)), compressor_(std::move(compressor)), coefficients_(basis_.size()) {
  EXPECTS(compressor_.cols() == basis_.size());
}

void ForwardThenCompress::apply(std::span<const double> map, std::span<double> out) {
  basis_.forward(map, coefficients_);
  compressor_.apply(coefficients_, out);
}

void ForwardThenCompress::apply_transpose(std::span<const double> y, std::span<double> out) {
  compressor_.apply_transpose(y, coefficients_);
  basis_.inverse(coefficients_, out);
}

InverseThenCompress::InverseThenCompress(Basis basis, Compressor compressor)
    : basis_(std::move(basis)), compressor_(std::move(compressor)), map_(basis_.cells()) {
  EXPECTS(compressor_.cols() == basis_.cells());
}

void InverseThenCompress::apply(std::span<const double> coefficients, std::span<double> out) {
  basis_.inverse(coefficients, map_);
  compressor_.apply(map_, out);
}

void InverseThenCompress::apply_transpose(std::span<const double> y, std::span<double> out) {
  compressor_.apply_transpose(y, map_);
  basis_.forward(map_, out);
}

}  // namespace cogslam
