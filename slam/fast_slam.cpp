#include "slam/fast_slam.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/check.hpp"
#include "slam/resampling.hpp"

namespace cogslam {
namespace {

constexpr double kFarthestMargin = 1e6;  // cells; what odometry that knows nothing would ask for

}  // namespace

FastSlam::FastSlam(const SlamConfig& config, std::uint32_t seed, Workers& workers, StageListener* listener)
    : config_(config),
      seed_(seed),
      workers_(workers),
      stage_{.listener = listener},
      meter_(std::make_shared<MemoryMeter>()),
      paths_(static_cast<std::size_t>(config.particles)),
      motion_(config.motion),
      drift_(config.loops),
      waiting_(config.tracks() ? config.loops.waiting_scans : 0) {
  config.check();
  if (config.tracks()) tracker_.emplace(config.tracker, config.sweep);
  const MapStore empty(config.store, config.cell_size, config.map_frame(), meter_);
  const double bias_variance = config.compass.bias_sigma * config.compass.bias_sigma;
  particles_.assign(static_cast<std::size_t>(config.particles),
                    Particle{.T_map_base = config.start, .compass_bias = {0.0, bias_variance}, .map = empty});
  for (int w = 0; w < workers.threads(); ++w) {
    map_workers_.push_back(std::make_unique<MapWorker>(config, StageMarker{listener, w}));
  }
}

FastSlam::~FastSlam() = default;

bool FastSlam::update(const Reading& reading) {
  stage_.enter(Stage::kTrack);
  if (scan_watch_.see(reading, health_)) return update_without_scan(reading);
  follow(reading);
  const bool first = statistics_.registered == 0;
  const bool registered = reading.scan && (first || config_.registration.due(motion_.T_last_now()));
  if (registered) {
    step(reading);
    motion_.restart();
    stage_.enter(Stage::kTrack);
    if (tracker_) tracker_->make_key();
  } else if (reading.scan) {
    ++statistics_.tracked;
  }
  ++records_;
  stage_.leave();
  return registered;
}

/// A scan that a frozen lidar repeats would hold the robot where it was taken: only the motion is taken.
bool FastSlam::update_without_scan(Reading reading) {
  reading.scan.reset();
  follow(reading);
  ++records_;
  stage_.leave();
  return false;
}

void FastSlam::follow(const Reading& reading) {
  if (!tracker_) {
    motion_.add(reading.motion);
    T_odom_base_ = T_odom_base_ * reading.motion.T_before_now;
    return;
  }
  tracker_->follow(reading);
  motion_.add(reading.motion);
  motion_.correct(tracker_->T_key_now());
  T_odom_base_ = tracker_->T_track_base();
  odometry_watch_.see(reading.motion, T_odom_base_, reading.scan.has_value(), health_);
}

// Algorithms 1 and 3. The lines are those of Alg. 3; with the dense store, 5 and 8 copy plain cells (Alg. 1).
void FastSlam::step(const Reading& reading) {
  stage_.enter(Stage::kPrepare);
  sweep_ = sweep_of(reading, config_.sweep);
  if (!config_.area) grow_reach();
  probes_ = map_workers_[0]->likelihood().probes_of(sweep_);
  spread_motion();
  waiting_.add(records_, reading);
  entering_ = waiting_.ripe() ? sweep_of(waiting_.oldest().reading, config_.sweep) : std::vector<Beam>{};
  workers_.for_each(particles_.size(), [&](std::size_t p, int worker) {  // (3) for p = 1..n
    MapWorker& own = *map_workers_[static_cast<std::size_t>(worker)];
    advance(particles_[p], p, reading, own);
    own.leave();
  });
  stage_.enter(Stage::kSettle);
  record_paths();
  // One after another: what is sealed is the same for any number of threads.
  for (Particle& particle : particles_) particle.map.settle(static_cast<std::uint64_t>(statistics_.registered) + 1);
  account();
  stage_.enter(Stage::kResample);
  resample_if_due();  // (12)-(15)
  map_watch_.see(look_, statistics_.last.effective_particles, config_.particles, health_);
}

/// How far the motion since the last registered scan is trusted; with a tracker, as far as it drifts while nothing old
/// is in sight, and farther where a loop closes.
void FastSlam::spread_motion() {
  if (!tracker_) {
    spread_ = motion_.covariance();
    return;
  }
  drift_.move(motion_.T_last_now());
  // Asked of the best particle for all: their paths differ by less than sight reaches. To walk its whole path costs far
  // less than one particle's match.
  drift_.look(drift_.old_map_in_sight(T_map_base(), best_path()));
  spread_ = tracker_->spread() + drift_.released();
}

/// Before any particle's map grows: to where the best one's will.
void FastSlam::grow_reach() {
  const CellWindow seen = window_of(sweep_, T_map_base(), config_.cell_size);
  if (seen.empty()) return;
  reach_.include(seen.min);
  reach_.include(seen.max);
  check_reach(reach_);
}

void FastSlam::advance(Particle& particle, std::size_t slot, const Reading& reading, MapWorker& worker) {
  const double before = particle.log_weight;
  Rng rng(
      {.seed = seed_, .purpose = Purpose::kMotionSample, .entity = static_cast<std::uint32_t>(slot), .tick = records_});
  if (config_.proposal == Proposal::kMotion) {
    propose_by_motion(particle, rng, worker);  // (4), (5), (6)
  } else {
    propose_by_match(particle, rng, worker);
  }
  if (slot == best_) look_ = look_of(particle, reading, worker);
  if (reading.heading && config_.compass.used) {
    particle.log_weight +=
        compass_log_likelihood(*reading.heading, particle.T_map_base.theta, config_.compass, particle.compass_bias);
  }
  particle.path_log_weight += particle.log_weight - before;
  if (!waiting_.ripe()) {
    particle.waiting.add(particle.T_map_base);
    return;
  }
  particle.entering = particle.waiting.exchange(particle.T_map_base);
  worker.write(particle.map, entering_, particle.entering.pose());  // (7), (8)
}

/// Before the compass's bias learns from this heading, and the map from this scan.
BestLook FastSlam::look_of(const Particle& particle, const Reading& reading, const MapWorker& worker) const {
  BestLook look;
  if (reading.heading && config_.compass.used) {
    look.heading_sigmas =
        compass_sigmas(*reading.heading, particle.T_map_base.theta, config_.compass, particle.compass_bias);
  }
  const bool first = statistics_.registered == 0;  // nothing was looked at
  if (!first) look.scan = worker.likelihood().agreement(probes_, particle.T_map_base);
  return look;
}

/// (5): the window that the scan can touch from poses up to `margin_cells` away, and the scan that enters.
void FastSlam::load_around(const Pose2& T_map_base, const Particle& particle, int margin_cells,
                           MapWorker& worker) const {
  CellWindow window = window_of(sweep_, T_map_base, config_.cell_size).grown(margin_cells);
  if (waiting_.ripe() && particle.waiting.size() > 0) {
    window = hull(window, window_of(entering_, particle.waiting[0], config_.cell_size));
  }
  if (!config_.area) check_reach(window);
  worker.load(particle.map, window);
}

void FastSlam::propose_by_motion(Particle& particle, Rng& rng, MapWorker& worker) const {
  const bool first = statistics_.registered == 0;  // the start pose is given: no noise, and no map to weigh against
  particle.T_map_base = first ? particle.T_map_base * motion_.T_last_now() : motion_.sample(particle.T_map_base, rng);
  load_around(particle.T_map_base, particle, worker.likelihood().margin_cells(), worker);
  worker.look();
  particle.log_weight += worker.likelihood().log_likelihood(probes_, particle.T_map_base);  // (6), eq. (8)
}

// Grisetti et al. 2007, sec. IV: the proposal uses the scan too, so few particles are wasted. The weight should be
// p(z | x', u) = integral of p(z | x) p(x | x', u) dx, here by Laplace's method about the mode. A heuristic departs
// from it: the match takes p(z | x)^sharpness, the weight the 1/sharpness power of the whole integral, motion prior and
// volume included, because a scan is sharper evidence of where it lies in its map than of which of two maps is right.
// It favours particles a little less than it should whose match agrees with odometry.
void FastSlam::propose_by_match(Particle& particle, Rng& rng, MapWorker& worker) const {
  const Pose2 predicted = particle.T_map_base * motion_.T_last_now();
  if (statistics_.registered == 0) {
    particle.T_map_base = predicted;
    load_around(predicted, particle, 0, worker);
    return;
  }
  load_around(predicted, particle, worker.likelihood().margin_cells() + search_margin_cells(), worker);
  worker.look();
  const double sharpness = config_.matcher.sharpness;
  const PoseScore score{
      [&](const Pose2& pose) { return sharpness * worker.likelihood().field_log_likelihood(probes_, pose); },
      [&](const Pose2& pose) { return sharpness * worker.likelihood().field_fit(probes_, pose); }};
  const ScanMatch match = match_scan(score, predicted, spread_, config_.matcher);
  particle.T_map_base = sample_pose(match.T_map_base, match.covariance, rng);
  const double log_evidence =
      match.log_posterior + 0.5 * std::log(match.covariance.determinant() / spread_.determinant());
  particle.log_weight += log_evidence / sharpness;
  if (drift_.closes_loop()) {  // what waits was tracked from here, and moves along
    particle.waiting.move(particle.T_map_base * predicted.inverse());
  }
}

/// How far end points move when the search goes to its limits.
int FastSlam::search_margin_cells() const {
  double longest = 0.0;
  for (const Beam& beam : sweep_) longest = std::max(longest, beam.end.norm());
  const double shift = farthest_move(spread_, longest, config_.matcher);
  return static_cast<int>(std::ceil(std::min(shift / config_.cell_size, kFarthestMargin))) + 1;
}

void FastSlam::record_paths() {
  if (waiting_.ripe()) {
    std::vector<StoredPose> entering;
    for (const Particle& particle : particles_) entering.push_back(particle.entering);
    paths_.append(waiting_.oldest().record, entering);
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
  statistics_.last.effective_particles = effective_sample_size(weights);
  statistics_.last.resampled = config_.resampling.every_step || statistics_.last.effective_particles < enough;
  if (!statistics_.last.resampled) return;

  Rng rng({.seed = seed_, .purpose = Purpose::kResample, .tick = records_});
  const std::vector<std::size_t> chosen = systematic_resample(weights, rng.uniform());
  std::vector<Particle> next;
  next.reserve(particles_.size());
  for (const std::size_t j : chosen) {
    next.push_back(particles_[j]);  // shares the map
    next.back().log_weight = 0.0;
  }
  particles_ = std::move(next);
  paths_.resample(chosen);
  choose_best();  // the best so far may have drawn no slot: report the best that lives on
  ++statistics_.resamplings;
}

void FastSlam::account() {
  const auto n = static_cast<double>(particles_.size());
  std::int64_t fixed = paths_.bytes() + waiting_.bytes() + drift_.bytes();
  for (const Particle& particle : particles_)
    fixed += static_cast<std::int64_t>(sizeof(Particle)) + particle.waiting.bytes();
  const double payload = static_cast<double>(meter_->payload()) / n;
  const double all_in = static_cast<double>(meter_->total() + fixed) / n;
  const auto count = static_cast<double>(++statistics_.registered);
  statistics_.payload_bytes += (payload - statistics_.payload_bytes) / count;
  statistics_.bytes += (all_in - statistics_.bytes) / count;
  statistics_.bytes_peak = std::max(statistics_.bytes_peak, all_in);
  statistics_.last.payload_bytes = payload;
  statistics_.last.bytes = all_in;
}

const Particle& FastSlam::best() const { return particles_[best_]; }

}  // namespace cogslam
