#pragma once

#include <array>
#include <cstdint>

namespace cogslam {

/// What the draws are for. Append only: the number is part of every recorded run.
enum class Purpose : std::uint32_t {
  kLidarNoise = 0,
  kCompassNoise = 1,
  kCompassBias = 2,
  kCameraNoise = 3,
  kFloorTexture = 4,
  kReferenceNoise = 5,
  kWheelRoughness = 6,
  kWheelEncoder = 7,
  kWorld = 8,
  kMotionSample = 9,
  kResample = 10,
  kProposal = 11,
  kCameraLight = 12,
  kCompression = 13,
  kBootstrap = 14,
  kSensorFault = 15,
};

/// Names one stream. Keys that differ in any field give independent draws, so adding a draw in
/// one place, or running particles in another order, changes nothing anywhere else.
struct StreamKey {
  std::uint32_t seed = 0;    ///< scenario seed
  Purpose purpose{};         ///< what is drawn
  std::uint32_t entity = 0;  ///< particle, beam or sensor index
  std::uint64_t tick = 0;    ///< reading, frame or simulation step; below 2^48
};

/// Counter-based generator (Philox4x32-10, Salmon et al. 2011). Cheap to make: make one where the draws are
/// needed and let it go. bits(), uniform() and below() are the same on every platform; normal() uses libm.
class Rng {
 public:
  explicit Rng(const StreamKey& key);

  std::uint32_t bits();
  std::uint64_t bits64();
  double uniform();                          ///< in (0, 1), 53 random bits
  double uniform(double low, double high);   ///< in (low, high)
  double normal();                           ///< mean 0, variance 1 (Box-Muller)
  std::uint32_t below(std::uint32_t bound);  ///< in [0, bound), without bias; bound > 0

 private:
  std::array<std::uint32_t, 2> key_;
  std::array<std::uint32_t, 4> counter_;
  std::array<std::uint32_t, 4> block_{};
  int used_ = 4;
  double spare_normal_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace cogslam
