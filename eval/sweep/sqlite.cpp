#include "eval/sweep/sqlite.hpp"

#include <stdexcept>

namespace cogslam {

Sqlite::Sqlite(const std::filesystem::path& file, int flags) : file_(file) {
  if (sqlite3_open_v2(file.c_str(), &handle_, flags, nullptr) == SQLITE_OK) {
    sqlite3_extended_result_codes(handle_, 1);
    return;
  }
  const std::string reason = sqlite3_errmsg(handle_);
  sqlite3_close(handle_);
  throw std::runtime_error(file.string() + ": " + reason);
}

Sqlite::~Sqlite() { sqlite3_close(handle_); }

void Sqlite::fail() const { throw std::runtime_error(file_.string() + ": " + sqlite3_errmsg(handle_)); }

void Sqlite::run(const std::string& sql) {
  if (sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

std::string Sqlite::ask(const std::string& sql) {
  SqliteStatement statement(*this, sql);
  return statement.step() ? statement.text(0) : "";
}

SqliteStatement::SqliteStatement(const Sqlite& database, const std::string& sql) : database_(database) {
  if (sqlite3_prepare_v2(database.handle(), sql.c_str(), -1, &statement_, nullptr) != SQLITE_OK) database.fail();
}

SqliteStatement::~SqliteStatement() { sqlite3_finalize(statement_); }

void SqliteStatement::bind(int index, const TableValue& value) {
  int code = SQLITE_OK;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) {
    code = sqlite3_bind_int64(statement_, index, *whole);
  } else if (const auto* number = std::get_if<double>(&value)) {
    code = sqlite3_bind_double(statement_, index, *number);
  } else if (const auto* text = std::get_if<std::string>(&value)) {
    code = sqlite3_bind_text(statement_, index, text->data(), static_cast<int>(text->size()), SQLITE_TRANSIENT);
  } else {
    code = sqlite3_bind_null(statement_, index);
  }
  if (code != SQLITE_OK) database_.fail();
}

bool SqliteStatement::step() {
  const int code = sqlite3_step(statement_);
  if (code != SQLITE_ROW && code != SQLITE_DONE) database_.fail();
  return code == SQLITE_ROW;
}

void SqliteStatement::reset() { sqlite3_reset(statement_); }

TableValue SqliteStatement::value(int index) const {
  switch (sqlite3_column_type(statement_, index)) {
    case SQLITE_INTEGER:
      return std::int64_t{sqlite3_column_int64(statement_, index)};
    case SQLITE_FLOAT:
      return sqlite3_column_double(statement_, index);
    case SQLITE_TEXT:
      return text(index);
    default:
      return {};
  }
}

std::string SqliteStatement::text(int index) const {
  const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement_, index));
  return bytes == nullptr ? "" : std::string(bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_, index)));
}

}  // namespace cogslam
