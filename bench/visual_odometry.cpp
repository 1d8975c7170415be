// Drift of visual odometry on each floor: the table of docs/odometry.md.
//
//   bench_visual_odometry [distance in m, default 20] [pictures per key, default as shipped]
#include <time.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "core/angle.hpp"
#include "sensors/floor_camera.hpp"
#include "slam/odometry/visual_odometry.hpp"

namespace cogslam {
namespace {

constexpr double kSpeed = 0.3, kPeriod = 1.0 / 30.0;

enum class Path { kMixed, kCircle };

double cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Mixed: turning up to 0.5 rad/s either way, and crabbing up to 0.6 rad off the heading. Circle: turning 0.5 rad/s.
Twist2 twist_at(Path path, double t) {
  if (path == Path::kCircle) return {kSpeed, 0.0, 0.5};
  const double crab = 0.6 * std::sin(2.0 * std::numbers::pi * t / 11.0);
  return {kSpeed * std::cos(crab), kSpeed * std::sin(crab), 0.5 * std::sin(2.0 * std::numbers::pi * t / 8.0)};
}

struct Track {
  std::vector<Pose2> truth{Pose2{}};
  std::vector<Pose2> estimate{Pose2{}};
  int without_estimate = 0;
  std::vector<Eigen::Matrix3d> covariance{Eigen::Matrix3d::Zero()};  ///< of each increment
  double camera_ms = 0.0, odometry_ms = 0.0;
};

/// Drives the path; an increment without estimate is filled from the truth, and counted.
Track drive(const Floor& floor, const FloorCameraConfig& camera_config, VisualOdometryConfig config, Path path,
            double distance) {
  config.pixel_noise = std::max(camera_config.noise, 0.5);  // the gate knows the camera; rounding is noise, too
  FloorCamera camera(camera_config, floor, 1);
  VisualOdometry odometry(camera_config.model, config);
  Track track;
  const int frames = static_cast<int>(distance / (kSpeed * kPeriod));
  for (int i = 0; i <= frames; ++i) {
    const Twist2 twist = twist_at(path, (i - 0.5) * kPeriod);
    const Pose2 motion = i == 0 ? Pose2{} : Pose2::exp(kPeriod * twist);
    if (i > 0) track.truth.push_back(track.truth.back() * motion);
    const double t0 = cpu_ms();
    const FloorImage image =
        camera.capture(static_cast<std::uint64_t>(i), Time::from_seconds(i * kPeriod), track.truth.back(), twist);
    const double t1 = cpu_ms();
    const auto found = odometry.update(image);
    track.camera_ms += t1 - t0;
    track.odometry_ms += cpu_ms() - t1;
    if (i == 0) continue;
    track.without_estimate += found ? 0 : 1;
    track.estimate.push_back(track.estimate.back() * (found ? found->T_before_now : motion));
    track.covariance.push_back(found ? found->covariance : Eigen::Matrix3d::Zero());
  }
  return track;
}

/// Mean of error^T covariance^-1 error over stretches of `length` pictures: 3 where the covariance is honest.
double mean_nees(const Track& track, std::size_t length) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i + length < track.truth.size(); i += length) {
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (std::size_t k = i + 1; k <= i + length; ++k) {
      const Pose2 step = track.estimate[k - 1].inverse() * track.estimate[k];
      covariance = compose_covariance(covariance, step, track.covariance[k]);
    }
    const Pose2 moved = track.truth[i].inverse() * track.truth[i + length];
    const Twist2 e = ((track.estimate[i].inverse() * track.estimate[i + length]).inverse() * moved).log();
    if (covariance.diagonal().minCoeff() <= 0.0) continue;
    const Eigen::Vector3d error(e.x, e.y, e.theta);
    sum += error.dot(covariance.ldlt().solve(error));
    ++count;
  }
  return count > 0.0 ? sum / count : 0.0;
}

void print_row(const char* floor, const char* pictures, const char* path, const Track& track) {
  const auto frames = static_cast<double>(track.truth.size() - 1);
  const double distance = frames * kSpeed * kPeriod;
  const auto last = track.truth.size() - 1;
  const Pose2 end_error = track.truth[last].inverse() * track.estimate[last];
  const auto metre = static_cast<std::size_t>(std::lround(1.0 / (kSpeed * kPeriod)));
  double trans = 0.0, rot = 0.0, signed_rot = 0.0, count = 0.0;
  for (std::size_t i = metre; i <= last; i += metre / 4, ++count) {
    const Pose2 moved = track.truth[i - metre].inverse() * track.truth[i];
    const Pose2 error = moved.inverse() * (track.estimate[i - metre].inverse() * track.estimate[i]);
    trans += error.position().norm();
    rot += std::abs(error.theta);
    signed_rot += error.theta;
  }
  std::printf("| %s | %s | %s | %.2f | %.2f | %.3f | %+.3f | %.1f | %.1f / %.1f | %.2f | %.2f |\n", floor, pictures,
              path, 100.0 * end_error.position().norm() / distance, 100.0 * trans / count, degrees(rot / count),
              degrees(signed_rot / count), 100.0 * track.without_estimate / frames, mean_nees(track, 1),
              mean_nees(track, metre), track.odometry_ms / frames, track.camera_ms / frames);
  std::fflush(stdout);
}

FloorCameraConfig clean_camera() {
  FloorCameraConfig config;
  config.noise = 0.0;
  config.light = {.vignette = 0.0, .drift = 0.0};
  return config;
}

FloorCameraConfig degraded_camera() {
  FloorCameraConfig config;
  config.exposure = 0.01;
  config.light = {.vignette = 0.35, .drift = 0.25, .step = 0.25};
  return config;
}

void print_table(double distance, const VisualOdometryConfig& config) {
  struct Named {
    const char* name;
    FloorKind kind;
  };
  const Named floors[] = {{"carpet", FloorKind::kCarpet},
                          {"wood", FloorKind::kWood},
                          {"concrete", FloorKind::kConcrete},
                          {"tile", FloorKind::kTile},
                          {"plain", FloorKind::kPlain}};
  std::printf(
      "| floor | pictures | path | end %% | 1 m: %% | deg | bias deg | none %% | NEES 1 picture / 1 m | odometry ms | "
      "camera ms "
      "|\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Named& floor : floors) {
    const Floor what{.kind = floor.kind};
    print_row(floor.name, "clean", "mixed", drive(what, clean_camera(), config, Path::kMixed, distance));
    print_row(floor.name, "shipped", "mixed", drive(what, FloorCameraConfig{}, config, Path::kMixed, distance));
    print_row(floor.name, "shipped", "circle", drive(what, FloorCameraConfig{}, config, Path::kCircle, distance));
    print_row(floor.name, "degraded", "mixed", drive(what, degraded_camera(), config, Path::kMixed, distance));
  }
}

}  // namespace
}  // namespace cogslam

int main(int argc, char** argv) {
  cogslam::VisualOdometryConfig config;
  if (argc > 2) config.frames_per_key = std::atoi(argv[2]);
  cogslam::print_table(argc > 1 ? std::atof(argv[1]) : 20.0, config);
}
