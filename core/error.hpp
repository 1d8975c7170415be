#pragma once

#include <stdexcept>
#include <string>

namespace cogslam {

/// Where in a text file something stands; line and column count from 1, and 0 means "not known".
struct SourcePlace {
  std::string file;
  int line = 0;
  int column = 0;

  /// "file:line:column", "file:line" or "file", whatever is known.
  [[nodiscard]] std::string text() const {
    std::string out = file;
    if (line > 0) out.append(1, ':').append(std::to_string(line));
    if (line > 0 && column > 0) out.append(1, ':').append(std::to_string(column));
    return out;
  }
};

/// A file or an option from outside is wrong. what() reads "place: what is wrong, what was expected".
class InputError : public std::runtime_error {
 public:
  InputError(const SourcePlace& place, const std::string& message)
      : std::runtime_error(place.file.empty() ? message : place.text() + ": " + message) {}
  explicit InputError(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace cogslam
