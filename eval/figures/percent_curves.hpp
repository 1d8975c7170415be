#pragma once

#include <string>
#include <vector>

#include "eval/figures/curve.hpp"

namespace cogslam {

/// A way back from kept coefficients, as the rows of a sweep name it, and its curve.
struct RecoveryCurve {
  const char* name;
  const char* compressor;
  const char* recovery;
  int look;
};

inline constexpr RecoveryCurve kTopL2{"l2, top m", "top_m", "fast_l2", 1};
inline constexpr RecoveryCurve kTopCs{"CS, top m", "top_m", "nesta", 2};
inline constexpr RecoveryCurve kHadamardCs{"CS, Hadamard rows", "hadamard", "nesta", 3};

/// % of the coefficients; OG keeps 100.
RowNumber percent_kept();

std::vector<CurveRows> recovery_rows(const EpisodeTable& table, const std::vector<RecoveryCurve>& curves,
                                     bool true_poses);
/// A score over percent_kept().
CurvePanel percent_panel(const std::string& title, const std::string& score, const ChartAxis& y_axis,
                         const std::vector<CurveRows>& curves);
/// OG: one point.
CurveRows og_rows(const EpisodeTable& table, bool true_poses);

}  // namespace cogslam
