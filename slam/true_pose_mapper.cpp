#include "slam/true_pose_mapper.hpp"

#include <algorithm>

namespace cogslam {

TruePoseMapper::TruePoseMapper(const SlamConfig& config)
    : config_(config),
      meter_(std::make_shared<MemoryMeter>()),
      map_(config.store, config.cell_size, config.map_frame(), meter_),
      motion_(config.motion) {
  config.check();
}

bool TruePoseMapper::update(const Reading& reading, const Pose2& T_map_base) {
  motion_.add(reading.motion);
  if (!reading.scan) return false;
  // The rule looks at odometry, as the filter's does, so that both register the same scans.
  if (statistics_.registered > 0 && !config_.registration.due(motion_.T_last_now())) {
    ++statistics_.tracked;
    return false;
  }
  motion_.restart();
  const std::vector<Beam> sweep = sweep_of(reading, config_.sweep);
  const CellWindow window = window_of(sweep, T_map_base, config_.cell_size);
  if (!config_.area && !window.empty()) {
    reach_.include(window.min);
    reach_.include(window.max);
    check_reach(reach_);
  }
  map_.load(window, scratch_);
  map_.commit(updater_.integrate(sweep, T_map_base, config_.log_odds, scratch_.log_odds), scratch_);
  map_.settle(static_cast<std::uint64_t>(statistics_.registered) + 1);

  const auto count = static_cast<double>(++statistics_.registered);
  statistics_.payload_bytes += (static_cast<double>(meter_->payload()) - statistics_.payload_bytes) / count;
  statistics_.bytes += (static_cast<double>(meter_->total()) - statistics_.bytes) / count;
  statistics_.bytes_peak = std::max(statistics_.bytes_peak, static_cast<double>(meter_->total()));
  statistics_.last = {.effective_particles = 1.0,
                      .payload_bytes = static_cast<double>(meter_->payload()),
                      .bytes = static_cast<double>(meter_->total())};
  return true;
}

Grid<float> TruePoseMapper::map() const {
  MapScratch scratch;
  const auto area = config_.map_frame();
  map_.load(area ? window_of(*area) : map_.extent(), scratch);
  return scratch.log_odds;
}

}  // namespace cogslam
