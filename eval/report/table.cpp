#include "eval/report/table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "core/angle.hpp"
#include "eval/report/aligned.hpp"

namespace cogslam {
namespace {

using Row = std::vector<std::string>;

std::string figure(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

std::string count(const std::optional<std::uint64_t>& value) { return value ? fmt::format("{}", *value) : "-"; }

std::optional<double> root(const std::optional<double>& mse, double unit = 1.0) {
  return mse ? std::optional(unit * std::sqrt(*mse)) : std::nullopt;
}

/// What the map is kept as: the store, or the parts of a compression.
std::string kept_as(const VariantRecord& v) {
  return v.recovery ? fmt::format("{}/{}/{}", v.basis.value_or("-"), v.compressor.value_or("-"), *v.recovery) : v.store;
}

Row score_row(const VariantRecord& v) {
  const Scores& s = v.scores;
  return {v.name,
          fmt::format("{}", v.cell_size_m),
          kept_as(v),
          v.percent_kept ? fmt::format("{}", *v.percent_kept) : "-",
          figure(root(s.path_mse_m2), 4),
          figure(root(s.heading_mse_rad2, degrees(1.0)), 3),
          figure(root(s.odometry_path_mse_m2), 4),
          figure(s.grid_mse, 4),
          figure(s.payload_bytes, 0),
          figure(s.payload_bytes_bitmap, 0),
          figure(s.bytes, 0),
          count(s.bytes_peak),
          figure(v.costs.cpu_ms_per_registered, 2),
          count(s.registered),
          count(s.resamplings)};
}

void add_relations(const VariantRecord& v, const char* path, const std::optional<RelationErrors>& errors,
                   std::vector<Row>& rows) {
  if (!errors) return;
  const std::pair<const char*, RelationStats> splits[] = {
      {"local", errors->local}, {"global", errors->global}, {"all", errors->all}};
  for (const auto& [name, stats] : splits) {
    const auto text = [&, n = stats.count](double value, int digits) {
      return n > 0 ? fmt::format("{:.{}f}", value, digits) : "-";
    };
    rows.push_back({v.name, fmt::format("{}", v.cell_size_m), path, name, fmt::format("{}", stats.count),
                    text(stats.trans_mean, 4), text(stats.trans_std, 4), text(degrees(stats.rot_mean), 2),
                    text(degrees(stats.rot_std), 2)});
  }
}

}  // namespace

std::string score_table(const RunRecord& record) {
  std::vector<Row> rows{{"variant", "cell m", "basis/compressor/recovery", "kept %", "path RMSE m", "heading RMSE deg",
                         "odometry RMSE m", "grid MSE", "payload B", "bitmap B", "all-in B", "peak B", "CPU ms/reg",
                         "registered", "resamplings"}};
  for (const VariantRecord& v : record.variants) rows.push_back(score_row(v));
  return aligned(rows);
}

std::string relations_table(const RunRecord& record) {
  std::vector<Row> rows{
      {"variant", "cell m", "path", "relations", "count", "trans mean m", "std m", "rot mean deg", "std deg"}};
  for (const VariantRecord& v : record.variants) {
    add_relations(v, "online", v.scores.relations_online, rows);
    add_relations(v, "final", v.scores.relations_final, rows);
  }
  return rows.size() > 1 ? aligned(rows) : "";
}

}  // namespace cogslam
