#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "slam/codec/dct.hpp"
#include "slam/codec/haar_basis.hpp"
#include "slam/codec/hadamard.hpp"

namespace cogslam {

/// Every orthonormal basis Phi of eq. (14), on one page. A signal of n values is a map of n x 1 cells.
enum class BasisKind {
  kHaar,          ///< 2-D non-standard: both directions at each level; sides padded to powers of two
  kHaarStandard,  ///< 2-D standard: all levels along x, then all levels along y; sides padded to powers of two
  kHaar1d,        ///< 1-D on vec(M), row-major (eq. 14 as printed); length padded to a power of two
  kDct,           ///< DCT-II, separable along x and y; any sides, nothing padded
  kDct1d,         ///< DCT-II on vec(M), row-major; any length, nothing padded
  kHadamard,      ///< Walsh-Hadamard in natural order, H_height (x) H_width; sides padded to powers of two
  kIdentity,      ///< the map itself
};

/// "haar", "haar_standard", "haar_1d", "dct", "dct_1d", "hadamard", "identity".
std::string_view name_of(BasisKind kind);
std::optional<BasisKind> basis_kind(std::string_view name);

/// No transform: coefficients are cells.
struct IdentityBasis {
  std::size_t length = 0;

  [[nodiscard]] std::size_t cells() const { return length; }
  [[nodiscard]] std::size_t size() const { return length; }
  void forward(std::span<const double> values, std::span<double> coefficients);
  void inverse(std::span<const double> coefficients, std::span<double> values);
};

/// A basis chosen at run time: coefficients c = Phi^T m and the map m = Phi c of eq. (14), in double.
///
/// Padding: cells that are added are 0 (unknown), on the canvas to the right of and above the map, or behind the last
/// cell in 1-D; `inverse` crops them. So forward has size() >= cells() coefficients, and
/// - ||forward(m)|| = ||m|| (Parseval), and inverse(forward(m)) = m;
/// - inverse is the adjoint of forward;
/// - forward(inverse(c)) = c where size() == cells(), else the projection of c onto coefficients of padded maps.
///
/// Nothing is allocated after construction. Scratch memory is kept: use one Basis per thread (copies are independent).
class Basis {
 public:
  /// A basis for maps of width x height cells, both >= 1 (at most 32768 for kHaar).
  Basis(BasisKind kind, int width, int height);

  [[nodiscard]] BasisKind kind() const { return kind_; }
  [[nodiscard]] std::size_t cells() const { return cells_; }  ///< n of "percent of data": values of a map
  [[nodiscard]] std::size_t size() const { return size_; }    ///< coefficients, those of the padding included

  /// `values`: cells() values, row-major; `coefficients`: size() values, all are written. They may not overlap.
  void forward(std::span<const double> values, std::span<double> coefficients);
  void inverse(std::span<const double> coefficients, std::span<double> values);

 private:
  using Any = std::variant<IdentityBasis, HaarBasis, HaarStandardBasis, Haar1dBasis, Dct2d, Dct1d, HadamardBasis>;
  static Any make(BasisKind kind, int width, int height);

  BasisKind kind_;
  Any basis_;
  std::size_t cells_;
  std::size_t size_;
};

}  // namespace cogslam
