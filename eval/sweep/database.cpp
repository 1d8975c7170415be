#include "eval/sweep/database.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/check.hpp"
#include "core/error.hpp"
#include "eval/sweep/columns.hpp"
#include "eval/sweep/sqlite.hpp"

namespace cogslam {
namespace {

constexpr const char* kSchema = "1";

std::string column_names() {
  std::string names;
  for (const EpisodeColumn& column : episode_columns()) names += (names.empty() ? "" : ", ") + std::string(column.name);
  return names;
}

std::string make_tables() {
  std::string columns;
  for (const EpisodeColumn& column : episode_columns()) {
    const char* type = column.type == ColumnType::kText      ? " TEXT"
                       : column.type == ColumnType::kInteger ? " INTEGER"
                                                             : " REAL";
    columns += std::string(column.name) + type + (columns.empty() ? " PRIMARY KEY NOT NULL" : "") + ", ";
  }
  columns.resize(columns.size() - 2);
  return "BEGIN; CREATE TABLE episodes(" + columns +
         ") STRICT;"
         "CREATE TABLE plan(position INTEGER PRIMARY KEY, key TEXT UNIQUE NOT NULL) STRICT;"
         "CREATE TABLE failures(key TEXT PRIMARY KEY NOT NULL, message TEXT NOT NULL) STRICT;"
         "CREATE VIEW results AS SELECT " +
         column_names() + " FROM plan JOIN episodes USING (key) ORDER BY position; PRAGMA user_version = " + kSchema +
         "; COMMIT;";
}

/// Throws where the file is not what it should be.
void check_schema(Sqlite& database, const std::filesystem::path& file) {
  if (const std::string verdict = database.ask("PRAGMA integrity_check"); verdict != "ok") {
    throw std::runtime_error(file.string() + ": damaged: " + verdict);
  }
  if (const std::string schema = database.ask("PRAGMA user_version"); schema != kSchema) {
    throw std::runtime_error(file.string() + ": of schema " + schema + ", expected " + kSchema);
  }
}

[[noreturn]] void cannot_use(const std::exception& error) {
  throw InputError(std::string(error.what()) +
                   "; where the file itself is at fault, move it away and run again: its rows are made anew from the "
                   "files in episodes/");
}

TableValue value_of(const nlohmann::json& json) {
  if (json.is_boolean()) return std::int64_t{json.get<bool>() ? 1 : 0};
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  return {};
}

}  // namespace

std::optional<double> EpisodeTable::number(std::size_t row, const std::string& column) const {
  const TableValue& value = at(row, column);
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return std::nullopt;
}

std::string EpisodeTable::text(std::size_t row, const std::string& column) const {
  const auto* text = std::get_if<std::string>(&at(row, column));
  return text == nullptr ? "" : *text;
}

const TableValue& EpisodeTable::at(std::size_t row, const std::string& column) const {
  const auto found = std::find(columns.begin(), columns.end(), column);
  EXPECTS(found != columns.end() && row < rows.size());
  return rows[row][static_cast<std::size_t>(found - columns.begin())];
}

struct SweepDatabase::State {
  State(const std::filesystem::path& file, int flags) : sqlite(file, flags) {}
  Sqlite sqlite;
};

SweepDatabase::SweepDatabase(std::unique_ptr<State> state) : state_(std::move(state)) {}
SweepDatabase::~SweepDatabase() = default;
SweepDatabase::SweepDatabase(SweepDatabase&&) noexcept = default;

SweepDatabase::SweepDatabase(const std::filesystem::path& file) {
  try {
    state_ = std::make_unique<State>(file, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
    Sqlite& sqlite = state_->sqlite;
    sqlite.run("PRAGMA journal_mode = WAL");
    sqlite.run("PRAGMA synchronous = FULL");
    const bool fresh = sqlite.ask("SELECT count(*) FROM sqlite_schema") == "0";
    if (fresh) sqlite.run(make_tables());
    check_schema(sqlite, file);
  } catch (const std::runtime_error& error) {
    cannot_use(error);
  }
}

SweepDatabase SweepDatabase::open_to_read(const std::filesystem::path& file) {
  try {
    auto state = std::make_unique<State>(file, SQLITE_OPEN_READONLY);
    check_schema(state->sqlite, file);
    return SweepDatabase(std::move(state));
  } catch (const std::runtime_error& error) {
    cannot_use(error);
  }
}

void SweepDatabase::set_plan(const SweepPlan& plan) {
  Sqlite& sqlite = state_->sqlite;
  sqlite.run("BEGIN");
  sqlite.run("DELETE FROM plan");
  SqliteStatement insert(sqlite, "INSERT INTO plan(position, key) VALUES (?, ?)");
  for (std::size_t i = 0; i < plan.episodes.size(); ++i) {
    insert.bind(1, static_cast<std::int64_t>(i));
    insert.bind(2, plan.episodes[i].key);
    insert.step();
    insert.reset();
  }
  sqlite.run("COMMIT");
}

bool SweepDatabase::has_episode(const std::string& key) const {
  SqliteStatement select(state_->sqlite, "SELECT 1 FROM episodes WHERE key = ?");
  select.bind(1, key);
  return select.step();
}

void SweepDatabase::add_episode(const std::string& key, const std::string& text) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (json.is_discarded() || json.value("key", "") != key || json.value("schema", 0) != 1) {
    throw InputError("episodes/" + key + ".json: expected the result of this episode, schema 1");
  }
  std::string marks;
  for (std::size_t i = 0; i < episode_columns().size(); ++i) marks += i == 0 ? "?" : ", ?";
  Sqlite& sqlite = state_->sqlite;
  SqliteStatement insert(sqlite, "INSERT OR REPLACE INTO episodes(" + column_names() + ") VALUES (" + marks + ")");
  int index = 0;
  for (const EpisodeColumn& column : episode_columns()) {
    const nlohmann::json::json_pointer pointer{std::string(column.json)};
    insert.bind(++index, json.contains(pointer) ? value_of(json.at(pointer)) : TableValue{});
  }
  SqliteStatement forgive(sqlite, "DELETE FROM failures WHERE key = ?");
  forgive.bind(1, key);
  sqlite.run("BEGIN IMMEDIATE");
  insert.step();
  forgive.step();
  insert.reset();
  forgive.reset();
  sqlite.run("COMMIT");
}

void SweepDatabase::note_failure(const std::string& key, const std::string& message) {
  SqliteStatement insert(state_->sqlite, "INSERT OR REPLACE INTO failures(key, message) VALUES (?, ?)");
  insert.bind(1, key);
  insert.bind(2, message);
  insert.step();
}

std::vector<std::pair<std::string, std::string>> SweepDatabase::failures() const {
  SqliteStatement select(state_->sqlite, "SELECT key, message FROM plan JOIN failures USING (key) ORDER BY position");
  std::vector<std::pair<std::string, std::string>> failures;
  while (select.step()) failures.emplace_back(select.text(0), select.text(1));
  return failures;
}

EpisodeTable SweepDatabase::results() const {
  EpisodeTable table;
  for (const EpisodeColumn& column : episode_columns()) table.columns.emplace_back(column.name);
  SqliteStatement select(state_->sqlite, "SELECT * FROM results");
  while (select.step()) {
    std::vector<TableValue>& row = table.rows.emplace_back();
    for (std::size_t i = 0; i < table.columns.size(); ++i) row.push_back(select.value(static_cast<int>(i)));
  }
  return table;
}

}  // namespace cogslam
