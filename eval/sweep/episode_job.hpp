#pragma once

#include <optional>
#include <string>

#include "eval/sweep/plan.hpp"
#include "eval/sweep/readings_cache.hpp"
#include "eval/variant_run.hpp"

namespace cogslam {

/// Why an episode fails whose readings hold no scan.
inline constexpr const char* kNothingToMeasure = "nothing measured: the readings hold no scan";

/// What a worker is told to do; the scenario lies in `episodes/<key>.yaml`.
struct EpisodeJob {
  bool only_readings = false;  ///< make the readings, run no filter
  std::string key;
  std::string readings_key;
  std::string own_key;
  std::string baseline_key;  ///< empty: compared with nothing

  static EpisodeJob of(const PlannedEpisode& episode, bool only_readings = false);
  /// One line without its end, and back. Throws InputError for anything else.
  [[nodiscard]] std::string line() const;
  static EpisodeJob parse(const std::string& line);
};

/// Does jobs one after the other in one thread. Readings and baseline of the last job stay in memory, since the next
/// one most often asks for the same.
class EpisodeRunner {
 public:
  explicit EpisodeRunner(SweepFolder folder);

  /// Writes `episodes/<key>.json`, and first the readings and the baseline where they are missing. What happened is
  /// told line by line to `note`. Throws InputError where a file cannot be read or written, and std::runtime_error
  /// where there is nothing to measure.
  void run(const EpisodeJob& job, const std::function<void(const std::string&)>& note);

 private:
  void run_episode(const EpisodeJob& job, const Scenario& scenario);
  const VariantRun& baseline(const EpisodeJob& job, const Scenario& scenario);
  VariantRun run_variant_of(const Scenario& scenario, const VariantConfig& variant);

  SweepFolder folder_;
  std::string program_;
  Workers workers_{1};
  std::function<void(const std::string&)> note_;
  std::string readings_key_;
  std::optional<CachedReadings> readings_;
  std::string baseline_key_;
  std::optional<VariantRun> baseline_;
};

/// 16 digits over every byte of the running program's file: two builds that print the same measure the same.
std::string program_hash();

}  // namespace cogslam
