#pragma once

#include <cstdint>
#include <vector>

#include "core/grid.hpp"
#include "slam/map/log_odds.hpp"

namespace cogslam {

/// How likely a beam ends near here, given the map: exp(-d^2 / 2 sigma^2), d the distance to the nearest sample of
/// an occupied cell, cut off at 3 sigma (likelihood field, Thrun et al. 2006, sec. 6.4).
struct LikelihoodFieldConfig {
  double sigma = 0.08;          ///< spread of an end point around its surface [m]
  double finest_sample = 0.05;  ///< cells larger than this are sampled several times [m]
};

/// The field over a window of the map, bilinear between samples.
///
/// Cells larger than `finest_sample` are sampled k x k times, and d is measured to the nearest sample of an occupied
/// cell: a surface may stand anywhere in a large cell, so every end point inside is equally likely, and a coarse grid
/// does not drag poses towards cell centres. A fine cell has one sample, its centre, and the field a sharp ridge: on it
/// a flat one lets headings drift with the odometry (measured on the Intel log: walls thicken along the drift).
class LikelihoodField {
 public:
  LikelihoodField(const LikelihoodFieldConfig& config, double cell_size);

  /// Draws the field of a map. Keeps its memory from call to call.
  void draw(const Grid<float>& log_odds);

  /// Value in [0, 1] at a point of the map [m]; 0 outside the outermost samples.
  [[nodiscard]] float at(double x, double y) const {
    const double u = x * per_metre_ - left_, v = y * per_metre_ - bottom_;  // samples are half a step inside
    if (!(u >= 0.0 && v >= 0.0 && u < width_ - 1 && v < height_ - 1)) return 0.0F;
    const int i = static_cast<int>(u), j = static_cast<int>(v);
    const float fx = static_cast<float>(u - i), fy = static_cast<float>(v - j);
    const float* p = values_.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(width_) + i;
    const float low = p[0] + fx * (p[1] - p[0]), high = p[width_] + fx * (p[width_ + 1] - p[width_]);
    return low + fy * (high - low);
  }
  [[nodiscard]] bool empty() const { return occupied_ == 0; }
  [[nodiscard]] double sample_size() const { return 1.0 / per_metre_; }
  /// Cells around the window that a draw looks at: load the map with this margin.
  [[nodiscard]] int margin_cells() const { return margin_cells_; }

 private:
  void stamp(int column, int row);

  int samples_;  ///< per cell side
  int reach_;    ///< samples around a cell that its kernel covers
  int margin_cells_;
  double per_metre_;
  double left_ = 0.0, bottom_ = 0.0;  ///< position of the first sample, in samples
  int width_ = 0, height_ = 0;        ///< samples
  std::size_t occupied_ = 0;
  std::vector<float> kernel_;  ///< (samples + 2 reach)^2, row-major
  std::vector<float> values_;
};

}  // namespace cogslam
