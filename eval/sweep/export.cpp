#include "eval/sweep/export.hpp"

#include "core/number_text.hpp"

namespace cogslam {
namespace {

std::string csv_text(const TableValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  if (const auto* number = std::get_if<double>(&value)) return number_text(*number);
  const auto* text = std::get_if<std::string>(&value);
  if (text == nullptr || text->find_first_of(",\"\n") == std::string::npos) return text == nullptr ? "" : *text;
  std::string quoted = "\"";
  for (const char c : *text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string table_csv(const EpisodeTable& table, ColumnKind kind) {
  const auto columns = episode_columns();
  const auto line = [&](const auto& text_of) {
    std::string out;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (columns[c].kind == ColumnKind::kIdentity || columns[c].kind == kind) out += text_of(c) + ",";
    }
    out.back() = '\n';
    return out;
  };
  std::string out = line([&](std::size_t c) { return std::string(columns[c].name); });
  for (const auto& row : table.rows) {
    out += line([&](std::size_t c) { return csv_text(row[c]); });
  }
  return out;
}

}  // namespace cogslam
