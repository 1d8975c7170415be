#pragma once

#include <cstddef>
#include <cstdint>

namespace cogslam {

/// What the filter works on, for those who want to know what each part costs. Algorithm 3's lines are those of
/// fast_slam.cpp.
enum class Stage : std::uint8_t {
  kTrack,     ///< every scan against the last few: how far the robot moved
  kPrepare,   ///< beams of a registered scan, and whether the old map is in sight
  kLoad,      ///< (5): the map around a particle in plain form
  kWeigh,     ///< (4), (6): likelihood field, match, draw, weight
  kWrite,     ///< (7), (8): ray walk and storing
  kSettle,    ///< paths, dense codes for idle tiles, and the count of bytes
  kResample,  ///< (12)-(15)
};
inline constexpr std::size_t kStages = 7;

/// Told what a thread works on. The filter itself reads no clock.
class StageListener {
 public:
  StageListener() = default;
  StageListener(const StageListener&) = delete;
  StageListener& operator=(const StageListener&) = delete;
  virtual ~StageListener() = default;

  /// From now on thread `worker` works on `stage`; the thread that calls the filter is worker 0. Called by that thread.
  virtual void enter(int worker, Stage stage) = 0;
  /// Thread `worker` has finished its stage and begins none.
  virtual void leave(int worker) = 0;
};

/// Tells a listener, if there is one, for one thread.
struct StageMarker {
  StageListener* listener = nullptr;
  int worker = 0;

  void enter(Stage stage) const {
    if (listener != nullptr) listener->enter(worker, stage);
  }
  void leave() const {
    if (listener != nullptr) listener->leave(worker);
  }
};

}  // namespace cogslam
