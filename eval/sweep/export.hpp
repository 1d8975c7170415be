#pragma once

#include <string>

#include "eval/sweep/columns.hpp"
#include "eval/sweep/database.hpp"

namespace cogslam {

/// The rows as CSV (RFC 4180, lines end with LF): identity, then the columns of `kind`. Numbers are as short as reads
/// back exactly; what was not measured is empty. Same scores, same bytes.
std::string table_csv(const EpisodeTable& table, ColumnKind kind);

}  // namespace cogslam
