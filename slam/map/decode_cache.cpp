#include "slam/map/decode_cache.hpp"

#include <bit>
#include <cstring>
#include <stdexcept>

namespace cogslam {

DecodeCache::DecodeCache(std::size_t tiles)
    : sets_(std::bit_ceil((tiles + kWays - 1) / kWays)),
      shift_(64 - std::countr_zero(sets_.size())),
      cells_(std::make_unique_for_overwrite<std::int8_t[]>(sets_.size() * kWays * kTileCells)) {}

DecodeCache::Set& DecodeCache::set_of(const Tile& tile) {
  const auto address = static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(&tile)) >> 4;
  const std::uint64_t mixed = address * 0x9e3779b97f4a7c15ULL;
  return sets_[shift_ == 64 ? 0 : mixed >> shift_];
}

std::int8_t* DecodeCache::cells_of(const Set& set, std::size_t way) {
  const auto index = static_cast<std::size_t>(&set - sets_.data());
  return cells_.get() + (index * kWays + way) * kTileCells;
}

std::int8_t* DecodeCache::place_for(Set& set, const Tile& tile) {
  std::size_t way = 0;
  while (way < kWays && set.tiles[way] != nullptr && set.tiles[way] != &tile) ++way;
  if (way == kWays) {
    way = set.next;
    set.next = (set.next + 1) % kWays;
  }
  set.tiles[way] = &tile;
  return cells_of(set, way);
}

std::int8_t* DecodeCache::held_or_decoded(Set& set, const Tile& tile) {
  for (std::size_t way = 0; way < kWays; ++way) {
    if (set.tiles[way] == &tile) return cells_of(set, way);
  }
  TileCells cells;
  if (!tile.decode(cells)) throw std::runtime_error("a map tile in memory is damaged: its code does not decode");
  std::int8_t* place = place_for(set, tile);
  std::memcpy(place, cells.levels.data(), kTileCells);
  return place;
}

void DecodeCache::put(const Tile& tile, const TileCells& cells) {
  Set& set = set_of(tile);
  const std::scoped_lock lock(set.mutex);
  std::memcpy(place_for(set, tile), cells.levels.data(), kTileCells);
}

void DecodeCache::forget(const Tile& tile) {
  Set& set = set_of(tile);
  const std::scoped_lock lock(set.mutex);
  for (const Tile*& held : set.tiles) {
    if (held == &tile) held = nullptr;
  }
}

}  // namespace cogslam
