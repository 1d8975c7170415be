#include "eval/sweep/resolved_text.hpp"

#include <algorithm>
#include <sstream>

#include "core/check.hpp"

namespace cogslam {

ResolvedText::ResolvedText(const std::string& text) {
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(' ')) parts_.emplace_back(line.substr(0, line.find(':')), "");
    EXPECTS(!parts_.empty());
    parts_.back().second += line + "\n";
  }
}

const std::string& ResolvedText::lines(const std::string& key) const {
  const auto at = std::find_if(parts_.begin(), parts_.end(), [&](const auto& part) { return part.first == key; });
  EXPECTS(at != parts_.end());
  return at->second;
}

std::string ResolvedText::without(const std::vector<std::string>& keys) const {
  std::string out;
  for (const auto& [key, lines] : parts_) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) out += lines;
  }
  return out;
}

std::string as_list_entry(const std::string& lines) {
  std::istringstream in(lines);
  std::string out;
  for (std::string line; std::getline(in, line);) out += (out.empty() ? "  - " : "    ") + line + "\n";
  return out;
}

}  // namespace cogslam
