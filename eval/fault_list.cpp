#include "eval/fault_list.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "worlds/free_space.hpp"
#include "worlds/polygon.hpp"
#include "worlds/rooms.hpp"
#include "worlds/world_faults.hpp"

namespace cogslam {
namespace {

enum class FaultKind {
  kDropout,
  kFrozen,
  kLate,
  kOutlierBeams,
  kGlass,
  kMagnet,
  kSlipPatch,
  kCameraBlackout,
  kPush,
  kKidnapping
};

FaultKind read_kind(ConfigSection& section) {
  FaultKind kind = FaultKind::kDropout;
  if (!section.has("kind")) section.fail("kind", "a fault without 'kind', expected one as in docs/faults.md");
  section.read_choice("kind", kind,
                      {{"dropout", FaultKind::kDropout},
                       {"frozen", FaultKind::kFrozen},
                       {"late", FaultKind::kLate},
                       {"outlier_beams", FaultKind::kOutlierBeams},
                       {"glass", FaultKind::kGlass},
                       {"magnet", FaultKind::kMagnet},
                       {"slip_patch", FaultKind::kSlipPatch},
                       {"camera_blackout", FaultKind::kCameraBlackout},
                       {"push", FaultKind::kPush},
                       {"kidnapping", FaultKind::kKidnapping}});
  return kind;
}

/// A fault of a sensor that is not there would be one that never shows.
void check_sensor(const ConfigSection& section, const Scenario& scenario, SensorKind sensor) {
  const bool there = (sensor == SensorKind::kCamera && scenario.camera.enabled) ||
                     (sensor == SensorKind::kCompass && scenario.sensors.compass.rate_hz > 0.0) ||
                     (sensor == SensorKind::kWheels && scenario.sensors.wheels.rate_hz > 0.0) ||
                     sensor == SensorKind::kLidar;
  if (!there) section.fail("sensor", "the robot has no such sensor, expected one that is switched on");
}

StreamFault read_checked(ConfigSection& section, const Scenario& scenario, StreamFaultKind kind, std::uint32_t number) {
  const StreamFault fault = read_stream_fault(section, kind, number);
  check_sensor(section, scenario, fault.sensor);
  return fault;
}

Segment read_pane(ConfigSection& section, const Scenario& scenario) {
  const Segment pane = read_glass(section);
  World world = scenario.world;
  world.panes.push_back(pane);
  const Rectangle area = world.bounds();
  if ((area.max - area.min).maxCoeff() > kLargestRoom) {
    section.fail("to_m", "with this pane the world is larger than 200 m, expected at most 200 m each way");
  }
  return pane;
}

Eigen::Vector2d read_blackout(ConfigSection& section, const Scenario& scenario) {
  check_sensor(section, scenario, SensorKind::kCamera);
  const FaultSpan span = read_fault_span(section);
  return {span.from.seconds(), span.to.seconds()};
}

void read_fault(ConfigSection& section, std::uint32_t number, Scenario& scenario) {
  SensorFaults& sensors = scenario.sensors.faults;
  switch (read_kind(section)) {
    case FaultKind::kDropout:
      return sensors.streams.push_back(read_checked(section, scenario, StreamFaultKind::kDropout, number));
    case FaultKind::kFrozen:
      return sensors.streams.push_back(read_checked(section, scenario, StreamFaultKind::kFrozen, number));
    case FaultKind::kLate:
      return sensors.streams.push_back(read_checked(section, scenario, StreamFaultKind::kLate, number));
    case FaultKind::kOutlierBeams:
      return sensors.outliers.push_back(read_outlier_beams(section, number));
    case FaultKind::kGlass:
      return scenario.world.panes.push_back(read_pane(section, scenario));
    case FaultKind::kMagnet:
      check_sensor(section, scenario, SensorKind::kCompass);
      return scenario.world.magnets.push_back(read_magnet(section));
    case FaultKind::kSlipPatch:
      return scenario.world.slip_patches.push_back(read_slip_patch(section));
    case FaultKind::kCameraBlackout:
      return scenario.camera.blackouts.push_back(read_blackout(section, scenario));
    case FaultKind::kPush:
      return scenario.disturbances.pushes.push_back(read_push(section));
    case FaultKind::kKidnapping:
      return scenario.disturbances.kidnappings.push_back(read_kidnapping(section));
  }
}

/// Where it is set down must be floor of this world: only now is all of that known.
void check_kidnappings(const Scenario& scenario, std::vector<ConfigSection>& sections) {
  if (scenario.disturbances.kidnappings.empty()) return;
  World without_glass = scenario.world;
  without_glass.panes.clear();
  const FreeSpace floor(without_glass);
  auto next = sections.begin();
  for (const Kidnapping& kidnapping : scenario.disturbances.kidnappings) {
    next = std::find_if(next, sections.end(), [](const ConfigSection& s) { return s.has("at_s") && s.has("x_m"); });
    if (!floor.contains(kidnapping.T_map_base.position())) {
      next->fail("x_m", "the robot is set down outside of the room, expected a place on its floor");
    }
    if (!has_room_to_stand(scenario.world, scenario.robot, kidnapping.T_map_base)) {
      next->fail("x_m",
                 fmt::format("the robot is set down in a wall, a box or glass, expected room for its body of {} x {} m",
                             scenario.robot.length, scenario.robot.width));
    }
    ++next;
  }
}

}  // namespace

void read_faults(ConfigSection& file, Scenario& scenario) {
  std::vector<ConfigSection> sections = file.sections("faults");
  std::uint32_t number = 0;
  for (ConfigSection& section : sections) read_fault(section, number++, scenario);
  check_kidnappings(scenario, sections);
}

bool has_room_to_stand(const World& world, const RobotConfig& robot, const Pose2& T_map_base) {
  const std::vector<Segment> surfaces = world.segments();
  const std::vector<Segment> body = edges(box(T_map_base, robot.length, robot.width));
  return std::none_of(body.begin(), body.end(), [&](const Segment& side) {
    return std::any_of(surfaces.begin(), surfaces.end(), [&](const Segment& s) { return touch(side, s); });
  });
}

}  // namespace cogslam
