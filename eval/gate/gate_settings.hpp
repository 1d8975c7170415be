#pragma once

#include <string>
#include <vector>

namespace cogslam {

/// A key of a resolved scenario that two of them do not agree on; empty text where one does not have it.
struct SettingChange {
  std::string key;  ///< "sensors.lidar.rate_hz"
  std::string before;
  std::string after;

  /// "sensors.lidar.rate_hz: 40 -> 20"; "nothing" for a key that is not there.
  [[nodiscard]] std::string text() const;
};

/// How two scenarios differ that were resolved by Scenario::resolved, perhaps by different versions of the program.
struct SettingChanges {
  std::vector<SettingChange> task;    ///< another world, drive, sensor or duration: scores cannot be compared
  std::vector<SettingChange> filter;  ///< another filter or odometry at the same task: what a gate is there to judge
  std::vector<SettingChange> known;   ///< keys that only one version of the program knows: at their default or gone
};

/// `seed` and `name` are no difference. Throws InputError in the words of `name_before` where that text is broken.
SettingChanges setting_changes(const std::string& before, const std::string& after, const std::string& name_before);

}  // namespace cogslam
