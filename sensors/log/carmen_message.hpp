#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/line_fields.hpp"
#include "core/pose2.hpp"
#include "core/time.hpp"

namespace cogslam {

/// One line of a CARMEN log that tells of motion: ODOM, FLASER or ROBOTLASER1.
struct CarmenMessage {
  struct Laser {
    double angle_first = 0.0;             ///< [rad]
    double angle_increment = 0.0;         ///< [rad]
    std::optional<double> range_max{};    ///< stated by the line itself [m]
    std::optional<Pose2> T_base_lidar{};  ///< stated by the line itself
    std::vector<float> ranges;            ///< as in the line [m]
  };

  Pose2 T_odom_base{};
  Twist2 twist{};        ///< zero where the line does not say
  double stamp_s = 0.0;  ///< nearest double to the stamp of the line [s]
  Time stamp{};          ///< the same, to the nanosecond
  std::optional<Laser> laser{};
};

/// `ODOM x y theta tv rv accel stamp host logger_stamp`
CarmenMessage parse_odom(LineFields& fields);

/// `FLASER n r1..rn laser_x laser_y laser_theta odom_x odom_y odom_theta stamp host logger_stamp`. The line does not
/// state its angles: beams spread over 180 degrees, the first at -90. An odd number includes both ends (181: 1 degree,
/// 361: half a degree), an even one lacks the last beam (180: 1 degree, 360: half a degree).
CarmenMessage parse_flaser(LineFields& fields);

/// `ROBOTLASER1 type start_angle field_of_view resolution maximum_range accuracy remission_mode n r1..rn m e1..em
/// laser_x laser_y laser_theta robot_x robot_y robot_theta tv rv forward side turn_axis stamp host logger_stamp`
CarmenMessage parse_robotlaser(LineFields& fields);

}  // namespace cogslam
