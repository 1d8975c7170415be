#include "worlds/world_faults.hpp"

namespace cogslam {
namespace {

constexpr double kShortestPane = 0.01;  // [m]
constexpr Range kAnywhere{-1e4, 1e4};   // [m]

void read_place(ConfigSection& section, Eigen::Vector2d& place) {
  section.read("x_m", place.x(), kAnywhere);
  section.read("y_m", place.y(), kAnywhere);
}

}  // namespace

SlipPatch read_slip_patch(ConfigSection& section) {
  SlipPatch patch;
  read_place(section, patch.centre);
  section.read("radius_m", patch.radius, {1e-3, 1e4});
  section.read("friction", patch.friction, {0.0, 1.0});
  return patch;
}

Segment read_glass(ConfigSection& section) {
  Segment pane{{0.0, 0.0}, {1.0, 0.0}};
  for (const char* key : {"from_m", "to_m"}) {
    if (!section.has(key)) section.fail(key, std::string("'") + key + "' is missing, expected two numbers");
  }
  section.read("from_m", pane.a, kAnywhere);
  section.read("to_m", pane.b, kAnywhere);
  if ((pane.b - pane.a).norm() < kShortestPane) {
    section.fail("to_m", "the pane ends where it begins, expected at least 0.01 m of glass");
  }
  return pane;
}

Magnet read_magnet(ConfigSection& section) {
  Magnet magnet;
  read_place(section, magnet.centre);
  section.read("reach_m", magnet.reach, {0.001, 100.0});
  section.read_degrees("axis_deg", magnet.axis, {-360.0, 360.0});
  return magnet;
}

}  // namespace cogslam
