#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

#include "core/error.hpp"

namespace cogslam {

/// The blank-separated fields of one line of a text file, taken one after the other.
///
/// Each is asked for by the name it has in the format's description; a field that is missing or not a number is an
/// InputError "file:line:column: range[17]: expected a number, found 'x'". `line` must outlive the object.
class LineFields {
 public:
  LineFields(std::string_view line, SourcePlace place) : line_(line), place_(std::move(place)) {}

  /// Whether no field is left.
  [[nodiscard]] bool done() const;
  std::string_view word(std::string_view name);
  double number(std::string_view name);
  std::int64_t whole_number(std::string_view name, std::int64_t min = std::numeric_limits<std::int64_t>::min(),
                            std::int64_t max = std::numeric_limits<std::int64_t>::max());
  /// Rejects fields that nobody asked for.
  void finish() const;

  /// Where the next field begins.
  [[nodiscard]] SourcePlace place() const;
  /// Reports `message` at the field taken last (at the start of the line where none was).
  [[noreturn]] void fail(std::string_view message) const;

 private:
  [[nodiscard]] std::size_t next_start() const;
  [[nodiscard]] SourcePlace at(std::size_t index) const;

  std::string_view line_;
  SourcePlace place_;
  std::size_t next_ = 0;  // first character not yet taken
  std::size_t last_ = 0;  // start of the field taken last
};

}  // namespace cogslam
