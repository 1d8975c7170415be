#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/error.hpp"

namespace cogslam {

/// Puts numbers one after the other, little-endian, bit by bit as they are (NaN keeps its payload).
class ByteWriter {
 public:
  template <class T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void put(T value) {
    std::array<char, sizeof(T)> bytes{};
    std::memcpy(bytes.data(), &value, sizeof(T));
    if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    bytes_.append(bytes.data(), bytes.size());
  }
  void put_count(std::size_t count) { put(static_cast<std::uint64_t>(count)); }
  void put_text(std::string_view text) {
    put_count(text.size());
    bytes_ += text;
  }
  void put_raw(std::string_view bytes) { bytes_ += bytes; }

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Takes numbers back out of a part of a file. Every error is an InputError "file: byte N: what is wrong", and nothing
/// is allocated before the bytes for it are known to be there.
class ByteReader {
 public:
  /// `bytes` begin at byte `offset` of `file` and must outlive the reader.
  ByteReader(std::string_view bytes, std::string file, std::size_t offset = 0)
      : bytes_(bytes), file_(std::move(file)), offset_(offset) {}

  template <class T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) T take(const char* what) {
    const std::string_view raw = take_raw(sizeof(T), what);
    std::array<char, sizeof(T)> bytes{};
    std::copy(raw.begin(), raw.end(), bytes.begin());
    if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
  }
  /// A whole number of one byte in [0, limit).
  std::uint8_t take_below(std::uint8_t limit, const char* what) {
    const auto value = take<std::uint8_t>(what);
    if (value >= limit)
      fail_at(next_ - 1,
              std::string(what) + " is " + std::to_string(value) + ", expected less than " + std::to_string(limit));
    return value;
  }
  /// A count of things that take at least `bytes_each` >= 1 bytes each; never more than can still follow.
  std::size_t take_count(std::size_t bytes_each, const char* what) {
    const auto count = take<std::uint64_t>(what);
    if (count > left() / bytes_each)
      fail_at(next_ - 8, std::string(what) + " is " + std::to_string(count) + ", but only " + std::to_string(left()) +
                             " bytes follow");
    return static_cast<std::size_t>(count);
  }
  std::string_view take_raw(std::size_t size, const char* what) {
    if (size > left())
      fail_at(next_, "the data end within " + std::string(what) + ", expected " + std::to_string(size) +
                         " bytes, found " + std::to_string(left()));
    next_ += size;
    return bytes_.substr(next_ - size, size);
  }
  std::string_view take_text(const char* what) { return take_raw(take_count(1, what), what); }

  [[nodiscard]] std::size_t left() const { return bytes_.size() - next_; }
  [[nodiscard]] std::size_t offset() const { return offset_ + next_; }
  [[nodiscard]] const std::string& file() const { return file_; }
  /// Rejects bytes that nobody took.
  void finish() const {
    if (left() > 0) fail_at(next_, std::to_string(left()) + " bytes too many, expected the end of the record");
  }
  [[noreturn]] void fail(const std::string& message) const { fail_at(next_, message); }
  /// Complains about the part as a whole.
  [[noreturn]] void fail_whole(const std::string& message) const { fail_at(0, message); }

 private:
  [[noreturn]] void fail_at(std::size_t index, const std::string& message) const {
    throw InputError({file_}, "byte " + std::to_string(offset_ + index) + ": " + message);
  }

  std::string_view bytes_;
  std::string file_;
  std::size_t offset_;
  std::size_t next_ = 0;
};

}  // namespace cogslam
