#pragma once

#include <span>
#include <string_view>

namespace cogslam {

enum class ColumnType : char { kText, kInteger, kReal };
enum class ColumnKind : char {
  kIdentity,  ///< which episode it is
  kScore,     ///< the same, bit by bit, for the same program and configuration
  kCost,      ///< of this machine at this hour
};

/// A column of the table `episodes`, and where an episode's JSON file states it.
struct EpisodeColumn {
  std::string_view name;
  ColumnType type;
  ColumnKind kind;
  std::string_view json;  ///< JSON pointer (RFC 6901)
};

/// All columns, in the order of the table and of the CSV files; the first is the key.
std::span<const EpisodeColumn> episode_columns();

}  // namespace cogslam
