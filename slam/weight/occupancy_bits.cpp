#include "slam/weight/occupancy_bits.hpp"

#include <algorithm>
#include <cmath>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace cogslam {
namespace {

struct Bits {
  std::uint64_t occupied = 0;
  std::uint64_t known = 0;
};

Bits bits_of(const float* cells, int count) {
  Bits bits;
  for (int i = 0; i < count; ++i) {
    bits.occupied |= static_cast<std::uint64_t>(cells[i] > kOccupiedLogOdds) << i;
    bits.known |= static_cast<std::uint64_t>(!is_unknown(cells[i])) << i;
  }
  return bits;
}

/// `highest_free`: the highest level that is no obstacle; `least_known`: the least size of a known level.
Bits bits_of(const std::int8_t* cells, int count, int highest_free, int least_known) {
  Bits bits;
  int i = 0;
#if defined(__SSE2__)
  const __m128i free = _mm_set1_epi8(static_cast<char>(highest_free));
  const __m128i above = _mm_set1_epi8(static_cast<char>(least_known - 1));
  const __m128i below = _mm_set1_epi8(static_cast<char>(1 - least_known));
  for (; i + 16 <= count; i += 16) {
    const __m128i x = _mm_loadu_si128(reinterpret_cast<const __m128i*>(cells + i));
    const int occupied = _mm_movemask_epi8(_mm_cmpgt_epi8(x, free));
    const int known = _mm_movemask_epi8(_mm_or_si128(_mm_cmpgt_epi8(x, above), _mm_cmplt_epi8(x, below)));
    bits.occupied |= static_cast<std::uint64_t>(static_cast<std::uint32_t>(occupied)) << i;
    bits.known |= static_cast<std::uint64_t>(static_cast<std::uint32_t>(known)) << i;
  }
#endif
  for (; i < count; ++i) {
    bits.occupied |= static_cast<std::uint64_t>(cells[i] > highest_free) << i;
    bits.known |= static_cast<std::uint64_t>(std::abs(cells[i]) >= least_known) << i;
  }
  return bits;
}

}  // namespace

void OccupancyBits::resize(const GridFrame& frame) {
  frame_ = frame;
  words_ = static_cast<std::size_t>((frame.width + 63) / 64 + 2);
  const std::size_t words = words_ * static_cast<std::size_t>(frame.height);
  occupied_.assign(words, 0);
  known_.assign(words, 0);
  any_occupied_ = false;
}

void OccupancyBits::read(const Grid<float>& log_odds) {
  resize(log_odds.frame());
  for (int y = 0; y < frame_.height; ++y) {
    const float* row = log_odds.values().data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(frame_.width);
    for (int x = 0; x < frame_.width; x += 64) {
      const Bits bits = bits_of(row + x, std::min(64, frame_.width - x));
      occupied_[word(x, y)] = bits.occupied;
      known_[word(x, y)] = bits.known;
      any_occupied_ = any_occupied_ || bits.occupied != 0;
    }
  }
}

void OccupancyBits::read(const Grid<std::int8_t>& levels, double unit) {
  resize(levels.frame());
  const int highest_free = static_cast<int>(std::min(127.0, std::floor(kOccupiedLogOdds / unit)));
  const int least_known = static_cast<int>(std::min(127.0, std::ceil(kUnknownLogOdds / unit)));
  for (int y = 0; y < frame_.height; ++y) {
    const std::int8_t* row =
        levels.values().data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(frame_.width);
    for (int x = 0; x < frame_.width; x += 64) {
      const Bits bits = bits_of(row + x, std::min(64, frame_.width - x), highest_free, least_known);
      occupied_[word(x, y)] = bits.occupied;
      known_[word(x, y)] = bits.known;
      any_occupied_ = any_occupied_ || bits.occupied != 0;
    }
  }
}

}  // namespace cogslam
