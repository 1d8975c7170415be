#pragma once

#include <utility>
#include <vector>

#include "core/grid_frame.hpp"

namespace cogslam {

/// A value per cell of a frame, row-major.
template <class T>
class Grid {
 public:
  Grid() = default;
  explicit Grid(GridFrame frame, T value = {}) : frame_(frame), values_(frame.size(), value) {}

  [[nodiscard]] const GridFrame& frame() const { return frame_; }
  [[nodiscard]] T& operator[](Cell c) { return values_[frame_.index(c)]; }
  [[nodiscard]] const T& operator[](Cell c) const { return values_[frame_.index(c)]; }
  [[nodiscard]] std::vector<T>& values() { return values_; }
  [[nodiscard]] const std::vector<T>& values() const { return values_; }

  /// Takes a new shape, every cell `value`; keeps the memory it has.
  void reset(const GridFrame& frame, T value = {}) {
    frame_ = frame;
    values_.assign(frame.size(), value);
  }
  /// Takes a new shape for a caller that writes every cell: what the cells hold until then is left open.
  void reshape(const GridFrame& frame) {
    frame_ = frame;
    values_.resize(frame.size());
  }

  bool operator==(const Grid&) const = default;

 private:
  GridFrame frame_;
  std::vector<T> values_;
};

}  // namespace cogslam
