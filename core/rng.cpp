#include "core/rng.hpp"

#include <Random123/philox.h>

#include <cmath>
#include <numbers>

#include "core/check.hpp"

namespace cogslam {

// Key = (seed, purpose); counter = (block, entity, tick). The block index takes 2^16 values of the top half word
// of the tick as well, so a stream holds 2^48 blocks and a tick may be as large as 2^48.
Rng::Rng(const StreamKey& key)
    : key_{key.seed, static_cast<std::uint32_t>(key.purpose)},
      counter_{0, key.entity, static_cast<std::uint32_t>(key.tick), static_cast<std::uint32_t>(key.tick >> 32)} {
  EXPECTS(key.tick < (std::uint64_t{1} << 48));
}

std::uint32_t Rng::bits() {
  if (used_ == 4) {
    const auto out = r123::Philox4x32{}({{counter_[0], counter_[1], counter_[2], counter_[3]}}, {{key_[0], key_[1]}});
    block_ = {out[0], out[1], out[2], out[3]};
    used_ = 0;
    if (++counter_[0] == 0) counter_[3] += 1U << 16;
  }
  return block_[static_cast<std::size_t>(used_++)];
}

std::uint64_t Rng::bits64() {
  const std::uint64_t high = bits();
  return (high << 32) | bits();
}

double Rng::uniform() { return (static_cast<double>(bits64() >> 11) + 0.5) * 0x1p-53; }

double Rng::uniform(double low, double high) { return low + (high - low) * uniform(); }

double Rng::normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_normal_;
  }
  const double radius = std::sqrt(-2.0 * std::log(uniform()));
  const double angle = 2.0 * std::numbers::pi * uniform();
  spare_normal_ = radius * std::sin(angle);
  has_spare_ = true;
  return radius * std::cos(angle);
}

std::uint32_t Rng::below(std::uint32_t bound) {
  EXPECTS(bound > 0);
  const std::uint32_t reject_below = (0U - bound) % bound;  // 2^32 mod bound: the uneven remainder
  for (;;) {
    const std::uint32_t draw = bits();
    if (draw >= reject_below) return draw % bound;
  }
}

}  // namespace cogslam
