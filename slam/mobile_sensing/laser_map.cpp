#include "slam/mobile_sensing/laser_map.hpp"

#include <algorithm>
#include <cmath>

#include "core/check.hpp"

namespace cogslam {
namespace {

constexpr double kGaussianReach = 5.0;  // in sigma; beyond, the Gaussian is below 4e-6

/// A sweep ready to be asked for many points.
class ScanField {
 public:
  ScanField(const LaserModel& model, const Scan& scan)
      : model_(model), scan_(scan), limit_(std::min(scan.range_max, model.range_max_m)) {
    ends_.reserve(scan.ranges.size());
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
      const double angle = scan.angle_first + static_cast<double>(i) * scan.angle_increment;
      const double range = std::isfinite(scan.ranges[i]) ? static_cast<double>(scan.ranges[i]) : 0.0;
      ends_.emplace_back(range * std::cos(angle), range * std::sin(angle));
    }
  }

  /// Nothing is said beyond this distance from the lidar [m].
  [[nodiscard]] double reach() const { return limit_ + kGaussianReach * model_.sigma_m; }

  [[nodiscard]] double at(const Eigen::Vector2d& p) const {
    const double angle = wrap_angle(std::atan2(p.y(), p.x()) - middle()) + middle();
    const double beam = std::round((angle - scan_.angle_first) / scan_.angle_increment);
    if (beam < 0.0 || beam >= static_cast<double>(ends_.size())) return kUnchanged;
    const auto i = static_cast<std::size_t>(beam);
    const float range = scan_.ranges[i];
    if (range == Scan::kNoReturn || range > limit_) return p.norm() <= limit_ ? model_.p_free : kUnchanged;
    if (!std::isfinite(range)) return kUnchanged;
    const double base = p.squaredNorm() <= static_cast<double>(range) * range ? model_.p_free : kUnchanged;
    const double squared = (p - ends_[i]).squaredNorm() / (model_.sigma_m * model_.sigma_m);
    if (squared > kGaussianReach * kGaussianReach) return base;
    return base + (model_.p_occupied - base) * std::exp(-0.5 * squared);
  }

 private:
  /// The middle of the field of view: angles are unwrapped about it.
  [[nodiscard]] double middle() const {
    return scan_.angle_first + 0.5 * scan_.angle_increment * (static_cast<double>(ends_.size()) - 1.0);
  }

  const LaserModel& model_;
  const Scan& scan_;
  double limit_;                       // [m]
  std::vector<Eigen::Vector2d> ends_;  // of the beams, in the lidar's frame [m]
};

}  // namespace

std::string LaserModel::check() const {
  if (!(p_free > 0.0 && p_free < kUnchanged)) return "p_free: expected more than 0 and less than 0.5";
  if (!(p_occupied > kUnchanged && p_occupied < 1.0)) return "p_occupied: expected more than 0.5 and less than 1";
  if (!(sigma_m > 0.0)) return "sigma_m: expected more than 0";
  if (points_per_side < 1) return "points_per_side: expected at least 1";
  if (!(range_max_m > 0.0)) return "range_max_m: expected more than 0";
  return "";
}

double occupancy_at(const LaserModel& model, const Scan& scan, const Eigen::Vector2d& p_lidar) {
  return ScanField(model, scan).at(p_lidar);
}

Grid<double> scan_occupancy(const LaserModel& model, const Scan& scan, const Pose2& T_frame_base,
                            const GridFrame& frame) {
  EXPECTS(model.check().empty());
  EXPECTS(frame.size() > 0 && scan.angle_increment > 0.0);
  const ScanField field(model, scan);
  const Pose2 T_lidar_frame = (T_frame_base * scan.T_base_lidar).inverse();
  const int n = model.points_per_side;
  const double step = frame.cell_size / n, half_diagonal = frame.cell_size * std::sqrt(0.5);
  // Neighbouring points of a cell, seen from the lidar.
  const Eigen::Vector2d along_x = step * Eigen::Vector2d(std::cos(T_lidar_frame.theta), std::sin(T_lidar_frame.theta));
  const Eigen::Vector2d along_y(-along_x.y(), along_x.x());
  Grid<double> out(frame, kUnchanged);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const Eigen::Vector2d centre = T_lidar_frame * frame.centre_of({x, y});
      if (centre.norm() > field.reach() + half_diagonal) continue;
      double sum = 0.0;
      for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
          sum += field.at(centre + (i - 0.5 * (n - 1)) * along_x + (j - 0.5 * (n - 1)) * along_y);
        }
      }
      out[{x, y}] = sum / (n * n);
    }
  }
  return out;
}

void add_evidence(Grid<double>& log_odds, const Grid<double>& occupancy) {
  EXPECTS(log_odds.frame() == occupancy.frame());
  for (std::size_t i = 0; i < occupancy.values().size(); ++i) {
    const double p = occupancy.values()[i];
    log_odds.values()[i] += std::log(p / (1.0 - p));
  }
}

Grid<double> probability(const Grid<double>& log_odds) {
  Grid<double> p(log_odds.frame());
  for (std::size_t i = 0; i < p.values().size(); ++i) p.values()[i] = 1.0 / (1.0 + std::exp(-log_odds.values()[i]));
  return p;
}

}  // namespace cogslam
