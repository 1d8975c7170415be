#pragma once

#include <memory>
#include <vector>

#include "core/parallel.hpp"
#include "slam/filter_statistics.hpp"
#include "slam/health/map_watch.hpp"
#include "slam/health/odometry_watch.hpp"
#include "slam/health/scan_watch.hpp"
#include "slam/loop_drift.hpp"
#include "slam/map/reach.hpp"
#include "slam/map_worker.hpp"
#include "slam/particle.hpp"
#include "slam/path_tree.hpp"
#include "slam/slam_config.hpp"
#include "slam/waiting_scans.hpp"

namespace cogslam {

/// FastSLAM with occupancy grids (Alg. 1) or compressed occupancy grids (Alg. 3) of Cain & Leonessa 2016: a particle
/// filter over paths in which every particle keeps the map that its path explains. Which map store the particles use
/// (config.store) is the only difference between the two.
///
/// The result depends on configuration, seed and readings alone, not on the number of threads.
class FastSlam {
 public:
  /// `workers` share out the particles; they and `listener`, which may be nullptr, must outlive the filter.
  FastSlam(const SlamConfig& config, std::uint32_t seed, Workers& workers, StageListener* listener = nullptr);
  ~FastSlam();

  /// Takes the next reading, in the order of the log. Returns true when its scan was registered.
  bool update(const Reading& reading);

  /// The pose to report now: of the best particle, moved on by odometry since the last registered scan.
  [[nodiscard]] Pose2 T_map_base() const;
  /// The poses of all particles now, each moved on by odometry since the last registered scan; in slot order.
  [[nodiscard]] std::vector<Pose2> cloud() const;
  /// The path of odometry, refined by tracking where the filter tracks scans. Its errors add up.
  [[nodiscard]] Pose2 T_odom_base() const { return T_odom_base_; }
  /// The registered poses of the best particle's whole path, oldest first.
  [[nodiscard]] std::vector<RegisteredPose> best_path() const;
  /// The best particle's map, with the scans that still wait: log-odds over the stated area, or over all it has seen.
  [[nodiscard]] Grid<float> best_map() const;
  [[nodiscard]] FilterStatistics statistics() const;
  [[nodiscard]] const FilterHealth& health() const { return health_; }
  [[nodiscard]] const LastScan& last_scan() const { return statistics_.last; }
  /// Names the belief (poses, weights, compass biases, maps), to compare runs.
  [[nodiscard]] std::uint64_t state_hash() const;

 private:
  bool update_without_scan(Reading reading);
  void follow(const Reading& reading);
  void step(const Reading& reading);
  void spread_motion();
  void advance(Particle& particle, std::size_t slot, const Reading& reading, MapWorker& worker);
  [[nodiscard]] BestLook look_of(const Particle& particle, const Reading& reading, const MapWorker& worker) const;
  void propose_by_motion(Particle& particle, Rng& rng, MapWorker& worker) const;
  void propose_by_match(Particle& particle, Rng& rng, MapWorker& worker) const;
  void load_around(const Pose2& T_map_base, const Particle& particle, int margin_cells, MapWorker& worker) const;
  [[nodiscard]] int search_margin_cells() const;
  void record_paths();
  void grow_reach();
  void choose_best();
  void resample_if_due();
  void account();
  [[nodiscard]] const Particle& best() const;

  SlamConfig config_;
  std::uint32_t seed_;
  Workers& workers_;
  StageMarker stage_;  ///< of the calling thread
  std::shared_ptr<MemoryMeter> meter_;
  std::vector<Particle> particles_;
  PathTree paths_;
  MotionModel motion_;
  std::optional<ScanTracker> tracker_;
  LoopDrift drift_;
  WaitingScans waiting_;  ///< none without a tracker
  Pose2 T_odom_base_;
  std::size_t records_ = 0;  ///< readings taken
  FilterStatistics statistics_{};
  FilterHealth health_{};
  ScanWatch scan_watch_;
  OdometryWatch odometry_watch_;
  MapWatch map_watch_;
  std::size_t best_ = 0;
  CellWindow reach_;  ///< what maps without a stated area have grown to

  // Of the scan being registered, the same for all particles.
  std::vector<Beam> sweep_;
  std::vector<Beam> probes_;
  BestLook look_{};             ///< of the particle that was the best before the scan
  std::vector<Beam> entering_;  ///< the scan that enters the maps: the oldest that waited, if one is due
  Eigen::Matrix3d spread_ = Eigen::Matrix3d::Zero();     ///< of motion since the last registered scan
  std::vector<std::unique_ptr<MapWorker>> map_workers_;  ///< one per thread
};

}  // namespace cogslam
