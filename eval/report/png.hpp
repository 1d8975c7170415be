#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace cogslam {

/// A PNG file of 8-bit RGB pixels, row-major, top row first; `rgb` holds 3 x width x height values. The same pixels
/// give the same bytes (no time stamp is written).
std::string png_bytes(int width, int height, std::span<const std::uint8_t> rgb);

}  // namespace cogslam
