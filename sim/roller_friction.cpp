#include "sim/roller_friction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cogslam {
namespace {

constexpr int kIterations = 8;

}  // namespace

struct RollerFriction::Bodies {
  const RollerFriction& model;
  const WheelValues& radius;
  Twist2& twist;
  WheelSpeeds& speeds;

  [[nodiscard]] double slip(std::size_t i) const {
    const Roller& roller = model.rollers_[i];
    return (twist.x - radius[i] * speeds[i]) * roller.axis.x() + twist.y * roller.axis.y() + twist.theta * roller.arm;
  }

  /// Slip that a unit impulse removes [1/kg].
  [[nodiscard]] double response(std::size_t i) const {
    const Roller& roller = model.rollers_[i];
    const double wheel_arm = radius[i] * roller.axis.x();
    return model.per_mass_ + roller.arm * roller.arm * model.per_inertia_ +
           wheel_arm * wheel_arm * model.per_wheel_inertia_;
  }

  void apply(std::size_t i, double impulse) {
    const Roller& roller = model.rollers_[i];
    twist.x += impulse * roller.axis.x() * model.per_mass_;
    twist.y += impulse * roller.axis.y() * model.per_mass_;
    twist.theta += impulse * roller.arm * model.per_inertia_;
    speeds[i] -= impulse * radius[i] * roller.axis.x() * model.per_wheel_inertia_;
  }
};

RollerFriction::RollerFriction(const RobotConfig& config)
    : per_mass_(1.0 / config.mass), per_inertia_(1.0 / config.inertia), per_wheel_inertia_(1.0 / config.wheel_inertia) {
  const double x = config.geometry.half_length, y = config.geometry.half_width;
  constexpr double kHalf = 1.0 / std::numbers::sqrt2;
  const std::array<Eigen::Vector2d, 4> positions{{{x, y}, {x, -y}, {-x, y}, {-x, -y}}};
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d& p = positions[i];
    const Eigen::Vector2d axis(kHalf, p.x() * p.y() > 0.0 ? -kHalf : kHalf);
    rollers_[i] = {p, axis, p.x() * axis.y() - p.y() * axis.x()};
  }
}

const WheelContacts& RollerFriction::solve(const WheelValues& radius, const WheelValues& limit, Twist2& twist,
                                           WheelSpeeds& speeds) {
  Bodies bodies{*this, radius, twist, speeds};
  WheelValues per_response;
  for (std::size_t i = 0; i < 4; ++i) {
    contacts_[i].limit = limit[i];
    contacts_[i].impulse = std::clamp(contacts_[i].impulse, -limit[i], limit[i]);
    per_response[i] = 1.0 / bodies.response(i);
    bodies.apply(i, contacts_[i].impulse);
  }
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    for (std::size_t i = 0; i < 4; ++i) {
      const double before = contacts_[i].impulse;
      contacts_[i].impulse = std::clamp(before - bodies.slip(i) * per_response[i], -limit[i], limit[i]);
      bodies.apply(i, contacts_[i].impulse - before);
    }
  }
  for (std::size_t i = 0; i < 4; ++i) contacts_[i].slip = bodies.slip(i);
  return contacts_;
}

}  // namespace cogslam
