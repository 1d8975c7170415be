#include "slam/map/tile_map.hpp"

#include <algorithm>
#include <cstring>

#include "core/check.hpp"

namespace cogslam {
namespace {

static_assert(kTileSide == 32);
int tile_of(int cell) { return cell >> 5; }  // rounds down, below zero too

CellWindow cells_of_tile(Cell tile) {
  const Cell low{tile.x * kTileSide, tile.y * kTileSide};
  return {low, {low.x + kTileSide - 1, low.y + kTileSide - 1}};
}

std::size_t offset(const CellWindow& window, Cell c) {
  return static_cast<std::size_t>(c.y - window.min.y) * static_cast<std::size_t>(window.width()) +
         static_cast<std::size_t>(c.x - window.min.x);
}

/// Copies rows between two row-major blocks; whole tiles, the usual case, by copies of constant size.
void copy_rows(const std::int8_t* from, std::size_t from_stride, std::int8_t* to, std::size_t to_stride, int width,
               int height) {
  for (int y = 0; y < height; ++y, from += from_stride, to += to_stride) {
    if (width == kTileSide) {
      std::memcpy(to, from, kTileSide);
    } else {
      std::memcpy(to, from, static_cast<std::size_t>(width));
    }
  }
}

void clear_rows(std::int8_t* to, std::size_t stride, int width, int height) {
  for (int y = 0; y < height; ++y, to += stride) std::memset(to, 0, static_cast<std::size_t>(width));
}

template <class Visit>
void for_each_tile(const CellWindow& tiles, Visit&& visit) {
  for (int y = tiles.min.y; y <= tiles.max.y; ++y) {
    for (int x = tiles.min.x; x <= tiles.max.x; ++x) visit(Cell{x, y});
  }
}

}  // namespace

CellWindow tiles_of(const CellWindow& cells) {
  if (cells.empty()) return {};
  return {{tile_of(cells.min.x), tile_of(cells.min.y)}, {tile_of(cells.max.x), tile_of(cells.max.y)}};
}

CellWindow whole_tiles(const CellWindow& cells) {
  if (cells.empty()) return cells;
  const CellWindow tiles = tiles_of(cells);
  return {cells_of_tile(tiles.min).min, cells_of_tile(tiles.max).max};
}

TileMap::TileMap(double cell_size, const std::optional<GridFrame>& area, std::shared_ptr<TileStore> store)
    : cell_size_(cell_size), directory_(std::move(store)) {
  if (area) {
    EXPECTS(area->cell_size == cell_size);
    area_ = window_of(*area);
  }
}

CellWindow TileMap::cells_of(Cell tile) const {
  return area_ ? intersection(cells_of_tile(tile), *area_) : cells_of_tile(tile);
}

void TileMap::load(const CellWindow& window, Grid<std::int8_t>& scratch) const {
  const CellWindow wanted = area_ ? intersection(window, *area_) : window;
  scratch.reshape(wanted.frame(cell_size_));
  const auto stride = static_cast<std::size_t>(wanted.width());
  for_each_tile(tiles_of(wanted), [&](Cell place) {
    const CellWindow whole = cells_of_tile(place), part = intersection(whole, wanted);
    std::int8_t* to = scratch.values().data() + offset(wanted, part.min);
    if (const Tile* tile = directory_.find(place)) {
      directory_.store().decoded().with(*tile, [&](const std::int8_t* cells) {
        copy_rows(cells + offset(whole, part.min), kTileSide, to, stride, part.width(), part.height());
      });
    } else {
      clear_rows(to, stride, part.width(), part.height());
    }
  });
}

void TileMap::commit(const Grid<std::int8_t>& scratch, const CellWindow& changed) {
  const CellWindow loaded = window_of(scratch.frame());
  const auto stride = static_cast<std::size_t>(loaded.width());
  TileStore& store = directory_.store();
  directory_.update(tiles_of(changed), [&](Cell place, const Tile* before) -> const Tile* {
    const CellWindow whole = cells_of_tile(place), part = intersection(whole, loaded);
    TileCells fresh;
    bool same = false;
    const auto take_over = [&](const std::int8_t* cells) {
      if (part != whole) std::memcpy(fresh.levels.data(), cells, kTileCells);
      copy_rows(scratch.values().data() + offset(loaded, part.min), stride,
                fresh.levels.data() + offset(whole, part.min), kTileSide, part.width(), part.height());
      store.simplify(fresh);
      same = std::memcmp(fresh.levels.data(), cells, kTileCells) == 0;
    };
    if (before != nullptr) {
      store.decoded().with(*before, take_over);
    } else {
      static constexpr std::int8_t kUnknown[kTileCells] = {};
      take_over(kUnknown);
    }
    return same ? before : store.make(fresh);
  });
}

CellWindow TileMap::extent() const {
  CellWindow extent;
  directory_.for_each([&](Cell place, const Tile&) {
    const CellWindow cells = cells_of(place);
    extent.include(cells.min);
    extent.include(cells.max);
  });
  return extent;
}

void TileMap::add_to(Hash& hash) const {
  Grid<std::int8_t> cells;
  for_each_tile(tiles_of(extent()), [&](Cell place) {
    if (directory_.find(place) == nullptr) return;
    load(cells_of(place), cells);
    hash.add(place.x).add(place.y).add(std::span<const std::int8_t>(cells.values()));
  });
}

}  // namespace cogslam
