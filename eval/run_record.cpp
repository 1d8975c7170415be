#include "eval/run_record.hpp"

#include <nlohmann/json.hpp>

#include "core/angle.hpp"

namespace cogslam {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json relation_stats(const RelationStats& stats) {
  const auto figure = [&](double value) { return stats.count > 0 ? Json(value) : Json(nullptr); };
  return {{"count", stats.count},
          {"trans_mean_m", figure(stats.trans_mean)},
          {"trans_std_m", figure(stats.trans_std)},
          {"rot_mean_deg", figure(degrees(stats.rot_mean))},
          {"rot_std_deg", figure(degrees(stats.rot_std))}};
}

Json relations(const std::optional<RelationErrors>& errors) {
  if (!errors) return nullptr;
  return {{"local", relation_stats(errors->local)},
          {"global", relation_stats(errors->global)},
          {"all", relation_stats(errors->all)},
          {"unmatched", errors->unmatched}};
}

Json confusion(const std::optional<std::array<std::array<std::size_t, 3>, 2>>& counts) {
  if (!counts) return nullptr;
  const auto row = [&](std::size_t truth) -> Json {
    const auto& n = (*counts)[truth];
    return {{"free", n[0]}, {"unknown", n[1]}, {"occupied", n[2]}};
  };
  return {{"truth_free", row(0)}, {"truth_occupied", row(1)}};
}

Json keys(const std::vector<Degradation>& degraded) {
  Json all = Json::array();
  for (const Degradation& degradation : degraded) all.push_back(degradation.key);
  return all;
}

Json health(const std::optional<FilterHealth>& h) {
  if (!h) return nullptr;
  return {{"records", h->records},
          {"scans_missing", h->scans_missing},
          {"blind_scans", h->blind_scans},
          {"repeated_scans", h->repeated_scans},
          {"by_camera", h->by_camera},
          {"by_wheels", h->by_wheels},
          {"odometry_checks", h->odometry_checks},
          {"odometry_doubted", h->odometry_doubted},
          {"headings", h->headings},
          {"headings_doubted", h->headings_doubted},
          {"scans_judged", h->scans_judged},
          {"scans_doubted", h->scans_doubted},
          {"beams_known", h->beams_known},
          {"beams_doubted", h->beams_doubted},
          {"longest_doubt", h->longest_doubt},
          {"collapses", h->collapses}};
}

Json scores(const Scores& s) {
  return {{"path_mse_m2", or_null(s.path_mse_m2)},
          {"heading_mse_rad2", or_null(s.heading_mse_rad2)},
          {"path_mse_final_m2", or_null(s.path_mse_final_m2)},
          {"heading_mse_final_rad2", or_null(s.heading_mse_final_rad2)},
          {"odometry_path_mse_m2", or_null(s.odometry_path_mse_m2)},
          {"odometry_heading_mse_rad2", or_null(s.odometry_heading_mse_rad2)},
          {"ate_rmse_m", or_null(s.ate_rmse_m)},
          {"rpe_trans_m", or_null(s.rpe_trans_m)},
          {"rpe_rot_rad", or_null(s.rpe_rot_rad)},
          {"grid_mse", or_null(s.grid_mse)},
          {"grid_mse_all", or_null(s.grid_mse_all)},
          {"grid_mse_logodds", or_null(s.grid_mse_logodds)},
          {"grid_log_score", or_null(s.grid_log_score)},
          {"grid_confusion", confusion(s.grid_confusion)},
          {"path_mse_vs_baseline_m2", or_null(s.path_mse_vs_baseline_m2)},
          {"grid_mse_vs_baseline", or_null(s.grid_mse_vs_baseline)},
          {"registered", or_null(s.registered)},
          {"tracked", or_null(s.tracked)},
          {"resamplings", or_null(s.resamplings)},
          {"ancestors_100", or_null(s.ancestors_100)},
          {"payload_bytes", or_null(s.payload_bytes)},
          {"payload_bytes_bitmap", or_null(s.payload_bytes_bitmap)},
          {"bytes", or_null(s.bytes)},
          {"bytes_peak", or_null(s.bytes_peak)},
          {"degraded", keys(s.degraded)},
          {"health", health(s.health)},
          {"state_hash", or_null(s.state_hash)},
          {"map_hash", or_null(s.map_hash)},
          {"relations", {{"online", relations(s.relations_online)}, {"final", relations(s.relations_final)}}}};
}

Json stages(const std::optional<StageSeconds>& seconds) {
  if (!seconds) return nullptr;
  Json by_name = Json::object();
  for (std::size_t s = 0; s < kStages; ++s) by_name[name_of(static_cast<Stage>(s))] = (*seconds)[s];
  return by_name;
}

Json costs(const Costs& c) {
  return {{"cpu_s", or_null(c.cpu_s)},
          {"cpu_ms_per_registered", or_null(c.cpu_ms_per_registered)},
          {"cpu_stages_s", stages(c.cpu_stages_s)},
          {"wall_s", or_null(c.wall_s)},
          {"rss_bytes_above_start", or_null(c.rss_bytes_above_start)}};
}

Json variant(const VariantRecord& v) {
  return {{"name", v.name},
          {"store", v.store},
          {"cell_size_m", v.cell_size_m},
          {"percent_kept", or_null(v.percent_kept)},
          {"basis", or_null(v.basis)},
          {"compressor", or_null(v.compressor)},
          {"recovery", or_null(v.recovery)},
          {"particles", v.particles},
          {"scores", scores(v.scores)},
          {"costs", costs(v.costs)}};
}

std::string text(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

Json whole(const RunRecord& record, Json variants) {
  return {{"schema", kRunRecordSchema},
          {"scenario", record.scenario},
          {"seed", record.seed},
          {"readings_hash", or_null(record.readings_hash)},
          {"simulated_s", or_null(record.simulated_s)},
          {"variants", std::move(variants)}};
}

}  // namespace

std::string to_json(const RunRecord& record) {
  Json variants = Json::array();
  for (const VariantRecord& v : record.variants) variants.push_back(variant(v));
  return text(whole(record, std::move(variants)));
}

std::string lasting_json(const RunRecord& record) {
  Json variants = Json::array();
  for (const VariantRecord& v : record.variants) {
    variants.push_back(variant(v));
    variants.back().erase("costs");
  }
  return text(whole(record, std::move(variants)));
}

std::string scores_json(const RunRecord& record) {
  Json all = Json::array();
  for (const VariantRecord& v : record.variants) all.push_back(scores(v.scores));
  return text(all);
}

}  // namespace cogslam
