#pragma once

#include "core/pose2.hpp"

namespace cogslam {

/// A pose as particles keep it for later: single precision halves its memory, and is good to 4 um in 100 m.
struct StoredPose {
  float x = 0.0F;
  float y = 0.0F;
  float theta = 0.0F;

  StoredPose() = default;
  explicit StoredPose(const Pose2& pose)
      : x(static_cast<float>(pose.x)), y(static_cast<float>(pose.y)), theta(static_cast<float>(pose.theta)) {}
  [[nodiscard]] Pose2 pose() const { return {x, y, theta}; }
};

}  // namespace cogslam
