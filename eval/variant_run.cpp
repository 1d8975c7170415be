#include "eval/variant_run.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "eval/filter_degradation.hpp"
#include "eval/metrics/map_error.hpp"
#include "eval/metrics/path_completion.hpp"
#include "eval/metrics/path_error.hpp"
#include "eval/metrics/stage_times.hpp"
#include "eval/metrics/timing.hpp"
#include "slam/fast_slam.hpp"
#include "slam/true_pose_mapper.hpp"

namespace cogslam {
namespace {

void add_statistics(const FilterStatistics& statistics, Scores& scores) {
  scores.registered = static_cast<std::uint64_t>(statistics.registered);
  scores.tracked = static_cast<std::uint64_t>(statistics.tracked);
  scores.resamplings = static_cast<std::uint64_t>(statistics.resamplings);
  if (statistics.ancestors_100) scores.ancestors_100 = static_cast<std::uint64_t>(*statistics.ancestors_100);
  scores.payload_bytes = statistics.payload_bytes;
  scores.bytes = statistics.bytes;
  scores.bytes_peak = static_cast<std::uint64_t>(statistics.bytes_peak);
}

/// What the kept coefficients take when a bit per possible position says which they are, in place of 4 bytes for each.
std::optional<double> bitmap_payload(const SlamConfig& slam, double payload_bytes) {
  if (slam.store.kind != StoreKind::kCoefficients || !slam.store.compression.is_papers_choice()) return std::nullopt;
  const GridFrame frame = *slam.map_frame();
  const std::size_t positions = HaarCanvas::covering(frame.width, frame.height).support();
  return payload_bytes / 2.0 + static_cast<double>((positions + 7) / 8);
}

std::string map_hash(const Grid<float>& map) {
  Hash hash;
  const GridFrame& f = map.frame();
  hash.add(f.cell_size).add(f.lattice_min.x).add(f.lattice_min.y).add(f.width).add(f.height);
  return hash.add(std::span<const float>(map.values())).hex();
}

/// The poses of readings that carry a scan: the records over which a path is scored.
std::vector<Pose2> at_scans(std::span<const Pose2> path, const Recording& recording) {
  std::vector<Pose2> poses;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (recording.readings[i].scan) poses.push_back(path[i]);
  }
  return poses;
}

std::vector<Pose2> true_path(const TruthLog& truth) {
  std::vector<Pose2> path;
  for (const TruePose& pose : truth.poses) path.push_back(pose.T_map_base);
  return path;
}

void score_path(const VariantRun& run, const Recording& recording, const TruthLog& log, Scores& scores) {
  const std::vector<Pose2> truth = at_scans(true_path(log), recording);
  const std::vector<Pose2> online = at_scans(run.online, recording);
  if (const auto error = path_error(truth, online)) {
    scores.path_mse_m2 = error->position_mse;
    scores.heading_mse_rad2 = error->heading_mse;
  }
  if (const auto error = path_error(truth, at_scans(run.final, recording))) {
    scores.path_mse_final_m2 = error->position_mse;
    scores.heading_mse_final_rad2 = error->heading_mse;
  }
  if (const auto error = path_error(truth, at_scans(odometry_path(recording), recording))) {
    scores.odometry_path_mse_m2 = error->position_mse;
    scores.odometry_heading_mse_rad2 = error->heading_mse;
  }
  scores.ate_rmse_m = ate_rmse(truth, online);
  if (const auto rpe = relative_pose_error(truth, online)) {
    scores.rpe_trans_m = rpe->trans_rmse;
    scores.rpe_rot_rad = rpe->rot_rmse;
  }
}

void score_map(const Grid<float>& map, const TruthLog& log, Scores& scores) {
  const auto error = map_error(truth_grid(log.world, map.frame().cell_size), map);
  if (!error) return;
  scores.grid_mse = error->mse;
  scores.grid_mse_all = error->mse_all;
  scores.grid_mse_logodds = error->mse_logodds;
  scores.grid_log_score = error->log_score;
  scores.grid_confusion = error->confusion;
}

void score_relations(const VariantRun& run, const Recording& recording, std::span<const Relation> relations,
                     Scores& scores) {
  std::vector<Time> stamps;
  for (const Reading& reading : recording.readings) stamps.push_back(reading.stamp);
  const std::vector<Pose2> odometry = odometry_path(recording);
  scores.relations_online = relation_errors(relations, stamps, odometry, run.online);
  scores.relations_final = relation_errors(relations, stamps, odometry, run.final);
}

/// Keeps a trace where one is wanted, and the time that this takes apart.
class Watch {
 public:
  Watch(const Recording& recording, const std::optional<TraceLimits>& limits) {
    if (limits) recorder_.emplace(recording, *limits);
  }
  void after(std::size_t record, bool registered, const LastScan& scan, const TraceRecorder::Belief& belief) {
    if (!recorder_) return;
    recorder_->note(record, registered, scan);
    if (!recorder_->due(record)) return;
    wall_.start();
    cpu_.start();
    recorder_->look(record, belief);
    cpu_.stop();
    wall_.stop();
  }
  [[nodiscard]] double wall_seconds() const { return wall_.seconds(); }
  [[nodiscard]] double cpu_seconds() const { return cpu_.seconds(); }
  std::optional<RunTrace> finish(const Grid<float>& map) {
    return recorder_ ? std::optional(recorder_->finish(map)) : std::nullopt;
  }

