#include "eval/gate/gate_update.hpp"

#include <fmt/format.h>

#include "core/number_text.hpp"
#include "eval/gate/gate_comparison.hpp"

namespace cogslam {
namespace {

std::string figure_line(const GateFigure* old, const GateFigure& now, const GateDemand& demand, int seeds,
                        const ChangeLimits& limits) {
  const std::string name =
      fmt::format("  {:<24}{:<24}", fmt::format("{} {} m", now.variant, number_text(now.cell_size)), now.metric);
  if (now.missing > 0) return name + fmt::format("left out: no figure with {} seeds\n", now.missing);
  const FigureSpread spread = spread_of(now.values);
  const double resolves = unpaired_resolution(now.values, static_cast<std::size_t>(seeds), limits);
  std::string text = name + (old != nullptr ? fmt::format("{:>11.4g}", spread_of(old->values).mean) : "          -");
  text += fmt::format("{:>11.4g}{:>9.2f} %{:>9.2f} %{:>9g} %", spread.mean, 100.0 * spread.spread, 100.0 * resolves,
                      100.0 * demand.effect);
  if (resolves > demand.effect) text += "  not enough: run more seeds, or ask for less";
  return text + "\n";
}

}  // namespace

std::string update_table(const std::optional<GateMeasurement>& old, const GateMeasurement& now,
                         const Scenario& scenario, const GateConfig& config, double false_alarm) {
  std::string text =
      fmt::format("{}: {} seeds from {}; the gate runs {}\n", now.scenario, now.seeds(), now.first_seed, config.seeds);
  text += fmt::format("  {:<24}{:<24}{:>11}{:>11}{:>11}{:>11}{:>11}\n", "variant", "metric", "before", "now", "spread",
                      "resolves", "asked");
  for (const VariantConfig& variant : scenario.variants) {
    for (const GateDemand& demand : config.demands) {
      if (!applies(demand, variant)) continue;
      const GateFigure* figure = now.find(variant.name, variant.slam.cell_size, demand.metric);
      const GateFigure* before = old ? old->find(variant.name, variant.slam.cell_size, demand.metric) : nullptr;
      text += figure_line(before, *figure, demand, config.seeds,
                          {demand.tolerance, demand.effect, false_alarm, config.power});
    }
  }
  return text;
}

}  // namespace cogslam
