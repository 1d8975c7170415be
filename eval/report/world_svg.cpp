#include "eval/report/world_svg.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/angle.hpp"
#include "core/check.hpp"
#include "eval/report/markup.hpp"
#include "worlds/world_map.hpp"

namespace cogslam {
namespace {

constexpr double kMargin = 0.5;  // [m]
constexpr char kSolid[] = "#c8c8c8";

/// All loops as one path, so that one within another is a hole.
std::string path_of(const std::vector<Polygon>& loops) {
  std::string out;
  for (const Polygon& loop : loops) {
    char command = 'M';
    for (const Eigen::Vector2d& p : loop) {
      // Ten digits: a nanometre in any world, without the noise of the last bits.
      out += fmt::format("{}{:.10g} {:.10g}", command, p.x(), p.y());
      command = 'L';
    }
    out += "Z";
  }
  return out;
}

std::string loops_text(const char* name, const std::vector<Polygon>& loops, const char* fill) {
  if (loops.empty()) return "";
  return fmt::format("    <path id=\"{}\" fill=\"{}\" fill-rule=\"evenodd\" d=\"{}\"/>\n", name, fill, path_of(loops));
}

std::string patches_text(const std::vector<SlipPatch>& patches) {
  std::string out;
  for (const SlipPatch& patch : patches) {
    out +=
        fmt::format("    <circle class=\"slip\" cx=\"{:.10g}\" cy=\"{:.10g}\" r=\"{:.10g}\" fill=\"url(#hatch)\"/>\n",
                    patch.centre.x(), patch.centre.y(), patch.radius);
  }
  return out;
}

std::string panes_text(const std::vector<Segment>& panes) {
  std::string out;
  for (const Segment& pane : panes) {
    out += fmt::format("    <path class=\"glass\" stroke=\"#0072b2\" d=\"M{:.10g} {:.10g}L{:.10g} {:.10g}\"/>\n",
                       pane.a.x(), pane.a.y(), pane.b.x(), pane.b.y());
  }
  return out;
}

/// A bar along its axis, as long as its reach on either side.
std::string magnets_text(const std::vector<Magnet>& magnets) {
  std::string out;
  for (const Magnet& magnet : magnets) {
    out += fmt::format(
        "    <path class=\"magnet\" transform=\"translate({:.10g} {:.10g}) rotate({:.10g})\" stroke=\"#d55e00\" "
        "d=\"M{:.10g} 0H{:.10g}\"/>\n",
        magnet.centre.x(), magnet.centre.y(), degrees(magnet.axis), -magnet.reach, magnet.reach);
  }
  return out;
}

/// An arrow of 0.3 m from where the robot's centre starts.
std::string start_text(const Pose2& start) {
  return fmt::format(
      "    <path id=\"start\" transform=\"translate({:.10g} {:.10g}) rotate({:.10g})\" stroke=\"#0072b2\" "
      "fill=\"none\" "
      "d=\"M0 0L0.3 0M0.2 0.07L0.3 0L0.2 -0.07\"/>\n",
      start.x, start.y, degrees(start.theta));
}

}  // namespace

std::string world_svg(const World& world, const std::string& title, double scale) {
  EXPECTS(scale > 0.0);
  const Rectangle area = world.bounds();
  const Eigen::Vector2d low = area.min.array() - kMargin, high = area.max.array() + kMargin, size = high - low;
  const double line = 0.0005 * scale;  // half a millimetre on paper [m]
  std::string out = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.10g}mm\" height=\"{1:.10g}mm\" "
      "viewBox=\"{2:.10g} {3:.10g} {4:.10g} {5:.10g}\">\n"
      "  <title>{6}, 1:{7:.10g}</title>\n"
      "  <defs><pattern id=\"hatch\" width=\"0.1\" height=\"0.1\" patternUnits=\"userSpaceOnUse\">"
      "<path d=\"M0 0L0.1 0.1\" stroke=\"#56b4e9\" stroke-width=\"0.02\"/></pattern></defs>\n"
      "  <rect x=\"{2:.10g}\" y=\"{3:.10g}\" width=\"{4:.10g}\" height=\"{5:.10g}\" fill=\"#ffffff\"/>\n",
      1000.0 * size.x() / scale, 1000.0 * size.y() / scale, low.x(), -high.y(), size.x(), size.y(), markup_text(title),
      scale);
  // The drawing's y runs down, the map's up.
  out += fmt::format(
      "  <g transform=\"scale(1 -1)\" stroke=\"#000000\" stroke-width=\"{:.10g}\" stroke-linejoin=\"round\">\n", line);
  out += patches_text(world.slip_patches) + loops_text("obstacles", world.obstacles, kSolid) +
         loops_text("walls", world.walls, walls_are_thick(world) ? kSolid : "none") + panes_text(world.panes) +
         magnets_text(world.magnets) + start_text(world.start);
  const double bar_y = low.y() + 0.2;
  out += fmt::format("    <path id=\"metre\" d=\"M{0:.10g} {1:.10g}v0.1v-0.05h1v0.05v-0.1\" fill=\"none\"/>\n",
                     area.min.x(), bar_y);
  out += "  </g>\n";
  out += fmt::format(
      "  <text x=\"{:.10g}\" y=\"{:.10g}\" font-family=\"sans-serif\" font-size=\"0.18\">1 m</text>\n</svg>\n",
      area.min.x() + 1.08, -bar_y);
  return out;
}

}  // namespace cogslam
