#include "slam/weight/likelihood_field.hpp"

#include <algorithm>
#include <cmath>

#include "core/check.hpp"

namespace cogslam {
namespace {

/// Samples between one of a cell and the nearest one of the cell that lies `cells` on, in a line; the next cell begins
/// `to_next` samples away.
int samples_between(int cells, int to_next, int samples) { return cells == 0 ? 0 : to_next + (cells - 1) * samples; }

}  // namespace

LikelihoodField::LikelihoodField(const LikelihoodFieldConfig& config, double cell_size)
    : samples_(std::max(1, static_cast<int>(std::lround(cell_size / config.finest_sample)))),
      reach_(static_cast<int>(std::ceil(3.0 * config.sigma / (cell_size / samples_)))),
      reach_cells_((reach_ + samples_ - 1) / samples_),
      per_metre_(samples_ / cell_size) {
  EXPECTS(config.sigma > 0.0 && config.finest_sample > 0.0 && cell_size > 0.0);
  EXPECTS(reach_cells_ <= OccupancyBits::kFarthest && reach_ < 255);  // 63 cells; squares of 16 bits
  const double step = cell_size / samples_;
  values_.push_back(0.0F);  // of no use: 0 means not worked out
  for (int squares = 0; squares <= reach_ * reach_; ++squares) {
    values_.push_back(static_cast<float>(std::exp(-0.5 * squares * step * step / (config.sigma * config.sigma))));
  }
  values_.push_back(0.0F);
}

void LikelihoodField::draw(const Grid<float>& log_odds) {
  bits_.read(log_odds);
  begin();
}

void LikelihoodField::draw(const Grid<std::int8_t>& levels, double unit) {
  bits_.read(levels, unit);
  begin();
}

void LikelihoodField::begin() {
  for (const std::size_t index : remembered_) squares_[index] = 0;
  remembered_.clear();
  const GridFrame& frame = bits_.frame();
  width_ = frame.width * samples_;
  height_ = frame.height * samples_;
  left_ = frame.lattice_min.x * samples_ + 0.5;
  bottom_ = frame.lattice_min.y * samples_ + 0.5;
  const std::size_t size = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  if (squares_.size() < size) squares_.resize(size, 0);
}

LikelihoodField::Squares LikelihoodField::work_out(int i, int j, std::size_t index) const {
  const int x = i / samples_, y = j / samples_;
  const int from_left = i - x * samples_ + 1, from_right = samples_ - (i - x * samples_);
  const int from_below = j - y * samples_ + 1, from_above = samples_ - (j - y * samples_);
  int nearest = reach_ * reach_ + 1;
  const int first = std::max(0, y - reach_cells_), last = std::min(bits_.frame().height - 1, y + reach_cells_);
  for (int row = first; row <= last; ++row) {
    const int up =
        row > y ? samples_between(row - y, from_above, samples_) : samples_between(y - row, from_below, samples_);
    if (up * up >= nearest) continue;
    const OccupancyBits::InRow cells = bits_.nearest_in_row(x, row, reach_cells_);
    const int across =
        std::min(samples_between(cells.right, from_right, samples_), samples_between(cells.left, from_left, samples_));
    nearest = std::min(nearest, up * up + across * across);
  }
  const auto squares = static_cast<Squares>(nearest + 1);
  squares_[index] = squares;
  remembered_.push_back(index);
  return squares;
}

}  // namespace cogslam
