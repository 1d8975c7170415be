#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace cogslam {

struct ConfigTree;  // the parsed text with its places; see config_tree.hpp

/// Values a number may take, both ends included.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
};
constexpr Range kPositive{std::numeric_limits<double>::denorm_min()};
constexpr Range kNotNegative{0.0};

/// One `key: value` section of a strict YAML file.
///
/// A stage reads its own section: `read` leaves the default in `value` where the key is absent. `finish` then rejects
/// every key that nobody asked for. All errors are InputError with file:line:column, what is wrong, what was expected,
/// and "did you mean" where a known name is close. Numbers must be finite; duplicate keys, anchors, aliases, several
/// documents and nesting deeper than 32 are errors.
///
/// Every read is noted with the value that holds in the end, so that a resolved file (`resolved`) lists them all.
class ConfigSection {
 public:
  static ConfigSection load(const std::filesystem::path& file);
  static ConfigSection parse(const std::string& text, const std::string& name);

  /// Sets `path` ("slam.particles") to `text`, parsed as YAML, as if the file said so. Errors name `--set path=text`.
  void override_value(const std::string& path, const std::string& text);
  /// The same, but errors name `option`.
  void override_value(const std::string& path, const std::string& text, const std::string& option);

  [[nodiscard]] bool has(const std::string& key) const;
  void read(const std::string& key, double& value, Range range = {});
  void read(const std::string& key, int& value, Range range = {});
  void read(const std::string& key, std::uint32_t& value, Range range = {});
  void read(const std::string& key, bool& value);
  void read(const std::string& key, std::string& value);
  /// The name of a file. A relative one starts at the folder of the file that names it, or at the working folder where
  /// --set names it; `value` is what to open. `resolved` keeps it as it stands where it names something in that folder
  /// or below, else in full, so that a resolved file finds it from its own place.
  void read(const std::string& key, std::filesystem::path& value);
  void read(const std::string& key, Eigen::Vector2d& value, Range range = {});
  void read(const std::string& key, std::vector<double>& value, Range range = {});
  void read(const std::string& key, std::vector<Eigen::Vector2d>& value, Range range = {});
  /// Degrees in the file, radians in `value`; the range is in degrees.
  void read_degrees(const std::string& key, double& value, Range range = {});

  /// Reads a name out of a closed list: `read_choice("kind", kind, {{"simple", Kind::kSimple}, ...})`.
  template <class E>
  void read_choice(const std::string& key, E& value, std::initializer_list<std::pair<std::string_view, E>> choices) {
    std::vector<std::string_view> names;
    std::size_t chosen = choices.size(), i = 0;
    for (const auto& [name, choice] : choices) {
      names.push_back(name);
      if (choice == value && chosen == choices.size()) chosen = i;
      ++i;
    }
    chosen = choose(key, names, chosen);
    if (chosen < choices.size()) value = (choices.begin() + static_cast<std::ptrdiff_t>(chosen))->second;
  }

  /// The section under `key`; an empty one (all defaults) where the key is absent.
  ConfigSection section(const std::string& key);
  /// The sections of the list under `key`; empty where the key is absent.
  std::vector<ConfigSection> sections(const std::string& key);

  /// Rejects, here and below, every key that was not read.
  void finish() const;

  /// Reports `message` at the place of `key` (or of the section where the key is absent).
  [[noreturn]] void fail(const std::string& key, const std::string& message) const;
  [[nodiscard]] SourcePlace place(const std::string& key = {}) const;

  /// YAML text of everything read so far from here down, defaults filled in, in the order of reading. Loads as itself.
  [[nodiscard]] std::string resolved() const;

 private:
  explicit ConfigSection(std::shared_ptr<ConfigTree> tree);
  std::size_t choose(const std::string& key, const std::vector<std::string_view>& names, std::size_t current);

  std::shared_ptr<ConfigTree> tree_;
};

/// The name in `known` nearest to `word` (edit distance, at most a third of its length), or an empty string.
std::string nearest_name(const std::string& word, const std::vector<std::string>& known);

}  // namespace cogslam
