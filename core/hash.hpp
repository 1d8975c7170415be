#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>

namespace cogslam {

/// FNV-1a over the bytes of values: names a state, so that two runs can be told apart. Not for secrets.
class Hash {
 public:
  template <class T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) Hash& add(T value) {
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    for (const unsigned char b : bytes) state_ = (state_ ^ b) * 0x100000001b3ULL;
    return *this;
  }
  template <class T>
  Hash& add(std::span<const T> values) {
    add(static_cast<std::uint64_t>(values.size()));
    for (const T& v : values) add(v);
    return *this;
  }
  Hash& add(const std::string& text) { return add(std::span<const char>(text.data(), text.size())); }

  [[nodiscard]] std::uint64_t value() const { return state_; }
  [[nodiscard]] std::string hex() const;  ///< 16 lower-case digits

 private:
  std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

inline std::string Hash::hex() const {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string out(16, '0');
  for (std::size_t i = 0; i < 16; ++i) out[i] = kDigits[(state_ >> (60 - 4 * i)) & 0xF];
  return out;
}

}  // namespace cogslam
