#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "slam/map/decode_cache.hpp"
#include "slam/map/memory_meter.hpp"
#include "slam/map/tile.hpp"

namespace cogslam {

/// What the tile maps of one filter have in common: it makes tiles, counts their owners and their bytes, and keeps the
/// plain form of those in use. Outlives every map. Safe to use from several threads.
class TileStore {
 public:
  explicit TileStore(std::shared_ptr<MemoryMeter> meter);
  ~TileStore();
  TileStore(const TileStore&) = delete;
  TileStore& operator=(const TileStore&) = delete;

  /// A tile of these cells, with one owner; nullptr where all are unknown (level 0). Tiles of one level throughout are
  /// made once for all.
  const Tile* make(const TileCells& cells);
  /// One more, and one fewer, owner.
  void retain(const Tile& tile) const;
  void release(const Tile& tile);

  DecodeCache& decoded() { return cache_; }
  MemoryMeter& meter() { return *meter_; }

 private:
  const Tile* allocate(TileCoding coding, std::span<const std::uint8_t> code) const;

  std::shared_ptr<MemoryMeter> meter_;
  DecodeCache cache_;
  std::array<const Tile*, 256> uniform_{};
  std::uint16_t scan_ = 0;
};

}  // namespace cogslam
