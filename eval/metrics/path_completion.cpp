#include "eval/metrics/path_completion.hpp"

#include "core/check.hpp"

namespace cogslam {

std::vector<Pose2> complete_path(std::span<const Pose2> odometry, std::span<const RegisteredPose> registered) {
  std::vector<Pose2> path(odometry.size());
  if (odometry.empty()) return path;
  EXPECTS(!registered.empty() && registered.back().record < odometry.size());
  const auto follow = [&](const RegisteredPose& from, std::size_t to) {
    return from.T_map_base * (odometry[from.record].inverse() * odometry[to]);
  };

  for (std::size_t i = 0; i < registered.front().record; ++i) path[i] = follow(registered.front(), i);
  for (std::size_t n = 0; n + 1 < registered.size(); ++n) {
    const RegisteredPose &from = registered[n], &to = registered[n + 1];
    EXPECTS(from.record < to.record);
    const Pose2 rest = follow(from, to.record).inverse() * to.T_map_base;
    const auto span = static_cast<double>(to.record - from.record);
    for (std::size_t i = from.record; i < to.record; ++i) {
      const double w = static_cast<double>(i - from.record) / span;
      path[i] = follow(from, i) * Pose2{w * rest.x, w * rest.y, w * rest.theta};
    }
    path[from.record] = from.T_map_base;  // exactly, where composing with the identity would round
  }
  for (std::size_t i = registered.back().record; i < odometry.size(); ++i) path[i] = follow(registered.back(), i);
  path[registered.back().record] = registered.back().T_map_base;
  return path;
}

}  // namespace cogslam
