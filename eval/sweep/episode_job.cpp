#include "eval/sweep/episode_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "core/hash.hpp"
#include "core/output_file.hpp"
#include "eval/metrics/timing.hpp"
#include "eval/sweep/baseline_file.hpp"
#include "eval/sweep/episode_result.hpp"

namespace cogslam {
namespace {

constexpr const char* kNothing = "-";

double span_seconds(const Recording& recording) {
  return recording.readings.empty() ? 0.0
                                    : (recording.readings.back().stamp - recording.readings.front().stamp).seconds();
}

}  // namespace

EpisodeJob EpisodeJob::of(const PlannedEpisode& episode, bool only_readings) {
  return {only_readings, episode.key, episode.readings_key, episode.own_key, episode.baseline_key};
}

std::string EpisodeJob::line() const {
  return fmt::format("{} {} {} {} {}", only_readings ? "readings" : "episode", key, readings_key, own_key,
                     baseline_key.empty() ? kNothing : baseline_key);
}

EpisodeJob EpisodeJob::parse(const std::string& line) {
  std::istringstream in(line);
  EpisodeJob job;
  std::string what, more;
  in >> what >> job.key >> job.readings_key >> job.own_key >> job.baseline_key;
  if (!in || in >> more || (what != "episode" && what != "readings")) {
    throw InputError("'" + line + "': expected a job of a sweep");
  }
  job.only_readings = what == "readings";
  if (job.baseline_key == kNothing) job.baseline_key.clear();
  return job;
}

std::string program_hash() {
  std::ifstream in("/proc/self/exe", std::ios::binary);
  Hash hash;
  std::array<char, 1 << 16> bytes{};
  while (in.read(bytes.data(), bytes.size()) || in.gcount() > 0) {
    hash.add(std::span<const char>(bytes.data(), static_cast<std::size_t>(in.gcount())));
  }
  return hash.hex();
}

EpisodeRunner::EpisodeRunner(SweepFolder folder) : folder_(std::move(folder)), program_(program_hash()) {}

void EpisodeRunner::run(const EpisodeJob& job, const std::function<void(const std::string&)>& note) {
  note_ = note;
  const Scenario scenario = load_scenario(folder_.episode(job.key, ".yaml"));
  if (readings_key_ != job.readings_key) {
    baseline_.reset();
    baseline_key_.clear();
    const Stopwatch watch(Clock::kWall);
    readings_ = cached_readings(folder_, job.readings_key, scenario);
    readings_key_ = job.readings_key;
    note_(fmt::format("readings {}: {}, {:.1f} s", job.readings_key, readings_->note, watch.seconds()));
  }
  if (!job.only_readings) run_episode(job, scenario);
}

VariantRun EpisodeRunner::run_variant_of(const Scenario& scenario, const VariantConfig& variant) {
  return run_variant(variant, scenario.seed, readings_->recording, {.truth = &readings_->truth}, workers_);
}

const VariantRun& EpisodeRunner::baseline(const EpisodeJob& job, const Scenario& scenario) {
  if (baseline_key_ == job.baseline_key) return *baseline_;
  const std::filesystem::path file = folder_.baseline(job.baseline_key);
  baseline_.reset();
  if (std::filesystem::exists(file)) {
    try {
      baseline_ = read_baseline(file);
      note_("baseline " + job.baseline_key + ": found");
    } catch (const InputError& error) {
      note_(error.what());
    }
  }
  if (!baseline_) {
    baseline_ = run_variant_of(scenario, scenario.variants.front());
    write_baseline(file, *baseline_);
    note_("baseline " + job.baseline_key + ": made");
  }
  baseline_key_ = job.baseline_key;
  return *baseline_;
}

void EpisodeRunner::run_episode(const EpisodeJob& job, const Scenario& scenario) {
  const std::vector<Reading>& readings = readings_->recording.readings;
  if (std::none_of(readings.begin(), readings.end(), [](const Reading& r) { return r.scan.has_value(); })) {
    throw std::runtime_error(kNothingToMeasure);
  }
  const VariantConfig& variant = scenario.variants.back();
  std::vector<VariantRun> runs;
  if (!job.baseline_key.empty()) runs.push_back(baseline(job, scenario));
  runs.push_back(run_variant_of(scenario, variant));
  compare_with_baseline(runs, scenario.variants, readings_->recording, &readings_->truth);
  const bool others_compare = variant.slam.store.kind == StoreKind::kDense;
  if (others_compare) write_baseline(folder_.baseline(job.own_key), runs.back());
  const VariantRecord& record = runs.back().record;
  const EpisodeResult result{.key = job.key,
                             .readings_key = job.readings_key,
                             .baseline = job.baseline_key.empty() ? "" : scenario.variants.front().name,
                             .true_poses = variant.true_poses,
                             .program = program_,
                             .run = {.scenario = scenario.name,
                                     .seed = scenario.seed,
                                     .readings_hash = readings_->truth.readings_hash,
                                     .simulated_s = span_seconds(readings_->recording),
                                     .variants = {record}}};
  write_file(folder_.episode(job.key, ".json"), to_json(result));
  note_(fmt::format("{}: measured, {:.1f} s", record.name, record.costs.wall_s.value_or(0.0)));
}

}  // namespace cogslam
