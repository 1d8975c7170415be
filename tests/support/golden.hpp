#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace cogslam::golden {

/// The reference values that stand beside the repository; absent on most machines.
inline std::filesystem::path folder() { return std::filesystem::path(COGSLAM_SOURCE_DIR) / "../shared/oracle"; }

/// All numbers of a comma-separated file, row after row.
inline std::vector<double> read(const std::string& name) {
  std::ifstream file(folder() / name);
  std::vector<double> values;
  for (std::string line; std::getline(file, line);) {
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) values.push_back(std::stod(field));
  }
  return values;
}

}  // namespace cogslam::golden

/// Skips a test whose reference values are not on this machine.
#define SKIP_WITHOUT_GOLDEN()                                               \
  if (!std::filesystem::exists(cogslam::golden::folder())) {                \
    GTEST_SKIP() << "no reference values at " << cogslam::golden::folder(); \
  }
