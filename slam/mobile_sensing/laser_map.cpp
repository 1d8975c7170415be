#include "slam/mobile_sensing/laser_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/check.hpp"

namespace cogslam {
namespace {

constexpr double kGaussianReach = 5.0;  // in sigma; beyond, the Gaussian is below 4e-6

/// A sweep, and which of its neighbouring beams end on one surface.
class Sweep {
 public:
  Sweep(const LaserModel& model, const Scan& scan)
      : scan_(scan), limit_(std::min(scan.range_max, model.range_max_m)), beams_(scan.ranges.size()) {
    for (std::size_t i = 0; i < beams_; ++i) {
      const double angle = scan.angle_first + static_cast<double>(i) * scan.angle_increment;
      ends_.emplace_back(Eigen::Vector2d(std::cos(angle), std::sin(angle)) * (has_end(i) ? scan.ranges[i] : 0.0));
    }
    for (std::size_t i = 0; i < beams_; ++i) joined_.push_back(joins(i, std::sin(model.least_incidence)));
  }

  /// Nothing is said of the room beyond this distance from the lidar [m].
  [[nodiscard]] double limit() const { return limit_; }

  /// Whether the beams passed through `p` before they ended.
  [[nodiscard]] bool is_free(const Eigen::Vector2d& p) const {
    const double middle = 0.5 * scan_.angle_increment * (static_cast<double>(beams_) - 1.0);
    const double angle = wrap_angle(std::atan2(p.y(), p.x()) - scan_.angle_first - middle) + middle;
    const double beam = angle / scan_.angle_increment, last = static_cast<double>(beams_) - 1.0;
    if (!(beam >= -0.5 && beam <= last + 0.5)) return false;
    const auto below = static_cast<std::size_t>(std::clamp(std::floor(beam), 0.0, last));
    if (beam >= 0.0 && joined_[below]) {
      const Eigen::Vector2d along = ends_[below + 1] - ends_[below], to_p = p - ends_[below];
      return along.x() * to_p.y() - along.y() * to_p.x() >= 0.0;
    }
    const float range = scan_.ranges[static_cast<std::size_t>(std::clamp(std::round(beam), 0.0, last))];
    const bool no_end = range == Scan::kNoReturn || range > limit_;
    return p.norm() <= (no_end ? limit_ : std::isfinite(range) ? static_cast<double>(range) : 0.0);
  }

  /// visit(a, b) for each piece of surface, in the lidar's frame [m]; a == b for an end that stands alone.
  template <class Visit>
  void for_each_piece(const Visit& visit) const {
    for (std::size_t i = 0; i < beams_; ++i) {
      if (joined_[i]) {
        visit(ends_[i], ends_[i + 1]);
      } else if (has_end(i) && (i == 0 || !joined_[i - 1])) {
        visit(ends_[i], ends_[i]);
      }
    }
  }

 private:
  [[nodiscard]] bool has_end(std::size_t i) const {
    return std::isfinite(scan_.ranges[i]) && scan_.ranges[i] <= limit_;
  }

  [[nodiscard]] bool joins(std::size_t i, double least_sine) const {
    if (i + 1 >= beams_ || !has_end(i) || !has_end(i + 1)) return false;
    const double nearer = std::min(scan_.ranges[i], scan_.ranges[i + 1]);
    return nearer * std::sin(scan_.angle_increment) >= least_sine * (ends_[i + 1] - ends_[i]).norm();
  }

  const Scan& scan_;
  double limit_;
  std::size_t beams_;
  std::vector<Eigen::Vector2d> ends_;  // of the beams, in the lidar's frame [m]
  std::vector<bool> joined_;           // beam i and the next end on one surface
};

double squared_distance(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d ab = b - a, ap = p - a;
  const double length = ab.squaredNorm();
  const double share = length > 0.0 ? std::clamp(ap.dot(ab) / length, 0.0, 1.0) : 0.0;
  return (ap - share * ab).squaredNorm();
}

/// The points at which a cell is asked, of all cells, as a grid of its own.
class Points {
 public:
  Points(const GridFrame& frame, int per_side)
      : width(frame.width * per_side),
        height(frame.height * per_side),
        step_(frame.cell_size / per_side),
        origin_(frame.origin() + Eigen::Vector2d::Constant(0.5 * step_)) {}

