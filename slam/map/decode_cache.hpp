#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "slam/map/tile.hpp"

namespace cogslam {

/// Tiles in plain form, so that each is decoded once for all maps that share it. Holds a fixed number of tiles; what it
/// holds at the moment never changes a result. Safe to use from several threads.
class DecodeCache {
 public:
  /// Room for `tiles` tiles, rounded up to a power of two and at least 8.
  explicit DecodeCache(std::size_t tiles);

  /// Calls `use(cells)` with the kTileCells levels of a tile, which may not be kept. Throws std::runtime_error where
  /// the tile's code is damaged.
  template <class Use>
  void with(const Tile& tile, Use&& use) {
    Set& set = set_of(tile);
    const std::scoped_lock lock(set.mutex);
    use(static_cast<const std::int8_t*>(held_or_decoded(set, tile)));
  }
  /// Takes over the cells of a tile that has just been made.
  void put(const Tile& tile, const TileCells& cells);
  /// Drops a tile whose memory is about to be returned.
  void forget(const Tile& tile);

  /// What the cache takes when full.
  [[nodiscard]] std::size_t bytes() const { return sets_.size() * (sizeof(Set) + kWays * kTileCells); }

 private:
  static constexpr std::size_t kWays = 8;
  struct Set {
    std::array<const Tile*, kWays> tiles{};
    std::mutex mutex;
    std::size_t next = 0;  ///< the place to give up next
  };
  [[nodiscard]] Set& set_of(const Tile& tile);
  std::int8_t* held_or_decoded(Set& set, const Tile& tile);
  std::int8_t* place_for(Set& set, const Tile& tile);
  [[nodiscard]] std::int8_t* cells_of(const Set& set, std::size_t way);

  std::vector<Set> sets_;
  int shift_;
  std::unique_ptr<std::int8_t[]> cells_;  ///< kTileCells for each place, left unset until used
};

}  // namespace cogslam
