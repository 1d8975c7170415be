#include "eval/lab/seeds.hpp"

#include <atomic>

namespace cogslam {

void for_each_seed(std::size_t count, Workers& workers, const LabProgress& progress,
                   const std::function<void(std::size_t)>& body) {
  std::atomic<std::size_t> done = 0;
  std::atomic<bool> ended = false;
  workers.for_each(count, [&](std::size_t index, int worker) {
    if (ended) return;
    body(index);
    ++done;
    if (worker != 0 || !progress) return;
    try {
      progress(static_cast<double>(done) / static_cast<double>(count));
    } catch (...) {
      ended = true;  // else the other threads would finish all that is left first
      throw;
    }
  });
}

}  // namespace cogslam
