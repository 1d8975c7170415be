#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/error.hpp"

namespace cogslam {

struct ConfigTree;
using ConfigTreePtr = std::shared_ptr<ConfigTree>;

/// What a reader asked for, and what it got: the text of a value, a section, or a list of sections.
struct ConfigNote {
  std::string key;
  std::variant<std::string, ConfigTreePtr, std::vector<ConfigTreePtr>> got;
};

/// One value of a strict YAML file with its place: nothing, a text, a list or a section; and what was read of it.
struct ConfigTree {
  enum class Kind { kNothing, kText, kList, kSection };
  struct Entry {
    std::string key;
    SourcePlace place;  ///< of the key
    ConfigTreePtr value;
  };

  Kind kind = Kind::kNothing;
  SourcePlace place;
  std::string text;                  ///< of a kText
  bool quoted = false;               ///< a kText written in quotes is no number
  std::vector<ConfigTreePtr> items;  ///< of a kList
  std::vector<Entry> entries;        ///< of a kSection, in the order of the file, keys unique
  std::vector<ConfigNote> notes;     ///< in the order of first reading

  [[nodiscard]] const Entry* find(const std::string& key) const;
  [[nodiscard]] const ConfigNote* find_note(const std::string& key) const;
  void note(const std::string& key, decltype(ConfigNote::got) got);
};

/// Parses one YAML document. `name` stands for the file in places; `with_lines` false leaves line and column out.
ConfigTreePtr parse_config_tree(const std::string& text, const std::string& name, bool with_lines = true);

/// YAML text of everything noted from `tree` down.
std::string resolved_text(const ConfigTree& tree);

/// A text as a YAML scalar, in quotes where it needs them.
std::string yaml_scalar(const std::string& text);

/// What stands there, for messages: "'abc'", "nothing", "a list", "a section".
std::string found_text(const ConfigTree& tree);

}  // namespace cogslam
