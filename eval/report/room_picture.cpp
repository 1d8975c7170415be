#include "eval/report/room_picture.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "eval/report/canvas.hpp"
#include "eval/report/palette.hpp"
#include "eval/report/png.hpp"
#include "eval/report/scale_bar.hpp"

namespace cogslam {
namespace {

constexpr int kStrip = 44;   // height of the legend above and of the scale bar below [pixels]
constexpr int kMargin = 24;  // around the room [pixels]
constexpr double kStartRadius = 7.0;
constexpr double kShortSide = 700.0, kLongSide = 1800.0;

struct Stroke {
  const char* name;
  std::span<const Pose2> path;
  double width;
  Colour colour;
};

bool finite(const Pose2& T) { return std::isfinite(T.x) && std::isfinite(T.y); }

Rectangle extent(const World& world, std::span<const Stroke> strokes) {
  std::vector<Eigen::Vector2d> points;
  for (const Segment& s : world.segments()) points.insert(points.end(), {s.a, s.b});
  for (const Stroke& stroke : strokes) {
    for (const Pose2& T : stroke.path) {
      if (finite(T)) points.push_back(T.position());
    }
  }
  if (points.empty()) return {{-0.5, -0.5}, {0.5, 0.5}};
  Rectangle area{points.front(), points.front()};
  for (const Eigen::Vector2d& p : points) area = {area.min.cwiseMin(p), area.max.cwiseMax(p)};
  // A path along a straight line has no width; half a metre keeps the scale finite.
  const Eigen::Vector2d grow = (Eigen::Vector2d::Constant(0.5) - (area.max - area.min)).cwiseMax(0.0) / 2.0;
  return {area.min - grow, area.max + grow};
}

/// From the map [m] to the canvas [pixels].
class View {
 public:
  explicit View(const Rectangle& area) : area_(area) {
    const Eigen::Vector2d size = area.max - area.min;
    scale_ = std::min(kShortSide / size.minCoeff(), kLongSide / size.maxCoeff());
  }
  [[nodiscard]] double pixels_per_metre() const { return scale_; }
  [[nodiscard]] int width() const { return pixels((area_.max - area_.min).x()); }
  [[nodiscard]] int height() const { return pixels((area_.max - area_.min).y()) + 2 * kStrip; }
  [[nodiscard]] Eigen::Vector2d at(const Eigen::Vector2d& p_map) const {
    return {kMargin + scale_ * (p_map.x() - area_.min.x()), kStrip + kMargin + scale_ * (area_.max.y() - p_map.y())};
  }
  [[nodiscard]] std::vector<Eigen::Vector2d> at(std::span<const Eigen::Vector2d> points) const {
    std::vector<Eigen::Vector2d> drawn;
    for (const Eigen::Vector2d& p : points) drawn.push_back(at(p));
    return drawn;
  }

 private:
  [[nodiscard]] int pixels(double metres) const { return static_cast<int>(std::ceil(scale_ * metres)) + 2 * kMargin; }

  Rectangle area_;
  double scale_ = 1.0;
};

void draw_loop(Canvas& canvas, std::vector<Eigen::Vector2d> corners) {
  if (corners.empty()) return;
  corners.push_back(corners.front());
  canvas.draw_line(corners, 3.0, kBlack);
}

void draw_world(Canvas& canvas, const View& view, const World& world) {
  for (const Polygon& box : world.obstacles) canvas.fill_polygon(view.at(box), kLightGrey);
  for (const Polygon& box : world.obstacles) draw_loop(canvas, view.at(box));
  for (const Polygon& wall : world.walls) draw_loop(canvas, view.at(wall));
  for (const Segment& pane : world.panes) {
    const Eigen::Vector2d ends[] = {view.at(pane.a), view.at(pane.b)};
    canvas.draw_line(ends, 3.0, kBlue);
  }
}

void draw_path(Canvas& canvas, const View& view, const Stroke& stroke) {
  std::vector<Eigen::Vector2d> points;
  for (const Pose2& T : stroke.path) {
    if (finite(T)) points.push_back(view.at(T.position()));
  }
  canvas.draw_line(points, stroke.width, stroke.colour);
}

void draw_legend(Canvas& canvas, std::span<const Stroke> strokes) {
  int x = kMargin;
  const int y = kStrip / 2;
  for (const Stroke& stroke : strokes) {
    const Eigen::Vector2d sample[] = {{x, y}, {x + 36.0, y}};
    canvas.draw_line(sample, stroke.width, stroke.colour);
    canvas.draw_text(x + 48, y - 8, stroke.name, 2, kBlack);
    x += 48 + Canvas::text_width(stroke.name, 2) + 32;
  }
  canvas.draw_disc({x + 8.0, y}, kStartRadius, kBlue);
  canvas.draw_text(x + 24, y - 8, "start", 2, kBlack);
}

}  // namespace

std::string room_picture(const World& world, const DrawnPaths& paths) {
  // The truth is broad and pale below, the estimate narrow and dark on top: where they agree, both are seen.
  std::vector<Stroke> strokes{{"truth", paths.truth, 7.0, kSkyBlue},
                              {"odometry", paths.odometry, 2.0, kVermilion},
                              {"estimate", paths.estimate, 2.0, kBlack}};
  std::erase_if(strokes, [](const Stroke& s) { return s.path.empty(); });
  const View view(extent(world, strokes));
  Canvas canvas(std::max(view.width(), 600), view.height(), kWhite);
  draw_world(canvas, view, world);
  for (const Stroke& stroke : strokes) draw_path(canvas, view, stroke);
  if (!strokes.empty() && finite(strokes.front().path.front())) {
    canvas.draw_disc(view.at(strokes.front().path.front().position()), kStartRadius, kBlue);
  }
  if (!strokes.empty()) draw_legend(canvas, strokes);
  draw_scale_bar(canvas, kMargin, view.height() - kStrip / 2 - 8, view.pixels_per_metre());
  return png_bytes(canvas.width(), canvas.height(), canvas.rgb());
}

}  // namespace cogslam
