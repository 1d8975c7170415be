#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/grid.hpp"

namespace cogslam {

/// Ways to store a map that owe nothing to a basis: what a transform has to beat. The shape of the map is known to both
/// ends and is not counted. All but kInt8 are lossless.
enum class Yardstick : std::uint8_t {
  kFloat32,    ///< 4 bytes per cell
  kInt8,       ///< a float step, then 1 byte per cell: the value in steps of max |value| / 127, rounded
  kRunLength,  ///< row-major runs of equal values: 2 bytes of length (at most 65535), 4 of value
  kLz4,        ///< the floats as an LZ4 block, at the library's default
  kZstd,       ///< the floats as a zstd frame, level 3 (the library's default)
  kQuadtree,   ///< quarters of equal values pruned; see quadtree.hpp
};

inline constexpr std::array<Yardstick, 6> kYardsticks{Yardstick::kFloat32, Yardstick::kInt8, Yardstick::kRunLength,
                                                      Yardstick::kLz4,     Yardstick::kZstd, Yardstick::kQuadtree};

/// "float32", "int8", "rle", "lz4", "zstd", "quadtree".
std::string_view name_of(Yardstick yardstick);

/// The bytes that stand for a map of at least one cell with finite values.
std::string encode_map(Yardstick yardstick, const Grid<float>& map);

/// The map that `bytes`, made by encode_map, stand for. Bytes that no map of this frame has break the contract.
Grid<float> decode_map(Yardstick yardstick, std::string_view bytes, const GridFrame& frame);

}  // namespace cogslam
