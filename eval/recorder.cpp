#include "eval/recorder.hpp"

#include <deque>
#include <optional>

#include "core/check.hpp"
#include "sim/disturbance.hpp"
#include "sim/driver.hpp"
#include "sim/simulation.hpp"
#include "slam/odometry/front_end.hpp"

namespace cogslam {
namespace {

constexpr std::int64_t kStepsPerProgress = 250;

OdometryFrontEnd make_front_end(const Scenario& scenario) {
  std::optional<CameraModel> camera;
  if (scenario.camera.enabled) camera = scenario.camera.model;
  std::optional<MecanumGeometry> wheels;
  if (scenario.sensors.wheels.rate_hz > 0.0) wheels = scenario.robot.geometry;
  return {scenario.odometry, camera, wheels};
}

/// The vehicle, its sensors and its odometry, stepped together.
class Recorder {
 public:
  explicit Recorder(const Scenario& scenario)
      : scenario_(scenario),
        simulation_(scenario.world, scenario.robot, scenario.seed),
        driver_(scenario.drive),
        disturbances_(scenario.disturbances),
        suite_(scenario.sensors, scenario.world, scenario.seed),
        camera_stream_(faults_of(SensorKind::kCamera, scenario.sensors.faults.streams), scenario.seed),
        front_end_(make_front_end(scenario)),
        track_(Duration::from_seconds(1.0)) {
    if (scenario.camera.enabled) camera_.emplace(scenario.camera, scenario.world.floor, scenario.seed);
    drive_.recording = {.source = "simulation: " + scenario.name, .start = scenario.world.start};
    drive_.truth.world = scenario.world;
  }

  /// Takes in the state of the vehicle, and moves it on.
  void step() {
    const Truth truth = simulation_.truth();
    track_.push(truth);
    const SensorOutput& seen = suite_.step(truth);
    for (const WheelSample& sample : seen.wheels) front_end_.add(sample);
    for (const CompassSample& sample : seen.compass) front_end_.add(sample);
    for (const Truth& due : seen.camera_due) take_picture(due);
    for (const ReferenceFix& fix : seen.reference) drive_.truth.references.push_back(fix);
    for (const ScanSample& scan : seen.scans) {
      stamped_truth_.push_back(track_.at(scan.stamp));
      front_end_.add(scan);
    }
    collect();
    disturbances_.apply(simulation_);
    simulation_.command(driver_.command(truth));
    simulation_.step();
    drive_.stuck = drive_.stuck || driver_.stuck();
  }

  Drive finish() {
    front_end_.flush();
    collect();
    drive_.truth.readings_hash = readings_hash(drive_.recording.readings);
    drive_.camera_spans = front_end_.spans();
    drive_.camera_spans_without = front_end_.spans_without_estimate();
    drive_.pictures_repeated = front_end_.pictures_repeated();
    return std::move(drive_);
  }

 private:
  void take_picture(const Truth& due) {
    FloorImage image = camera_->capture(frame_, due.time, due.T_map_base, due.twist);
    if (const auto seen = camera_stream_.pass(std::move(image), frame_)) front_end_.add(*seen);
    ++frame_;
  }

  void collect() {
    while (auto reading = front_end_.next()) {
      while (stamped_truth_.front().time < reading->stamp) stamped_truth_.pop_front();
      EXPECTS(stamped_truth_.front().time == reading->stamp);
      drive_.truth.poses.push_back({reading->sequence, reading->stamp, stamped_truth_.front().T_map_base});
      drive_.recording.readings.push_back(std::move(*reading));
    }
  }

  const Scenario& scenario_;
  Simulation simulation_;
  Driver driver_;
  Disturbances disturbances_;
  SensorSuite suite_;
  FaultyStream<FloorImage> camera_stream_;
  std::optional<FloorCamera> camera_;
  OdometryFrontEnd front_end_;
  PoseTrack track_;
  std::uint64_t frame_ = 0;
  std::deque<Truth> stamped_truth_;  ///< at the stamps of scans whose reading is not out yet
  Drive drive_;
};

}  // namespace

Drive record_drive(const Scenario& scenario, const Progress& progress) {
  Recorder recorder(scenario);
  const std::int64_t steps = scenario.duration.ns / scenario.robot.step.ns;
  for (std::int64_t i = 0; i <= steps; ++i) {
    if (progress && i % kStepsPerProgress == 0) progress(static_cast<double>(i) / static_cast<double>(steps));
    recorder.step();
  }
  return recorder.finish();
}

}  // namespace cogslam
