#include "eval/gate/gate_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>

#include "eval/gate/gate_settings.hpp"

namespace cogslam {
namespace {

Verdict worse(Verdict a, Verdict b) {
  if (a == Verdict::kFail || b == Verdict::kFail) return Verdict::kFail;
  return a == Verdict::kNotMeasured ? a : b;
}

/// "variants.1.slam.particles" where "slam.particles" says the same already.
bool is_echo(const SettingChange& change, const std::vector<SettingChange>& changes) {
  const std::size_t at = change.key.find(".slam.");
  if (!change.key.starts_with("variants.") || at == std::string::npos) return false;
  const std::string shared = change.key.substr(at + 1);
  return std::any_of(changes.begin(), changes.end(), [&](const SettingChange& other) {
    return other.key == shared && other.before == change.before && other.after == change.after;
  });
}

std::string list_of(const std::vector<SettingChange>& all) {
  constexpr std::size_t kMost = 8;
  std::vector<SettingChange> changes;
  std::copy_if(all.begin(), all.end(), std::back_inserter(changes),
               [&](const SettingChange& change) { return !is_echo(change, all); });
  std::string text;
  for (std::size_t i = 0; i < std::min(changes.size(), kMost); ++i) text += (i > 0 ? ", " : "") + changes[i].text();
  if (changes.size() > kMost) text += fmt::format(" and {} more", changes.size() - kMost);
  return text;
}

bool overlap(const GateMeasurement& baseline, const GateSeeds& seeds) {
  const std::uint64_t last = std::uint64_t{seeds.first} + static_cast<std::uint64_t>(seeds.count) - 1;
  return seeds.first < baseline.first_seed + baseline.seeds() && last >= baseline.first_seed;
}

bool contains(const GateMeasurement& baseline, const GateSeeds& seeds) {
  const std::uint64_t last = std::uint64_t{seeds.first} + static_cast<std::uint64_t>(seeds.count) - 1;
  return baseline.has_seed(seeds.first) && baseline.has_seed(last);
}

/// The baseline's values of the seeds that were run now.
std::span<const double> same_seeds(const GateMeasurement& baseline, const GateFigure& figure,
                                   const GateMeasurement& now) {
  return std::span(figure.values).subspan(now.first_seed - baseline.first_seed, now.seeds());
}

std::vector<std::string> notes_of(const GateMeasurement& baseline, const GateMeasurement& now, bool paired,
                                  const std::string& file) {
  std::vector<std::string> notes;
  const SettingChanges changes = setting_changes(baseline.settings, now.settings, file);
  if (!changes.filter.empty()) notes.push_back("other settings than the baseline's: " + list_of(changes.filter));
  if (!changes.known.empty()) notes.push_back("keys that only one version knows: " + list_of(changes.known));
  if (!paired) return notes;
  std::size_t other = 0;
  for (std::size_t i = 0; i < now.seeds(); ++i) {
    other += now.readings[i] != baseline.readings[now.first_seed - baseline.first_seed + i] ? 1 : 0;
  }
  if (other > 0) {
    notes.push_back(
        fmt::format("other readings than the baseline's with {} of {} seeds: simulation, sensors or "
                    "odometry have changed",
                    other, now.seeds()));
  }
  return notes;
}

void compare_row(const GateMeasurement& baseline, const GateMeasurement& now, bool paired, GateRow& row) {
  const GateFigure* then = baseline.find(row.variant, row.cell_size, row.metric);
  const GateFigure* figure = now.find(row.variant, row.cell_size, row.metric);
  if (figure == nullptr || figure->missing > 0) {
    const std::size_t missing = figure == nullptr ? now.seeds() : static_cast<std::size_t>(figure->missing);
    row.reason = fmt::format("no figure with {} of {} seeds", missing, now.seeds());
    return;
  }
  if (then == nullptr) {
    row.reason = "the baseline has no such figure: make it anew with --update";
    return;
  }
  row.change = paired ? compare_paired(same_seeds(baseline, *then, now), figure->values, row.limits)
                      : compare_unpaired(then->values, figure->values, row.limits);
  row.verdict = row.change->verdict;
  if (row.verdict == Verdict::kNotMeasured) {
    row.reason = fmt::format("these seeds resolve {:+.1f} %, not {:+.1f} %: run more (--seeds, or --update with more)",
                             100.0 * row.change->resolves, 100.0 * row.limits.effect);
  }
}

/// A variant that is gone would pass unseen.
void add_lost_variants(const GateMeasurement& baseline, const Scenario& scenario, GateResult& result) {
  for (const GateFigure& figure : baseline.figures) {
    const auto same = [&](const VariantConfig& v) {
      return v.name == figure.variant && v.slam.cell_size == figure.cell_size;
    };
    if (std::any_of(scenario.variants.begin(), scenario.variants.end(), same)) continue;
    result.rows.push_back({.variant = figure.variant,
                           .cell_size = figure.cell_size,
                           .metric = figure.metric,
                           .reason = "the scenario no longer has this variant at this cell size"});
  }
}

}  // namespace

std::string name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPass:
      return "pass";
    case Verdict::kFail:
      return "FAIL";
    case Verdict::kNotMeasured:
      break;
  }
  return "not measured";
}

