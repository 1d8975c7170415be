#include "eval/gate/gate_metric.hpp"

#include <array>
#include <cmath>

#include "core/check.hpp"

namespace cogslam {
namespace {

enum class Of { kPath, kMap, kMemory };

struct Metric {
  const char* name;
  Of of;
  std::optional<double> (*score)(const Scores&);
};

constexpr std::array kMetrics{
    Metric{"path_mse_m2", Of::kPath, [](const Scores& s) { return s.path_mse_m2; }},
    Metric{"heading_mse_rad2", Of::kPath, [](const Scores& s) { return s.heading_mse_rad2; }},
    Metric{"path_mse_final_m2", Of::kPath, [](const Scores& s) { return s.path_mse_final_m2; }},
    Metric{"heading_mse_final_rad2", Of::kPath, [](const Scores& s) { return s.heading_mse_final_rad2; }},
    Metric{"ate_rmse_m", Of::kPath, [](const Scores& s) { return s.ate_rmse_m; }},
    Metric{"rpe_trans_m", Of::kPath, [](const Scores& s) { return s.rpe_trans_m; }},
    Metric{"rpe_rot_rad", Of::kPath, [](const Scores& s) { return s.rpe_rot_rad; }},
    Metric{"grid_mse", Of::kMap, [](const Scores& s) { return s.grid_mse; }},
    Metric{"grid_mse_all", Of::kMap, [](const Scores& s) { return s.grid_mse_all; }},
    Metric{"grid_mse_logodds", Of::kMap, [](const Scores& s) { return s.grid_mse_logodds; }},
    Metric{"grid_log_score", Of::kMap, [](const Scores& s) { return s.grid_log_score; }},
    Metric{"payload_bytes", Of::kMemory, [](const Scores& s) { return s.payload_bytes; }},
    Metric{"bytes", Of::kMemory, [](const Scores& s) { return s.bytes; }},
    Metric{"bytes_peak", Of::kMemory,
           [](const Scores& s) -> std::optional<double> {
             return s.bytes_peak ? std::optional(static_cast<double>(*s.bytes_peak)) : std::nullopt;
           }},
};

const Metric& metric_called(const std::string& name) {
  for (const Metric& metric : kMetrics) {
    if (name == metric.name) return metric;
  }
  EXPECTS(!"one of gate_metrics()");
  return kMetrics[0];
}

}  // namespace

std::vector<std::string> gate_metrics() {
  std::vector<std::string> names;
  for (const Metric& metric : kMetrics) names.emplace_back(metric.name);
  return names;
}

std::optional<double> gate_score(const Scores& scores, const std::string& metric) {
  const std::optional<double> value = metric_called(metric).score(scores);
  return value && *value > 0.0 && std::isfinite(*value) ? value : std::nullopt;
}

bool gate_metric_is_of_path(const std::string& metric) { return metric_called(metric).of == Of::kPath; }

}  // namespace cogslam
