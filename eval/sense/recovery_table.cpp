#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "eval/sense/recovery_study.hpp"

namespace cogslam {
namespace {

struct Column {
  const char* name;
  double MapQuality::*score;
};
constexpr std::array<Column, 6> kColumns = {{{"relative_error", &MapQuality::relative_error},
                                             {"psnr_db", &MapQuality::psnr_db},
                                             {"accuracy", &MapQuality::accuracy},
                                             {"wall_f1", &MapQuality::wall_f1},
                                             {"wall_precision", &MapQuality::wall_precision},
                                             {"wall_recall", &MapQuality::wall_recall}}};

/// Half a width that means something: a single run has none, infinite values neither.
bool has_interval(const MeanInterval& m) { return m.count > 1 && std::isfinite(m.half_width); }

std::string with_interval(const MeanInterval& m, int digits) {
  const std::string mean = fmt::format("{:.{}f}", m.mean, digits);
  return has_interval(m) ? fmt::format("{} +-{:.{}f}", mean, m.half_width, digits) : mean;
}

/// JSON has no infinity.
nlohmann::ordered_json number(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json json_of(const RecoveryRun& run) {
  nlohmann::ordered_json json{{"seed", run.seed}};
  for (const Column& column : kColumns) json[column.name] = number(run.quality.*column.score);
  json["objective"] = run.objective;
  json["gap"] = run.gap;
  json["converged"] = run.converged;
  json["iterations"] = run.iterations;
  json["cpu_s"] = run.cpu_s;
  return json;
}

nlohmann::ordered_json json_of(const RecoveryScore& score) {
  nlohmann::ordered_json json{{"map", score.map},
                              {"cells", score.cells},
                              {"choice", name_of(score.choice)},
                              {"prior", name_of(score.prior)},
                              {"k", score.count}};
  for (const Column& column : kColumns) {
    const MeanInterval mean = score.mean(column.score);
    json[column.name] = {{"mean", number(mean.mean)},
                         {"half_width_95", has_interval(mean) ? number(mean.half_width) : nullptr}};
  }
  json["largest_gap"] = score.largest_gap();
  json["converged"] = score.converged();
  json["mean_cpu_s"] = score.mean_cpu_s();
  for (const RecoveryRun& run : score.runs) json["runs"].push_back(json_of(run));
  return json;
}

}  // namespace

std::string recovery_table(const std::vector<RecoveryScore>& scores) {
  std::string text =
      fmt::format("{:<26}{:<10}{:<9}{:>6}{:>18}{:>16}{:>18}{:>17}{:>9}{:>7}{:>9}\n", "map", "cells by", "prior", "K",
                  "relative error", "PSNR [dB]", "accuracy", "wall F1", "gap", "ended", "CPU [s]");
  for (const RecoveryScore& s : scores) {
    text +=
        fmt::format("{:<26}{:<10}{:<9}{:>6}{:>18}{:>16}{:>18}{:>17}{:>9.1e}{:>7}{:>9.3f}\n", s.map, name_of(s.choice),
                    name_of(s.prior), s.count, with_interval(s.mean(&MapQuality::relative_error), 4),
                    with_interval(s.mean(&MapQuality::psnr_db), 2), with_interval(s.mean(&MapQuality::accuracy), 4),
                    with_interval(s.mean(&MapQuality::wall_f1), 4), s.largest_gap(),
                    fmt::format("{}/{}", s.converged(), s.runs.size()), s.mean_cpu_s());
  }
  return text;
}

std::string recovery_csv(const std::vector<RecoveryScore>& scores) {
  std::string text = "map,n,choice,prior,k,seeds";
  for (const Column& column : kColumns) text += fmt::format(",{0}_mean,{0}_low95,{0}_high95", column.name);
  text += ",objective_mean,largest_gap,converged,iterations_mean,cpu_s_mean\n";
  for (const RecoveryScore& s : scores) {
    text +=
        fmt::format("{},{},{},{},{},{}", s.map, s.cells, name_of(s.choice), name_of(s.prior), s.count, s.runs.size());
    for (const Column& column : kColumns) {
      const MeanInterval mean = s.mean(column.score);
      text += has_interval(mean) ? fmt::format(",{},{},{}", mean.mean, mean.low(), mean.high())
                                 : fmt::format(",{},,", mean.mean);
    }
    text += fmt::format(",{},{},{},{},{}\n", s.mean_objective().mean, s.largest_gap(), s.converged(),
                        s.mean_iterations(), s.mean_cpu_s());
  }
  return text;
}

std::string recovery_json(const RecoveryStudy& study, const std::vector<RecoveryScore>& scores) {
  nlohmann::ordered_json json{{"schema", 1},
                              {"first_seed", study.first_seed},
                              {"seeds", study.seeds},
                              {"stop_at_gap", study.stop_at_gap},
                              {"max_iterations", study.max_iterations}};
  json["scores"] = nlohmann::ordered_json::array();
  for (const RecoveryScore& score : scores) json["scores"].push_back(json_of(score));
  return json.dump(2) + "\n";
}

}  // namespace cogslam
