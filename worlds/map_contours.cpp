#include "worlds/map_contours.hpp"

#include <opencv2/imgproc.hpp>
#include <utility>

namespace cogslam {
namespace {

using Contour = std::vector<cv::Point>;

constexpr int kHole = 2;  // in the hierarchy of a contour: its first hole; -1 where it has none

/// 255 where a surface may stand, the lowest row of the map first; with one more cell around where all beyond is solid.
cv::Mat solid_image(const OccupancyMap& map, bool unknown_is_solid, int margin) {
  cv::Mat solid(map.height + 2 * margin, map.width + 2 * margin, CV_8UC1, cv::Scalar(0));
  for (int y = 0; y < solid.rows; ++y) {
    for (int x = 0; x < solid.cols; ++x) {
      const MapCell cell = map.at({x - margin, y - margin});
      const bool is_solid = cell == MapCell::kOccupied || (cell == MapCell::kUnknown && unknown_is_solid);
      solid.at<std::uint8_t>(y, x) = is_solid ? 255 : 0;
    }
  }
  return solid;
}

/// The loop in the plane, through the centres of the cells.
Polygon loop_of(const OccupancyMap& map, const Contour& contour, int margin) {
  const auto centre = [&](const cv::Point& p) { return Eigen::Vector2d(p.x - margin + 0.5, p.y - margin + 0.5); };
  Polygon loop;
  if (contour.size() == 1) {
    for (const auto& [x, y] : {std::pair{-0.25, -0.25}, {0.25, -0.25}, {0.25, 0.25}, {-0.25, 0.25}}) {
      loop.push_back(map.point(centre(contour.front()) + Eigen::Vector2d(x, y)));
    }
    return loop;
  }
  for (const cv::Point& p : contour) loop.push_back(map.point(centre(p)));
  return loop;
}

Contour simplified(const Contour& contour, double tolerance_cells) {
  if (tolerance_cells <= 0.0) return contour;
  Contour out;
  cv::approxPolyDP(contour, out, tolerance_cells, true);
  // A group of cells that is smaller than the tolerance stays as it is: it would vanish.
  return out.size() < 3 ? contour : out;
}

}  // namespace

std::size_t count_corners(const OccupancyMap& map, bool unknown_is_solid) {
  const auto solid = [&](int x, int y) {
    const MapCell cell = map.at({x, y});
    return cell == MapCell::kOccupied || (cell == MapCell::kUnknown && unknown_is_solid) ? 1 : 0;
  };
  std::size_t corners = 0;
  for (int y = -1; y < map.height; ++y) {
    int below = solid(-1, y), above = solid(-1, y + 1);
    for (int x = 0; x <= map.width; ++x) {
      const int left_below = std::exchange(below, solid(x, y)), left_above = std::exchange(above, solid(x, y + 1));
      const int count = left_below + left_above + below + above;
      const bool touch = count == 2 && left_below == above;
      corners += touch ? 2 : count == 1 || count == 3 ? 1 : 0;
    }
  }
  return corners;
}

World map_contours(const OccupancyMap& map, const MapContourConfig& config) {
  const int margin = config.unknown_is_solid ? 1 : 0;
  std::vector<Contour> contours;
  std::vector<cv::Vec4i> hierarchy;
  cv::findContours(solid_image(map, config.unknown_is_solid, margin), contours, hierarchy, cv::RETR_CCOMP,
                   cv::CHAIN_APPROX_SIMPLE);
  World world;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const bool is_hole = hierarchy[i][3] >= 0, has_hole = hierarchy[i][kHole] >= 0;
    const Polygon loop = loop_of(map, simplified(contours[i], config.simplify / map.resolution), margin);
    (is_hole || has_hole ? world.walls : world.obstacles).push_back(loop);
  }
  return world;
}

}  // namespace cogslam
