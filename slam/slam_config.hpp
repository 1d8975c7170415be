#pragma once

#include <optional>

#include "core/config.hpp"
#include "slam/loop_drift.hpp"
#include "slam/map/log_odds.hpp"
#include "slam/map/store.hpp"
#include "slam/match/scan_matcher.hpp"
#include "slam/motion_model.hpp"
#include "slam/registration.hpp"
#include "slam/sweep.hpp"
#include "slam/track/scan_tracker.hpp"
#include "slam/weight/compass_likelihood.hpp"
#include "slam/weight/scan_likelihood.hpp"

namespace cogslam {

/// Where a new pose is drawn from.
enum class Proposal {
  kMotion,       ///< p(x | x', u): the paper's (eq. 4)
  kScanMatched,  ///< a Gaussian fitted to p(z | x, map) p(x | x', u) about its mode (Grisetti et al. 2007)
};

struct ResamplingConfig {
  double effective_share = 0.5;  ///< resample when N_eff < share * N; in (0, 1]
  bool every_step = false;       ///< at every registered scan, as Alg. 1 and 3 are printed
};

/// Everything the filter can be told. Plain values; `check` says what cannot be.
struct SlamConfig {
  int particles = 100;
  double cell_size = 0.1;         ///< [m]
  std::optional<Rectangle> area;  ///< what the map covers [m]; nothing: it grows (not with coefficients)
  Pose2 start{};                  ///< T_map_base before the first reading
  Proposal proposal = Proposal::kScanMatched;
  StoreConfig store{};
  LogOddsModel log_odds{};
  SweepConfig sweep{};
  TrackerConfig tracker{};
  MotionModelConfig motion{};
  RegistrationConfig registration{};
  LoopConfig loops{};  ///< with a tracker only
  ScanLikelihoodConfig likelihood{};
  ScanMatcherConfig matcher{};
  CompassModel compass{};
  ResamplingConfig resampling{};

  /// The lattice frame of `area`, or nothing.
  [[nodiscard]] std::optional<GridFrame> map_frame() const;
  /// Whether every scan is tracked: the paper's own proposal has no tracker.
  [[nodiscard]] bool tracks() const { return proposal == Proposal::kScanMatched && tracker.used; }
  /// Throws InputError when the parts contradict each other.
  void check() const;
};

/// Reads the `slam:` section over the values that `config` already holds. Area, start and cell size are the caller's.
void read_slam_config(ConfigSection& section, SlamConfig& config);

}  // namespace cogslam
