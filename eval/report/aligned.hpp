#pragma once

#include <string>
#include <vector>

namespace cogslam {

/// Rows of equally many entries, at least one row, with columns as wide as their widest entry and two spaces between;
/// the first flush left, the others flush right. Entries are ASCII.
std::string aligned(const std::vector<std::vector<std::string>>& rows);

}  // namespace cogslam