Verdict GateResult::verdict() const {
  if (!problem.empty()) return Verdict::kFail;
  Verdict all = rows.empty() ? Verdict::kNotMeasured : Verdict::kPass;
  for (const GateRow& row : rows) all = worse(all, row.verdict);
  return all;
}

Verdict GateReport::verdict() const {
  Verdict all = results.empty() ? Verdict::kNotMeasured : Verdict::kPass;
  for (const GateResult& result : results) all = worse(all, result.verdict());
  return all;
}

std::size_t GateReport::count(Verdict verdict) const {
  std::size_t n = 0;
  for (const GateResult& result : results) {
    n += !result.problem.empty() && verdict == Verdict::kFail ? 1 : 0;
    for (const GateRow& row : result.rows) n += row.verdict == verdict ? 1 : 0;
  }
  return n;
}

std::size_t count_tests(const std::vector<Scenario>& scenarios, const std::vector<GateDemand>& demands) {
  std::size_t tests = 0;
  for (const Scenario& scenario : scenarios) {
    for (const VariantConfig& variant : scenario.variants) {
      for (const GateDemand& demand : demands) tests += applies(demand, variant) ? 1 : 0;
    }
  }
  return tests;
}

std::string why_not_comparable(const std::optional<GateMeasurement>& baseline, const Scenario& scenario,
                               const GateSeeds& seeds, const std::string& file) {
  if (!baseline) return "no baseline: make " + file + " with --update, look at it and commit it";
  const SettingChanges changes = setting_changes(baseline->settings, scenario.resolved, file);
  const std::string remedy = "; if that is meant, make " + file + " anew with --update";
  if (!changes.task.empty()) return "not the baseline's scenario: " + list_of(changes.task) + remedy;
  if (baseline->map_hash != hash_of_map(scenario.world)) return "not the map of the baseline's world" + remedy;
  if (overlap(*baseline, seeds) && !contains(*baseline, seeds)) {
    return fmt::format("seeds {} to {}: some are the baseline's ({} to {}) and some not; expected all or none",
                       seeds.first, seeds.first + static_cast<std::uint32_t>(seeds.count) - 1, baseline->first_seed,
                       baseline->first_seed + baseline->seeds() - 1);
  }
  return {};
}

GateResult compare(const GateMeasurement& baseline, const GateMeasurement& now, const Scenario& scenario,
                   const GateConfig& config, double false_alarm) {
  const GateSeeds seeds{.first = now.first_seed, .count = static_cast<int>(now.seeds())};
  const bool paired = contains(baseline, seeds);
  GateResult result{.scenario = now.scenario, .paired = paired, .seeds = seeds, .baseline_seeds = baseline.seeds()};
  result.notes = notes_of(baseline, now, paired, "baseline of " + now.scenario);
  for (const VariantConfig& variant : scenario.variants) {
    for (const GateDemand& demand : config.demands) {
      if (!applies(demand, variant)) continue;
      GateRow row{.variant = variant.name, .cell_size = variant.slam.cell_size, .metric = demand.metric};
      row.limits = {demand.tolerance, demand.effect, false_alarm, config.power};
      compare_row(baseline, now, paired, row);
      result.rows.push_back(std::move(row));
    }
  }
  add_lost_variants(baseline, scenario, result);
  return result;
}

}  // namespace cogslam
