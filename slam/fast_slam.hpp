#pragma once

#include <memory>
#include <vector>

#include "core/parallel.hpp"
#include "slam/filter_statistics.hpp"
#include "slam/map/inverse_sensor_model.hpp"
#include "slam/particle.hpp"
#include "slam/slam_config.hpp"

namespace cogslam {

/// FastSLAM with occupancy grids (Alg. 1) or compressed occupancy grids (Alg. 3) of Cain & Leonessa 2016: a particle
/// filter over paths in which every particle keeps the map that its path explains. Which map store the particles use
/// (config.store) is the only difference between the two.
///
/// The result depends on configuration, seed and readings alone, not on the number of threads.
class FastSlam {
 public:
  /// `workers` share out the particles and must outlive the filter.
  FastSlam(const SlamConfig& config, std::uint32_t seed, Workers& workers);
  ~FastSlam();

  /// Takes the next reading, in the order of the log. Returns true when its scan was registered.
  bool update(const Reading& reading);

  /// The pose to report now: of the best particle, moved on by odometry since the last registered scan.
  [[nodiscard]] Pose2 T_map_base() const;
  /// The path of odometry, refined by tracking where the filter tracks scans. Its errors add up.
  [[nodiscard]] Pose2 T_odom_base() const { return T_odom_base_; }
  /// The registered poses of the best particle's whole path, oldest first.
  [[nodiscard]] std::vector<RegisteredPose> best_path() const;
  /// The best particle's map: log-odds over the stated area, or over all it has seen.
  [[nodiscard]] Grid<float> best_map() const;
  [[nodiscard]] FilterStatistics statistics() const;
  /// Names the belief (poses, weights, compass biases, maps), to compare runs.
  [[nodiscard]] std::uint64_t state_hash() const;

 private:
  struct WorkerScratch;

  void follow(const Reading& reading);
  void step(const Reading& reading);
  void advance(Particle& particle, std::size_t slot, const Reading& reading, WorkerScratch& scratch) const;
  void propose_by_motion(Particle& particle, Rng& rng, WorkerScratch& scratch) const;
  void propose_by_match(Particle& particle, Rng& rng, WorkerScratch& scratch) const;
  void load_around(const Pose2& T_map_base, const Particle& particle, int margin_cells, WorkerScratch& scratch) const;
  void look_at_loaded(WorkerScratch& scratch) const;
  [[nodiscard]] int search_margin_cells(const Eigen::Matrix3d& covariance) const;
  void record_paths();
  void choose_best();
  void resample_if_due();
  void account();
  [[nodiscard]] const Particle& best() const;

  SlamConfig config_;
  std::uint32_t seed_;
  Workers& workers_;
  std::shared_ptr<MemoryMeter> meter_;
  std::optional<LatticeModel> levels_;  ///< where the maps are worked on in levels
  std::vector<Particle> particles_;
  PathTree paths_;
  MotionModel motion_;
  std::optional<ScanTracker> tracker_;
  Pose2 T_odom_base_;
  std::size_t records_ = 0;  ///< readings taken
  FilterStatistics statistics_{};
  std::size_t best_ = 0;

  // Of the scan being registered, the same for all particles.
  std::vector<Beam> sweep_;
  std::vector<Beam> probes_;
  std::vector<std::unique_ptr<WorkerScratch>> scratch_;  ///< one per worker
};

}  // namespace cogslam
