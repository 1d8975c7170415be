#include "core/parallel.hpp"

#include <exception>

#include "core/check.hpp"

namespace cogslam {

Workers::Workers(int threads) {
  EXPECTS(threads >= 1);
  for (int w = 1; w < threads; ++w) {
    crew_.emplace_back([this, w](const std::stop_token& stop) { serve(w, stop); });
  }
}

Workers::~Workers() {
  for (std::jthread& t : crew_) t.request_stop();
  wake_.notify_all();
}

void Workers::for_each(std::size_t count, const std::function<void(std::size_t, int)>& body) {
  if (crew_.empty() || count < 2) {
    for (std::size_t i = 0; i < count; ++i) body(i, 0);
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    body_ = &body;
    count_ = count;
    next_ = 0;
    failure_ = nullptr;
    busy_ = static_cast<int>(crew_.size());
    ++round_;
  }
  wake_.notify_all();
  take_share(0);
  std::unique_lock lock(mutex_);
  done_.wait(lock, [this] { return busy_ == 0; });
  body_ = nullptr;
  if (failure_) std::rethrow_exception(failure_);
}

void Workers::serve(int worker, const std::stop_token& stop) {
  std::uint64_t seen = 0;
  for (;;) {
    {
      std::unique_lock lock(mutex_);
      if (!wake_.wait(lock, stop, [&] { return round_ != seen; })) return;
      seen = round_;
    }
    take_share(worker);
    const std::lock_guard lock(mutex_);
    if (--busy_ == 0) done_.notify_one();
  }
}

void Workers::take_share(int worker) {
  for (;;) {
    std::size_t index = 0;
    {
      const std::lock_guard lock(mutex_);
      if (next_ == count_) return;
      index = next_++;
    }
    try {
      (*body_)(index, worker);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_ || index < failed_index_) {
        failure_ = std::current_exception();
        failed_index_ = index;
      }
    }
  }
}

}  // namespace cogslam
