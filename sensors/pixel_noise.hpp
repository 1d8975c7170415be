#pragma once

#include <cstdint>
#include <span>

#include "core/rng.hpp"

namespace cogslam {

/// grey = round(grey * gain * gains[i] + noise), clamped to 0..255, in place; `gains` has one entry per pixel.
///
/// The noise is the sum of four random bytes, scaled to standard deviation `sigma` [grey]: bell-shaped to +-3.45 sigma
/// (kurtosis 2.7 instead of 3), and the cheapest there is: one Philox block serves four pixels. Pixel i takes word i of
/// the stream `key`. Where sigma is 0 nothing is drawn.
void light_and_noise(std::span<std::uint8_t> grey, std::span<const float> gains, double gain, double sigma,
                     const StreamKey& key);

}  // namespace cogslam
