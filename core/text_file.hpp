#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace cogslam {

/// What a file may hold at most, once unpacked. Beyond it reading stops with an InputError.
struct TextLimits {
  std::size_t file_bytes = std::size_t{1} << 30;
  std::size_t line_bytes = std::size_t{1} << 20;
  int lines = 1 << 24;  ///< a gzip bomb holds a line end per byte
};

/// Reads a text file line by line, plain or gzipped (told by its content, not by its name).
///
/// A line end is "\n" or "\r\n"; the last line needs none. Throws InputError naming the file (and the line, once
/// reading) where it cannot be opened, is no regular file, holds broken or cut-off gzip data or control characters, or
/// exceeds the limits.
class LineReader {
 public:
  explicit LineReader(const std::filesystem::path& file, TextLimits limits = {});
  ~LineReader();
  LineReader(LineReader&&) noexcept;
  LineReader& operator=(LineReader&&) noexcept;

  /// Moves on to the next line; false at the end of the file.
  bool next();
  /// The current line without its line end; valid until next() is called.
  [[nodiscard]] std::string_view line() const;
  /// File and number of the current line, counted from 1.
  [[nodiscard]] SourcePlace place() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The whole content of a text file, plain or gzipped, unchanged. Errors as LineReader's.
std::string read_text_file(const std::filesystem::path& file, std::size_t max_bytes);

}  // namespace cogslam
