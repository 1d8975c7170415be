#include "slam/map/tile_directory.hpp"

#include <array>
#include <bit>
#include <new>
#include <utility>

#include "core/check.hpp"

namespace cogslam {
namespace {

constexpr int kPlaces = 16;
constexpr int kMostLevels = 14;  // 4^14 tiles of 32 cells along a side: more than an int counts
// Added to tile coordinates: not negative any more, and tile 0 lies inside the squares of all levels, not at a border.
constexpr std::uint32_t kOrigin = 0x15555555;

std::uint32_t biased(int tile) { return static_cast<std::uint32_t>(tile) + kOrigin; }
int unbiased(std::uint32_t tile) { return static_cast<int>(tile - kOrigin); }

using Places = std::array<const void*, kPlaces>;

const void* const* children(const TileNode& node) { return reinterpret_cast<const void* const*>(&node + 1); }
std::size_t memory_for(int count) { return sizeof(TileNode) + static_cast<std::size_t>(count) * sizeof(void*); }

const void* child_at(const TileNode& node, int place) {
  const auto bit = static_cast<std::uint16_t>(1U << place);
  if ((node.held & bit) == 0) return nullptr;
  return children(node)[std::popcount(static_cast<std::uint16_t>(node.held & (bit - 1)))];
}

Places places_of(const TileNode* node) {
  Places places{};
  if (node == nullptr) return places;
  const void* const* child = children(*node);
  for (std::uint32_t held = node->held; held != 0; held &= held - 1) {
    places[static_cast<std::size_t>(std::countr_zero(held))] = *child++;
  }
  return places;
}

/// A node of these children, which it takes over; nullptr where there are none.
const TileNode* make_node(const Places& places, MemoryMeter& meter) {
  std::uint16_t held = 0;
  for (int i = 0; i < kPlaces; ++i) {
    if (places[static_cast<std::size_t>(i)] != nullptr) held |= static_cast<std::uint16_t>(1U << i);
  }
  if (held == 0) return nullptr;
  const std::size_t bytes = memory_for(std::popcount(held));
  auto* node = new (::operator new(bytes)) TileNode{.held = held};
  auto* child = reinterpret_cast<const void**>(node + 1);
  for (const void* place : places) {
    if (place != nullptr) *child++ = place;
  }
  meter.add(0, heap_bytes(bytes));
  return node;
}

void release(const TileNode* node, int level, TileStore& store) {
  if (node == nullptr || node->owners.fetch_sub(1, std::memory_order_acq_rel) > 1) return;
  const int count = std::popcount(node->held);
  for (int i = 0; i < count; ++i) {
    const void* child = children(*node)[i];
    if (level == 1) {
      store.release(*static_cast<const Tile*>(child));
    } else {
      release(static_cast<const TileNode*>(child), level - 1, store);
    }
  }
  store.meter().add(0, -heap_bytes(memory_for(count)));
  node->~TileNode();
  ::operator delete(const_cast<TileNode*>(node));
}

void retain(const void* child, int level, TileStore& store) {
  if (level == 1) {
    store.retain(*static_cast<const Tile*>(child));
  } else {
    static_cast<const TileNode*>(child)->owners.fetch_add(1, std::memory_order_relaxed);
  }
}

/// One update of a tree.
struct Update {
  TileStore& store;
  std::uint32_t x0, y0, x1, y1;  ///< the window, in biased tile coordinates, both ends included
  const TileDirectory::Change& change;

