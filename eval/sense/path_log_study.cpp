#include "eval/sense/path_log_study.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/check.hpp"
#include "core/error.hpp"
#include "eval/metrics/path_completion.hpp"

namespace cogslam {
namespace {

std::string rows(const char* name, const RelationErrors& errors) {
  std::string out;
  const auto row = [&](const char* split, const RelationStats& s) {
    out += fmt::format("{:<10} {:<7} {:>6} {:>8.3f} +- {:<8.3f} {:>8.3f} +- {:<8.3f}\n", name, split, s.count,
                       s.trans_mean, s.trans_std, degrees(s.rot_mean), degrees(s.rot_std));
  };
  row("local", errors.local);
  row("global", errors.global);
  row("all", errors.all);
  return out;
}

}  // namespace

std::string LogPathConfig::check() const {
  if (const std::string wrong = map.check(); !wrong.empty()) return wrong;
  if (samples < 1 || samples > map.cells()) {
    return fmt::format("samples: expected 1 to {}, the cells of a partial map, found {}", map.cells(), samples);
  }
  if (!(step_m > 0.0)) return "step_m: expected more than 0";
  if (!(step_turn > 0.0)) return "step_turn: expected more than 0";
  return offset.check();
}

LogPath correct_log(const CarmenLog& log, const std::filesystem::path& file, const LogPathConfig& config) {
  EXPECTS(config.check().empty());
  if (log.scans == 0) {
    throw InputError({file.string()}, "no laser scan in the log, expected FLASER or ROBOTLASER1 lines");
  }
  LogPath path;
  std::vector<RegisteredPose> registered;
  OffsetChain chain(config.offset, log.odometry.front());
  std::size_t before = 0;
  for (std::size_t i = 0; i < log.readings.size(); ++i) {
    if (!log.readings[i].scan) continue;
    const Pose2 moved = log.odometry[before].inverse() * log.odometry[i];
    const bool far = moved.position().norm() >= config.step_m || std::abs(moved.theta) >= config.step_turn;
    if (!registered.empty() && !far) continue;
    const PartialMap map = recover_from_samples(partial_map(config.map, *log.readings[i].scan), config.samples,
                                                config.seed, static_cast<std::uint32_t>(i));
    const std::optional<Offset> offset = chain.push(map, moved);
    ++path.maps;
    if (offset) path.links.add(*offset);
    registered.push_back({.record = i, .T_map_base = chain.pose()});
    before = i;
  }
  expect_overlap(path.links, config.offset, {file.string()});
  path.poses = complete_path(log.odometry, registered);
  return path;
}

std::string log_table(const LogPath& path, const RelationErrors& odometry, const RelationErrors& corrected) {
  return fmt::format(
             "{} partial maps, {} links not estimated ({} without overlap), {} with a direction not observed\n\n",
             path.maps, path.links.not_estimated, path.links.no_overlap, path.links.not_observed) +
         fmt::format("{:<10} {:<7} {:>6} {:>20} {:>20}\n", "path", "split", "count", "translation [m]", "turn [deg]") +
         rows("odometry", odometry) + rows("corrected", corrected);
}

}  // namespace cogslam
