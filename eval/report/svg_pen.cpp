#include <fmt/format.h>

#include "eval/report/chart_pen.hpp"
#include "eval/report/markup.hpp"

namespace cogslam {
namespace {

std::string hex(Colour c) { return fmt::format("#{:02x}{:02x}{:02x}", c.red, c.green, c.blue); }

std::string list(std::span<const Eigen::Vector2d> points) {
  std::string text;
  for (const Eigen::Vector2d& p : points) text += fmt::format("{}{:.2f},{:.2f}", text.empty() ? "" : " ", p.x(), p.y());
  return text;
}

}  // namespace

SvgPen::SvgPen(int width, int height)
    : svg_(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
                       "font-family=\"sans-serif\" font-size=\"{2}\">\n",
                       width, height, kLetterHeight)) {
  rectangle(0, 0, width, height, {255, 255, 255});
}

void SvgPen::line(std::span<const Eigen::Vector2d> points, double width, Colour colour) {
  svg_ += fmt::format(
      "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\" "
      "stroke-linecap=\"round\"/>\n",
      list(points), hex(colour), width);
}

void SvgPen::polygon(std::span<const Eigen::Vector2d> corners, Colour colour) {
  svg_ += fmt::format("<polygon points=\"{}\" fill=\"{}\"/>\n", list(corners), hex(colour));
}

void SvgPen::band(std::span<const Eigen::Vector2d> low, std::span<const Eigen::Vector2d> high, Colour colour) {
  std::vector<Eigen::Vector2d> outline(low.begin(), low.end());
  outline.insert(outline.end(), high.rbegin(), high.rend());
  svg_ += fmt::format("<polygon points=\"{}\" fill=\"{}\" fill-opacity=\"0.25\"/>\n", list(outline), hex(colour));
}

void SvgPen::rectangle(double x, double y, double width, double height, Colour colour) {
  svg_ += fmt::format(
      "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\" "
      "shape-rendering=\"crispEdges\"/>\n",
      x, y, width, height, hex(colour));
}

void SvgPen::text(double x, double y, std::string_view text, TextAnchor anchor) {
  const char* name = anchor == TextAnchor::kLeft ? "start" : anchor == TextAnchor::kMiddle ? "middle" : "end";
  svg_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\">{}</text>\n", x, y + 0.85 * kLetterHeight,
                      name, markup_text(text));
}

}  // namespace cogslam
