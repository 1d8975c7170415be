#include "eval/lab/quadtree.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "core/check.hpp"

namespace cogslam {
namespace {

struct Square {
  int x, y, side;

  [[nodiscard]] std::array<Square, 4> quarters() const {
    const int half = side / 2;
    return {{{x, y, half}, {x + half, y, half}, {x, y + half, half}, {x + half, y + half, half}}};
  }
  [[nodiscard]] bool outside(const GridFrame& frame) const { return x >= frame.width || y >= frame.height; }
};

Square root_of(const GridFrame& frame) {
  return {0, 0, static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(frame.width, frame.height))))};
}

bool equal_bits(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }

/// Calls visit(cell) for the cells of the map in the square, as long as it says true; returns whether it always did.
template <class Visit>
bool for_cells(const GridFrame& frame, const Square& s, Visit&& visit) {
  for (int y = s.y; y < std::min(s.y + s.side, frame.height); ++y) {
    for (int x = s.x; x < std::min(s.x + s.side, frame.width); ++x) {
      if (!visit(Cell{x, y})) return false;
    }
  }
  return true;
}

class Writer {
 public:
  explicit Writer(const Grid<float>& map) : map_(map) { write(root_of(map.frame())); }
  [[nodiscard]] std::string bytes() const { return bits_ + values_; }

 private:
  void write(const Square& s) {
    if (s.outside(map_.frame())) return;
    const float first = map_[{s.x, s.y}];
    const bool equal = for_cells(map_.frame(), s, [&](Cell c) { return equal_bits(map_[c], first); });
    if (s.side > 1) put(!equal);
    if (equal) {
      values_.append(reinterpret_cast<const char*>(&first), sizeof first);
    } else {
      for (const Square& quarter : s.quarters()) write(quarter);
    }
  }
  void put(bool bit) {
    if (count_ % 8 == 0) bits_ += '\0';
    if (bit) bits_.back() = static_cast<char>(static_cast<unsigned char>(bits_.back()) | 1U << (count_ % 8));
    ++count_;
  }

  const Grid<float>& map_;
  std::string bits_, values_;
  unsigned count_ = 0;
};

/// The squares that have a value, in order; `bits` is used up to `bit`.
void collect_leaves(std::string_view bits, const GridFrame& frame, const Square& s, std::size_t& bit,
                    std::vector<Square>& leaves) {
  if (s.outside(frame)) return;
  bool divided = false;
  if (s.side > 1) {
    EXPECTS(bit / 8 < bits.size());
    divided = (static_cast<unsigned char>(bits[bit / 8]) >> (bit % 8) & 1) != 0;
    ++bit;
  }
  if (!divided) return leaves.push_back(s);
  for (const Square& quarter : s.quarters()) collect_leaves(bits, frame, quarter, bit, leaves);
}

}  // namespace

std::string quadtree_encoded(const Grid<float>& map) { return Writer(map).bytes(); }

std::vector<float> quadtree_decoded(std::string_view bytes, const GridFrame& frame) {
  std::vector<Square> leaves;
  std::size_t bit = 0;
  collect_leaves(bytes, frame, root_of(frame), bit, leaves);
  std::string_view values = bytes.substr((bit + 7) / 8);
  EXPECTS(values.size() == leaves.size() * sizeof(float));
  Grid<float> map(frame);
  for (const Square& leaf : leaves) {
    float value = 0.0F;
    std::memcpy(&value, values.data(), sizeof value);
    values.remove_prefix(sizeof value);
    for_cells(frame, leaf, [&](Cell c) {
      map[c] = value;
      return true;
    });
  }
  return map.values();
}

}  // namespace cogslam
