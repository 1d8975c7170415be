#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eval/stats.hpp"
#include "eval/sweep/database.hpp"

namespace cogslam {

/// A figure of one variant over all seeds, alone and against its baseline on the same readings.
struct FigureSummary {
  std::string figure;  ///< column of the table
  MeanInterval mean{};
  std::optional<PairedComparison> against_baseline;  ///< over the seeds for which both are there
};

/// One variant in one world at one cell size.
struct VariantSummary {
  std::string world;
  double cell_size = 0.0;
  std::string variant;
  std::string baseline;  ///< empty: none
  std::size_t count = 0;
  std::vector<FigureSummary> figures;  ///< those that were measured at all

  [[nodiscard]] const FigureSummary* find(const std::string& figure) const;
};

/// In the order of the rows. Deterministic: figures are scores, no costs.
std::vector<VariantSummary> summarize(const EpisodeTable& table);

std::string summary_csv(const std::vector<VariantSummary>& summary);
/// For people: path, map and bytes, each with its interval, what compression changes, and n.
std::string summary_table(const std::vector<VariantSummary>& summary);

}  // namespace cogslam
