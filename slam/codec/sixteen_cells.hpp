#pragma once

#include <cstdint>
#include <cstring>

#include "slam/codec/tile_cells.hpp"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

// Sixteen cells at a time, with SSE2 (part of every x86-64) or in plain C++.

namespace cogslam {

/// Bit i: cells i of two groups are equal.
inline std::uint32_t equal_16(const std::int8_t* a, const std::int8_t* b) {
#if defined(__SSE2__)
  const __m128i x = _mm_loadu_si128(reinterpret_cast<const __m128i*>(a));
  const __m128i y = _mm_loadu_si128(reinterpret_cast<const __m128i*>(b));
  return static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_cmpeq_epi8(x, y)));
#else
  std::uint32_t mask = 0;
  for (int i = 0; i < 16; ++i) mask |= static_cast<std::uint32_t>(a[i] == b[i]) << i;
  return mask;
#endif
}

/// The cells as nibbles level - lowest, cell 0 lowest; of use where all of them fit (see outside_16).
inline std::uint64_t pack_16(const std::int8_t* cells, int lowest) {
#if defined(__SSE2__)
  const __m128i x = _mm_loadu_si128(reinterpret_cast<const __m128i*>(cells));
  const __m128i bytes = _mm_sub_epi8(x, _mm_set1_epi8(static_cast<char>(lowest)));
  const __m128i pairs = _mm_and_si128(_mm_or_si128(bytes, _mm_srli_epi16(bytes, 4)), _mm_set1_epi16(0xFF));
  std::uint64_t packed;
  _mm_storel_epi64(reinterpret_cast<__m128i*>(&packed), _mm_packus_epi16(pairs, pairs));
  return packed;
#else
  std::uint64_t packed = 0;
  for (int i = 0; i < 16; ++i) packed |= static_cast<std::uint64_t>((cells[i] - lowest) & 15) << (4 * i);
  return packed;
#endif
}

/// Writes sixteen cells of level nibble + lowest.
inline void unpack_16(std::uint64_t packed, int lowest, std::int8_t* cells) {
#if defined(__SSE2__)
  const __m128i pairs = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(&packed));
  const __m128i low = _mm_set1_epi8(15);
  const __m128i even = _mm_and_si128(pairs, low), odd = _mm_and_si128(_mm_srli_epi16(pairs, 4), low);
  const __m128i nibbles = _mm_unpacklo_epi8(even, odd);
  _mm_storeu_si128(reinterpret_cast<__m128i*>(cells), _mm_add_epi8(nibbles, _mm_set1_epi8(static_cast<char>(lowest))));
#else
  for (int i = 0; i < 16; ++i) cells[i] = static_cast<std::int8_t>(static_cast<int>(packed >> (4 * i) & 15) + lowest);
#endif
}

/// True where a level lies outside [lowest, highest].
inline bool outside_16(const std::int8_t* cells, int lowest, int highest) {
#if defined(__SSE2__)
  const __m128i x = _mm_loadu_si128(reinterpret_cast<const __m128i*>(cells));
  const __m128i above = _mm_sub_epi8(x, _mm_set1_epi8(static_cast<char>(lowest)));
  const __m128i excess = _mm_subs_epu8(above, _mm_set1_epi8(static_cast<char>(highest - lowest)));
  return _mm_movemask_epi8(_mm_cmpeq_epi8(excess, _mm_setzero_si128())) != 0xFFFF;
#else
  for (int i = 0; i < 16; ++i) {
    if (cells[i] < lowest || cells[i] > highest) return true;
  }
  return false;
#endif
}

}  // namespace cogslam
