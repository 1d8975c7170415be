#pragma once

#include <vector>

#include "core/grid.hpp"
#include "slam/match/pose_fit.hpp"
#include "slam/sweep.hpp"
#include "slam/weight/likelihood_field.hpp"

namespace cogslam {

/// The measurement model p(z | pose, map) of eq. (8).
enum class ScanModel {
  kLikelihoodField,  ///< how near the end points lie to occupied cells (Thrun et al. 2006, sec. 6.4)
  kBeam,             ///< measured against expected range along each beam (sec. 6.3)
};

struct ScanLikelihoodConfig {
  ScanModel model = ScanModel::kLikelihoodField;
  int beams = 180;              ///< returns looked at per scan, evenly spread
  double effective_beams = 20;  ///< a scan counts as so many independent beams: neighbours see the same wall
  double hit_share = 0.9;       ///< of returns that come from a mapped surface; the rest may end anywhere
  double unknown_value = 0.3;   ///< of an end point in an unknown cell, against 1 on a mapped surface
  double range_sigma = 0.02;    ///< beam model: spread of a range about the expected one [m]
  LikelihoodFieldConfig field{};
};

/// How a scan goes with what a map knows.
struct ScanAgreement {
  int known = 0;         ///< probes that end in cells of which the map knows anything
  int contradicted = 0;  ///< of those: far from every occupied cell
};

/// Weighs poses against one map at a time. Keeps scratch memory, so make one per thread.
class ScanLikelihood {
 public:
  ScanLikelihood(const ScanLikelihoodConfig& config, double cell_size);

  /// The returns that are looked at: at most `beams`, evenly spread over the sweep.
  [[nodiscard]] std::vector<Beam> probes_of(const std::vector<Beam>& sweep) const;

  /// Takes a map to weigh against: log-odds, which must outlive the calls of `log_likelihood`, or levels of `unit`
  /// log-odds each, which the beam model cannot use.
  void look_at(const Grid<float>& log_odds);
  void look_at(const Grid<std::int8_t>& levels, double unit);

  /// log p(z | pose, map) up to a constant, tempered: effective_beams times the mean over the probes.
  /// 0 without probes. A map that shows no obstacle is no excuse: its free and unknown cells speak as any others.
  [[nodiscard]] double log_likelihood(const std::vector<Beam>& probes, const Pose2& T_map_base) const;
  /// The same by the likelihood field, whatever the model: what a scan matcher climbs.
  [[nodiscard]] double field_log_likelihood(const std::vector<Beam>& probes, const Pose2& T_map_base) const;

  /// That value with its slope and information over the small motion that follows the pose: what a matcher steps by.
  /// The information is that of a Gaussian end point about its wall, shared with the chance that no mapped surface was
  /// hit (Fisher scoring); inside a large occupied cell, where the field is flat, there is none.
  [[nodiscard]] PoseFit field_fit(const std::vector<Beam>& probes, const Pose2& T_map_base) const;

  /// Of what is loaded, by the likelihood field.
  [[nodiscard]] ScanAgreement agreement(const std::vector<Beam>& probes, const Pose2& T_map_base) const;

  /// Cells around the probes' window that the map must cover.
  [[nodiscard]] int margin_cells() const { return field_.margin_cells(); }

 private:
  [[nodiscard]] double beam_log_likelihood(const std::vector<Beam>& probes, const Pose2& T_map_base) const;

  ScanLikelihoodConfig config_;
  LikelihoodField field_;
  const Grid<float>* map_ = nullptr;
};

}  // namespace cogslam
