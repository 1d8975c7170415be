#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "eval/sweep/plan.hpp"

namespace cogslam {

/// A value of a table: nothing, a whole number, a number or a text.
using TableValue = std::variant<std::monostate, std::int64_t, double, std::string>;

/// Rows of episodes (docs/sweeps.md), in the order of the plan.
struct EpisodeTable {
  std::vector<std::string> columns;
  std::vector<std::vector<TableValue>> rows;

  /// The number there, or nothing where there is none. `column` must be one of the columns.
  [[nodiscard]] std::optional<double> number(std::size_t row, const std::string& column) const;
  /// The text there, empty where there is none.
  [[nodiscard]] std::string text(std::size_t row, const std::string& column) const;

 private:
  [[nodiscard]] const TableValue& at(std::size_t row, const std::string& column) const;
};

/// The results of a sweep in SQLite. Every change is on disk when the call returns; one process writes.
class SweepDatabase {
 public:
  /// Opens the file, or makes it. Throws InputError where it cannot, is of another schema, or fails SQLite's integrity
  /// check.
  explicit SweepDatabase(const std::filesystem::path& file);
  /// Only to read: a file that is there.
  static SweepDatabase open_to_read(const std::filesystem::path& file);
  ~SweepDatabase();
  SweepDatabase(SweepDatabase&&) noexcept;
  SweepDatabase& operator=(SweepDatabase&&) = delete;

  /// From now on the table is of these episodes; rows of others stay in the file.
  void set_plan(const SweepPlan& plan);
  [[nodiscard]] bool has_episode(const std::string& key) const;
  /// Adds the row that `json` (an `episodes/<key>.json`) states. Throws InputError where it is not of `key`.
  void add_episode(const std::string& key, const std::string& json);
  void note_failure(const std::string& key, const std::string& message);
  /// Of the planned episodes without a row: why, by key, in the order of the plan.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> failures() const;
  /// The planned episodes that have a row.
  [[nodiscard]] EpisodeTable results() const;

 private:
  struct State;
  explicit SweepDatabase(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace cogslam
