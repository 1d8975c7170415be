#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/config.hpp"

namespace cogslam {

/// A key of a section, and the values it shall take one after the other.
struct SweepAxis {
  std::string key;                  ///< "slam.store.percent_kept"
  std::string label = "_";          ///< stands before the value in names
  std::vector<std::string> values;  ///< as the file would state them
  SourcePlace place;
};

/// Reads the list `each` of `section`: entries with `key`, `label`, and either `values` (numbers) or `words` (names,
/// separated by blanks). Throws InputError where an entry has no value, or both.
std::vector<SweepAxis> read_axes(ConfigSection& section);

/// One value of each axis, and what that adds to a name: "_40_p10", nothing without axes.
struct AxisPoint {
  std::vector<std::pair<std::string, std::string>> settings;  ///< for ConfigSection::override_value
  std::string suffix;
};

/// Every combination, the last axis changing fastest; one without settings where there is no axis.
std::vector<AxisPoint> axis_points(const std::vector<SweepAxis>& axes);

/// Calls `use`; its InputError about the value of an axis is rethrown with the place of the axis.
void with_axis_places(const std::vector<SweepAxis>& axes, const std::function<void()>& use);

}  // namespace cogslam
