#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cogslam {

/// A map as the coefficients that were kept (Alg. 7): y of eq. (15) and the rows of the selection matrix H.
struct CoefficientCode {
  std::vector<std::uint32_t> indices;  ///< positions among the coefficients, ascending, each once
  std::vector<float> values;           ///< the coefficient at each position

  [[nodiscard]] std::size_t size() const { return indices.size(); }
  bool operator==(const CoefficientCode&) const = default;
};

/// Fast l2 reconstruction (Alg. 8): c = H^+ y = H^T y (eq. 69) is zeros with the kept values in their places.
/// `coefficients` has the size that was encoded; all of it is written.
void reconstruct_fast_l2(const CoefficientCode& code, std::span<float> coefficients);

/// How the positions of the kept coefficients are written down.
enum class IndexCoding {
  kU32,     ///< 4 bytes each, the plain form, as CoefficientCode
  kU16,     ///< 2 bytes each; for at most 65536 positions
  kBitmap,  ///< one bit per position
};

/// Bytes of `kept` float values and their positions among `positions` possible ones (HaarCanvas::support() or size());
/// nothing where the coding cannot count that far.
std::optional<std::size_t> payload_bytes(std::size_t kept, std::size_t positions, IndexCoding coding);

struct Payload {
  IndexCoding coding{};
  std::size_t bytes = 0;

  bool operator==(const Payload&) const = default;
};

/// The coding with the fewest bytes; of equals, the one listed first in IndexCoding.
Payload cheapest_payload(std::size_t kept, std::size_t positions);

}  // namespace cogslam
