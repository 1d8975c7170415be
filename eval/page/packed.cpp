#include "eval/page/packed.hpp"

#include <zlib.h>

#include <algorithm>
#include <cmath>

#include "core/check.hpp"

namespace cogslam {
namespace {

constexpr double kFarthest = 1 << 30;  // steps

std::int64_t steps(double value, double unit) {
  if (!std::isfinite(value)) return PackedColumns::kMissing;
  return std::llround(std::clamp(value / unit, -kFarthest, kFarthest));
}

void append_zigzag(std::int64_t value, std::string& bytes) {
  auto rest = (static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63);
  while (rest >= 0x80) {
    bytes += static_cast<char>((rest & 0x7F) | 0x80);
    rest >>= 7;
  }
  bytes += static_cast<char>(rest);
}

}  // namespace

std::string base64(std::string_view bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    }
    for (unsigned k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? kDigits[(group >> (18 - 6 * k)) & 0x3F] : '=';
    }
  }
  return text;
}

std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  const int result = compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                               reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_COMPRESSION);
  ENSURES(result == Z_OK);
  out.resize(size);
  return out;
}

void PackedColumns::add(const std::string& name, const std::vector<double>& values, double unit, Packing packing) {
  EXPECTS(unit > 0.0);
  std::int64_t before = 0;
  for (const double value : values) {
    const std::int64_t now = steps(value, unit);
    append_zigzag(packing == Packing::kDifference ? now - before : now, bytes_);
    before = now;
  }
  heads_.push_back({name, values.size(), unit, packing});
}

}  // namespace cogslam