  /// What becomes of square (x, y) of a level: `before` itself, or another one (nullptr: nothing left) with an owner.
  const void* square(const void* before, int level, std::uint32_t x, std::uint32_t y) {
    if (level == 0) return change({unbiased(x), unbiased(y)}, static_cast<const Tile*>(before));
    const int shift = 2 * (level - 1);
    Places places = places_of(static_cast<const TileNode*>(before));
    std::uint32_t changed = 0;
    for (std::uint32_t place = 0; place < kPlaces; ++place) {
      const std::uint32_t child_x = 4 * x + place % 4, child_y = 4 * y + place / 4;
      if (child_x < x0 >> shift || child_x > x1 >> shift || child_y < y0 >> shift || child_y > y1 >> shift) continue;
      const void* after = square(places[place], level - 1, child_x, child_y);
      if (after == places[place]) continue;
      places[place] = after;
      changed |= 1U << place;
    }
    if (changed == 0) return before;
    for (std::uint32_t place = 0; place < kPlaces; ++place) {
      if ((changed >> place & 1U) == 0 && places[place] != nullptr) retain(places[place], level, store);
    }
    return make_node(places, store.meter());
  }
};

/// Returns true where nothing below can ever be idle again. Its children are const for everybody else.
bool seal_idle_below(const TileNode& node, int level, TileStore& store) {
  if (node.swept == TileNode::kAllSealed) return true;
  if (node.swept == store.sealing()) return false;
  bool all = true;
  auto* child = reinterpret_cast<const void**>(const_cast<TileNode*>(&node) + 1);
  for (int i = 0; i < std::popcount(node.held); ++i, ++child) {
    if (level > 1) {
      all &= seal_idle_below(*static_cast<const TileNode*>(*child), level - 1, store);
      continue;
    }
    const auto* tile = static_cast<const Tile*>(*child);
    if (store.is_idle(*tile)) {
      *child = store.sealed(*tile);
      if (*child != tile) store.release(*tile);
    }
    all &= store.is_settled(*static_cast<const Tile*>(*child));
  }
  node.swept = all ? TileNode::kAllSealed : store.sealing();
  return all;
}

void visit_pieces(const TileNode& node, int level, const TileDirectory::VisitMemory& visit) {
  const int count = std::popcount(node.held);
  visit(&node, 0, heap_bytes(memory_for(count)));
  for (int i = 0; i < count; ++i) {
    if (level > 1) {
      visit_pieces(*static_cast<const TileNode*>(children(node)[i]), level - 1, visit);
    } else if (const auto& tile = *static_cast<const Tile*>(children(node)[i]); tile.coding() != TileCoding::kUniform) {
      visit(&tile, static_cast<std::int64_t>(tile.code().size()), tile.memory());
    }
  }
}

void visit_square(const void* square, int level, std::uint32_t x, std::uint32_t y, const TileDirectory::Visit& visit) {
  if (square == nullptr) return;
  if (level == 0) {
    visit({unbiased(x), unbiased(y)}, *static_cast<const Tile*>(square));
    return;
  }
  for (std::uint32_t place = 0; place < kPlaces; ++place) {
    visit_square(child_at(*static_cast<const TileNode*>(square), static_cast<int>(place)), level - 1, 4 * x + place % 4,
                 4 * y + place / 4, visit);
  }
}

}  // namespace

TileDirectory::TileDirectory(const TileDirectory& other)
    : store_(other.store_), root_(other.root_), levels_(other.levels_), root_x_(other.root_x_), root_y_(other.root_y_) {
  if (root_ != nullptr) root_->owners.fetch_add(1, std::memory_order_relaxed);
}

TileDirectory::~TileDirectory() {
  if (root_ != nullptr) release(root_, levels_, *store_);
}

void TileDirectory::swap(TileDirectory& other) noexcept {
  std::swap(store_, other.store_);
  std::swap(root_, other.root_);
  std::swap(levels_, other.levels_);
  std::swap(root_x_, other.root_x_);
  std::swap(root_y_, other.root_y_);
}

const Tile* TileDirectory::find(Cell tile) const {
  const std::uint32_t x = biased(tile.x), y = biased(tile.y);
  if (root_ == nullptr || x >> 2 * levels_ != root_x_ || y >> 2 * levels_ != root_y_) return nullptr;
  const void* square = root_;
  for (int level = levels_; level > 0 && square != nullptr; --level) {
    const int shift = 2 * (level - 1);
    const std::uint32_t place = (y >> shift & 3U) << 2 | (x >> shift & 3U);
    square = child_at(*static_cast<const TileNode*>(square), static_cast<int>(place));
  }
  return static_cast<const Tile*>(square);
}

void TileDirectory::grow_to(const CellWindow& tiles) {
  if (root_ == nullptr) {
    levels_ = 1;
    root_x_ = biased(tiles.min.x) >> 2;
    root_y_ = biased(tiles.min.y) >> 2;
  }
  const auto covered = [&](Cell tile) {
    return biased(tile.x) >> 2 * levels_ == root_x_ && biased(tile.y) >> 2 * levels_ == root_y_;
  };
  while (!covered(tiles.min) || !covered(tiles.max)) {
    ENSURES(levels_ < kMostLevels);
    if (root_ != nullptr) {
      Places places{};
      places[(root_y_ & 3U) << 2 | (root_x_ & 3U)] = root_;
      root_ = make_node(places, store_->meter());
    }
    ++levels_;
    root_x_ >>= 2;
    root_y_ >>= 2;
  }
}

void TileDirectory::update(const CellWindow& tiles, const Change& change) {
  if (tiles.empty()) return;
  grow_to(tiles);
  Update job{*store_, biased(tiles.min.x), biased(tiles.min.y), biased(tiles.max.x), biased(tiles.max.y), change};
  const auto* after = static_cast<const TileNode*>(job.square(root_, levels_, root_x_, root_y_));
  if (after == root_) return;
  release(root_, levels_, *store_);
  root_ = after;
}

void TileDirectory::seal_idle() {
  if (root_ != nullptr) seal_idle_below(*root_, levels_, *store_);
}

void TileDirectory::for_each_piece(const VisitMemory& visit) const {
  if (root_ != nullptr) visit_pieces(*root_, levels_, visit);
}

void TileDirectory::for_each(const Visit& visit) const { visit_square(root_, levels_, root_x_, root_y_, visit); }

}  // namespace cogslam
