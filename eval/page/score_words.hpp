#pragma once

#include <span>
#include <string_view>

namespace cogslam {

/// A score in plain words, for readers who have not seen docs/metrics.md.
struct ScoreWords {
  std::string_view key;      ///< in scores.json
  std::string_view name;     ///< for people
  std::string_view unit;     ///< empty: none
  std::string_view meaning;  ///< one or two sentences
  std::string_view good;     ///< which way is better, and what to hold it against
};

/// One for each key of `scores`, in the order of scores.json.
std::span<const ScoreWords> score_words();

}  // namespace cogslam
