#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <unordered_map>

#include "slam/map/decode_cache.hpp"
#include "slam/map/memory_meter.hpp"
#include "slam/map/tile.hpp"

namespace cogslam {

struct TileStoreConfig {
  bool two_resolutions = false;  ///< coarsen tiles without an occupied cell (coarse_cells.hpp): not lossless any more
  int seal_after = 8;            ///< registered scans without a change until a tile gets its dense code; 0: at once
};

/// What the tile maps of one filter have in common: it makes tiles, counts their owners and their bytes, and keeps the
/// plain form of those in use. Outlives every map. Safe to use from several threads.
class TileStore {
 public:
  explicit TileStore(std::shared_ptr<MemoryMeter> meter, const TileStoreConfig& config = {});
  ~TileStore();
  TileStore(const TileStore&) = delete;
  TileStore& operator=(const TileStore&) = delete;

  /// What the store makes of cells before it keeps them: as they are, or coarsened.
  void simplify(TileCells& cells) const;
  /// A tile of these cells, which went through `simplify`, with one owner; nullptr where all are unknown (level 0).
  /// Tiles of one level throughout are made once for all.
  const Tile* make(const TileCells& cells);
  /// One more, and one fewer, owner.
  void retain(const Tile& tile) const;
  void release(const Tile& tile);

  /// Says which registered scan it is, counted from anywhere: tiles made from now on are of this scan. As every fourth
  /// begins, returns true: then tiles are to be sealed.
  bool begin_scan(std::uint64_t scan);
  /// A number for each call of begin_scan that returned true, in 1..0xFFFE.
  [[nodiscard]] std::uint16_t sealing() const { return sealing_; }
  /// True for a tile in fast code that was made seal_after scans ago or earlier and has not been tried.
  [[nodiscard]] bool is_idle(const Tile& tile) const;
  /// True for a tile that is_idle never holds for again.
  [[nodiscard]] static bool is_settled(const Tile& tile) { return !is_fast(tile.coding_) || tile.kept_fast_; }
  /// The tile in dense code, with an owner for the caller: the same one for all that ask in one scan. The tile itself,
  /// without a new owner, where that saves no memory. Not beside any other call.
  const Tile* sealed(const Tile& tile);

  DecodeCache& decoded() { return cache_; }
  MemoryMeter& meter() { return *meter_; }

 private:
  const Tile* allocate(TileCoding coding, std::span<const std::uint8_t> code) const;
  const Tile* make_fast(const TileCells& cells);
  const Tile* make_dense(const TileCells& cells, bool nibbles, std::int64_t below);
  const Tile* seal(const Tile& tile);
  void count(const Tile& tile, int sign);

  std::shared_ptr<MemoryMeter> meter_;
  DecodeCache cache_;
  TileStoreConfig config_;
  std::array<const Tile*, 256> uniform_{};
  std::uint16_t scan_ = 0;
  std::uint16_t sealing_ = 0;
  std::unordered_map<const Tile*, const Tile*> sealed_;  ///< in this scan; looked up, never gone through
};

}  // namespace cogslam
