#include "slam/map/reach.hpp"

#include <cstdint>
#include <string>

#include "core/error.hpp"

namespace cogslam {

void check_reach(const CellWindow& window) {
  const double width = 1.0 + window.max.x - static_cast<double>(window.min.x);
  const double height = 1.0 + window.max.y - static_cast<double>(window.min.y);
  if (window.empty() || width * height <= kMostMapCells) return;
  const auto text = [](double cells) { return std::to_string(static_cast<std::int64_t>(cells)); };
  throw InputError("the map would grow to " + text(width) + " x " + text(height) + " cells, expected at most " +
                   text(kMostMapCells) +
                   " in all: state the map's area, use larger cells, or look for jumps in the odometry");
}

}  // namespace cogslam