 private:
  std::optional<TraceRecorder> recorder_;
  StretchTimer wall_{Clock::kWall}, cpu_{Clock::kProcessCpu};
};

void run_filter(const VariantConfig& variant, std::uint32_t seed, const Recording& recording, Workers& workers,
                const Progress& progress, Watch& watch, VariantRun& run) {
  StageTimes times(workers.threads());
  FastSlam slam(variant.slam, seed, workers, &times);
  std::vector<Pose2> odometry;
  const TraceRecorder::Belief belief{.cloud = [&] { return slam.cloud(); }, .map = [&] { return slam.best_map(); }};
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    if (progress) {  // each time: with many particles one reading takes seconds
      progress(static_cast<double>(i) / static_cast<double>(recording.readings.size()));
    }
    bool registered = false;
    try {
      registered = slam.update(recording.readings[i]);
    } catch (const InputError& error) {
      throw InputError({recording.source}, "reading " + std::to_string(i) + ": " + error.what());
    }
    run.online.push_back(slam.T_map_base());
    odometry.push_back(slam.T_odom_base());
    watch.after(i, registered, slam.last_scan(), belief);
  }
  run.final = complete_path(odometry, slam.best_path());
  run.map = slam.best_map();
  run.record.costs.cpu_stages_s = times.seconds();
  add_statistics(slam.statistics(), run.record.scores);
  run.record.scores.health = slam.health();
  run.record.scores.state_hash = Hash().add(slam.state_hash()).hex();
}

void run_mapper(const VariantConfig& variant, const Recording& recording, const TruthLog& truth,
                const Progress& progress, Watch& watch, VariantRun& run) {
  TruePoseMapper mapper(variant.slam);
  const TraceRecorder::Belief belief{.map = [&] { return mapper.map(); }};
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    if (progress) progress(static_cast<double>(i) / static_cast<double>(recording.readings.size()));
    const bool registered = mapper.update(recording.readings[i], truth.poses[i].T_map_base);
    watch.after(i, registered, mapper.statistics().last, belief);
  }
  run.map = mapper.map();
  add_statistics(mapper.statistics(), run.record.scores);
}

VariantRecord describe(const VariantConfig& variant) {
  const SlamConfig& slam = variant.slam;
  VariantRecord record{.name = variant.name,
                       .store = store_name(slam.store.kind),
                       .cell_size_m = slam.cell_size,
                       .particles = variant.true_poses ? 1 : slam.particles};
  if (slam.store.kind == StoreKind::kCoefficients) {
    record.percent_kept = slam.store.percent_kept;
    record.basis = name_of(slam.store.compression.basis);
    record.compressor = name_of(slam.store.compression.compressor);
    record.recovery = name_of(slam.store.compression.recovery);
  }
  return record;
}

}  // namespace

