#include "slam/map_worker.hpp"

namespace cogslam {

MapWorker::MapWorker(const SlamConfig& config, StageMarker stage)
    : stage_(stage),
      log_odds_(config.log_odds),
      cell_size_(config.cell_size),
      unit_(config.store.lattice_unit),
      likelihood_(config.likelihood, config.cell_size) {
  if (keeps_levels(config.store.kind) && config.likelihood.model == ScanModel::kLikelihoodField) {
    levels_ = lattice_model(config.log_odds, config.store.lattice_unit);
  }
}

void MapWorker::load(const MapStore& map, const CellWindow& window) {
  stage_.enter(Stage::kLoad);
  loaded_ = window;
  if (levels_) {
    map.load_levels(window, scratch_);
  } else {
    map.load(window, scratch_);
  }
}

void MapWorker::look() {
  stage_.enter(Stage::kWeigh);
  if (levels_) {
    likelihood_.look_at(scratch_.levels, unit_);
  } else {
    likelihood_.look_at(scratch_.log_odds);
  }
}

void MapWorker::write(MapStore& map, const std::vector<Beam>& sweep, const Pose2& T_map_base) {
  if (sweep.empty()) return;
  const CellWindow window = window_of(sweep, T_map_base, cell_size_);
  if (!loaded_.contains(window)) load(map, window);
  stage_.enter(Stage::kWrite);
  if (levels_) {
    map.commit_levels(updater_.integrate(sweep, T_map_base, *levels_, scratch_.levels), scratch_);
  } else {
    map.commit(updater_.integrate(sweep, T_map_base, log_odds_, scratch_.log_odds), scratch_);
  }
}

}  // namespace cogslam
