#include "sensors/pixel_noise.hpp"

#include <Random123/philox.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/check.hpp"

namespace cogslam {
namespace {

constexpr std::size_t kBatch = 256;  // pixels; small enough to stay in the first cache
// Variance of the sum of four bytes, each uniform over 0..255.
const double kDeviationOfSum = std::sqrt(4.0 * (256.0 * 256.0 - 1.0) / 12.0);

/// Sum of the four bytes of a word, less its mean.
int byte_sum(std::uint32_t word) {
  const std::uint32_t pairs = (word & 0x00FF00FFU) + ((word >> 8) & 0x00FF00FFU);
  return static_cast<int>((pairs & 0xFFFFU) + (pairs >> 16)) - 510;
}

void draw(std::array<int, kBatch>& sums, std::size_t first_pixel, const StreamKey& key) {
  const auto tick_low = static_cast<std::uint32_t>(key.tick), tick_high = static_cast<std::uint32_t>(key.tick >> 32);
  const r123::Philox4x32::key_type philox_key{{key.seed, static_cast<std::uint32_t>(key.purpose)}};
  for (std::size_t i = 0; i < kBatch; i += 4) {
    const auto block = static_cast<std::uint32_t>((first_pixel + i) / 4);
    const auto words = r123::Philox4x32{}({{block, key.entity, tick_low, tick_high}}, philox_key);
    for (std::size_t j = 0; j < 4; ++j) sums[i + j] = byte_sum(words[j]);
  }
}

}  // namespace

void light_and_noise(std::span<std::uint8_t> grey, std::span<const float> gains, double gain, double sigma,
                     const StreamKey& key) {
  EXPECTS(grey.size() == gains.size() && sigma >= 0.0 && gain >= 0.0);
  const auto light = static_cast<float>(gain), scale = static_cast<float>(sigma / kDeviationOfSum);
  std::array<int, kBatch> sums{};
  for (std::size_t first = 0; first < grey.size(); first += kBatch) {
    if (sigma > 0.0) draw(sums, first, key);
    const std::size_t count = std::min(kBatch, grey.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const float value =
          static_cast<float>(grey[first + i]) * gains[first + i] * light + scale * static_cast<float>(sums[i]);
      grey[first + i] = static_cast<std::uint8_t>(static_cast<int>(std::clamp(value + 0.5F, 0.0F, 255.0F)));
    }
  }
}

}  // namespace cogslam
