#include "eval/lab/run_length.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

#include "core/check.hpp"

namespace cogslam {
namespace {

constexpr std::size_t kRunBytes = sizeof(std::uint16_t) + sizeof(float);

bool same(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }

}  // namespace

std::string run_length_encoded(const std::vector<float>& values) {
  std::string bytes;
  for (std::size_t i = 0; i < values.size();) {
    std::uint16_t length = 0;
    const float value = values[i];
    while (i < values.size() && same(values[i], value) && length < std::numeric_limits<std::uint16_t>::max()) {
      ++i;
      ++length;
    }
    bytes.append(reinterpret_cast<const char*>(&length), sizeof length);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  return bytes;
}

std::vector<float> run_length_decoded(std::string_view bytes) {
  EXPECTS(bytes.size() % kRunBytes == 0);
  std::vector<float> values;
  for (std::size_t at = 0; at < bytes.size(); at += kRunBytes) {
    std::uint16_t length = 0;
    float value = 0.0F;
    std::memcpy(&length, bytes.data() + at, sizeof length);
    std::memcpy(&value, bytes.data() + at + sizeof length, sizeof value);
    values.insert(values.end(), length, value);
  }
  return values;
}

}  // namespace cogslam
