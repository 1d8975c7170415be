#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/rng.hpp"
#include "sensors/readings.hpp"

// A small world for tests of slam/ alone, which sees neither worlds/ nor sim/ nor the sensor models.

namespace cogslam {

struct Wall {
  Eigen::Vector2d a;
  Eigen::Vector2d b;
};

/// A closed polygon of walls.
inline std::vector<Wall> walls_of(const std::vector<Eigen::Vector2d>& corners) {
  std::vector<Wall> walls;
  for (std::size_t i = 0; i < corners.size(); ++i) walls.push_back({corners[i], corners[(i + 1) % corners.size()]});
  return walls;
}

/// A room of 6 m x 4 m about the origin with a step in one corner, a slanted one, and a box on the floor. Walls lie off
/// the cell borders.
inline std::vector<Wall> cornered_room() {
  std::vector<Wall> walls = walls_of(
      {{-3.03, -2.02}, {3.04, -2.02}, {3.04, 1.13}, {2.17, 1.98}, {-1.96, 1.98}, {-1.96, 1.03}, {-3.03, 1.03}});
  for (const Wall& wall : walls_of({{0.82, 0.27}, {1.33, 0.27}, {1.33, 0.91}, {0.82, 0.91}})) walls.push_back(wall);
  return walls;
}

/// Range of the nearest wall along a direction of length 1, by trying them all; infinity where there is none.
inline double cast_to(const std::vector<Wall>& walls, const Eigen::Vector2d& origin, const Eigen::Vector2d& direction) {
  const auto cross = [](const Eigen::Vector2d& u, const Eigen::Vector2d& v) { return u.x() * v.y() - u.y() * v.x(); };
  double nearest = std::numeric_limits<double>::infinity();
  for (const Wall& wall : walls) {
    const Eigen::Vector2d along = wall.b - wall.a, to_wall = wall.a - origin;
    const double determinant = cross(direction, along);
    if (determinant == 0.0) continue;
    const double range = cross(to_wall, along) / determinant, share = cross(to_wall, direction) / determinant;
    if (range > 0.0 && share >= 0.0 && share <= 1.0) nearest = std::min(nearest, range);
  }
  return nearest;
}

/// A sweep all round, all at once, with normal noise on each range.
inline Scan scan_of(const std::vector<Wall>& walls, const Pose2& T_map_base, int beams, double sigma, Rng& rng) {
  Scan scan{.angle_first = -std::numbers::pi,
            .angle_increment = 2.0 * std::numbers::pi / beams,
            .range_min = 0.05,
            .range_max = 20.0,
            .ranges = {}};
  for (int i = 0; i < beams; ++i) {
    const double angle = T_map_base.theta + scan.angle_first + i * scan.angle_increment;
    const double range =
        cast_to(walls, T_map_base.position(), {std::cos(angle), std::sin(angle)}) + sigma * rng.normal();
    scan.ranges.push_back(range < scan.range_max ? static_cast<float>(range) : Scan::kNoReturn);
  }
  return scan;
}

struct SyntheticLog {
  std::vector<Pose2> truth;  ///< T_map_base at each reading
  std::vector<Reading> readings;
};

/// A drive round the middle of `cornered_room` with noisy odometry, compass and ranges, from poses 0.06 m apart.
inline SyntheticLog drive_round(int readings, std::uint32_t seed, int beams = 120) {
  const std::vector<Wall> walls = cornered_room();
  SyntheticLog log;
  for (int i = 0; i < readings; ++i) {
    Rng rng({.seed = seed, .purpose = Purpose::kLidarNoise, .tick = static_cast<std::uint64_t>(i)});
    const double phase = 0.06 * i;
    const Pose2 T_map_base{-0.5 + 1.2 * std::cos(phase), -0.4 + 0.9 * std::sin(phase), wrap_angle(0.8 * phase)};
    Reading reading;
    reading.sequence = static_cast<std::uint64_t>(i);
    if (i > 0) {
      const Pose2 moved = log.truth.back().inverse() * T_map_base;
      const double sigma = 0.008, turn_sigma = 0.006;
      reading.motion.T_before_now =
          moved * Pose2::exp({sigma * rng.normal(), sigma * rng.normal(), turn_sigma * rng.normal()});
      reading.motion.covariance = Eigen::Vector3d(sigma * sigma, sigma * sigma, turn_sigma * turn_sigma).asDiagonal();
    }
    reading.heading = wrap_angle(T_map_base.theta + 0.02 + 0.035 * rng.normal());
    reading.scan = scan_of(walls, T_map_base, beams, 0.01, rng);
    log.truth.push_back(T_map_base);
    log.readings.push_back(reading);
  }
  return log;
}

}  // namespace cogslam
