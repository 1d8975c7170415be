// What a filter believes at the moment, for those who ask; fast_slam.cpp has the steps that change it.
#include "slam/fast_slam.hpp"

namespace cogslam {

Pose2 FastSlam::T_map_base() const { return best().T_map_base * motion_.T_last_now(); }

std::vector<Pose2> FastSlam::cloud() const {
  std::vector<Pose2> poses;
  for (const Particle& particle : particles_) poses.push_back(particle.T_map_base * motion_.T_last_now());
  return poses;
}

std::vector<RegisteredPose> FastSlam::best_path() const {
  std::vector<RegisteredPose> path = paths_.path_of(best_);
  for (std::size_t i = 0; i < waiting_.size(); ++i) path.push_back({waiting_[i].record, best().waiting[i]});
  return path;
}

Grid<float> FastSlam::best_map() const {
  MapStore map = best().map;  // shares all that the waiting scans do not touch
  MapWorker worker(config_);
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    worker.write(map, sweep_of(waiting_[i].reading, config_.sweep), best().waiting[i]);
  }
  MapScratch scratch;
  const auto area = config_.map_frame();
  map.load(area ? window_of(*area) : map.extent(), scratch);
  return scratch.log_odds;
}

FilterStatistics FastSlam::statistics() const {
  FilterStatistics statistics = statistics_;
  constexpr int kBack = 100;
  const auto waiting = static_cast<int>(waiting_.size());  // not in the tree
  if (statistics.registered > kBack && waiting <= kBack) {
    statistics.ancestors_100 = static_cast<double>(paths_.ancestors(static_cast<std::size_t>(kBack - waiting)));
  }
  return statistics;
}

std::uint64_t FastSlam::state_hash() const {
  Hash hash;
  for (const Particle& particle : particles_) {
    hash.add(particle.T_map_base.x).add(particle.T_map_base.y).add(particle.T_map_base.theta);
    hash.add(particle.log_weight).add(particle.path_log_weight);
    hash.add(particle.compass_bias.mean).add(particle.compass_bias.variance);
    particle.map.add_to(hash);
  }
  return hash.value();
}

}  // namespace cogslam
