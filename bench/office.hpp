#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "core/cell_walk.hpp"
#include "core/pose2.hpp"
#include "core/rng.hpp"
#include "slam/sweep.hpp"

namespace cogslam::bench {

/// A building without end, drawn by rule: rooms of 6 x 6 m with doors, a box in each, all on cells of 0.05 m.
class Office {
 public:
  [[nodiscard]] static bool wall(Cell c) {
    const int x = floor_mod(c.x), y = floor_mod(c.y);
    if (x < 3 || y < 3) return !(in_door(x < 3 ? y : x));
    const auto room = static_cast<std::uint32_t>((c.x - x) * 73856093 ^ (c.y - y) * 19349663);
    const int left = 20 + static_cast<int>(room % 37), low = 20 + static_cast<int>(room / 64 % 41);
    return x >= left && x < left + 14 && y >= low && y < low + 10;
  }

  /// What a lidar of 1081 beams over 270 degrees and 5 m sees, with 10 mm of noise.
  static std::vector<Beam> scan(const Pose2& T_map_base, Rng& rng) {
    constexpr int kBeams = 1081;
    constexpr double kFarthest = 5.0, kNoise = 0.01, kQuarter = std::numbers::pi / 2;
    std::vector<Beam> sweep;
    for (int i = 0; i < kBeams; ++i) {
      const double bearing = kQuarter * (3.0 * i / (kBeams - 1) - 1.5);
      const Eigen::Vector2d ahead{std::cos(bearing), std::sin(bearing)};
      double range = kFarthest;
      const Eigen::Vector2d from{T_map_base.x, T_map_base.y}, to = T_map_base * (kFarthest * ahead);
      walk_cells(from / kCell, to / kCell, [&](Cell c) {
        if (!wall(c)) return true;
        range = (Eigen::Vector2d(c.x + 0.5, c.y + 0.5) * kCell - from).norm();
        return false;
      });
      const bool hit = range < kFarthest;
      if (hit) range += kNoise * rng.normal();
      sweep.push_back({.end = range * ahead, .range = static_cast<float>(range), .hit = hit});
    }
    return sweep;
  }

  /// A place in the door between two rooms of row `j`.
  static Pose2 door(int i, int j, double turn) { return {6.0 * i + 0.075, 6.0 * j + 3.0, turn}; }

  static constexpr double kCell = 0.05;

 private:
  static constexpr int kRoom = 120;  // cells
  static int floor_mod(int a) { return ((a % kRoom) + kRoom) % kRoom; }
  static bool in_door(int along) { return along >= 48 && along < 72; }
};

}  // namespace cogslam::bench
