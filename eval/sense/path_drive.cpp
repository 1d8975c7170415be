#include "eval/sense/path_drive.hpp"

#include <algorithm>
#include <cmath>

#include "core/check.hpp"
#include "eval/sense/path_look.hpp"

namespace cogslam {
namespace {

constexpr double kStride = 0.1;               // odometry is read every so many metres
constexpr double kStrideTurn = radians(2.0);  // or turns [rad]

class Driver {
 public:
  Driver(const World& world, const PathDriveConfig& config, std::uint32_t seed, const Pose2& start)
      : config_(config),
        lidar_(config.lidar, world, seed),
        odometry_(config.odometry, seed),
        here_{start, start, start.theta, {}} {
    look();
  }

  void turn_to(double heading) {
    here_.corridor_heading = heading;
    const double turn = angle_difference(heading, here_.T_map_base.theta);
    const int steps = static_cast<int>(std::ceil(std::abs(turn) / config_.step_turn - 1e-9));
    for (int i = 0; i < steps; ++i) move({0.0, 0.0, turn / steps});
  }

  void drive(double way) {
    const int steps = static_cast<int>(std::ceil(way / config_.step_m - 1e-9));
    for (int i = 0; i < steps; ++i) move({way / steps, 0.0, 0.0});
  }

  std::vector<PathLook> looks;

 private:
  void move(const Pose2& motion) {
    const int strides = static_cast<int>(std::ceil(std::max(motion.x / kStride, std::abs(motion.theta) / kStrideTurn)));
    const Pose2 stride{motion.x / strides, 0.0, motion.theta / strides};
    for (int i = 0; i < strides; ++i) {
      here_.T_map_base = here_.T_map_base * stride;
      here_.T_odom_base = here_.T_odom_base * odometry_.measure(stride);
    }
    look();
  }

  void look() {
    here_.scan = look_from(lidar_, here_.T_map_base, looks.size());
    looks.push_back(here_);
  }

  const PathDriveConfig& config_;
  Lidar lidar_;
  FaultyOdometry odometry_;
  PathLook here_;
};

}  // namespace

std::string PathDriveConfig::check() const {
  if (!(step_m > 0.0)) return "step_m: expected more than 0";
  if (!(step_turn > 0.0)) return "step_turn: expected more than 0";
  if (const std::string wrong = lidar.check(); !wrong.empty()) return wrong;
  return odometry.check();
}

std::vector<PathLook> drive_path(const World& world, const std::vector<Eigen::Vector2d>& route,
                                 const PathDriveConfig& config, std::uint32_t seed) {
  EXPECTS(config.check().empty());
  EXPECTS(route.size() >= 2);
  const auto heading = [&](std::size_t leg) {
    const Eigen::Vector2d way = route[leg + 1] - route[leg];
    return std::atan2(way.y(), way.x());
  };
  Driver driver(world, config, seed, {route[0].x(), route[0].y(), heading(0)});
  for (std::size_t leg = 0; leg + 1 < route.size(); ++leg) {
    driver.turn_to(heading(leg));
    driver.drive((route[leg + 1] - route[leg]).norm());
  }
  return driver.looks;
}

}  // namespace cogslam
