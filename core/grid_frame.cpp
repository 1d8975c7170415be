#include "core/grid_frame.hpp"

#include "core/check.hpp"

namespace cogslam {

GridFrame GridFrame::covering(const Rectangle& area, double cell_size, int margin_cells) {
  EXPECTS(cell_size > 0.0 && margin_cells >= 0);
  const GridFrame lattice{.cell_size = cell_size};
  const Cell low = lattice.cell_of(area.min);
  // A far side that lies on a cell border needs no cell beyond it; one micron of slack absorbs rounding.
  const Cell high = lattice.cell_of(area.max - Eigen::Vector2d::Constant(1e-6));
  return {.cell_size = cell_size,
          .lattice_min = {low.x - margin_cells, low.y - margin_cells},
          .width = std::max(high.x - low.x, 0) + 1 + 2 * margin_cells,
          .height = std::max(high.y - low.y, 0) + 1 + 2 * margin_cells};
}

}  // namespace cogslam
