#include "sensors/faults/compass_deflection.hpp"

#include <algorithm>
#include <cmath>

namespace cogslam {

double compass_deflection(std::span<const Magnet> magnets, const Eigen::Vector2d& p_map, double declination) {
  const Eigen::Vector2d north(std::sin(declination), std::cos(declination));
  Eigen::Vector2d field = north;
  for (const Magnet& magnet : magnets) {
    const Eigen::Vector2d way = p_map - magnet.centre;
    const double distance = way.norm();
    const Eigen::Vector2d moment(std::cos(magnet.axis), std::sin(magnet.axis));
    const Eigen::Vector2d u = distance > 0.0 ? Eigen::Vector2d(way / distance) : moment;
    const double ratio = magnet.reach / std::max(distance, 0.1 * magnet.reach);
    field += ratio * ratio * ratio * (3.0 * moment.dot(u) * u - moment);
  }
  const double cross = north.x() * field.y() - north.y() * field.x();
  return std::atan2(cross, north.dot(field));
}

}  // namespace cogslam
