#pragma once

#include <cstddef>
#include <span>

namespace cogslam {

/// The rectangle on which a map is Haar transformed: each side grown to the next power of two, with log-odds 0
/// (unknown) above and to the right of the map. A 40 x 46 map lies on a 64 x 64 canvas, a 100 x 30 map on 128 x 32.
///
/// Padding is cheap here. Unknown cells give zero coefficients, so only `support()` coefficients, about as many as the
/// map has cells, can differ from zero (1873 for 40 x 46 = 1840 cells), and the transform computes no others.
struct HaarCanvas {
  int map_width = 0;   ///< cells along x, as given
  int map_height = 0;  ///< cells along y, as given
  int width = 0;       ///< power of two >= map_width
  int height = 0;      ///< power of two >= map_height
  int levels = 0;      ///< log2 of the longer side

  static constexpr int kMaxSide = 32768;  ///< of a map

  /// The smallest canvas of a map; both sides in [1, kMaxSide].
  static HaarCanvas covering(int map_width, int map_height);

  /// Cells of the map: the n of "percent of data".
  [[nodiscard]] std::size_t cells() const;
  /// Coefficients, the zero ones included.
  [[nodiscard]] std::size_t size() const;
  /// Coefficients that can differ from zero for some map of this size. Which ones follows from the map's size alone, so
  /// an index or a bitmap that is shared by both ends needs to tell apart only these.
  [[nodiscard]] std::size_t support() const;
  /// Scratch values that a transform needs.
  [[nodiscard]] std::size_t scratch_size() const;

  /// Cells of the map's low-pass image after `level` steps, along x and along y.
  [[nodiscard]] int extent_x(int level) const { return (map_width + (1 << level) - 1) >> level; }
  [[nodiscard]] int extent_y(int level) const { return (map_height + (1 << level) - 1) >> level; }
  /// Steps that halve both sides; the remaining ones halve the longer side only.
  [[nodiscard]] int square_levels() const;

  bool operator==(const HaarCanvas&) const = default;
};

/// Orthonormal Haar transform c = Phi^T m (eq. 14), non-standard (both directions at each level), at full depth.
///
/// Layout: the pyramid [LL | detail] on the row-major canvas. A step turns each block of cells a b / c d into
///   LL (a+b+c+d)/2    column differences, to its right (a-b+c-d)/2
///   row differences, in the next quarter rows (a+b-c-d)/2    diagonal (a-b-c+d)/2
/// and goes on with LL. When the shorter side has become one cell, the longer is halved alone, (a+b)/sqrt2 and
/// (a-b)/sqrt2, so that one coefficient, at index 0, carries the mean of any canvas, and a map of one row or one column
/// has the 1-D Haar transform.
///
/// Laws: ||c|| = ||m||; haar_inverse is the adjoint, and haar_inverse(haar_forward(m)) = m. On a map that fills its
/// canvas haar_forward(haar_inverse(c)) = c too; otherwise it is the projection onto coefficients of padded maps.
///
/// `values`: cells() values, row-major. `coefficients`: size() values, all are written.
/// `scratch`: scratch_size() values or more, overwritten. No two may overlap. Nothing is allocated.
void haar_forward(const HaarCanvas& canvas, std::span<const float> values, std::span<float> coefficients,
                  std::span<float> scratch);
void haar_forward(const HaarCanvas& canvas, std::span<const double> values, std::span<double> coefficients,
                  std::span<double> scratch);

/// The map m = Phi c (eq. 14), cropped to cells(); parameters as haar_forward.
void haar_inverse(const HaarCanvas& canvas, std::span<const float> coefficients, std::span<float> values,
                  std::span<float> scratch);
void haar_inverse(const HaarCanvas& canvas, std::span<const double> coefficients, std::span<double> values,
                  std::span<double> scratch);

}  // namespace cogslam
