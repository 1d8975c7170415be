#pragma once

#include <memory>

#include "slam/filter_statistics.hpp"
#include "slam/map/inverse_sensor_model.hpp"
#include "slam/map/reach.hpp"
#include "slam/slam_config.hpp"

namespace cogslam {

/// A map built from given poses, with the same map store, sensor model and registration rule as the filter: it scores a
/// store without the filter's chance. The poses come from the caller; this knows nothing of where they are from.
class TruePoseMapper {
 public:
  explicit TruePoseMapper(const SlamConfig& config);

  /// Takes the next reading and the pose at its stamp. Returns true when its scan was registered.
  bool update(const Reading& reading, const Pose2& T_map_base);

  [[nodiscard]] Grid<float> map() const;
  [[nodiscard]] const FilterStatistics& statistics() const { return statistics_; }

 private:
  SlamConfig config_;
  std::shared_ptr<MemoryMeter> meter_;
  MapStore map_;
  MapScratch scratch_;
  MapUpdater updater_;
  CellWindow reach_;  ///< what a map without a stated area has grown to
  MotionModel motion_;
  FilterStatistics statistics_{};
};

}  // namespace cogslam
