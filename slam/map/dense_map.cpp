#include "slam/map/dense_map.hpp"

#include <algorithm>

#include "core/check.hpp"

namespace cogslam {
namespace {

int floor_div(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

/// The blocks that hold any cell of a window.
CellWindow blocks_of(const CellWindow& cells) {
  if (cells.empty()) return {};
  constexpr int b = DenseMap::kBlock;
  return {{floor_div(cells.min.x, b), floor_div(cells.min.y, b)},
          {floor_div(cells.max.x, b), floor_div(cells.max.y, b)}};
}

template <class Visit>
void for_each_cell(const CellWindow& window, Visit&& visit) {
  for (int y = window.min.y; y <= window.max.y; ++y) {
    for (int x = window.min.x; x <= window.max.x; ++x) visit(Cell{x, y});
  }
}

/// Offset of a lattice cell in the row-major values of a window.
std::size_t offset(const CellWindow& window, Cell c) {
  return static_cast<std::size_t>(c.y - window.min.y) * static_cast<std::size_t>(window.width()) +
         static_cast<std::size_t>(c.x - window.min.x);
}

}  // namespace

template <class T>
BlockMap<T>::Block::Block(std::shared_ptr<MemoryMeter> meter, std::size_t cell_count)
    : counted(std::move(meter), static_cast<std::int64_t>(cell_count * sizeof(T)),
              shared_block_bytes<Block>() + heap_bytes(cell_count * sizeof(T))),
      cells(cell_count, T{}) {}

template <class T>
BlockMap<T>::Directory::Directory(std::shared_ptr<MemoryMeter> meter, const CellWindow& window)
    : counted(
          std::move(meter), 0,
          shared_block_bytes<Directory>() + heap_bytes(static_cast<std::size_t>(window.width()) *
                                                       static_cast<std::size_t>(window.height()) * sizeof(BlockPtr))),
      blocks(window),
      entries(static_cast<std::size_t>(window.width()) * static_cast<std::size_t>(window.height())) {}

template <class T>
std::size_t BlockMap<T>::Directory::index(Cell block) const {
  return offset(blocks, block);
}

template <class T>
BlockMap<T>::BlockMap(double cell_size, std::optional<GridFrame> area, std::shared_ptr<MemoryMeter> meter)
    : cell_size_(cell_size), meter_(std::move(meter)), directory_(std::make_shared<Directory>(meter_, CellWindow{})) {
  if (area) {
    EXPECTS(area->cell_size == cell_size);
    area_ = window_of(*area);
  }
}

template <class T>
CellWindow BlockMap<T>::cells_of(Cell block) const {
  const Cell low{block.x * kBlock, block.y * kBlock};
  const CellWindow whole{low, {low.x + kBlock - 1, low.y + kBlock - 1}};
  return area_ ? intersection(whole, *area_) : whole;
}

template <class T>
typename BlockMap<T>::BlockPtr BlockMap<T>::block_at(Cell block) const {
  const CellWindow& held = directory_->blocks;
  const bool inside = block.x >= held.min.x && block.x <= held.max.x && block.y >= held.min.y && block.y <= held.max.y;
  return inside ? directory_->entries[directory_->index(block)] : nullptr;
}

template <class T>
void BlockMap<T>::load(const CellWindow& window, Grid<T>& scratch) const {
  const CellWindow wanted = area_ ? intersection(window, *area_) : window;
  scratch.reset(wanted.frame(cell_size_), T{});
  for_each_cell(intersection(blocks_of(wanted), directory_->blocks), [&](Cell block) {
    const BlockPtr& held = directory_->entries[directory_->index(block)];
    if (!held) return;
    const CellWindow cells = cells_of(block);
    const CellWindow part = intersection(cells, wanted);
    for (int y = part.min.y; y <= part.max.y; ++y) {
      std::copy_n(held->cells.data() + offset(cells, {part.min.x, y}), part.width(),
                  scratch.values().data() + offset(wanted, {part.min.x, y}));
    }
  });
}

template <class T>
typename BlockMap<T>::BlockPtr BlockMap<T>::written(Cell block, const Grid<T>& scratch,
                                                    const CellWindow& changed) const {
  const BlockPtr before = block_at(block);
  const CellWindow cells = cells_of(block);
  const CellWindow part = intersection(cells, changed);
  const CellWindow loaded = window_of(scratch.frame());
  bool same = true;
  for (int y = part.min.y; y <= part.max.y && same; ++y) {
    const T* fresh = scratch.values().data() + offset(loaded, {part.min.x, y});
    const std::size_t at = offset(cells, {part.min.x, y});
    same = before ? std::equal(fresh, fresh + part.width(), before->cells.data() + at)
                  : std::all_of(fresh, fresh + part.width(), [](T v) { return v == T{}; });
  }
  if (same) return before;
  auto after = std::make_shared<Block>(
      meter_, static_cast<std::size_t>(cells.width()) * static_cast<std::size_t>(cells.height()));
  if (before) after->cells = before->cells;
  for (int y = part.min.y; y <= part.max.y; ++y) {
    std::copy_n(scratch.values().data() + offset(loaded, {part.min.x, y}), part.width(),
                after->cells.data() + offset(cells, {part.min.x, y}));
  }
  const bool unknown = std::all_of(after->cells.begin(), after->cells.end(), [](T v) { return v == T{}; });
  return unknown ? nullptr : BlockPtr(std::move(after));
}

template <class T>
void BlockMap<T>::commit(const Grid<T>& scratch, const CellWindow& changed) {
  if (changed.empty()) return;
  const CellWindow touched = blocks_of(changed);
  CellWindow held = directory_->blocks;
  held.include(touched.min);
  held.include(touched.max);
  // A new directory in every case: particles that share the old one may be reading it in another thread.
  auto next = std::make_shared<Directory>(meter_, held);
  for_each_cell(directory_->blocks,
                [&](Cell block) { next->entries[next->index(block)] = directory_->entries[directory_->index(block)]; });
  for_each_cell(touched, [&](Cell block) { next->entries[next->index(block)] = written(block, scratch, changed); });
  directory_ = std::move(next);
}

template <class T>
CellWindow BlockMap<T>::extent() const {
  CellWindow extent;
  for_each_cell(directory_->blocks, [&](Cell block) {
    if (!directory_->entries[directory_->index(block)]) return;
    const CellWindow cells = cells_of(block);
    extent.include(cells.min);
    extent.include(cells.max);
  });
  return extent;
}

template <class T>
void BlockMap<T>::add_to(Hash& hash) const {
  for_each_cell(directory_->blocks, [&](Cell block) {
    const BlockPtr& held = directory_->entries[directory_->index(block)];
    if (!held) return;
    hash.add(block.x).add(block.y).add(std::span<const T>(held->cells));
  });
}

template class BlockMap<float>;
template class BlockMap<std::int8_t>;

}  // namespace cogslam
