#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "slam/codec/coefficient_code.hpp"

namespace cogslam {

/// m = floor(n percent / 100 + 1/2), with n the cells of the map (not of a padded canvas); `percent` in [0, 100].
std::size_t kept_count(std::size_t n, double percent);

/// Memory that select_top_m reuses between calls.
struct TopMScratch {
  std::vector<std::uint32_t> positions;
  std::vector<std::uint32_t> magnitudes;
};

/// Fast compression (Alg. 7): keeps the m coefficients of largest magnitude. In an orthonormal basis this is the
/// selection of least squared error, the sum of the squares of the others (eq. 66, without its outer sum over i).
/// Of equal magnitudes the lower index is kept, so the result depends on the coefficients alone. Zeros are never kept:
/// `code` has min(m, non-zeros) entries, indices ascending. Coefficients must be finite.
///
/// Linear in the number of coefficients; allocates only while `code` and `scratch` grow.
void select_top_m(std::span<const float> coefficients, std::size_t m, CoefficientCode& code, TopMScratch& scratch);

}  // namespace cogslam