std::string store_name(StoreKind kind) {
  switch (kind) {
    case StoreKind::kDense:
      return "dense";
    case StoreKind::kCoefficients:
      return "coefficients";
    case StoreKind::kTiles:
      return "tiles";
    case StoreKind::kTwoResolution:
      return "two_resolution";
    case StoreKind::kLattice:
      return "lattice";
  }
  return {};
}

std::vector<Pose2> odometry_path(const Recording& recording) {
  std::vector<Pose2> path;
  Pose2 T_map_base = recording.start;
  for (const Reading& reading : recording.readings) {
    T_map_base = T_map_base * reading.motion.T_before_now;
    path.push_back(T_map_base);
  }
  return path;
}

VariantRun run_variant(const VariantConfig& variant, std::uint32_t seed, const Recording& recording,
                       const Evidence& evidence, Workers& workers, const Progress& progress,
                       const std::optional<TraceLimits>& limits) {
  EXPECTS(!variant.true_poses || evidence.truth != nullptr);
  VariantRun run{.record = describe(variant)};
  const auto rss_before = rss_bytes();
  reset_rss_peak();
  Watch watch(recording, limits);
  const Stopwatch wall(Clock::kWall), cpu(Clock::kProcessCpu);
  if (variant.true_poses) {
    run_mapper(variant, recording, *evidence.truth, progress, watch, run);
  } else {
    run_filter(variant, seed, recording, workers, progress, watch, run);
  }
  Costs& costs = run.record.costs;
  Scores& scores = run.record.scores;
  costs.wall_s = wall.seconds() - watch.wall_seconds();
  costs.cpu_s = cpu.seconds() - watch.cpu_seconds();
  run.trace = watch.finish(run.map);
  if (*scores.registered > 0)
    costs.cpu_ms_per_registered = 1e3 * *costs.cpu_s / static_cast<double>(*scores.registered);
  if (const auto peak = rss_peak_bytes(); peak && rss_before) {
    costs.rss_bytes_above_start = *peak - std::min(*peak, *rss_before);
  }
  scores.map_hash = map_hash(run.map);
  scores.degraded = degradations(recording, variant.slam.sweep, run.map);
  if (scores.health) {
    const std::vector<Degradation> seen_by_filter = degradations(*scores.health);
    scores.degraded.insert(scores.degraded.end(), seen_by_filter.begin(), seen_by_filter.end());
  }
  scores.payload_bytes_bitmap = bitmap_payload(variant.slam, *scores.payload_bytes);
  if (evidence.truth != nullptr) {
    score_map(run.map, *evidence.truth, scores);
    if (!variant.true_poses) score_path(run, recording, *evidence.truth, scores);
  }
  if (!evidence.relations.empty() && !variant.true_poses) score_relations(run, recording, evidence.relations, scores);
  return run;
}

void compare_with_baseline(std::vector<VariantRun>& runs, const std::vector<VariantConfig>& variants,
                           const Recording& recording, const TruthLog* truth) {
  EXPECTS(runs.size() == variants.size());
  for (std::size_t v = 0; v < runs.size(); ++v) {
    for (std::size_t b = 0; b < v; ++b) {
      const bool comparable = variants[b].slam.store.kind == StoreKind::kDense &&
                              variants[b].slam.cell_size == variants[v].slam.cell_size &&
                              variants[b].true_poses == variants[v].true_poses;
      if (!comparable) continue;
      Scores& scores = runs[v].record.scores;
      const GridFrame area =
          truth != nullptr ? truth_grid(truth->world, variants[v].slam.cell_size).frame() : runs[b].map.frame();
      scores.grid_mse_vs_baseline = map_difference(area, runs[v].map, runs[b].map);
      if (const auto error = path_error(at_scans(runs[b].online, recording), at_scans(runs[v].online, recording));
          error && !variants[v].true_poses) {
        scores.path_mse_vs_baseline_m2 = error->position_mse;
      }
      break;
    }
  }
}

}  // namespace cogslam
