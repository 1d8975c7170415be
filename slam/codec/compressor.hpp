#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "slam/codec/basis.hpp"
#include "slam/codec/noiselet.hpp"
#include "slam/codec/row_sample.hpp"

namespace cogslam {

/// Every compression matrix H of eq. (15), y = H c, on one page.
enum class CompressorKind {
  kTopM,       ///< the m coefficients of largest magnitude: depends on c, so the indices belong to the data (Alg. 7)
  kSelection,  ///< m coefficients picked at random
  kGaussian,   ///< orthonormalised Gaussian rows, dense: m x n doubles
  kHadamard,   ///< random rows of the Walsh-Hadamard matrix / sqrt(n); n a power of two
  kDct,        ///< random rows of the DCT-II matrix
  kNoiselet,   ///< random rows of the real noiselet matrix (noiselet.hpp); n a power of two
};

/// "top_m", "selection", "gaussian", "hadamard", "dct", "noiselet".
std::string_view name_of(CompressorKind kind);
std::optional<CompressorKind> compressor_kind(std::string_view name);

/// Whether H of this kind exists for n coefficients.
bool exists_for(CompressorKind kind, std::size_t n);

/// Rows given as a dense matrix.
struct MatrixRows {
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> matrix;
  bool orthonormal = false;
};

/// Picks entries: row i is the unit vector of position indices[i].
struct Selection {
  std::vector<std::uint32_t> indices;  ///< each once
  std::size_t length = 0;              ///< entries to pick from
};

/// H, chosen at run time; a LinearMap from n = cols() coefficients to m = rows() measurements. All but a given matrix
/// have orthonormal rows, H H' = I, so the pseudo-inverse is H'. Nothing is allocated by apply and apply_transpose.
class Compressor {
 public:
  /// A given dense matrix; `orthonormal` is the caller's promise.
  static Compressor matrix(const Eigen::MatrixXd& rows, bool orthonormal);
  /// The given positions in the given order, each once and below n.
  static Compressor selection(std::vector<std::uint32_t> indices, std::size_t n);
  /// The given rows of an orthonormal n x n transform (kHadamard, kDct or kNoiselet), in the given order.
  static Compressor transform_rows(CompressorKind kind, std::vector<std::uint32_t> rows, std::size_t n);

  [[nodiscard]] std::size_t rows() const;
  [[nodiscard]] std::size_t cols() const;
  [[nodiscard]] bool orthonormal_rows() const;
  [[nodiscard]] bool is_selection() const { return std::holds_alternative<Selection>(rows_); }
  /// The selected positions; for selections only.
  [[nodiscard]] std::span<const std::uint32_t> indices() const { return std::get<Selection>(rows_).indices; }

  void apply(std::span<const double> x, std::span<double> out);            ///< out = H x
  void apply_transpose(std::span<const double> y, std::span<double> out);  ///< out = H' y

 private:
  using Rows = std::variant<MatrixRows, Selection, RowSample>;
  explicit Compressor(Rows rows) : rows_(std::move(rows)) {}
  Rows rows_;
};

/// H of m rows for n coefficients, 0 <= m <= n, any kind but kTopM, where exists_for(kind, n). Nested: the rows for m
/// are the first rows for any larger m of the same seed. Random rows are the first m of a random order of all.
Compressor make_compressor(CompressorKind kind, std::size_t m, std::size_t n, std::uint32_t seed);

/// The selection of the m entries of c of largest magnitude (Alg. 7), ascending; of equals the lower index. Zeros are
/// never kept, so there are min(m, non-zeros) rows.
Compressor make_top_m(std::span<const double> c, std::size_t m);

/// A random order of 0 .. n-1; the m first are a uniform sample without replacement.
std::vector<std::uint32_t> random_order(std::size_t n, std::uint32_t seed);

/// H Phi': measures the coefficients of a map, from the map itself. y = H (Phi' m).
class ForwardThenCompress {
 public:
  ForwardThenCompress(Basis basis, Compressor compressor);  ///< compressor.cols() == basis.size()

  [[nodiscard]] std::size_t rows() const { return compressor_.rows(); }
  [[nodiscard]] std::size_t cols() const { return basis_.cells(); }
  /// Not on a padded canvas, of which the map sees a part only.
  [[nodiscard]] bool orthonormal_rows() const {
    return compressor_.orthonormal_rows() && basis_.cells() == basis_.size();
  }
  [[nodiscard]] bool is_selection() const {
    return compressor_.is_selection() && basis_.kind() == BasisKind::kIdentity;
  }
  void apply(std::span<const double> map, std::span<double> out);
  void apply_transpose(std::span<const double> y, std::span<double> out);

 private:
  Basis basis_;
  Compressor compressor_;
  std::vector<double> coefficients_;
};

/// H Phi: measures the map that given coefficients stand for. With a selection of cells, samples of the map at points.
class InverseThenCompress {
 public:
  InverseThenCompress(Basis basis, Compressor compressor);  ///< compressor.cols() == basis.cells()

  [[nodiscard]] std::size_t rows() const { return compressor_.rows(); }
  [[nodiscard]] std::size_t cols() const { return basis_.size(); }
  [[nodiscard]] bool orthonormal_rows() const { return compressor_.orthonormal_rows(); }
  [[nodiscard]] bool is_selection() const {
    return compressor_.is_selection() && basis_.kind() == BasisKind::kIdentity;
  }
  void apply(std::span<const double> coefficients, std::span<double> out);
  void apply_transpose(std::span<const double> y, std::span<double> out);

 private:
  Basis basis_;
  Compressor compressor_;
  std::vector<double> map_;
};

}  // namespace cogslam
