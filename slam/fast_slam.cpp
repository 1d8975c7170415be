#include "slam/fast_slam.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <set>

#include "core/check.hpp"
#include "slam/resampling.hpp"

namespace cogslam {

struct FastSlam::WorkerScratch {
  explicit WorkerScratch(const SlamConfig& config) : likelihood(config.likelihood, config.cell_size) {}
  MapScratch map;
  CellWindow loaded;  ///< asked for; the map may hold less
  MapUpdater updater;
  ScanLikelihood likelihood;
};

FastSlam::FastSlam(const SlamConfig& config, std::uint32_t seed, Workers& workers)
    : config_(config), seed_(seed), workers_(workers), meter_(std::make_shared<MemoryMeter>()), motion_(config.motion) {
  config.check();
  if (config.proposal == Proposal::kScanMatched && config.tracker.used) tracker_.emplace(config.tracker, config.sweep);
  if (keeps_levels(config.store.kind) && config.likelihood.model == ScanModel::kLikelihoodField) {
    levels_ = lattice_model(config.log_odds, config.store.lattice_unit);
  }
  const MapStore empty(config.store, config.cell_size, config.map_frame(), meter_);
  const double bias_variance = config.compass.bias_sigma * config.compass.bias_sigma;
  particles_.assign(static_cast<std::size_t>(config.particles),
                    Particle{.T_map_base = config.start, .compass_bias = {0.0, bias_variance}, .map = empty});
  for (int w = 0; w < workers.threads(); ++w) scratch_.push_back(std::make_unique<WorkerScratch>(config));
}

FastSlam::~FastSlam() = default;

bool FastSlam::update(const Reading& reading) {
  follow(reading);
  const bool first = statistics_.registered == 0;
  const bool registered = reading.scan && (first || config_.registration.due(motion_.T_last_now()));
  if (registered) {
    step(reading);
    motion_.restart();
    if (tracker_) tracker_->make_key();
  } else if (reading.scan) {
    ++statistics_.tracked;
  }
  ++records_;
  return registered;
}

void FastSlam::follow(const Reading& reading) {
  if (!tracker_) {
    motion_.add(reading.motion);
    T_odom_base_ = T_odom_base_ * reading.motion.T_before_now;
    return;
  }
  // The spread stays odometry's: each particle's map was made of the scans that the tracker matched, and its own
  // certainty would count them twice. Loops then stay open more often (measured on the Intel log).
  tracker_->follow(reading);
  motion_.add(reading.motion);
  motion_.correct(tracker_->T_key_now());
  T_odom_base_ = tracker_->T_track_base();
}

// Algorithms 1 and 3. The lines are those of Alg. 3; with the dense store, 5 and 8 copy plain cells (Alg. 1).
void FastSlam::step(const Reading& reading) {
  sweep_ = sweep_of(reading, config_.sweep);
  probes_ = scratch_[0]->likelihood.probes_of(sweep_);
  workers_.for_each(particles_.size(), [&](std::size_t p, int worker) {  // (3) for p = 1..n
    advance(particles_[p], p, reading, *scratch_[static_cast<std::size_t>(worker)]);
  });
  record_paths();
  // One after another: what is sealed is the same for any number of threads.
  for (Particle& particle : particles_) particle.map.settle(static_cast<std::uint64_t>(statistics_.registered) + 1);
  account();
  resample_if_due();  // (12)-(15)
}

void FastSlam::advance(Particle& particle, std::size_t slot, const Reading& reading, WorkerScratch& scratch) const {
  const double before = particle.log_weight;
  Rng rng(
      {.seed = seed_, .purpose = Purpose::kMotionSample, .entity = static_cast<std::uint32_t>(slot), .tick = records_});
  if (config_.proposal == Proposal::kMotion) {
    propose_by_motion(particle, rng, scratch);  // (4), (5), (6)
  } else {
    propose_by_match(particle, rng, scratch);
  }
  if (reading.heading && config_.compass.used) {
    particle.log_weight +=
        compass_log_likelihood(*reading.heading, particle.T_map_base.theta, config_.compass, particle.compass_bias);
  }
  particle.path_log_weight += particle.log_weight - before;
  // (7), (8): alpha - beta is added to the loaded window, and the store takes the changed cells back (eqs. 18, 22).
  if (levels_) {
    particle.map.commit_levels(scratch.updater.integrate(sweep_, particle.T_map_base, *levels_, scratch.map.levels),
                               scratch.map);
  } else {
    particle.map.commit(scratch.updater.integrate(sweep_, particle.T_map_base, config_.log_odds, scratch.map.log_odds),
                        scratch.map);
  }
}

/// (5): the map window that the sweep can touch from poses up to `margin_cells` away, in plain form.
void FastSlam::load_around(const Pose2& T_map_base, const Particle& particle, int margin_cells,
                           WorkerScratch& scratch) const {
  scratch.loaded = window_of(sweep_, T_map_base, config_.cell_size).grown(margin_cells);
  if (levels_) {
    particle.map.load_levels(scratch.loaded, scratch.map);
  } else {
    particle.map.load(scratch.loaded, scratch.map);
  }
}

void FastSlam::look_at_loaded(WorkerScratch& scratch) const {
  if (levels_) {
    scratch.likelihood.look_at(scratch.map.levels, config_.store.lattice_unit);
  } else {
    scratch.likelihood.look_at(scratch.map.log_odds);
  }
}

void FastSlam::propose_by_motion(Particle& particle, Rng& rng, WorkerScratch& scratch) const {
  const bool first = statistics_.registered == 0;  // the start pose is given: no noise, and no map to weigh against
  particle.T_map_base = first ? particle.T_map_base * motion_.T_last_now() : motion_.sample(particle.T_map_base, rng);
  load_around(particle.T_map_base, particle, scratch.likelihood.margin_cells(), scratch);
  look_at_loaded(scratch);
  particle.log_weight += scratch.likelihood.log_likelihood(probes_, particle.T_map_base);  // (6), eq. (8)
}

// Grisetti et al. 2007, sec. IV: the proposal uses the scan too, so few particles are wasted. The weight should be
// p(z | x', u) = integral of p(z | x) p(x | x', u) dx, here by Laplace's method about the mode. A heuristic departs
// from it: the match takes p(z | x)^sharpness, the weight the 1/sharpness power of the whole integral, motion prior and
// volume included, because a scan is sharper evidence of where it lies in its map than of which of two maps is right.
// It favours particles a little less than it should whose match agrees with odometry.
void FastSlam::propose_by_match(Particle& particle, Rng& rng, WorkerScratch& scratch) const {
  const Pose2 predicted = particle.T_map_base * motion_.T_last_now();
  const Eigen::Matrix3d covariance = motion_.covariance();
  if (statistics_.registered == 0) {
    particle.T_map_base = predicted;
    load_around(predicted, particle, 0, scratch);
    return;
  }
  load_around(predicted, particle, scratch.likelihood.margin_cells() + search_margin_cells(covariance), scratch);
  look_at_loaded(scratch);
  const double sharpness = config_.matcher.sharpness;
  const PoseScore score{
      [&](const Pose2& pose) { return sharpness * scratch.likelihood.field_log_likelihood(probes_, pose); },
      [&](const Pose2& pose) { return sharpness * scratch.likelihood.field_fit(probes_, pose); }};
  const ScanMatch match = match_scan(score, predicted, covariance, config_.matcher);
  particle.T_map_base = sample_pose(match.T_map_base, match.covariance, rng);
  const double log_evidence =
      match.log_posterior + 0.5 * std::log(match.covariance.determinant() / covariance.determinant());
  particle.log_weight += log_evidence / sharpness;
  if (!scratch.loaded.contains(window_of(sweep_, particle.T_map_base, config_.cell_size))) {
    load_around(particle.T_map_base, particle, 0, scratch);  // a rare draw from far out
  }
}

/// How far end points move when the search, and the draw after it, go to their limits.
int FastSlam::search_margin_cells(const Eigen::Matrix3d& covariance) const {
  double longest = 0.0;
  for (const Beam& beam : sweep_) longest = std::max(longest, beam.end.norm());
  const Eigen::Vector3d sigma = covariance.diagonal().cwiseSqrt();
  const double sigmas = config_.matcher.window_sigmas + 1.0;
  const double shift = sigmas * (sigma.head<2>().norm() + longest * sigma.z());
  return static_cast<int>(std::ceil(shift / config_.cell_size)) + 1;
}

void FastSlam::record_paths() {
  for (Particle& particle : particles_) {
    const PathTree::Node leaf = paths_.append(particle.node, {records_, particle.T_map_base});
    paths_.release(particle.node);
    particle.node = leaf;
  }
  choose_best();
}

void FastSlam::choose_best() {
  best_ = 0;
  for (std::size_t p = 1; p < particles_.size(); ++p) {
    if (particles_[p].path_log_weight > particles_[best_].path_log_weight) best_ = p;
  }
}

void FastSlam::resample_if_due() {
  std::vector<double> log_weights;
  for (const Particle& particle : particles_) log_weights.push_back(particle.log_weight);
  const std::vector<double> weights = normalised_weights(log_weights);
  const double enough = config_.resampling.effective_share * static_cast<double>(particles_.size());
  if (!config_.resampling.every_step && effective_sample_size(weights) >= enough) return;

  Rng rng({.seed = seed_, .purpose = Purpose::kResample, .tick = records_});
  const std::vector<std::size_t> chosen = systematic_resample(weights, rng.uniform());
  std::vector<Particle> next;
  next.reserve(particles_.size());
  for (const std::size_t j : chosen) {
    next.push_back(particles_[j]);  // shares the map
    next.back().log_weight = 0.0;
    paths_.hold(particles_[j].node);
  }
  for (const Particle& particle : particles_) paths_.release(particle.node);
  particles_ = std::move(next);
  choose_best();  // the best so far may have drawn no slot: report the best that lives on
  ++statistics_.resamplings;
}

void FastSlam::account() {
  const auto n = static_cast<double>(particles_.size());
  const double fixed = static_cast<double>(paths_.bytes()) + n * sizeof(Particle);
  const double payload = static_cast<double>(meter_->payload()) / n;
  const double all_in = (static_cast<double>(meter_->total()) + fixed) / n;
  const auto count = static_cast<double>(++statistics_.registered);
  statistics_.payload_bytes += (payload - statistics_.payload_bytes) / count;
  statistics_.bytes += (all_in - statistics_.bytes) / count;
  statistics_.bytes_peak = std::max(statistics_.bytes_peak, all_in);
}

const Particle& FastSlam::best() const { return particles_[best_]; }

Pose2 FastSlam::T_map_base() const { return best().T_map_base * motion_.T_last_now(); }

std::vector<RegisteredPose> FastSlam::best_path() const { return paths_.path_to(best().node); }

Grid<float> FastSlam::best_map() const {
  MapScratch scratch;
  const auto area = config_.map_frame();
  best().map.load(area ? window_of(*area) : best().map.extent(), scratch);
  return scratch.log_odds;
}

FilterStatistics FastSlam::statistics() const {
  FilterStatistics statistics = statistics_;
  constexpr int kBack = 100;
  if (statistics.registered > kBack) {
    std::set<PathTree::Node> ancestors;
    for (const Particle& particle : particles_) ancestors.insert(paths_.ancestor(particle.node, kBack));
    statistics.ancestors_100 = static_cast<double>(ancestors.size());
  }
  return statistics;
}

std::uint64_t FastSlam::state_hash() const {
  Hash hash;
  for (const Particle& particle : particles_) {
    hash.add(particle.T_map_base.x).add(particle.T_map_base.y).add(particle.T_map_base.theta);
    hash.add(particle.log_weight).add(particle.path_log_weight);
    hash.add(particle.compass_bias.mean).add(particle.compass_bias.variance);
    particle.map.add_to(hash);
  }
  return hash.value();
}

}  // namespace cogslam
