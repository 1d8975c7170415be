#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "slam/map/cell_window.hpp"
#include "slam/map/tile_store.hpp"

namespace cogslam {

/// A node of the directory: up to 4 x 4 nodes of the level below, or tiles, of which only those that are there take
/// memory. In one piece: this header with the pointers behind it.
struct TileNode {
  mutable std::atomic<std::uint32_t> owners{1};
  std::uint16_t held = 0;           ///< bit 4 y + x: the child in that place is there
  mutable std::uint16_t swept = 0;  ///< the last sealing that went through it, or kAllSealed
  static constexpr std::uint16_t kAllSealed = 0xFFFF;
};

/// Which tile lies where: a tree of 4 x 4-way nodes that is never changed. Copies share all of it; an update makes new
/// nodes on the way to what changed and shares the rest. The tree grows at its root, in any direction.
class TileDirectory {
 public:
  explicit TileDirectory(std::shared_ptr<TileStore> store) : store_(std::move(store)) {}
  ~TileDirectory();
  TileDirectory(const TileDirectory& other);
  TileDirectory(TileDirectory&& other) noexcept { swap(other); }
  TileDirectory& operator=(TileDirectory other) noexcept {
    swap(other);
    return *this;
  }
  void swap(TileDirectory& other) noexcept;

  [[nodiscard]] TileStore& store() const { return *store_; }
  /// The tile at tile coordinates (cells / 32, rounded down), nullptr where all is unknown.
  [[nodiscard]] const Tile* find(Cell tile) const;

  /// What becomes of a tile (nullptr: unknown): itself, or another one with an owner for the directory.
  using Change = std::function<const Tile*(Cell place, const Tile* before)>;
  /// Asks `change` for every tile of a window of tile coordinates.
  void update(const CellWindow& tiles, const Change& change);

  /// Puts idle tiles into dense code, also for the maps that share them: the one change to nodes that are there. Not
  /// beside any other call to maps of this store.
  void seal_idle();

  /// Every piece of memory that the map holds, with what a MemoryMeter counts for it: tiles and nodes, each as often as
  /// it is found.
  using VisitMemory = std::function<void(const void* piece, std::int64_t payload, std::int64_t total)>;
  void for_each_piece(const VisitMemory& visit) const;

  using Visit = std::function<void(Cell place, const Tile& tile)>;
  void for_each(const Visit& visit) const;

 private:
  void grow_to(const CellWindow& tiles);

  std::shared_ptr<TileStore> store_;
  const TileNode* root_ = nullptr;
  int levels_ = 0;                         ///< of nodes; 0: the map is unknown all over
  std::uint32_t root_x_ = 0, root_y_ = 0;  ///< which of the squares of 4^levels_ tiles the root covers
};

}  // namespace cogslam
