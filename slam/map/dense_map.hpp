#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/grid.hpp"
#include "core/hash.hpp"
#include "slam/map/cell_window.hpp"
#include "slam/map/memory_meter.hpp"

namespace cogslam {

/// An uncompressed map: one value per cell, in blocks of 32 x 32 cells that copies share until one of them writes. With
/// a stated area blocks are cut off at its border, so that it holds one value per cell of the area and no more; without
/// one it grows in any direction. Cells never written are 0 (unknown); a block of nothing else is not kept.
template <class T>
class BlockMap {
 public:
  static constexpr int kBlock = 32;  ///< cells per side

  /// An empty map. `area`: the lattice cells it may hold; nothing: unbounded.
  BlockMap(double cell_size, std::optional<GridFrame> area, std::shared_ptr<MemoryMeter> meter);

  /// Fills `scratch` with the values of `window` (cut to the area).
  void load(const CellWindow& window, Grid<T>& scratch) const;

  /// Takes over the cells of `changed` from `scratch`, which a load filled.
  void commit(const Grid<T>& scratch, const CellWindow& changed);

  /// The smallest window that holds every block.
  [[nodiscard]] CellWindow extent() const;
  void add_to(Hash& hash) const;

 private:
  struct Block {
    Block(std::shared_ptr<MemoryMeter> meter, std::size_t cells);
    MeteredBlock counted;
    std::vector<T> cells;  ///< row-major over the block's own window
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
  [[nodiscard]] BlockPtr written(Cell block, const Grid<T>& scratch, const CellWindow& changed) const;

  double cell_size_;
  std::optional<CellWindow> area_;
  std::shared_ptr<MemoryMeter> meter_;
  std::shared_ptr<const Directory> directory_;
};

/// The map of FastSLAM OG: float log-odds.
using DenseMap = BlockMap<float>;
/// The plain twin of the tile store: levels of a LatticeModel.
using LatticeMap = BlockMap<std::int8_t>;

extern template class BlockMap<float>;
extern template class BlockMap<std::int8_t>;

}  // namespace cogslam
