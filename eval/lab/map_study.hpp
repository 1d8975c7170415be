#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/grid.hpp"
#include "eval/lab/seeds.hpp"
#include "slam/codec/compressor.hpp"
#include "slam/recover/recovery.hpp"

namespace cogslam {

/// A map of log-odds through basis x compressor x recovery, at several percentages of data.
struct MapStudy {
  std::vector<BasisKind> bases{BasisKind::kHaar};
  std::vector<CompressorKind> compressors{CompressorKind::kTopM};
  std::vector<std::string> recoveries{"fast_l2"};  ///< of kRecoveryNames
  std::vector<double> percents;                    ///< in (0, 100], of the cells of the map
  std::uint32_t seed = 1;                          ///< of random compressors
};

/// One combination. Measurements are stored as floats, so MSE includes their rounding.
struct MapScore {
  std::string basis, compressor, recovery;
  double percent = 0.0;
  std::size_t m = 0;                     ///< measurements kept; fewer where there are fewer non-zero coefficients
  std::optional<std::string> not_valid;  ///< why this combination does not exist; then nothing below is measured
  double mse_log_odds = 0.0;
  double mse_probability = 0.0;
  bool converged = false;
  double compress_ms = 0.0;  ///< CPU: basis and measurement
  double recover_ms = 0.0;   ///< CPU: recovery and inverse basis
  /// Values as floats and their positions in each coding; of a random compressor the seed (4 bytes) stands for the
  /// positions. Nothing where a coding cannot count so far.
  std::optional<std::size_t> bytes_u32, bytes_u16, bytes_bitmap;
};

/// Every combination in the order basis, compressor, recovery, percent. InputError for an unknown recovery.
std::vector<MapScore> run_map_study(const MapStudy& study, const Grid<float>& map, Workers& workers,
                                    const LabProgress& progress);

/// Log-odds and probability MSE of two maps of one frame.
struct MapMse {
  double log_odds = 0.0;
  double probability = 0.0;
};
MapMse map_mse(const Grid<float>& truth, const Grid<float>& estimate);

}  // namespace cogslam
