#include "slam/codec/coefficient_code.hpp"

#include <algorithm>

#include "core/check.hpp"

namespace cogslam {

void reconstruct_fast_l2(const CoefficientCode& code, std::span<float> coefficients) {
  EXPECTS(code.indices.size() == code.values.size());
  EXPECTS(code.indices.empty() || code.indices.back() < coefficients.size());  // ascending: the last is the largest
  std::fill(coefficients.begin(), coefficients.end(), 0.0F);
  for (std::size_t i = 0; i < code.indices.size(); ++i) {
    coefficients[code.indices[i]] = code.values[i];
  }
}

std::optional<std::size_t> payload_bytes(std::size_t kept, std::size_t positions, IndexCoding coding) {
  EXPECTS(kept <= positions);
  const std::size_t values = kept * sizeof(float);
  switch (coding) {
    case IndexCoding::kU32:
      return positions <= (std::size_t{1} << 32) ? std::optional(values + 4 * kept) : std::nullopt;
    case IndexCoding::kU16:
      return positions <= (std::size_t{1} << 16) ? std::optional(values + 2 * kept) : std::nullopt;
    case IndexCoding::kBitmap:
      return values + (positions + 7) / 8;
  }
  return std::nullopt;
}

Payload cheapest_payload(std::size_t kept, std::size_t positions) {
  Payload best{IndexCoding::kBitmap, *payload_bytes(kept, positions, IndexCoding::kBitmap)};
  for (const IndexCoding coding : {IndexCoding::kU16, IndexCoding::kU32}) {
    const std::optional<std::size_t> bytes = payload_bytes(kept, positions, coding);
    if (bytes && *bytes <= best.bytes) {
      best = {coding, *bytes};
    }
  }
  return best;
}

}  // namespace cogslam
