#pragma once

#include <cstdint>
#include <vector>

#include "slam/weight/occupancy_bits.hpp"

namespace cogslam {

/// How likely a beam ends near here, given the map: exp(-d^2 / 2 sigma^2), d the distance to the nearest sample of
/// an occupied cell, cut off at 3 sigma (likelihood field, Thrun et al. 2006, sec. 6.4).
struct LikelihoodFieldConfig {
  double sigma = 0.08;          ///< spread of an end point around its surface [m]
  double finest_sample = 0.05;  ///< cells larger than this are sampled several times [m]
};

/// The field over a window of the map, bilinear between samples, worked out where it is looked at.
///
/// Cells larger than `finest_sample` are sampled k x k times, and d is measured to the nearest sample of an occupied
/// cell: a surface may stand anywhere in a large cell, so every end point inside is equally likely, and a coarse grid
/// does not drag poses towards cell centres. A fine cell has one sample, its centre, and the field a sharp ridge: on it
/// a flat one lets headings drift with the odometry (measured on the Intel log: walls thicken along the drift).
///
/// Looking at the field changes what it remembers, so one object must not be shared between threads.
class LikelihoodField {
 public:
  LikelihoodField(const LikelihoodFieldConfig& config, double cell_size);

  /// Takes a map window: log-odds, or levels of `unit` log-odds each. Keeps its memory from call to call.
  void draw(const Grid<float>& log_odds);
  void draw(const Grid<std::int8_t>& levels, double unit);

  /// Value in [0, 1] at a point of the map [m]; 0 outside the outermost samples.
  [[nodiscard]] float at(double x, double y) const { return slope_at(x, y).value; }

  /// The same with its derivative [1/m].
  struct Slope {
    float value = 0.0F;
    float dx = 0.0F;
    float dy = 0.0F;
  };
  [[nodiscard]] Slope slope_at(double x, double y) const {
    const double u = x * per_metre_ - left_, v = y * per_metre_ - bottom_;  // samples are half a step inside
    if (!(u >= 0.0 && v >= 0.0 && u < width_ - 1 && v < height_ - 1)) return {};
    const int i = static_cast<int>(u), j = static_cast<int>(v);
    const float fx = static_cast<float>(u - i), fy = static_cast<float>(v - j);
    const float a = sample(i, j), b = sample(i + 1, j), c = sample(i, j + 1), d = sample(i + 1, j + 1);
    const float low = a + fx * (b - a), high = c + fx * (d - c), step = static_cast<float>(per_metre_);
    return {low + fy * (high - low), step * ((b - a) + fy * ((d - c) - (b - a))), step * (high - low)};
  }

  /// Whether nothing is known of the cell that holds a point of the map [m].
  [[nodiscard]] bool unknown_at(double x, double y) const { return !bits_.known(bits_.frame().cell_of({x, y})); }
  [[nodiscard]] bool empty() const { return !bits_.any_occupied(); }
  [[nodiscard]] double sample_size() const { return 1.0 / per_metre_; }
  /// Cells around the window that the field looks at: load the map with this margin.
  [[nodiscard]] int margin_cells() const { return reach_cells_ + 1; }

 private:
  using Squares = std::uint16_t;  ///< a squared distance in samples, plus 1; 0: not worked out yet
  void begin();
  [[nodiscard]] float sample(int i, int j) const {
    const std::size_t index = static_cast<std::size_t>(j) * static_cast<std::size_t>(width_) + i;
    const Squares known = squares_[index];
    return values_[known != 0 ? known : work_out(i, j, index)];
  }
  Squares work_out(int i, int j, std::size_t index) const;

  int samples_;      ///< per cell side
  int reach_;        ///< samples that the field reaches beyond a cell
  int reach_cells_;  ///< and cells
  double per_metre_;
  double left_ = 0.0, bottom_ = 0.0;  ///< position of the first sample, in samples
  int width_ = 0, height_ = 0;        ///< samples
  std::vector<float> values_;         ///< by Squares; the last is 0, for farther samples
  OccupancyBits bits_;
  mutable std::vector<Squares> squares_;         ///< what has been worked out of this window
  mutable std::vector<std::size_t> remembered_;  ///< where
};

}  // namespace cogslam
