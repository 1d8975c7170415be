#pragma once

#include <optional>
#include <vector>

#include "core/pose2.hpp"
#include "sensors/camera_model.hpp"
#include "sensors/readings.hpp"
#include "slam/odometry/flow.hpp"
#include "slam/odometry/planar_fit.hpp"

namespace cogslam {

struct VisualOdometryConfig {
  FlowConfig flow{};
  int frames_per_key = 1;           ///< pictures compared with one reference before the next one replaces it
  double pixel_noise = 3.0;         ///< of the camera, standard deviation [grey]
  double texture_over_noise = 1.5;  ///< gate: a point counts if its window shows this many times what noise would
  int min_inliers = 20;             ///< gate: pairs that agree with the motion, at least
  double min_inlier_share = 0.5;    ///< gate: their share of all pairs, at least
  double inlier_distance = 1.0;     ///< [pixel]
  double covariance_factor = 1.5;   ///< on the covariance of the fit: neighbouring windows share pixels
  double scale_error = 0.001;       ///< share of the motion that may be wrong in every picture alike
};

/// Motion of the base from pictures of the floor.
class VisualOdometry {
 public:
  VisualOdometry(const CameraModel& model, const VisualOdometryConfig& config);

  /// The motion since the picture given before. Nothing for the first picture, and nothing where the gates say that
  /// the floor shows too little texture or the points do not agree on one motion: better no estimate than a wrong one,
  /// since flow on a plain floor follows vignette and noise and reports next to no motion.
  std::optional<MotionIncrement> update(const FloorImage& image);

 private:
  [[nodiscard]] Eigen::Vector2d predicted(const Eigen::Vector2d& pixel, const Pose2& T_key_now) const;
  /// Where the base is now, seen from the reference picture, and the pairs that say so.
  struct Found {
    PlanarFit fit{};
    std::vector<FlowPair> pairs;
  };
  [[nodiscard]] std::optional<Found> find(double dt) const;
  [[nodiscard]] std::optional<Found> find_near(const FlowTracker::Prediction& predicted) const;
  [[nodiscard]] MotionIncrement increment_to(const PlanarFit& fit) const;
  void keep_key_fresh(const Found& found);

  CameraModel model_;
  VisualOdometryConfig config_;
  FlowTracker tracker_;
  Time stamp_{};                   ///< of the picture before
  Pose2 T_key_last_{};             ///< the base at the picture before, seen from the reference picture
  std::optional<Twist2> twist_{};  ///< at the picture before, where known
  int frames_since_key_ = 0;
};

}  // namespace cogslam
