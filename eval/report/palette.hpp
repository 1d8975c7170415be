#pragma once

#include "eval/report/canvas.hpp"

// Okabe and Ito (2008), "Color Universal Design": told apart by readers with any colour vision, and by their lightness.

namespace cogslam {

inline constexpr Colour kBlack{0, 0, 0};
inline constexpr Colour kWhite{255, 255, 255};
inline constexpr Colour kGrey{127, 127, 127};
inline constexpr Colour kLightGrey{225, 225, 225};
inline constexpr Colour kSkyBlue{86, 180, 233};
inline constexpr Colour kBlue{0, 114, 178};
inline constexpr Colour kVermilion{213, 94, 0};

}  // namespace cogslam
