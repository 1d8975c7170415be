#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/angle.hpp"
#include "core/config.hpp"
#include "core/pose2.hpp"
#include "sensors/readings.hpp"
#include "worlds/world.hpp"

namespace cogslam {

/// Map heading [rad], counter-clockwise from +x, in (-pi, pi], of a magnetic bearing [rad], clockwise from magnetic
/// north. The map's +y is true north (REP-103: east, north); `declination` [rad] is the bearing of magnetic north.
double heading_of_bearing(double bearing, double declination);
/// The way back; in [0, 2 pi).
double bearing_of_heading(double heading, double declination);

struct CompassConfig {
  double rate_hz = 50.0;             ///< 0: no compass
  double noise = radians(2.0);       ///< standard deviation of the white noise [rad]
  double bias_bound = radians(3.0);  ///< the constant bias is drawn once per run, evenly within +- this [rad]
  std::optional<double> bias{};      ///< or stated [rad], counter-clockwise; the filter is not told
  double declination = 0.0;          ///< bearing of magnetic north at this place [rad]
};

CompassConfig read_compass_config(ConfigSection& section);

/// A magnetic compass: white noise and one bias for the whole run, and the deflection of its needle by magnets.
class Compass {
 public:
  Compass(const CompassConfig& config, std::uint32_t seed, std::vector<Magnet> magnets = {});

  /// What the device says, clockwise from magnetic north [rad], in [0, 2 pi). Sample `index` has its own noise.
  [[nodiscard]] double bearing(const Pose2& T_map_base, std::uint64_t index) const;
  /// The same as a heading in the map: the one place where bearings turn into headings.
  [[nodiscard]] CompassSample sample(const Pose2& T_map_base, Time stamp, std::uint64_t index) const;

  /// Counter-clockwise [rad]; for tests and the truth only.
  [[nodiscard]] double bias() const { return bias_; }

 private:
  CompassConfig config_;
  std::uint32_t seed_;
  double bias_;
  std::vector<Magnet> magnets_;
};

}  // namespace cogslam
