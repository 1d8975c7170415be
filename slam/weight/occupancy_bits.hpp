#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "core/grid.hpp"
#include "slam/map/log_odds.hpp"

namespace cogslam {

/// Which cells of a map window are occupied and which are known, a bit each: 64 neighbours are looked at at once.
class OccupancyBits {
 public:
  static constexpr int kFarthest = 63;  ///< cells along a row that `nearest_in_row` looks

  /// From log-odds, or from levels of `unit` log-odds each.
  void read(const Grid<float>& log_odds);
  void read(const Grid<std::int8_t>& levels, double unit);

  [[nodiscard]] const GridFrame& frame() const { return frame_; }
  [[nodiscard]] bool any_occupied() const { return any_occupied_; }
  /// False outside the window. Cells of the frame.
  [[nodiscard]] bool known(Cell c) const {
    return frame_.contains(c) && (known_[word(c.x, c.y)] >> (c.x & 63) & 1U) != 0;
  }

  /// Cells from (x, y) to the nearest occupied cell of that row: to the right, and to the left; kFarthest + 1 where
  /// there is none within `reach` <= kFarthest. (x, y) lies inside the frame.
  struct InRow {
    int right;
    int left;
  };
  [[nodiscard]] InRow nearest_in_row(int x, int y, int reach) const {
    const std::uint64_t after = sixty_four(x, y) & mask(reach), before = sixty_four(x - 63, y) >> (63 - reach);
    return {after != 0 ? std::countr_zero(after) : kFarthest + 1,
            before != 0 ? reach + 1 - static_cast<int>(std::bit_width(before)) : kFarthest + 1};
  }

 private:
  static std::uint64_t mask(int reach) { return ~std::uint64_t{0} >> (63 - reach); }
  /// A word of margin stands before and after each row.
  [[nodiscard]] std::size_t word(int x, int y) const {
    return static_cast<std::size_t>(y) * words_ + static_cast<std::size_t>((x >> 6) + 1);
  }
  /// Occupied bits of cells x to x + 63 of row y, cell x lowest.
  [[nodiscard]] std::uint64_t sixty_four(int x, int y) const {
    const std::size_t w = word(x, y);
    const int shift = x & 63;
    return shift == 0 ? occupied_[w] : occupied_[w] >> shift | occupied_[w + 1] << (64 - shift);
  }
  void resize(const GridFrame& frame);

  GridFrame frame_;
  std::size_t words_ = 0;  ///< per row
  bool any_occupied_ = false;
  std::vector<std::uint64_t> occupied_;
  std::vector<std::uint64_t> known_;
};

}  // namespace cogslam
