#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

#include "slam/codec/tile_cells.hpp"
#include "slam/map/memory_meter.hpp"

namespace cogslam {

/// How the cells of a tile are written down.
enum class TileCoding : std::uint8_t {
  kUniform,       ///< one byte: the level of all cells
  kNibbles,       ///< nibble_code.hpp, fast: levels -5 to 8
  kBytes,         ///< byte_code.hpp, fast: any level
  kCoarse,        ///< coarse_cells.hpp: a coarsened tile, levels -5 to 8
  kContexts,      ///< context_code.hpp, dense: levels -5 to 8
  kContextBytes,  ///< context_code.hpp, dense: any level
};
inline bool is_fast(TileCoding coding) { return coding == TileCoding::kNibbles || coding == TileCoding::kBytes; }

/// A coded tile, not changed once made, in one piece of memory: this header with the code behind it. Made and returned
/// by a TileStore; maps share it by count.
class Tile {
 public:
  Tile(TileCoding coding, std::span<const std::uint8_t> code, std::uint16_t born);

  [[nodiscard]] std::span<const std::uint8_t> code() const { return {bytes(), size_}; }
  [[nodiscard]] TileCoding coding() const { return coding_; }
  /// What it takes from the heap [bytes].
  [[nodiscard]] std::int64_t memory() const { return heap_bytes(sizeof(Tile) + size_); }
  /// False for a code that is not what was written: its sum or its own rules do not hold.
  [[nodiscard]] bool decode(TileCells& cells) const;

 private:
  friend class TileStore;
  [[nodiscard]] const std::uint8_t* bytes() const { return reinterpret_cast<const std::uint8_t*>(this + 1); }

  mutable std::atomic<std::uint32_t> owners_{1};
  std::uint16_t check_;  ///< sum over the code
  std::uint16_t size_;   ///< of the code [bytes]
  std::uint16_t born_;   ///< the registered scan that made it, modulo 2^16
  TileCoding coding_;
  mutable bool kept_fast_ = false;  ///< its dense code was tried and saves nothing
};

/// The sum that is kept beside a code. One changed bit always changes it, other damage but for one chance in 2^16.
std::uint16_t check_sum(std::span<const std::uint8_t> code);

}  // namespace cogslam
