#pragma once

#include <Eigen/Core>

namespace cogslam {

/// A score of poses about one of them, to second order over the small motion that follows it [m, m, rad].
struct PoseFit {
  double value = 0.0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< minus the curvature, made positive semidefinite
};

inline PoseFit operator*(double factor, const PoseFit& fit) {
  return {factor * fit.value, factor * fit.gradient, factor * fit.information};
}

}  // namespace cogslam
