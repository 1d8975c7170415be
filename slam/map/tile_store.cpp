#include "slam/map/tile_store.hpp"

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
constexpr std::uint64_t kScansBetweenSealings = 4;
constexpr std::uint32_t kForGood =
    std::numeric_limits<std::uint32_t>::max();  // owners of a tile that is never returned

void free(const Tile& tile) {
  tile.~Tile();
  ::operator delete(const_cast<Tile*>(&tile));
}

}  // namespace

TileStore::TileStore(std::shared_ptr<MemoryMeter> meter, const TileStoreConfig& config)
    : meter_(std::move(meter)), cache_(kTilesDecoded), config_(config) {
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
  for (const Tile* tile : uniform_) free(*tile);
}

const Tile* TileStore::allocate(TileCoding coding, std::span<const std::uint8_t> code) const {
  void* memory = ::operator new(sizeof(Tile) + code.size());
  return new (memory) Tile(coding, code, scan_);
}

void TileStore::simplify(TileCells& cells) const {
  if (config_.two_resolutions && nothing_above(cells, kNotOccupied)) coarsen(cells);
}

const Tile* TileStore::make(const TileCells& cells) {
  if (std::memcmp(cells.levels.data(), cells.levels.data() + 1, kTileCells - 1) == 0) {
    const std::int8_t level = cells.levels[0];
    return level == 0 ? nullptr : uniform_[static_cast<std::uint8_t>(level)];
  }
  const Tile* tile = make_fast(cells);
  if (config_.seal_after == 0 && is_fast(tile->coding_)) {
    if (const Tile* dense = make_dense(cells, tile->coding_ == TileCoding::kNibbles, tile->memory())) {
      free(*tile);
      tile = dense;
    } else {
      tile->kept_fast_ = true;
    }
  }
  count(*tile, 1);
  cache_.put(*tile, cells);
  return tile;
}

const Tile* TileStore::make_fast(const TileCells& cells) {
  if (!fits_nibbles(cells)) {
    ByteBuffer code;
    return allocate(TileCoding::kBytes, {code.data(), encode_bytes(cells, code)});
  }
  NibbleBuffer code;
  const std::size_t size = encode_nibbles(cells, code);
  if (config_.two_resolutions && size > kCoarseCodeBytes && nothing_above(cells, kNotOccupied)) {
    return allocate(TileCoding::kCoarse, encode_coarse(cells));
  }
  return allocate(TileCoding::kNibbles, {code.data(), size});
}

/// A tile in dense code if it takes less than `below` from the heap, or nullptr.
const Tile* TileStore::make_dense(const TileCells& cells, bool nibbles, std::int64_t below) {
  ContextBuffer code;
  const auto size = encode_contexts(cells, nibbles, code);
  if (!size || heap_bytes(sizeof(Tile) + *size) >= below) return nullptr;
  return allocate(nibbles ? TileCoding::kContexts : TileCoding::kContextBytes, {code.data(), *size});
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
  return is_fast(tile.coding_) && !tile.kept_fast_ &&
         static_cast<std::uint16_t>(scan_ - tile.born_) >= config_.seal_after;
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
  const Tile* dense = make_dense(cells, tile.coding_ == TileCoding::kNibbles, tile.memory());
  if (dense == nullptr) {
    tile.kept_fast_ = true;
    return &tile;
  }
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
  free(tile);
}

}  // namespace cogslam
