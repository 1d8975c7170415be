#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

namespace cogslam {

/// Bytes that the maps of one filter hold at the moment, whoever shares them.
///
/// The mean per particle, shared blocks divided among their sharers, is `total() / particles`: every block is counted
/// once. Reading it between steps gives the same value for any number of threads.
class MemoryMeter {
 public:
  void add(std::int64_t payload, std::int64_t total) {
    payload_.fetch_add(payload, std::memory_order_relaxed);
    total_.fetch_add(total, std::memory_order_relaxed);
  }
  /// What is there once, however many particles there are, is counted apart.
  void add_process(std::int64_t bytes) { process_.fetch_add(bytes, std::memory_order_relaxed); }
  [[nodiscard]] std::int64_t payload() const { return payload_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::int64_t total() const { return total_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::int64_t process() const { return process_.load(std::memory_order_relaxed); }

 private:
  std::atomic<std::int64_t> payload_{0};
  std::atomic<std::int64_t> total_{0};
  std::atomic<std::int64_t> process_{0};
};

/// What a request of `bytes` takes from the heap: glibc adds an 8-byte header and rounds up to 16, at least 32.
constexpr std::int64_t heap_bytes(std::size_t bytes) {
  if (bytes == 0) return 0;
  const auto padded = static_cast<std::int64_t>((bytes + 8 + 15) / 16 * 16);
  return padded < 32 ? 32 : padded;
}

/// What std::make_shared<T> takes from the heap: the object behind its two counters and a table pointer.
template <class T>
constexpr std::int64_t shared_block_bytes() {
  return heap_bytes(sizeof(T) + 16);
}

/// Counts a block of memory for as long as it lives.
class MeteredBlock {
 public:
  MeteredBlock(std::shared_ptr<MemoryMeter> meter, std::int64_t payload, std::int64_t total)
      : meter_(std::move(meter)), payload_(payload), total_(total) {
    meter_->add(payload_, total_);
  }
  ~MeteredBlock() { meter_->add(-payload_, -total_); }
  MeteredBlock(const MeteredBlock&) = delete;
  MeteredBlock& operator=(const MeteredBlock&) = delete;

 private:
  std::shared_ptr<MemoryMeter> meter_;
  std::int64_t payload_;
  std::int64_t total_;
};

}  // namespace cogslam
