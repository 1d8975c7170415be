#include "eval/gate/gate_settings.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "core/config_tree.hpp"

namespace cogslam {
namespace {

using Values = std::map<std::string, std::string>;

void flatten(const ConfigTree& tree, const std::string& key, Values& values) {
  const std::string prefix = key.empty() ? "" : key + ".";
  switch (tree.kind) {
    case ConfigTree::Kind::kNothing:
      values[key] = "";
      return;
    case ConfigTree::Kind::kText:
      values[key] = tree.text;
      return;
    case ConfigTree::Kind::kSection:
      for (const auto& entry : tree.entries) flatten(*entry.value, prefix + entry.key, values);
      return;
    case ConfigTree::Kind::kList:
      for (std::size_t i = 0; i < tree.items.size(); ++i) flatten(*tree.items[i], prefix + std::to_string(i), values);
      return;
  }
}

bool is_below(const std::string& key, const std::string& section) {
  return key.starts_with(section) && (key.size() == section.size() || key[section.size()] == '.');
}

bool is_of_filter(const std::string& key) {
  constexpr std::array kSections{"slam", "variants", "odometry"};
  return std::any_of(kSections.begin(), kSections.end(), [&](const char* s) { return is_below(key, s); });
}

/// "drive.waypoints.8.x_m": an item more or less, which no version of the program adds of its own.
bool is_of_list(const std::string& key) {
  for (std::size_t dot = key.find('.'); dot != std::string::npos; dot = key.find('.', dot + 1)) {
    if (dot + 1 < key.size() && key[dot + 1] >= '0' && key[dot + 1] <= '9') return true;
  }
  return false;
}

void add(SettingChange change, bool missing, SettingChanges& changes) {
  if (change.key == "seed" || change.key == "name") return;
  if (missing && !is_of_list(change.key)) {
    changes.known.push_back(std::move(change));
  } else {
    (is_of_filter(change.key) ? changes.filter : changes.task).push_back(std::move(change));
  }
}

}  // namespace

std::string SettingChange::text() const {
  const auto shown = [](const std::string& value) { return value.empty() ? "nothing" : value; };
  return key + ": " + shown(before) + " -> " + shown(after);
}

SettingChanges setting_changes(const std::string& before, const std::string& after, const std::string& name_before) {
  Values then, now;
  flatten(*parse_config_tree(before, name_before), "", then);
  flatten(*parse_config_tree(after, "scenario"), "", now);
  SettingChanges changes;
  for (const auto& [key, value] : then) {
    const auto found = now.find(key);
    if (found == now.end()) {
      add({key, value, ""}, true, changes);
    } else if (found->second != value) {
      add({key, value, found->second}, false, changes);
    }
  }
  for (const auto& [key, value] : now) {
    if (!then.contains(key)) add({key, "", value}, true, changes);
  }
  return changes;
}

}  // namespace cogslam
