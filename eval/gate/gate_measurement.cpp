#include "eval/gate/gate_measurement.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/check.hpp"
#include "core/hash.hpp"
#include "eval/gate/gate_metric.hpp"
#include "worlds/map_file.hpp"

namespace cogslam {
namespace {

/// The figures that are asked for, still without values: each once, though two demands may speak of it.
std::vector<GateFigure> asked_figures(const Scenario& scenario, const std::vector<GateDemand>& demands) {
  GateMeasurement asked;
  for (const VariantConfig& variant : scenario.variants) {
    for (const GateDemand& demand : demands) {
      const double cell_size = variant.slam.cell_size;
      if (!applies(demand, variant) || asked.find(variant.name, cell_size, demand.metric) != nullptr) continue;
      asked.figures.push_back({.variant = variant.name, .cell_size = cell_size, .metric = demand.metric});
    }
  }
  return asked.figures;
}

void take_scores(const RunRecord& record, std::vector<GateFigure>& figures) {
  for (GateFigure& figure : figures) {
    const auto of_figure = [&](const VariantRecord& variant) {
      return variant.name == figure.variant && variant.cell_size_m == figure.cell_size;
    };
    const auto variant = std::find_if(record.variants.begin(), record.variants.end(), of_figure);
    const bool ran = variant != record.variants.end();  // none does where there was no scan
    const std::optional<double> score = ran ? gate_score(variant->scores, figure.metric) : std::nullopt;
    if (score) {
      figure.values.push_back(*score);
    } else {
      ++figure.missing;
    }
  }
}

void run_seed(const Scenario& scenario, Workers& workers, const Progress& progress, GateMeasurement& measurement) {
  constexpr double kDriving = 0.65;  // of the time that a seed takes, about
  const auto share = [&progress](double from, double part) {
    return progress ? Progress([=](double done) { progress(from + part * done); }) : Progress{};
  };
  const Drive drive = record_drive(scenario, share(0.0, kDriving));
  const double part = (1.0 - kDriving) / static_cast<double>(scenario.variants.size());
  double from = kDriving - part;
  const StageBegin next_variant = [&](const std::string&) { return share(from += part, part); };
  const Episode episode = replay_variants(scenario.name, drive.recording, {.truth = &drive.truth}, scenario.variants,
                                          scenario.seed, workers, next_variant);
  measurement.readings.push_back(episode.record.readings_hash.value_or("none"));
  take_scores(episode.record, measurement.figures);
}

}  // namespace

const GateFigure* GateMeasurement::find(const std::string& variant, double cell_size, const std::string& metric) const {
  for (const GateFigure& figure : figures) {
    if (figure.variant == variant && figure.cell_size == cell_size && figure.metric == metric) return &figure;
  }
  return nullptr;
}

std::string hash_of_map(const World& world) {
  if (!world.map) return {};
  return Hash().add(map_yaml_text(*world.map, "world.pgm")).add(map_pgm_bytes(*world.map)).hex();
}

GateMeasurement measure(const std::string& name, Scenario scenario, const std::vector<GateDemand>& demands,
                        const GateSeeds& seeds, const std::string& program, Workers& workers, const StageBegin& begin) {
  EXPECTS(seeds.count >= 1);
  GateMeasurement measurement{.program = program,
                              .scenario = name,
                              .settings = scenario.resolved,
                              .map_hash = hash_of_map(scenario.world),
                              .first_seed = seeds.first,
                              .figures = asked_figures(scenario, demands)};
  for (int i = 0; i < seeds.count; ++i) {
    scenario.seed = seeds.first + static_cast<std::uint32_t>(i);
    const std::string stage = fmt::format("{}, seed {}", name, scenario.seed);
    const Progress progress = begin ? begin(stage) : Progress{};
    try {
      run_seed(scenario, workers, progress, measurement);
    } catch (const InputError&) {
      throw;
    } catch (const std::exception& error) {
      throw std::runtime_error(stage + ": " + error.what());
    }
  }
  return measurement;
}

}  // namespace cogslam
