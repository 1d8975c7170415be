#pragma once

#include "slam/map/inverse_sensor_model.hpp"
#include "tests/support/synthetic_log.hpp"

namespace cogslam {

/// The beams of a scan without noise.
inline std::vector<Beam> clean_sweep(const std::vector<Wall>& walls, const Pose2& T_map_base, int beams) {
  Rng rng({.seed = 1, .purpose = Purpose::kLidarNoise});
  Reading reading;
  reading.scan = scan_of(walls, T_map_base, beams, 0.0, rng);
  return sweep_of(reading, SweepConfig{});
}

/// The map that clean sweeps from given poses leave behind, each seen three times.
inline Grid<float> mapped(const std::vector<Wall>& walls, const std::vector<Pose2>& poses, const Rectangle& area,
                          double cell_size) {
  Grid<float> grid(GridFrame::covering(area, cell_size));
  MapUpdater updater;
  for (int again = 0; again < 3; ++again) {
    for (const Pose2& pose : poses) updater.integrate(clean_sweep(walls, pose, 1440), pose, LogOddsModel{}, grid);
  }
  return grid;
}

/// The cornered room as seen from four places.
inline Grid<float> mapped_cornered_room(double cell_size) {
  return mapped(cornered_room(), {{-1.5, -1.0, 0.0}, {1.8, -1.2, 0.0}, {2.2, 0.8, 0.0}, {-0.5, 1.0, 0.0}},
                Rectangle{{-4.0, -3.0}, {4.0, 3.0}}, cell_size);
}

}  // namespace cogslam
