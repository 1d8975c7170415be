#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/config.hpp"
#include "core/grid_frame.hpp"
#include "slam/codec/basis.hpp"
#include "slam/codec/compressor.hpp"
#include "slam/recover/recovery.hpp"

namespace cogslam {

/// How a map of n cells becomes m numbers and comes back: y = H Phi' m (eqs. 14, 15), c = recovery(H, y), m = Phi c.
///
/// What goes together:
/// | compressor H                    | basis Phi                          | recovery                                |
/// |---------------------------------|------------------------------------|-----------------------------------------|
/// | top_m, selection, gaussian, dct | any                                | any but tv                              |
/// | hadamard, noiselet              | 2^k coefficients: the Haar bases,  | any but tv                              |
/// |                                 | hadamard; the others if n = 2^k    |                                         |
/// | selection                       | identity                           | tv (fills in the map between its cells) |
/// Besides, gaussian and pinv store m x n numbers (at most 2^24), and the csekf kinds n x n (n at most 4096).
///
/// With H picking coefficients (top_m, selection) nothing is known of the others, and the pinv, fast_l2 and nesta
/// (eps = 0) recoveries are all the same: zeros with the kept values in their places.
struct CompressionConfig {
  BasisKind basis = BasisKind::kHaar;
  CompressorKind compressor = CompressorKind::kTopM;
  Recovery recovery = FastL2{};
  std::uint32_t compressor_seed = 1;  ///< of the random rows of H, which all particles share

  /// The combination that the paper chooses, for which there is a fast path (CoefficientMap).
  [[nodiscard]] bool is_papers_choice() const;
};

/// A combination that cannot be: the key that is wrong and a sentence for the user.
struct CompressionTrouble {
  std::string key;
  std::string message;
};

/// What the names alone rule out.
std::optional<CompressionTrouble> trouble_of(const CompressionConfig& config);
/// What a map of width x height cells, of whose coefficients `percent` in (0, 100] are kept, rules out besides.
std::optional<CompressionTrouble> trouble_of(const CompressionConfig& config, double percent, int width, int height);

/// The recovery for a map of that size: total variation needs to know its shape.
Recovery recovery_for(const CompressionConfig& config, int width, int height);

/// Reads the keys `basis`, `compressor`, `compressor_seed`, `recovery`, and those of the recovery's parameters in a
/// section of its own name ("nesta", "csekf", "csekf_p" or "tv").
void read_compression(ConfigSection& section, CompressionConfig& config);

}  // namespace cogslam
