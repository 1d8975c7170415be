#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace cogslam {

inline constexpr int kGlyphWidth = 5;
inline constexpr int kGlyphHeight = 8;  ///< 7 above the base line, 1 below

/// A letter as five columns, left to right; bit 0 is the top dot.
using Glyph = std::array<std::uint8_t, kGlyphWidth>;

/// The glyph of a printable ASCII character; that of '?' for all others.
const Glyph& glyph(char letter);

}  // namespace cogslam
