#pragma once

#include <Eigen/Core>
#include <vector>

#include "slam/mobile_sensing/partial_map.hpp"

namespace cogslam {

/// A partial map blurred for one pass of offset estimation. Points are in cells from the centre of cell (0, 0).
class OffsetLevel {
 public:
  /// Gaussian blur of `sigma_cells`, in which a cell counts by its weight: blur(m w) / blur(w). What is not known does
  /// not bleed into what is.
  OffsetLevel(const PartialMap& map, double sigma_cells);

  struct Sample {
    double value = 0.0;
    double weight = 0.0;                                 ///< 0 outside the map
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero();  ///< [1/cell]
  };
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] Sample at_cell(Cell c) const;
  /// Cubic for values (Keys 1981), linear for weights and gradients.
  [[nodiscard]] Sample at(const Eigen::Vector2d& p) const;

 private:
  [[nodiscard]] std::size_t clamped_index(int x, int y) const;
  [[nodiscard]] double cubic_value(int x, int y, double share_x, double share_y) const;

  int width_;
  int height_;
  std::vector<double> value_, weight_, gradient_x_, gradient_y_;
};

}  // namespace cogslam
