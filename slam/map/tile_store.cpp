#include "slam/map/tile_store.hpp"

#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>

#include "slam/codec/byte_code.hpp"
#include "slam/codec/coarse_cells.hpp"
#include "slam/codec/context_code.hpp"
#include "slam/codec/nibble_code.hpp"

namespace cogslam {
namespace {

constexpr std::size_t kTilesDecoded = 2048;
constexpr std::int8_t kNotOccupied = 1;  // the highest level that counts as no obstacle
constexpr std::uint16_t kIdleScans = 8;
constexpr std::uint64_t kScansBetweenSealings = 4;
constexpr std::uint32_t kForGood =
    std::numeric_limits<std::uint32_t>::max();  // owners of a tile that is never returned

}  // namespace

TileStore::TileStore(std::shared_ptr<MemoryMeter> meter, bool two_resolutions)
    : meter_(std::move(meter)), cache_(kTilesDecoded), two_resolutions_(two_resolutions) {
  std::int64_t bytes = static_cast<std::int64_t>(sizeof(TileStore) + cache_.bytes() + sizeof(ContextModel));
  for (std::size_t level = 0; level < uniform_.size(); ++level) {
    const auto code = static_cast<std::uint8_t>(level);
    uniform_[level] = allocate(TileCoding::kUniform, {&code, 1});
    uniform_[level]->owners_ = kForGood;
    bytes += uniform_[level]->memory();
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

void TileStore::simplify(TileCells& cells) const {
  if (two_resolutions_ && nothing_above(cells, kNotOccupied)) coarsen(cells);
}

const Tile* TileStore::make(const TileCells& cells) {
  if (std::memcmp(cells.levels.data(), cells.levels.data() + 1, kTileCells - 1) == 0) {
    const std::int8_t level = cells.levels[0];
    return level == 0 ? nullptr : uniform_[static_cast<std::uint8_t>(level)];
  }
  const Tile* tile = nullptr;
  if (fits_nibbles(cells)) {
    NibbleBuffer code;
    const std::size_t size = encode_nibbles(cells, code);
    if (two_resolutions_ && size > kCoarseCodeBytes && nothing_above(cells, kNotOccupied)) {
      tile = allocate(TileCoding::kCoarse, encode_coarse(cells));
    } else {
      tile = allocate(TileCoding::kNibbles, {code.data(), size});
    }
  } else {
    ByteBuffer code;
    tile = allocate(TileCoding::kBytes, {code.data(), encode_bytes(cells, code)});
  }
  count(*tile, 1);
  cache_.put(*tile, cells);
  return tile;
}

void TileStore::count(const Tile& tile, int sign) {
  meter_->add(sign * static_cast<std::int64_t>(tile.code().size()), sign * tile.memory());
}

bool TileStore::begin_scan(std::uint64_t scan) {
  const auto now = static_cast<std::uint16_t>(scan);
  if (now == scan_) return scan % kScansBetweenSealings == 0 && sealing_ != 0;
  scan_ = now;
  if (scan % kScansBetweenSealings != 0) return false;
  sealed_.clear();
  sealing_ = static_cast<std::uint16_t>(sealing_ % 0xFFFE + 1);
  return true;
}

bool TileStore::is_idle(const Tile& tile) const {
  return is_fast(tile.coding_) && !tile.kept_fast_ && static_cast<std::uint16_t>(scan_ - tile.born_) >= kIdleScans;
}

const Tile* TileStore::sealed(const Tile& tile) {
  if (const auto done = sealed_.find(&tile); done != sealed_.end()) {
    if (done->second != &tile) retain(*done->second);
    return done->second;
  }
  const bool shared = tile.owners_.load(std::memory_order_relaxed) > 1;
  const Tile* dense = seal(tile);
  if (shared) sealed_.emplace(&tile, dense);
  return dense;
}

const Tile* TileStore::seal(const Tile& tile) {
  TileCells cells;
  cache_.with(tile, [&](const std::int8_t* levels) { std::memcpy(cells.levels.data(), levels, kTileCells); });
  const bool nibbles = tile.coding_ == TileCoding::kNibbles;
  ContextBuffer code;
  const auto size = encode_contexts(cells, nibbles, code);
  if (!size || heap_bytes(sizeof(Tile) + *size) >= tile.memory()) {
    tile.kept_fast_ = true;
    return &tile;
  }
  const Tile* dense = allocate(nibbles ? TileCoding::kContexts : TileCoding::kContextBytes, {code.data(), *size});
  count(*dense, 1);
  return dense;
}

void TileStore::retain(const Tile& tile) const {
  if (tile.owners_.load(std::memory_order_relaxed) == kForGood) return;
  tile.owners_.fetch_add(1, std::memory_order_relaxed);
}

void TileStore::release(const Tile& tile) {
  if (tile.owners_.load(std::memory_order_relaxed) == kForGood) return;
  if (tile.owners_.fetch_sub(1, std::memory_order_acq_rel) > 1) return;
  cache_.forget(tile);
  count(tile, -1);
  tile.~Tile();
  ::operator delete(const_cast<Tile*>(&tile));
}

}  // namespace cogslam
