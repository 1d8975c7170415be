#pragma once

#include <vector>

#include "slam/sweep.hpp"

namespace cogslam {

/// What a scan saw free: how far its beams went, by bearing.
class RangeView {
 public:
  /// The beams of a sweep, in the frame that the sweep is in.
  explicit RangeView(const std::vector<Beam>& sweep);

  /// Whether a beam passed the point by, and went on for more than `margin` [m].
  [[nodiscard]] bool passes(const Eigen::Vector2d& point, double margin) const;

 private:
  struct Ray {
    double bearing;  ///< [rad], from -pi to pi, increasing
    double range;    ///< [m]
  };
  Eigen::Vector2d origin_{0.0, 0.0};
  std::vector<Ray> rays_;
};

}  // namespace cogslam
