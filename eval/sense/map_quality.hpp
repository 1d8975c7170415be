#pragma once

#include <span>
#include <string>

namespace cogslam {

/// How close a recovered field comes to the true one. Values are those of the field, 0 free to 1 occupied; they are
/// compared as they are, not cut to that range. Padding has been cropped before.
///
/// For accuracy and walls both fields are read as classes: free and occupied, parted at 0.5. A field that has cells in
/// (0.25, 0.75) knows "unknown" too, and then the classes free, unknown, occupied are parted at 0.25 and 0.75.
struct MapQuality {
  double relative_error = 0.0;  ///< ||m - mhat||_2 / ||m||_2; of a zero field 0 where mhat is zero too, else infinite
  double psnr_db = 0.0;         ///< 10 log10(1 / MSE): the peak is 1; infinite where nothing differs
  double accuracy = 0.0;        ///< share of cells whose class is right, in [0, 1]
  double wall_precision = 0.0;  ///< share of cells found occupied that are; 1 where none is found
  double wall_recall = 0.0;     ///< share of occupied cells that are found; 1 where there is none
  double wall_f1 = 0.0;  ///< 2 TP / (2 TP + FP + FN) of the class occupied; 1 where there is none and none is found
};

/// `truth` and `estimate`: of one size, at least one cell.
[[nodiscard]] MapQuality map_quality(std::span<const double> truth, std::span<const double> estimate);

/// "error 0.510, PSNR 11.9 dB, accuracy 0.880, wall F1 0.134": the relative one.
[[nodiscard]] std::string quality_line(const MapQuality& quality);

}  // namespace cogslam
