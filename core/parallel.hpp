#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace cogslam {

/// A fixed crew of threads that shares out loops. What a loop body writes must depend on its index alone; then the
/// result is the same, bit for bit, for any number of threads.
class Workers {
 public:
  /// `threads` >= 1, the caller's own included: with 1 everything runs inline.
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  [[nodiscard]] int threads() const { return static_cast<int>(crew_.size()) + 1; }

  /// Calls body(index, worker) for every index in [0, count), and returns when all are done. `worker` in
  /// [0, threads()) names the calling thread, for scratch memory. The first exception (lowest index) is rethrown.
  void for_each(std::size_t count, const std::function<void(std::size_t index, int worker)>& body);

 private:
  void serve(int worker, const std::stop_token& stop);
  void take_share(int worker);

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::condition_variable done_;
  const std::function<void(std::size_t, int)>* body_ = nullptr;
  std::size_t count_ = 0;
  std::size_t next_ = 0;
  std::size_t failed_index_ = 0;
  std::exception_ptr failure_;
  std::uint64_t round_ = 0;
  int busy_ = 0;
  std::vector<std::jthread> crew_;
};

}  // namespace cogslam
