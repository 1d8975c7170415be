#pragma once

#include <cstdint>
#include <optional>

#include "core/rng.hpp"
#include "sensors/lidar_config.hpp"
#include "sensors/pose_track.hpp"
#include "sensors/ray_caster.hpp"
#include "sensors/readings.hpp"

namespace cogslam {

/// Turns true poses into sweeps. Each beam leaves from where the lidar truly is at the beam's own time, so a sweep of a
/// moving lidar is bent; the scan tells the times and leaves the straightening to its reader.
class Lidar {
 public:
  /// `config` must pass its check().
  Lidar(const LidarConfig& config, const World& world, std::uint32_t seed);

  [[nodiscard]] const LidarConfig& config() const { return config_; }
  /// From the first beam of a sweep to the last.
  [[nodiscard]] Duration sweep_time() const;

  /// Sweep number `index`, whose first beam leaves at `start`. `track` must cover the time of the whole sweep. The
  /// noise depends on the seed, `index` and the beam alone, so sweeps may be taken in any order.
  [[nodiscard]] ScanSample sweep(const PoseTrack& track, Time start, std::uint64_t index) const;

 private:
  int sweep_leg(const PoseTrack& track, int beam, Rng& rng, ScanSample& out) const;
  [[nodiscard]] float measure(std::optional<double> distance, Rng& rng) const;

  LidarConfig config_;
  RayCaster caster_;
  std::uint32_t seed_;
  Scan blank_;  // all but the ranges
};

}  // namespace cogslam
