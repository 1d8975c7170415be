#include "eval/sweep/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/angle.hpp"
#include "core/number_text.hpp"
#include "eval/report/aligned.hpp"

namespace cogslam {
namespace {

constexpr std::array kFigures{
    "path_mse_m2",          "heading_mse_rad2", "path_mse_final_m2", "path_mse_vs_baseline_m2",
    "ate_rmse_m",           "rpe_trans_m",      "grid_mse",          "grid_mse_all",
    "grid_mse_logodds",     "grid_log_score",   "payload_bytes",     "bytes",
    "grid_mse_vs_baseline", "bytes_peak",       "resamplings",
};

/// The rows of a variant, by their seed.
using BySeed = std::map<std::int64_t, std::size_t>;
using Group = std::tuple<std::string, double, std::string>;  ///< world, cell size, variant

Group group_of(const EpisodeTable& table, std::size_t row, const std::string& variant_column) {
  return {table.text(row, "world"), table.number(row, "cell_size_m").value_or(0.0), table.text(row, variant_column)};
}

std::optional<FigureSummary> summarize_figure(const EpisodeTable& table, const std::string& figure, const BySeed& rows,
                                              const BySeed* baseline) {
  std::vector<double> values, paired, references;
  for (const auto& [seed, row] : rows) {
    const auto value = table.number(row, figure);
    if (!value) continue;
    values.push_back(*value);
    const auto other = baseline == nullptr ? BySeed::const_iterator{} : baseline->find(seed);
    if (baseline == nullptr || other == baseline->end()) continue;
    if (const auto reference = table.number(other->second, figure)) {
      paired.push_back(*value);
      references.push_back(*reference);
    }
  }
  if (values.empty()) return std::nullopt;
  FigureSummary summary{.figure = figure, .mean = mean_interval(values)};
  if (!paired.empty()) summary.against_baseline = compare_pairs(paired, references);
  return summary;
}

std::string number_or_empty(const std::optional<double>& value) { return value ? number_text(*value) : ""; }

/// "0.0152 +- 0.0004"; a single value tells no spread.
std::string interval_text(const MeanInterval& interval, double unit, const char* format) {
  const std::string mean = fmt::format(fmt::runtime(format), unit * interval.mean);
  if (interval.count < 2) return mean;
  return mean + " +- " + fmt::format(fmt::runtime(format), unit * interval.half_width);
}

struct ShownFigure {
  const char* figure;
  const char* title;
  double unit;
  const char* format;
};

constexpr std::array kShown{ShownFigure{"path_mse_m2", "path MSE cm2", 1e4, "{:.3f}"},
                            ShownFigure{"grid_mse", "grid MSE", 1.0, "{:.4f}"},
                            ShownFigure{"bytes", "bytes", 1.0, "{:.0f}"}};

void add_shown(const FigureSummary* figure, const ShownFigure& shown, std::vector<std::string>& row) {
  row.push_back(figure == nullptr ? "-" : interval_text(figure->mean, shown.unit, shown.format));
  const bool paired = figure != nullptr && figure->against_baseline;
  row.push_back(paired ? interval_text(figure->against_baseline->difference, shown.unit, shown.format) : "-");
  const auto correlation = paired ? figure->against_baseline->correlation : std::nullopt;
  row.push_back(correlation ? fmt::format("{:.2f}", *correlation) : "-");
}

}  // namespace

const FigureSummary* VariantSummary::find(const std::string& figure) const {
  const auto at = std::find_if(figures.begin(), figures.end(), [&](const auto& f) { return f.figure == figure; });
  return at == figures.end() ? nullptr : &*at;
}

std::vector<VariantSummary> summarize(const EpisodeTable& table) {
  std::map<Group, BySeed> groups;
  std::vector<std::size_t> first_rows;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    BySeed& seeds = groups[group_of(table, row, "variant")];
    if (seeds.empty()) first_rows.push_back(row);
    seeds.emplace(static_cast<std::int64_t>(table.number(row, "seed").value_or(0.0)), row);
  }
  std::vector<VariantSummary> summaries;
  for (const std::size_t row : first_rows) {
    const BySeed& rows = groups.at(group_of(table, row, "variant"));
    const auto baseline = groups.find(group_of(table, row, "baseline"));
    VariantSummary& summary = summaries.emplace_back();
    std::tie(summary.world, summary.cell_size, summary.variant) = group_of(table, row, "variant");
    summary.baseline = table.text(row, "baseline");
    summary.count = rows.size();
    for (const char* figure : kFigures) {
      const BySeed* references = baseline == groups.end() ? nullptr : &baseline->second;
      if (auto found = summarize_figure(table, figure, rows, references)) summary.figures.push_back(std::move(*found));
    }
  }
  return summaries;
}

std::string summary_csv(const std::vector<VariantSummary>& summary) {
  std::string out =
      "world,cell_size_m,variant,baseline,figure,n,mean,half_width_95,n_pairs,difference,difference_half_width_95,"
      "bootstrap_low_95,bootstrap_high_95,pair_correlation\n";
  for (const VariantSummary& variant : summary) {
    for (const FigureSummary& figure : variant.figures) {
      const bool spread = figure.mean.count > 1;
      out += fmt::format("{},{},{},{},{},{},{},{}", variant.world, number_text(variant.cell_size), variant.variant,
                         variant.baseline, figure.figure, figure.mean.count, number_text(figure.mean.mean),
                         spread ? number_text(figure.mean.half_width) : "");
      if (const auto& pairs = figure.against_baseline) {
        const bool pairs_spread = pairs->difference.count > 1;
        out += fmt::format(",{},{},{},{},{},{}\n", pairs->difference.count, number_text(pairs->difference.mean),
                           pairs_spread ? number_text(pairs->difference.half_width) : "",
                           pairs_spread ? number_text(pairs->bootstrap.low) : "",
                           pairs_spread ? number_text(pairs->bootstrap.high) : "", number_or_empty(pairs->correlation));
      } else {
        out += ",0,,,,,\n";
      }
    }
  }
  return out;
}

std::string summary_table(const std::vector<VariantSummary>& summary) {
  std::vector<std::vector<std::string>> rows{{"variant", "world", "cell m", "n", "baseline"}};
  for (const ShownFigure& shown : kShown) {
    rows.front().insert(rows.front().end(), {shown.title, "- baseline", "corr"});
  }
  for (const VariantSummary& variant : summary) {
    std::vector<std::string>& row = rows.emplace_back();
    row = {variant.variant, variant.world, fmt::format("{}", variant.cell_size), fmt::format("{}", variant.count),
           variant.baseline.empty() ? "-" : variant.baseline};
    for (const ShownFigure& shown : kShown) add_shown(variant.find(shown.figure), shown, row);
  }
  return aligned(rows) +
         "mean +- 95 % interval over n seeds (Student's t); - baseline: mean difference on the same "
         "readings; corr: of the pairs\n";
}

}  // namespace cogslam
