#pragma once

#include <sqlite3.h>

#include <filesystem>
#include <string>

#include "eval/sweep/database.hpp"

namespace cogslam {

/// A connection to SQLite. Every error is thrown, as a std::runtime_error that names the file.
class Sqlite {
 public:
  /// `flags`: of sqlite3_open_v2.
  Sqlite(const std::filesystem::path& file, int flags);
  ~Sqlite();
  Sqlite(const Sqlite&) = delete;
  Sqlite& operator=(const Sqlite&) = delete;

  /// Statements without results.
  void run(const std::string& sql);
  /// The text of the first value of the first row, empty where there is none.
  std::string ask(const std::string& sql);
  [[nodiscard]] sqlite3* handle() const { return handle_; }
  [[noreturn]] void fail() const;

 private:
  std::filesystem::path file_;
  sqlite3* handle_ = nullptr;
};

/// One prepared statement.
class SqliteStatement {
 public:
  SqliteStatement(const Sqlite& database, const std::string& sql);
  ~SqliteStatement();
  SqliteStatement(const SqliteStatement&) = delete;
  SqliteStatement& operator=(const SqliteStatement&) = delete;

  /// `index` counts from 1.
  void bind(int index, const TableValue& value);
  /// Moves on to the next row; false at the end.
  bool step();
  /// Ready for other values.
  void reset();
  /// Of the row; `index` counts from 0.
  [[nodiscard]] TableValue value(int index) const;
  [[nodiscard]] std::string text(int index) const;

 private:
  const Sqlite& database_;
  sqlite3_stmt* statement_ = nullptr;
};

}  // namespace cogslam
