#include "core/config.hpp"

#include <algorithm>

#include "core/config_tree.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/text_file.hpp"

namespace cogslam {
namespace {

constexpr std::size_t kMaxFileBytes = 1'000'000;

[[noreturn]] void fail_at(const ConfigTree& value, const std::string& key, const std::string& expected) {
  throw InputError(value.place, key + ": expected " + expected + ", found " + found_text(value));
}

ConfigTreePtr require_section(const ConfigTreePtr& value, const std::string& key) {
  if (value->kind != ConfigTree::Kind::kSection && value->kind != ConfigTree::Kind::kNothing) {
    fail_at(*value, key, "a section of `key: value` lines");
  }
  return value;
}

std::string known_keys(const ConfigTree& section) {
  std::string out;
  for (const ConfigNote& note : section.notes) out += (out.empty() ? "" : ", ") + note.key;
  return out.empty() ? "none" : out;
}

/// What the writer of an unknown key may have meant: most often the name without its unit, or a slip of the keys.
std::string meant_name(const std::string& key, const std::vector<std::string>& known) {
  for (const std::string& name : known) {
    if (name.starts_with(key + "_")) return name;
  }
  return nearest_name(key, known);
}

void reject_unread(const ConfigTree& section) {
  std::vector<std::string> known;
  for (const ConfigNote& note : section.notes) known.push_back(note.key);
  for (const ConfigTree::Entry& entry : section.entries) {
    if (section.find_note(entry.key)) continue;
    const std::string near = meant_name(entry.key, known);
    throw InputError(entry.place,
                     "unknown key " + in_quotes(entry.key) +
                         (near.empty() ? "; known here: " + known_keys(section) : "; did you mean '" + near + "'?"));
  }
  for (const ConfigNote& note : section.notes) {
    if (const auto* child = std::get_if<ConfigTreePtr>(&note.got)) reject_unread(**child);
    if (const auto* list = std::get_if<std::vector<ConfigTreePtr>>(&note.got)) {
      for (const ConfigTreePtr& child : *list) reject_unread(*child);
    }
  }
}

/// The value under one step of an override's path, made where it is missing.
ConfigTreePtr& slot(ConfigTree& at, const std::string& step, const SourcePlace& place) {
  if (step.empty()) throw InputError(place, "expected names joined by dots, found an empty name");
  if (at.kind == ConfigTree::Kind::kList) {
    const auto index = parse_whole_number(step);
    if (!index || *index < 0 || *index >= static_cast<std::int64_t>(at.items.size())) {
      const std::string count = std::to_string(at.items.size());
      throw InputError(place, "expected an index below " + count + ", found " + in_quotes(step));
    }
    return at.items[static_cast<std::size_t>(*index)];
  }
  if (at.kind == ConfigTree::Kind::kText) {
    throw InputError(place, in_quotes(step) + " lies under " + found_text(at) + ", expected a section");
  }
  at.kind = ConfigTree::Kind::kSection;
  for (ConfigTree::Entry& entry : at.entries) {
    if (entry.key == step) return entry.value;
  }
  auto missing = std::make_shared<ConfigTree>();
  missing->place = place;
  at.entries.push_back({step, place, missing});
  return at.entries.back().value;
}

}  // namespace

ConfigSection::ConfigSection(std::shared_ptr<ConfigTree> tree) : tree_(std::move(tree)) {}

ConfigSection ConfigSection::load(const std::filesystem::path& file) {
  return parse(read_text_file(file, kMaxFileBytes), file.string());
}

ConfigSection ConfigSection::parse(const std::string& text, const std::string& name) {
  ConfigTreePtr tree = parse_config_tree(text, name);
  if (tree->kind == ConfigTree::Kind::kNothing) tree->place = {name};
  if (tree->kind == ConfigTree::Kind::kText || tree->kind == ConfigTree::Kind::kList) {
    throw InputError(tree->place, "expected `key: value` lines, found " + found_text(*tree));
  }
  return ConfigSection(tree);
}

void ConfigSection::override_value(const std::string& path, const std::string& text) {
  override_value(path, text, "--set " + path + "=" + text);
}

void ConfigSection::override_value(const std::string& path, const std::string& text, const std::string& option) {
  const SourcePlace place{option};
  ConfigTree* at = tree_.get();
  std::size_t start = 0;
  for (std::size_t dot = path.find('.'); dot != std::string::npos; dot = path.find('.', start)) {
    at = slot(*at, path.substr(start, dot - start), place).get();
    start = dot + 1;
  }
  ConfigTreePtr value = parse_config_tree(text, place.file, false);
  value->place = place;
  slot(*at, path.substr(start), place) = value;
}

bool ConfigSection::has(const std::string& key) const { return tree_->find(key) != nullptr; }

std::size_t ConfigSection::choose(const std::string& key, const std::vector<std::string_view>& names,
                                  std::size_t current) {
  if (const ConfigTree::Entry* entry = tree_->find(key)) {
    const ConfigTree& value = *entry->value;
    const auto at = std::find(names.begin(), names.end(), value.text);
    if (value.kind != ConfigTree::Kind::kText || at == names.end()) {
      const std::vector<std::string> known(names.begin(), names.end());
      std::string list;
      for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
      const std::string near = nearest_name(value.text, known);
      throw InputError(value.place, key + ": expected one of " + list + ", found " + found_text(value) +
                                        (near.empty() ? "" : "; did you mean '" + near + "'?"));
    }
    current = static_cast<std::size_t>(at - names.begin());
  }
  if (current < names.size()) tree_->note(key, yaml_scalar(std::string(names[current])));
  return tree_->find(key) ? current : names.size();
}

ConfigSection ConfigSection::section(const std::string& key) {
  if (const ConfigTree::Entry* entry = tree_->find(key)) {
    tree_->note(key, require_section(entry->value, key));
  } else if (!tree_->find_note(key)) {
    auto absent = std::make_shared<ConfigTree>();
    absent->place = tree_->place;
    tree_->note(key, absent);
  }
  return ConfigSection(std::get<ConfigTreePtr>(tree_->find_note(key)->got));
}

std::vector<ConfigSection> ConfigSection::sections(const std::string& key) {
  std::vector<ConfigTreePtr> list;
  if (const ConfigTree::Entry* entry = tree_->find(key)) {
    const ConfigTree& value = *entry->value;
    if (value.kind != ConfigTree::Kind::kList && value.kind != ConfigTree::Kind::kNothing) {
      fail_at(value, key, "a list of sections");
    }
    for (const ConfigTreePtr& item : value.items) list.push_back(require_section(item, key));
  }
  tree_->note(key, list);
  std::vector<ConfigSection> out;
  out.reserve(list.size());
  for (const ConfigTreePtr& item : list) out.push_back(ConfigSection(item));
  return out;
}

void ConfigSection::finish() const { reject_unread(*tree_); }

void ConfigSection::fail(const std::string& key, const std::string& message) const {
  throw InputError(place(key), message);
}

SourcePlace ConfigSection::place(const std::string& key) const {
  const ConfigTree::Entry* entry = tree_->find(key);
  return entry ? entry->place : tree_->place;
}

std::string ConfigSection::resolved() const { return resolved_text(*tree_); }

}  // namespace cogslam
