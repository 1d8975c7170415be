#include "slam/codec/byte_code.hpp"

#include "slam/codec/tile_runs.hpp"

namespace cogslam {
namespace {

constexpr int kLiterals = 64, kBefore = 64, kAbove = 128;
constexpr int kLongestBefore = kShortestRun + 63, kLongestAbove = kShortestRun + 127;

class ByteWriter {
 public:
  explicit ByteWriter(std::uint8_t* to) : start_(to), to_(to) {}
  void run(int kind, int length) {
    *to_++ = static_cast<std::uint8_t>(kind + length - kShortestRun);
    literals_ = nullptr;
  }
  void literal(std::int8_t level) {
    if (literals_ == nullptr || *literals_ == kLiterals - 1) {
      literals_ = to_++;
      *literals_ = 0;
    } else {
      ++*literals_;
    }
    *to_++ = static_cast<std::uint8_t>(level);
  }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(to_ - start_); }

 private:
  std::uint8_t* start_;
  std::uint8_t* to_;
  std::uint8_t* literals_ = nullptr;  ///< the count of those being written
};

}  // namespace

std::size_t encode_bytes(const TileCells& tile, ByteBuffer& code) {
  const TileRepeats repeats(tile);
  ByteWriter out(code.data());
  for (int at = 0; at < kTileCells;) {
    const int above = std::min(repeats.above.run(at), kLongestAbove);
    const int before = std::min(repeats.before.run(at), kLongestBefore);
    if (std::max(above, before) < kShortestRun) {
      out.literal(tile.levels[static_cast<std::size_t>(at++)]);
    } else if (above >= before) {
      out.run(kAbove, above);
      at += above;
    } else {
      out.run(kBefore, before);
      at += before;
    }
  }
  return out.size();
}

bool decode_bytes(std::span<const std::uint8_t> code, TileCells& tile) {
  TileWriter out;
  std::size_t at = 0;
  while (out.left() > 0) {
    if (at == code.size()) return false;
    const int control = code[at++];
    if (control < kLiterals) {
      const std::size_t count = static_cast<std::size_t>(control) + 1;
      if (static_cast<int>(count) > out.left() || count > code.size() - at) return false;
      for (std::size_t i = 0; i < count; ++i) out.put(static_cast<std::int8_t>(code[at++]));
    } else if (control < kAbove) {
      const int count = control - kBefore + kShortestRun;
      if (count > out.left()) return false;
      out.repeat_before(count);
    } else {
      const int count = control - kAbove + kShortestRun;
      if (count > out.left()) return false;
      out.repeat_above(count);
    }
  }
  out.copy_to(tile);
  return at == code.size();
}

}  // namespace cogslam
