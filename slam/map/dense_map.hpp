#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/grid.hpp"
#include "core/hash.hpp"
#include "slam/map/cell_window.hpp"
#include "slam/map/memory_meter.hpp"

namespace cogslam {

/// The uncompressed map of FastSLAM OG: float log-odds, in blocks of 32 x 32 cells that copies share until one of them
/// writes. With a stated area blocks are cut off at its border, so that it holds 4 bytes per cell of the area and no
/// more; without one it grows in any direction. Cells never written are 0 (unknown).
class DenseMap {
 public:
  static constexpr int kBlock = 32;  ///< cells per side

  /// An empty map. `area`: the lattice cells it may hold; nothing: unbounded.
  DenseMap(double cell_size, std::optional<GridFrame> area, std::shared_ptr<MemoryMeter> meter);

  /// Fills `scratch` with the log-odds of `window` (cut to the area).
  void load(const CellWindow& window, Grid<float>& scratch) const;

  /// Takes over the cells of `changed` from `scratch`, which a load filled.
  void commit(const Grid<float>& scratch, const CellWindow& changed);

  /// The smallest window that holds every block.
  [[nodiscard]] CellWindow extent() const;
  void add_to(Hash& hash) const;

 private:
  struct Block {
    Block(std::shared_ptr<MemoryMeter> meter, std::size_t cells);
    MeteredBlock counted;
    std::vector<float> cells;  ///< row-major over the block's own window
  };
  using BlockPtr = std::shared_ptr<const Block>;
  struct Directory {
    Directory(std::shared_ptr<MemoryMeter> meter, const CellWindow& window);
    MeteredBlock counted;
    CellWindow blocks;  ///< in blocks
    std::vector<BlockPtr> entries;
    [[nodiscard]] std::size_t index(Cell block) const;
  };

  [[nodiscard]] CellWindow cells_of(Cell block) const;
  [[nodiscard]] BlockPtr block_at(Cell block) const;
  [[nodiscard]] BlockPtr written(Cell block, const Grid<float>& scratch, const CellWindow& changed) const;

  double cell_size_;
  std::optional<CellWindow> area_;
  std::shared_ptr<MemoryMeter> meter_;
  std::shared_ptr<const Directory> directory_;
};

}  // namespace cogslam
