#include "eval/degradation.hpp"

#include <algorithm>

namespace cogslam {

std::vector<Degradation> degradations(const Recording& recording, const SweepConfig& sweep, const Grid<float>& map) {
  const auto sees_something = [&](const Reading& reading) {
    const std::vector<Beam> beams = sweep_of(reading, sweep);
    return std::any_of(beams.begin(), beams.end(), [](const Beam& beam) { return beam.hit; });
  };
  std::vector<Degradation> found;
  if (std::none_of(recording.readings.begin(), recording.readings.end(), sees_something)) found.push_back(kNoReturns);
  if (std::all_of(map.values().begin(), map.values().end(), [](float v) { return v == 0.0F; })) {
    found.push_back(kEmptyMap);
  }
  return found;
}

}  // namespace cogslam
