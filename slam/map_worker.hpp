#pragma once

#include <optional>

#include "slam/map/inverse_sensor_model.hpp"
#include "slam/map/store.hpp"
#include "slam/slam_config.hpp"
#include "slam/stage.hpp"
#include "slam/weight/scan_likelihood.hpp"

namespace cogslam {

/// What works on one particle's map at a time: loads a window in plain form, weighs scans against it, and writes scans
/// into it. Keeps its memory between calls, so make one per thread.
class MapWorker {
 public:
  explicit MapWorker(const SlamConfig& config, StageMarker stage = {});

  /// (5) of Alg. 3: the window in plain form; the map may hold less.
  void load(const MapStore& map, const CellWindow& window);
  /// Makes `likelihood` speak of what is loaded.
  void look();
  [[nodiscard]] const ScanLikelihood& likelihood() const { return likelihood_; }
  /// (7), (8) of Alg. 3: alpha - beta is added to the loaded window, and the store takes the changed cells back (eqs.
  /// 18, 22). `map` is the one loaded last; its window may be another, and is then loaded.
  void write(MapStore& map, const std::vector<Beam>& sweep, const Pose2& T_map_base);
  /// Done with a particle.
  void leave() const { stage_.leave(); }

 private:
  StageMarker stage_;
  std::optional<LatticeModel> levels_;  ///< where the maps are worked on in levels
  LogOddsModel log_odds_;
  double cell_size_;
  double unit_;
  MapScratch scratch_;
  CellWindow loaded_;
  MapUpdater updater_;
  ScanLikelihood likelihood_;
};

}  // namespace cogslam
