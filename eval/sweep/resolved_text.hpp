#pragma once

#include <string>
#include <utility>
#include <vector>

namespace cogslam {

/// The text of a resolved configuration (ConfigSection::resolved) as its top-level keys, each with its lines.
class ResolvedText {
 public:
  explicit ResolvedText(const std::string& text);

  /// The lines of a key that is there, ends of lines included.
  [[nodiscard]] const std::string& lines(const std::string& key) const;
  /// All keys in their order, but without those named.
  [[nodiscard]] std::string without(const std::vector<std::string>& keys) const;

 private:
  std::vector<std::pair<std::string, std::string>> parts_;
};

/// The lines as an entry of a list: "  - " before the first, four blanks before the others.
std::string as_list_entry(const std::string& lines);

}  // namespace cogslam
