#include <algorithm>
#include <array>
#include <string_view>

#include "core/config_tree.hpp"
#include "core/printable.hpp"

namespace cogslam {
namespace {

bool is_plain(const std::string& text) {
  constexpr std::array<std::string_view, 5> kReserved{"null", "Null", "NULL", "true", "false"};
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const auto inner = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '/'; };
  return !text.empty() && letter(text[0]) && std::all_of(text.begin(), text.end(), inner) &&
         std::find(kReserved.begin(), kReserved.end(), text) == kReserved.end();
}

void append(std::string& out, const ConfigTree& tree, const std::string& indent);

void append_list(std::string& out, const std::vector<ConfigTreePtr>& list, const std::string& indent) {
  for (const ConfigTreePtr& item : list) {
    std::string text;
    append(text, *item, indent + "    ");
    // The first line of the item moves up behind the dash.
    out += indent + "  - " + (text.empty() ? "{}\n" : text.substr(indent.size() + 4));
  }
}

void append(std::string& out, const ConfigTree& tree, const std::string& indent) {
  for (const auto& [key, got] : tree.notes) {
    out += indent + key + ":";
    if (const auto* text = std::get_if<std::string>(&got)) {
      out += " " + *text + "\n";
    } else if (const auto* section = std::get_if<ConfigTreePtr>(&got)) {
      out += (*section)->notes.empty() ? " {}\n" : "\n";
      append(out, **section, indent + "  ");
    } else {
      const auto& list = std::get<std::vector<ConfigTreePtr>>(got);
      out += list.empty() ? " []\n" : "\n";
      append_list(out, list, indent);
    }
  }
}

}  // namespace

std::string resolved_text(const ConfigTree& tree) {
  std::string out;
  append(out, tree, "");
  return out;
}

std::string yaml_scalar(const std::string& text) {
  if (is_plain(text)) return text;
  static constexpr char kDigits[] = "0123456789ABCDEF";
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F) {
      out += {'\\', 'x', kDigits[byte >> 4], kDigits[byte & 0xF]};
      continue;
    }
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

std::string found_text(const ConfigTree& tree) {
  switch (tree.kind) {
    case ConfigTree::Kind::kNothing:
      return "nothing";
    case ConfigTree::Kind::kList:
      return "a list of " + std::to_string(tree.items.size());
    case ConfigTree::Kind::kSection:
      return "a section";
    case ConfigTree::Kind::kText:
      break;
  }
  return tree.quoted ? "the text \"" + printable(tree.text) + "\"" : in_quotes(tree.text);
}

}  // namespace cogslam
