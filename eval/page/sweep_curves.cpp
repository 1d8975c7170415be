#include "eval/page/sweep_curves.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "eval/page/score_words.hpp"
#include "eval/report/chart.hpp"

namespace cogslam {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kFigures{"path_mse_m2",   "grid_mse", "path_mse_vs_baseline_m2", "grid_mse_vs_baseline",
                              "payload_bytes", "bytes",    "heading_mse_rad2",        "grid_mse_logodds"};

Json number_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

/// A summary with one of its rows: all of them have the same configuration.
struct Variant {
  const VariantSummary* summary;
  std::size_t row;
};

std::vector<Variant> variants_of(const SweepPageData& data) {
  std::map<std::tuple<std::string, double, std::string>, std::size_t> rows;
  for (std::size_t row = 0; row < data.table.rows.size(); ++row) {
    rows.emplace(std::tuple(data.table.text(row, "world"), data.table.number(row, "cell_size_m").value_or(0.0),
                            data.table.text(row, "variant")),
                 row);
  }
  std::vector<Variant> variants;
  for (const VariantSummary& v : data.summary) {
    variants.push_back({&v, rows.at(std::tuple(v.world, v.cell_size, v.variant))});
  }
  return variants;
}

Json values_of(const VariantSummary& variant) {
  Json values = Json::object();
  for (const FigureSummary& figure : variant.figures) {
    values[figure.figure] = {figure.mean.mean, figure.mean.half_width, figure.mean.count};
  }
  return values;
}

std::string title_of(std::string_view figure) {
  const auto words = score_words();
  const auto at = std::find_if(words.begin(), words.end(), [&](const ScoreWords& w) { return w.key == figure; });
  return at == words.end() ? std::string(figure) : std::string(at->name);
}

std::string unit_of(std::string_view figure) {
  const auto words = score_words();
  const auto at = std::find_if(words.begin(), words.end(), [&](const ScoreWords& w) { return w.key == figure; });
  return at == words.end() ? std::string() : std::string(at->unit);
}

/// Variants that differ by the percentage kept alone.
std::string family_of(const EpisodeTable& table, std::size_t row) {
  std::string name = table.text(row, "store");
  for (const char* part : {"basis", "compressor", "recovery"}) {
    if (const std::string text = table.text(row, part); !text.empty()) name += " " + text;
  }
  if (table.number(row, "true_poses") == 1.0) return name + ", true poses";
  return name + " x" + std::to_string(static_cast<int>(table.number(row, "particles").value_or(0.0)));
}

/// x, mean, low, high.
using Sample = std::array<double, 4>;

Series series_of(const std::string& name, std::vector<Sample> samples) {
  std::sort(samples.begin(), samples.end());
  Series series{.name = name};
  for (const auto& [x, mean, low, high] : samples) {
    series.x.push_back(x);
    series.y.push_back(mean);
    series.low.push_back(low);
    series.high.push_back(high);
  }
  return series;
}

/// The variants of the first world at its finest cell size.
std::vector<Variant> first_group(const SweepPageData& data) {
  std::vector<Variant> group = variants_of(data);
  const std::string world = data.summary.front().world;
  std::erase_if(group, [&](const Variant& v) { return v.summary->world != world; });
  double finest = data.summary.front().cell_size;
  for (const Variant& v : group) finest = std::min(finest, v.summary->cell_size);
  std::erase_if(group, [&](const Variant& v) { return v.summary->cell_size != finest; });
  return group;
}

Chart chart_of(const SweepPageData& data, const std::vector<Variant>& group, const std::string& figure,
               bool by_percent) {
  Chart chart{.title = title_of(figure),
              .x = {.label = by_percent ? "coefficients kept [%]" : "all bytes per particle"},
              .y = {.label = unit_of(figure), .min = 0.0}};
  std::map<std::string, std::vector<Sample>> families;
  for (const auto& [summary, row] : group) {
    const FigureSummary *value = summary->find(figure), *bytes = summary->find("bytes");
    const auto percent = data.table.number(row, "percent_kept");
    if (value == nullptr || (by_percent ? !percent : bytes == nullptr)) continue;
    families[family_of(data.table, row)].push_back(
        {by_percent ? *percent : bytes->mean.mean, value->mean.mean, value->mean.low(), value->mean.high()});
  }
  for (auto& [name, samples] : families) chart.series.push_back(series_of(name, std::move(samples)));
  return chart;
}

}  // namespace

std::string sweep_curves_json(const SweepPageData& data) {
  Json figures = Json::array(), points = Json::array();
  for (const char* figure : kFigures) {
    figures.push_back({{"key", figure}, {"name", title_of(figure)}, {"unit", unit_of(figure)}});
  }
  for (const auto& [summary, row] : variants_of(data)) {
    points.push_back({{"world", summary->world},
                      {"cell_size_m", summary->cell_size},
                      {"variant", summary->variant},
                      {"family", family_of(data.table, row)},
                      {"percent_kept", number_or_null(data.table.number(row, "percent_kept"))},
                      {"particles", number_or_null(data.table.number(row, "particles"))},
                      {"values", values_of(*summary)}});
  }
  return Json{{"figures", figures}, {"points", points}}.dump();
}

std::string sweep_curves_svg(const SweepPageData& data) {
  if (data.summary.empty()) return {};
  const std::vector<Variant> group = first_group(data);
  const bool by_percent = std::any_of(group.begin(), group.end(), [&](const Variant& v) {
    return data.table.number(v.row, "percent_kept").has_value();
  });
  ChartSheet sheet{.heading = data.summary.front().world, .columns = 2};
  for (const char* figure : {"path_mse_m2", "grid_mse", "grid_mse_vs_baseline", "bytes"}) {
    Chart chart = chart_of(data, group, figure, by_percent);
    if (!chart.series.empty()) sheet.charts.push_back(std::move(chart));
  }
  return sheet.charts.empty() ? std::string() : chart_svg(sheet);
}

}  // namespace cogslam
