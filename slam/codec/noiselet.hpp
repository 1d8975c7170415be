#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace cogslam {

/// Real orthonormal noiselets (Coifman, Geshwind, Meyer 2001) of length n = 2^q.
///
/// The complex noiselets are, up to one common phase, the rows u_j(k) = n^(-1/2) i^d(j,k), with d the number of bits in
/// which j and k differ: a unitary, symmetric matrix. Row ~j (all bits turned) is the complex conjugate of row j up to
/// a phase, so each pair spans sqrt2 Re and sqrt2 Im of one of them. With the common phase e^(i pi/4) all entries are
/// +-n^(-1/2). Row j < n/2 of the real matrix is sqrt2 Re(e^(i pi/4) u_j), row ~j is sqrt2 Im(e^(i pi/4) u_j); for
/// n = 1 the matrix is [1]. Complex noiselets have coefficients of equal size on every Haar function; the real ones
/// share that size between the two rows of a pair.
class Noiselets {
 public:
  explicit Noiselets(std::size_t length);  ///< a power of two

  [[nodiscard]] std::size_t length() const { return real_.size(); }
  void forward(std::span<const double> values, std::span<double> out);
  void inverse(std::span<const double> coefficients, std::span<double> out);  ///< the transpose

 private:
  std::vector<double> real_, imaginary_;
};

}  // namespace cogslam
