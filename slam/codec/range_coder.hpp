#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace cogslam {

/// The chance that a bit is 1, of 2^16; never 0.
using BitChance = std::uint16_t;

/// Writes bits of stated chances in little more than their information: a binary arithmetic coder that keeps an
/// interval of 32 bits and gives out its leading bytes once they are settled.
class RangeEncoder {
 public:
  explicit RangeEncoder(std::span<std::uint8_t> to) : to_(to) {}

  bool bit(BitChance one, bool bit) {
    const std::uint32_t middle = low_ + static_cast<std::uint32_t>((std::uint64_t{high_ - low_} * one) >> 16);
    if (bit) {
      high_ = middle;
    } else {
      low_ = middle + 1;
    }
    for (; (low_ ^ high_) >> 24 == 0; low_ <<= 8, high_ = high_ << 8 | 255U) put(high_ >> 24);
    return bit;
  }
  /// Closes the code with the fewest bytes that, followed by zeros, lie in the interval.
  void finish() {
    for (int bytes = 0; bytes <= 4; ++bytes) {
      const std::uint64_t unit = std::uint64_t{1} << (32 - 8 * bytes);
      const std::uint64_t value = (low_ + unit - 1) / unit * unit;
      if (value > high_) continue;
      for (int i = 0; i < bytes; ++i) put(static_cast<std::uint32_t>(value) >> (24 - 8 * i));
      break;
    }
    while (size_ > 0 && !overflown_ && to_[size_ - 1] == 0) --size_;
  }
  /// Bytes written; nothing can be made of them where they did not fit.
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool overflown() const { return overflown_; }

 private:
  void put(std::uint32_t byte) {
    if (size_ == to_.size()) {
      overflown_ = true;
      return;
    }
    to_[size_++] = static_cast<std::uint8_t>(byte);
  }

  std::span<std::uint8_t> to_;
  std::size_t size_ = 0;
  bool overflown_ = false;
  std::uint32_t low_ = 0, high_ = 0xFFFFFFFF;
};

/// Reads what a RangeEncoder wrote, given the same chances. Any bytes decode to some bits: whoever must know that they
/// are the right ones keeps a check sum.
class RangeDecoder {
 public:
  explicit RangeDecoder(std::span<const std::uint8_t> code) : code_(code) {
    for (int i = 0; i < 4; ++i) shift_in();
  }

  bool bit(BitChance one, bool /*unknown*/ = false) {
    const std::uint32_t middle = low_ + static_cast<std::uint32_t>((std::uint64_t{high_ - low_} * one) >> 16);
    const bool bit = value_ <= middle;
    if (bit) {
      high_ = middle;
    } else {
      low_ = middle + 1;
    }
    for (; (low_ ^ high_) >> 24 == 0; low_ <<= 8, high_ = high_ << 8 | 255U) shift_in();
    return bit;
  }
  /// All bytes of the code were needed.
  [[nodiscard]] bool took_all() const { return at_ >= code_.size(); }

 private:
  void shift_in() {
    value_ = value_ << 8 | (at_ < code_.size() ? code_[at_] : 0U);
    ++at_;
  }

  std::span<const std::uint8_t> code_;
  std::size_t at_ = 0;
  std::uint32_t low_ = 0, high_ = 0xFFFFFFFF, value_ = 0;
};

}  // namespace cogslam
