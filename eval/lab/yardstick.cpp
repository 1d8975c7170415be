#include "eval/lab/yardstick.hpp"

#include <lz4.h>
#include <zstd.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/check.hpp"
#include "eval/lab/quadtree.hpp"
#include "eval/lab/run_length.hpp"

namespace cogslam {
namespace {

constexpr int kZstdLevel = 3;

std::string_view bytes_of(const std::vector<float>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}

std::string int8_encoded(const std::vector<float>& values) {
  float most = 0.0F;
  for (const float v : values) most = std::max(most, std::abs(v));
  const float step = most > 0.0F ? most / 127.0F : 1.0F;
  std::string bytes(reinterpret_cast<const char*>(&step), sizeof step);
  for (const float v : values) bytes += static_cast<char>(std::lround(v / step));
  return bytes;
}

std::vector<float> int8_decoded(std::string_view bytes) {
  float step = 0.0F;
  EXPECTS(bytes.size() >= sizeof step);
  std::memcpy(&step, bytes.data(), sizeof step);
  std::vector<float> values;
  for (const char c : bytes.substr(sizeof step))
    values.push_back(step * static_cast<float>(static_cast<signed char>(c)));
  return values;
}

std::string lz4_encoded(std::string_view raw) {
  const int size = static_cast<int>(raw.size());
  std::string bytes(static_cast<std::size_t>(LZ4_compressBound(size)), '\0');
  const int written = LZ4_compress_default(raw.data(), bytes.data(), size, static_cast<int>(bytes.size()));
  ENSURES(written > 0);
  bytes.resize(static_cast<std::size_t>(written));
  return bytes;
}

std::string zstd_encoded(std::string_view raw) {
  std::string bytes(ZSTD_compressBound(raw.size()), '\0');
  const std::size_t written = ZSTD_compress(bytes.data(), bytes.size(), raw.data(), raw.size(), kZstdLevel);
  ENSURES(ZSTD_isError(written) == 0);
  bytes.resize(written);
  return bytes;
}

/// The floats that the library's packed bytes hold.
std::vector<float> unpacked(Yardstick yardstick, std::string_view bytes, std::size_t cells) {
  std::vector<float> values(cells);
  const std::size_t raw = cells * sizeof(float);
  auto* out = reinterpret_cast<char*>(values.data());
  if (yardstick == Yardstick::kLz4) {
    const int read = LZ4_decompress_safe(bytes.data(), out, static_cast<int>(bytes.size()), static_cast<int>(raw));
    EXPECTS(read == static_cast<int>(raw));
  } else {
    EXPECTS(ZSTD_decompress(out, raw, bytes.data(), bytes.size()) == raw);
  }
  return values;
}

std::vector<float> decoded(Yardstick yardstick, std::string_view bytes, const GridFrame& frame) {
  switch (yardstick) {
    case Yardstick::kFloat32: {
      std::vector<float> values(frame.size());
      EXPECTS(bytes.size() == values.size() * sizeof(float));
      std::memcpy(values.data(), bytes.data(), bytes.size());
      return values;
    }
    case Yardstick::kInt8:
      return int8_decoded(bytes);
    case Yardstick::kRunLength:
      return run_length_decoded(bytes);
    case Yardstick::kQuadtree:
      return quadtree_decoded(bytes, frame);
    default:
      return unpacked(yardstick, bytes, frame.size());
  }
}

}  // namespace

std::string_view name_of(Yardstick yardstick) {
  constexpr std::array<std::string_view, 6> kNames{"float32", "int8", "rle", "lz4", "zstd", "quadtree"};
  return kNames[static_cast<std::size_t>(yardstick)];
}

std::string encode_map(Yardstick yardstick, const Grid<float>& map) {
  EXPECTS(map.frame().size() > 0 && map.frame().size() < 500'000'000);  // LZ4 counts bytes in an int
  const std::string_view raw = bytes_of(map.values());
  switch (yardstick) {
    case Yardstick::kFloat32:
      return std::string(raw);
    case Yardstick::kInt8:
      return int8_encoded(map.values());
    case Yardstick::kRunLength:
      return run_length_encoded(map.values());
    case Yardstick::kLz4:
      return lz4_encoded(raw);
    case Yardstick::kZstd:
      return zstd_encoded(raw);
    case Yardstick::kQuadtree:
      break;
  }
  return quadtree_encoded(map);
}

Grid<float> decode_map(Yardstick yardstick, std::string_view bytes, const GridFrame& frame) {
  Grid<float> map(frame);
  map.values() = decoded(yardstick, bytes, frame);
  ENSURES(map.values().size() == frame.size());
  return map;
}

}  // namespace cogslam
