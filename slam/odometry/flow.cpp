#include "slam/odometry/flow.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include "core/check.hpp"

namespace cogslam {
namespace {

// OpenCV's Scharr gradients are 32 times too large.
constexpr double kGradientUnit = 32.0;
// Side of the square whose mean is taken off each pixel [pixel].
constexpr int kFlattenSide = 31;

/// OpenCV's pixel centres are whole numbers, ours are halves.
cv::Point2f to_cv(const Eigen::Vector2d& p) {
  return {static_cast<float>(p.x() - 0.5), static_cast<float>(p.y() - 0.5)};
}
Eigen::Vector2d from_cv(const cv::Point2f& p) { return {p.x + 0.5, p.y + 0.5}; }

cv::Mat view_of(const FloorImage& image) {
  EXPECTS(image.width > 0 && image.height > 0);
  EXPECTS(image.grey.size() == static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  return {image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.grey.data())};
}

}  // namespace

double texture_of_noise(double noise) { return noise * noise * 236.0 / (32.0 * 32.0); }

struct FlowTracker::State {
  struct Picture {
    cv::Mat grey;
    std::vector<cv::Mat> pyramid;
  };
  Picture reference;
  Picture latest;
  std::vector<cv::Point2f> points;  ///< in the reference
  std::vector<double> texture;      ///< of each point
};

namespace {

/// The picture less its local mean. Vignette and shadows stand still in the picture and would pull every point back:
/// on concrete a vignette of 25 % cost 0.2 % of the motion.
cv::Mat flattened(const cv::Mat& grey) {
  cv::Mat mean, flat;
  cv::blur(grey, mean, {kFlattenSide, kFlattenSide});
  cv::addWeighted(grey, 1.0, mean, -1.0, 128.0, flat);
  return flat;
}

std::vector<cv::Mat> pyramid_of(const cv::Mat& grey, const FlowConfig& config) {
  std::vector<cv::Mat> pyramid;
  cv::buildOpticalFlowPyramid(grey, pyramid, {config.window, config.window}, config.levels - 1,
                              /*withDerivatives=*/true);
  return pyramid;
}

std::vector<cv::Point2f> corners_of(const cv::Mat& grey, const FlowConfig& config) {
  std::vector<cv::Point2f> corners;
  // A corner at the border could not be compared over its whole window.
  const int border = config.window / 2 + 1;
  if (grey.cols <= 2 * border || grey.rows <= 2 * border) return corners;
  const cv::Rect inside(border, border, grey.cols - 2 * border, grey.rows - 2 * border);
  cv::goodFeaturesToTrack(grey(inside), corners, config.points, config.corner_quality, config.corner_distance);
  for (cv::Point2f& corner : corners) corner += cv::Point2f(static_cast<float>(border), static_cast<float>(border));
  return corners;
}

/// Smaller eigenvalue of the mean squared gradient over the window around a point.
double texture_at(const cv::Mat& gradients, const cv::Point2f& point, int window) {
  const cv::Rect around(cvRound(point.x) - window / 2, cvRound(point.y) - window / 2, window, window);
  const cv::Rect inside = around & cv::Rect(0, 0, gradients.cols, gradients.rows);
  std::int64_t xx = 0, xy = 0, yy = 0;
  for (int row = inside.y; row < inside.y + inside.height; ++row) {
    const auto* gradient = gradients.ptr<cv::Vec2s>(row);
    for (int column = inside.x; column < inside.x + inside.width; ++column) {
      const int x = gradient[column][0], y = gradient[column][1];
      xx += x * x;
      xy += x * y;
      yy += y * y;
    }
  }
  const double half_trace = 0.5 * static_cast<double>(xx + yy), half_difference = 0.5 * static_cast<double>(xx - yy);
  const double smaller = half_trace - std::hypot(half_difference, static_cast<double>(xy));
  return smaller / (kGradientUnit * kGradientUnit * std::max(1, inside.area()));
}

}  // namespace

FlowTracker::FlowTracker(const FlowConfig& config) : config_(config), state_(std::make_unique<State>()) {
  cv::setNumThreads(1);  // runs are parallel by process; OpenCV's own threads only get in each other's way
}

FlowTracker::~FlowTracker() = default;

bool FlowTracker::has_reference() const { return !state_->reference.pyramid.empty(); }

int FlowTracker::points() const { return static_cast<int>(state_->points.size()); }

void FlowTracker::start(const FloorImage& image) {
  look(image);
  rebase({});
}

void FlowTracker::look(const FloorImage& image) {
  State& s = *state_;
  s.latest.grey = flattened(view_of(image));
  s.latest.pyramid = pyramid_of(s.latest.grey, config_);
}

Eigen::Vector2d FlowTracker::shift() const {
  const State& s = *state_;
  EXPECTS(has_reference() && s.latest.grey.size() == s.reference.grey.size());
  cv::Mat before, now, window;
  s.reference.grey.convertTo(before, CV_32F);
  s.latest.grey.convertTo(now, CV_32F);
  cv::createHanningWindow(window, before.size(), CV_32F);
  const cv::Point2d moved = cv::phaseCorrelate(before, now, window);
  return {moved.x, moved.y};
}

std::vector<FlowPair> FlowTracker::track(const Prediction& predicted) const {
  const State& s = *state_;
  EXPECTS(has_reference() && s.latest.grey.size() == s.reference.grey.size());
  if (s.points.empty()) return {};
  std::vector<cv::Point2f> found;
  for (const cv::Point2f& p : s.points) found.push_back(to_cv(predicted(from_cv(p))));
  std::vector<std::uint8_t> status;
  std::vector<float> difference;
  cv::calcOpticalFlowPyrLK(
      s.reference.pyramid, s.latest.pyramid, s.points, found, status, difference, {config_.window, config_.window},
      config_.levels - 1, {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, config_.iterations, config_.step_tolerance},
      cv::OPTFLOW_USE_INITIAL_FLOW, /*minEigThreshold=*/1e-7);

  const auto border = static_cast<float>(config_.window / 2);
  const cv::Size size = s.latest.grey.size();
  const cv::Rect2f inside(border, border, static_cast<float>(size.width - 1) - 2 * border,
                          static_cast<float>(size.height - 1) - 2 * border);
  std::vector<FlowPair> pairs;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (status[i] == 0 || !inside.contains(found[i])) continue;
    pairs.push_back({from_cv(s.points[i]), from_cv(found[i]), s.texture[i]});
  }
  return pairs;
}

void FlowTracker::rebase(const std::vector<Eigen::Vector2d>& points) {
  State& s = *state_;
  std::swap(s.reference, s.latest);
  std::vector<cv::Point2f> wanted;
  for (const Eigen::Vector2d& p : points) wanted.push_back(to_cv(p));
  if (3 * points.size() < 2 * static_cast<std::size_t>(config_.points)) wanted = corners_of(s.reference.grey, config_);
  s.points.clear();
  s.texture.clear();
  for (const cv::Point2f& p : wanted) {
    const double texture = texture_at(s.reference.pyramid[1], p, config_.window);  // gradients follow each level
    if (texture < config_.min_texture) continue;
    s.points.push_back(p);
    s.texture.push_back(texture);
  }
}

}  // namespace cogslam
