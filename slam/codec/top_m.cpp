#include "slam/codec/top_m.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>

#include "core/check.hpp"

namespace cogslam {
namespace {

/// |value| as an integer of the same order.
std::uint32_t magnitude_of(float value) { return std::bit_cast<std::uint32_t>(value) & 0x7fffffffU; }

/// Writes the positions of all non-zeros, ascending; returns how many there are.
std::size_t find_nonzeros(std::span<const float> coefficients, std::vector<std::uint32_t>& positions) {
  if (positions.size() < coefficients.size()) {
    positions.resize(coefficients.size());
  }
  std::uint32_t* out = positions.data();
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    // Always written and kept only where non-zero: a branch here would be mispredicted half the time.
    *out = static_cast<std::uint32_t>(i);
    out += magnitude_of(coefficients[i]) != 0 ? 1 : 0;
  }
  return static_cast<std::size_t>(out - positions.data());
}

struct Threshold {
  std::uint32_t magnitude;  // of the m-th largest
  std::size_t equals;       // how many of exactly this magnitude belong to the m largest
};

constexpr std::size_t kBuckets = 2048;

/// How many candidates have each value of the bits selected by `shift` and `mask` (< kBuckets).
std::array<std::uint32_t, kBuckets> count_buckets(std::span<const std::uint32_t> candidates, int shift,
                                                  std::uint32_t mask) {
  // Two counters in turn: maps have many equal magnitudes, and one counter would wait for itself.
  std::array<std::uint32_t, kBuckets> counts{};
  std::array<std::uint32_t, kBuckets> others{};
  const std::size_t even = candidates.size() / 2 * 2;
  for (std::size_t i = 0; i < even; i += 2) {
    ++counts[candidates[i] >> shift & mask];
    ++others[candidates[i + 1] >> shift & mask];
  }
  if (even < candidates.size()) {
    ++counts[candidates[even] >> shift & mask];
  }
  std::transform(counts.begin(), counts.end(), others.begin(), counts.begin(), std::plus<>());
  return counts;
}

bool all_equal(std::span<const std::uint32_t> candidates) {
  std::uint32_t differing = 0;  // no early end: this way it runs on vector units
  for (const std::uint32_t candidate : candidates) differing |= candidate ^ candidates.front();
  return differing == 0;
}

/// The m-th largest magnitude at the given positions; 1 <= m <= positions.size(). `magnitudes` is scratch.
/// Radix selection: narrows the candidates to one bucket by the leading bits, then the middle, then the last ones.
/// Linear whatever the input, and as fast as nth_element at its best.
Threshold find_threshold(std::span<const float> coefficients, std::span<const std::uint32_t> positions, std::size_t m,
                         std::vector<std::uint32_t>& magnitudes) {
  if (magnitudes.size() < positions.size()) {
    magnitudes.resize(positions.size());
  }
  std::transform(positions.begin(), positions.end(), magnitudes.begin(),
                 [&](std::uint32_t position) { return magnitude_of(coefficients[position]); });
  std::span<std::uint32_t> candidates(magnitudes.data(), positions.size());
  std::size_t wanted = m;                // of the m largest, those that are among the candidates
  for (const int shift : {20, 10, 0}) {  // 11, 10 and 10 bits
    if (all_equal(candidates)) break;    // nothing to tell apart, and counting in one bucket is slow
    const std::uint32_t mask = shift == 20 ? 0x7ffU : 0x3ffU;
    const std::array<std::uint32_t, kBuckets> counts = count_buckets(candidates, shift, mask);
    std::uint32_t bucket = mask;
    while (counts[bucket] < wanted) {
      wanted -= counts[bucket--];
    }
    std::uint32_t* out = candidates.data();
    for (const std::uint32_t candidate : candidates) {
      *out = candidate;
      out += (candidate >> shift & mask) == bucket ? 1 : 0;
    }
    candidates = candidates.first(counts[bucket]);
  }
  return {candidates.front(), wanted};
}

/// Leaves the positions above the threshold and the first `equals` at it; returns how many these are.
std::size_t keep_largest(std::span<const float> coefficients, std::span<std::uint32_t> positions, Threshold threshold) {
  std::size_t kept = 0;
  std::size_t equals_left = threshold.equals;
  for (const std::uint32_t position : positions) {
    const std::uint32_t magnitude = magnitude_of(coefficients[position]);
    const std::size_t equal = magnitude == threshold.magnitude && equals_left > 0 ? 1 : 0;
    positions[kept] = position;
    kept += (magnitude > threshold.magnitude ? 1 : 0) + equal;
    equals_left -= equal;
  }
  return kept;
}

}  // namespace

std::size_t kept_count(std::size_t n, double percent) {
  EXPECTS(percent >= 0.0 && percent <= 100.0);
  return static_cast<std::size_t>(std::floor(static_cast<double>(n) * percent / 100.0 + 0.5));
}

void select_top_m(std::span<const float> coefficients, std::size_t m, CoefficientCode& code, TopMScratch& scratch) {
  EXPECTS(coefficients.size() <= std::numeric_limits<std::uint32_t>::max());
  std::size_t kept = m == 0 ? 0 : find_nonzeros(coefficients, scratch.positions);
  if (kept > m) {
    const std::span<std::uint32_t> nonzeros(scratch.positions.data(), kept);
    kept = keep_largest(coefficients, nonzeros, find_threshold(coefficients, nonzeros, m, scratch.magnitudes));
  }
  code.indices.assign(scratch.positions.begin(), scratch.positions.begin() + static_cast<std::ptrdiff_t>(kept));
  code.values.resize(kept);
  for (std::size_t i = 0; i < kept; ++i) {
    code.values[i] = coefficients[code.indices[i]];
  }
}

}  // namespace cogslam