  [[nodiscard]] Eigen::Vector2d at(int x, int y) const { return origin_ + step_ * Eigen::Vector2d(x, y); }
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  /// First and last column (axis 0) or row (axis 1) within [low, high].
  [[nodiscard]] std::pair<int, int> span(int axis, double low, double high) const {
    const int first = static_cast<int>(std::ceil((low - origin_[axis]) / step_));
    const int last = static_cast<int>(std::floor((high - origin_[axis]) / step_));
    return {std::max(first, 0), std::min(last, (axis == 0 ? width : height) - 1)};
  }

  int width, height;

 private:
  double step_;
  Eigen::Vector2d origin_;
};

/// Squared distance of each point to the nearest piece of surface, as far as `reach` [m]; infinity beyond.
std::vector<double> squared_distances(const Points& points, const Sweep& sweep, const Pose2& T_frame_lidar,
                                      double reach) {
  std::vector<double> nearest(static_cast<std::size_t>(points.width) * static_cast<std::size_t>(points.height),
                              std::numeric_limits<double>::infinity());
  sweep.for_each_piece([&](const Eigen::Vector2d& a_lidar, const Eigen::Vector2d& b_lidar) {
    const Eigen::Vector2d a = T_frame_lidar * a_lidar, b = T_frame_lidar * b_lidar;
    const Eigen::Vector2d low = a.cwiseMin(b).array() - reach, high = a.cwiseMax(b).array() + reach;
    const auto [first_x, last_x] = points.span(0, low.x(), high.x());
    const auto [first_y, last_y] = points.span(1, low.y(), high.y());
    for (int y = first_y; y <= last_y; ++y) {
      for (int x = first_x; x <= last_x; ++x) {
        double& least = nearest[points.index(x, y)];
        least = std::min(least, squared_distance(points.at(x, y), a, b));
      }
    }
  });
  return nearest;
}

}  // namespace

std::string LaserModel::check() const {
  if (!(p_free > 0.0 && p_free < kUnchanged)) return "p_free: expected more than 0 and less than 0.5";
  if (!(p_occupied > kUnchanged && p_occupied < 1.0)) return "p_occupied: expected more than 0.5 and less than 1";
  if (!(sigma_m > 0.0)) return "sigma_m: expected more than 0";
  if (!(least_incidence > 0.0 && least_incidence <= 0.5 * std::numbers::pi)) {
    return "least_incidence: expected more than 0 and at most pi/2";
  }
  if (points_per_side < 1) return "points_per_side: expected at least 1";
  if (!(range_max_m > 0.0)) return "range_max_m: expected more than 0";
  return "";
}

Grid<double> scan_occupancy(const LaserModel& model, const Scan& scan, const Pose2& T_frame_base,
                            const GridFrame& frame) {
  EXPECTS(model.check().empty());
  EXPECTS(frame.size() > 0 && scan.angle_increment > 0.0);
  const Sweep sweep(model, scan);
  const Pose2 T_frame_lidar = T_frame_base * scan.T_base_lidar, T_lidar_frame = T_frame_lidar.inverse();
  const Points points(frame, model.points_per_side);
  const double reach = kGaussianReach * model.sigma_m;
  const std::vector<double> squared = squared_distances(points, sweep, T_frame_lidar, reach);
  Grid<double> out(frame, 0.0);
  for (int y = 0; y < points.height; ++y) {
    for (int x = 0; x < points.width; ++x) {
      const Eigen::Vector2d p = T_lidar_frame * points.at(x, y);
      const double base = p.norm() <= sweep.limit() && sweep.is_free(p) ? model.p_free : kUnchanged;
      const double d = squared[points.index(x, y)] / (model.sigma_m * model.sigma_m);
      const double wall = d <= kGaussianReach * kGaussianReach ? std::exp(-0.5 * d) : 0.0;
      out[{x / model.points_per_side, y / model.points_per_side}] += base + (model.p_occupied - base) * wall;
    }
  }
  for (double& p : out.values()) p /= model.points_per_side * model.points_per_side;
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
