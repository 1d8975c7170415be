#include "slam/map/tile_store.hpp"

#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>

#include "slam/codec/byte_code.hpp"
#include "slam/codec/nibble_code.hpp"

namespace cogslam {
namespace {

constexpr std::size_t kTilesDecoded = 2048;
constexpr std::uint32_t kForGood =
    std::numeric_limits<std::uint32_t>::max();  // owners of a tile that is never returned

std::int64_t memory_of(const Tile& tile) { return heap_bytes(sizeof(Tile) + tile.code().size()); }

}  // namespace

TileStore::TileStore(std::shared_ptr<MemoryMeter> meter) : meter_(std::move(meter)), cache_(kTilesDecoded) {
  std::int64_t bytes = static_cast<std::int64_t>(sizeof(TileStore) + cache_.bytes());
  for (std::size_t level = 0; level < uniform_.size(); ++level) {
    const auto code = static_cast<std::uint8_t>(level);
    uniform_[level] = allocate(TileCoding::kUniform, {&code, 1});
    uniform_[level]->owners_ = kForGood;
    bytes += memory_of(*uniform_[level]);
  }
  meter_->add_process(bytes);
}

TileStore::~TileStore() {
  for (const Tile* tile : uniform_) ::operator delete(const_cast<Tile*>(tile));
}

const Tile* TileStore::allocate(TileCoding coding, std::span<const std::uint8_t> code) const {
  void* memory = ::operator new(sizeof(Tile) + code.size());
  return new (memory) Tile(coding, code, scan_);
}

const Tile* TileStore::make(const TileCells& cells) {
  if (std::memcmp(cells.levels.data(), cells.levels.data() + 1, kTileCells - 1) == 0) {
    const std::int8_t level = cells.levels[0];
    return level == 0 ? nullptr : uniform_[static_cast<std::uint8_t>(level)];
  }
  const Tile* tile = nullptr;
  if (fits_nibbles(cells)) {
    NibbleBuffer code;
    tile = allocate(TileCoding::kNibbles, {code.data(), encode_nibbles(cells, code)});
  } else {
    ByteBuffer code;
    tile = allocate(TileCoding::kBytes, {code.data(), encode_bytes(cells, code)});
  }
  meter_->add(static_cast<std::int64_t>(tile->code().size()), memory_of(*tile));
  cache_.put(*tile, cells);
  return tile;
}

void TileStore::retain(const Tile& tile) const {
  if (tile.owners_.load(std::memory_order_relaxed) == kForGood) return;
  tile.owners_.fetch_add(1, std::memory_order_relaxed);
}

void TileStore::release(const Tile& tile) {
  if (tile.owners_.load(std::memory_order_relaxed) == kForGood) return;
  if (tile.owners_.fetch_sub(1, std::memory_order_acq_rel) > 1) return;
  cache_.forget(tile);
  meter_->add(-static_cast<std::int64_t>(tile.code().size()), -memory_of(tile));
  tile.~Tile();
  ::operator delete(const_cast<Tile*>(&tile));
}

}  // namespace cogslam
