#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

#include "slam/codec/tile_cells.hpp"

namespace cogslam {

/// How the cells of a tile are written down.
enum class TileCoding : std::uint8_t {
  kUniform,  ///< one byte: the level of all cells
  kNibbles,  ///< nibble_code.hpp: levels -5 to 8
  kBytes,    ///< byte_code.hpp: any level
};

/// A coded tile, not changed once made, in one piece of memory: this header with the code behind it. Made and returned
/// by a TileStore; maps share it by count.
class Tile {
 public:
  Tile(TileCoding coding, std::span<const std::uint8_t> code, std::uint16_t born);

  [[nodiscard]] std::span<const std::uint8_t> code() const { return {bytes(), size_}; }
  [[nodiscard]] TileCoding coding() const { return coding_; }
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
};

/// The sum that is kept beside a code; a changed bit changes it, but for one chance in 2^16.
std::uint16_t check_sum(std::span<const std::uint8_t> code);

}  // namespace cogslam
