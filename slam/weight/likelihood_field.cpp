#include "slam/weight/likelihood_field.hpp"

#include <algorithm>
#include <cmath>

#include "core/check.hpp"

namespace cogslam {

LikelihoodField::LikelihoodField(const LikelihoodFieldConfig& config, double cell_size)
    : samples_(std::max(1, static_cast<int>(std::lround(cell_size / config.finest_sample)))),
      reach_(static_cast<int>(std::ceil(3.0 * config.sigma / (cell_size / samples_)))),
      margin_cells_((reach_ + samples_ - 1) / samples_ + 1),
      per_metre_(samples_ / cell_size) {
  EXPECTS(config.sigma > 0.0 && config.finest_sample > 0.0 && cell_size > 0.0);
  const int side = samples_ + 2 * reach_;
  const double step = cell_size / samples_;
  const auto outside = [&](int k) {  // distance of a sample from those of the cell along one axis
    return step * std::max({0, reach_ - k, k - (reach_ + samples_ - 1)});
  };
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const double d2 = outside(row) * outside(row) + outside(column) * outside(column);
      kernel_.push_back(static_cast<float>(std::exp(-0.5 * d2 / (config.sigma * config.sigma))));
    }
  }
}

void LikelihoodField::draw(const Grid<float>& log_odds) {
  const GridFrame& frame = log_odds.frame();
  width_ = frame.width * samples_;
  height_ = frame.height * samples_;
  left_ = frame.lattice_min.x * samples_ + 0.5;
  bottom_ = frame.lattice_min.y * samples_ + 0.5;
  values_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0.0F);
  occupied_ = 0;
  const float* value = log_odds.values().data();
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x, ++value) {
      if (*value > kOccupiedLogOdds) stamp(x * samples_ - reach_, y * samples_ - reach_);
    }
  }
}

void LikelihoodField::stamp(int column, int row) {
  ++occupied_;
  const int side = samples_ + 2 * reach_;
  const int first_x = std::max(0, column), last_x = std::min(width_, column + side);
  for (int y = std::max(0, row); y < std::min(height_, row + side); ++y) {
    float* out = values_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
    const float* kernel = kernel_.data() + static_cast<std::size_t>((y - row) * side);
    for (int x = first_x; x < last_x; ++x) out[x] = std::max(out[x], kernel[x - column]);
  }
}

}  // namespace cogslam
