#pragma once

#include <memory>
#include <optional>

#include "core/grid.hpp"
#include "core/hash.hpp"
#include "slam/map/tile_directory.hpp"

namespace cogslam {

/// The compressed map of FastSLAM with tiles: levels of a LatticeModel in tiles of 32 x 32 cells, each coded by itself
/// and shared between maps until one of them changes it. A commit codes only tiles that did change, and costs nothing
/// for the rest of the map. Grows in any direction; with a stated area, cells outside it are left out.
class TileMap {
 public:
  TileMap(double cell_size, const std::optional<GridFrame>& area, std::shared_ptr<TileStore> store);

  /// Fills `scratch` with the levels of `window` (cut to the area).
  void load(const CellWindow& window, Grid<std::int8_t>& scratch) const;
  /// Takes over the cells of `changed` from `scratch`, which a load filled.
  void commit(const Grid<std::int8_t>& scratch, const CellWindow& changed);

  /// Says that registered scan number `scan` begins, and on every fourth seals tiles that are no longer changed. To be
  /// called for all maps of a store, one after another and beside no other call.
  void settle(std::uint64_t scan) {
    if (directory_.store().begin_scan(scan)) directory_.seal_idle();
  }

  /// The smallest window that holds every tile.
  [[nodiscard]] CellWindow extent() const;
  /// Equal maps have equal hashes, also between this and LatticeMap.
  void add_to(Hash& hash) const;
  [[nodiscard]] const TileDirectory& directory() const { return directory_; }

 private:
  [[nodiscard]] CellWindow cells_of(Cell tile) const;

  double cell_size_;
  std::optional<CellWindow> area_;
  TileDirectory directory_;
};

/// The tiles that hold any cell of a window, in tile coordinates.
CellWindow tiles_of(const CellWindow& cells);

/// The window of all cells of those tiles.
CellWindow whole_tiles(const CellWindow& cells);

}  // namespace cogslam
