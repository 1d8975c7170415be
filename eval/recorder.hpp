#pragma once

#include <functional>

#include "eval/scenario.hpp"
#include "sensors/log/recording.hpp"
#include "sensors/log/truth_log.hpp"

namespace cogslam {

/// A drive through a simulated world: what the filter is told, and what only the scoring may know.
struct Drive {
  Recording recording;
  TruthLog truth;
  std::uint64_t camera_spans = 0;          ///< spans between floor pictures
  std::uint64_t camera_spans_without = 0;  ///< of those, without an estimate: wheel odometry stood in
  std::uint64_t pictures_repeated = 0;     ///< equal to the one before: the camera was frozen
  bool stuck = false;                      ///< the vehicle was blocked for 5 s at some time
};

/// Told now and then how far a long job has come; `done` in [0, 1]. Throw from it to stop the job.
using Progress = std::function<void(double done)>;

/// Simulates the scenario once. The same scenario and seed give the same readings, bit for bit.
Drive record_drive(const Scenario& scenario, const Progress& progress = {});

}  // namespace cogslam
