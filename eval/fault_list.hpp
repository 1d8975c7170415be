#pragma once

#include "core/config.hpp"
#include "eval/scenario.hpp"

namespace cogslam {

/// Reads the list `faults` of a scenario, each entry into the part that it spoils. Everything before it in the file
/// (world, robot, sensors) must have been read. docs/faults.md tells what each kind does.
void read_faults(ConfigSection& file, Scenario& scenario);

/// Whether the body touches no surface there.
bool has_room_to_stand(const World& world, const RobotConfig& robot, const Pose2& T_map_base);

}  // namespace cogslam
