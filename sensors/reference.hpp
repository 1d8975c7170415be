#pragma once

#include <cstdint>

#include "core/angle.hpp"
#include "core/config.hpp"
#include "core/pose2.hpp"
#include "core/time.hpp"

namespace cogslam {

/// A pose from landmarks on the ceiling. It belongs to the truth: nothing in slam/ ever sees one.
struct ReferenceFix {
  Time stamp{};
  Pose2 T_map_base{};
  double sigma = 0.0;  ///< standard deviation of x and of y that this fix was drawn with [m]

  bool operator==(const ReferenceFix&) const = default;
};

/// A localiser like the Hagisonic StarGazer. How good a fix is depends on the landmarks in view: its standard deviation
/// is drawn evenly from [sigma_min_m, sigma_max_m] each time.
struct ReferenceConfig {
  double rate_hz = 10.0;                ///< 0: no reference
  double sigma_min_m = 0.001;           ///< many landmarks
  double sigma_max_m = 0.010;           ///< one
  double heading_noise = radians(0.5);  ///< standard deviation [rad]
};

ReferenceConfig read_reference_config(ConfigSection& section);

class Reference {
 public:
  Reference(const ReferenceConfig& config, std::uint32_t seed) : config_(config), seed_(seed) {}

  /// Fix number `index` has its own noise.
  [[nodiscard]] ReferenceFix fix(const Pose2& T_map_base, Time stamp, std::uint64_t index) const;

 private:
  ReferenceConfig config_;
  std::uint32_t seed_;
};

}  // namespace cogslam
