#include "eval/episode.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace cogslam {
namespace {

bool has_scan(const Reading& reading) { return reading.scan.has_value(); }

/// Of the stamps, since those of real logs jump.
double span_seconds(const std::vector<Reading>& readings) {
  const auto [first, last] = std::minmax_element(readings.begin(), readings.end(),
                                                 [](const auto& a, const auto& b) { return a.stamp < b.stamp; });
  return (last->stamp - first->stamp).seconds();
}

}  // namespace

std::string label(const VariantConfig& variant) { return fmt::format("{} {} m", variant.name, variant.slam.cell_size); }

std::string label(const VariantRecord& variant) { return fmt::format("{} {} m", variant.name, variant.cell_size_m); }

Episode replay_variants(const std::string& name, const Recording& recording, const Evidence& evidence,
                        const std::vector<VariantConfig>& variants, std::uint32_t seed, Workers& workers,
                        const StageBegin& begin, const std::optional<TraceLimits>& limits) {
  Episode episode{.record = {.scenario = name, .seed = seed, .readings_hash = readings_hash(recording.readings)}};
  if (std::none_of(recording.readings.begin(), recording.readings.end(), has_scan)) return episode;
  episode.record.simulated_s = span_seconds(recording.readings);
  for (const VariantConfig& variant : variants) {
    const Progress progress = begin ? begin(label(variant)) : Progress{};
    episode.runs.push_back(run_variant(variant, seed, recording, evidence, workers, progress, limits));
  }
  compare_with_baseline(episode.runs, variants, recording, evidence.truth);
  for (const VariantRun& run : episode.runs) episode.record.variants.push_back(run.record);
  return episode;
}

}  // namespace cogslam
