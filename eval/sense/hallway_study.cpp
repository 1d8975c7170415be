#include "eval/sense/hallway_study.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "worlds/hallway.hpp"

namespace cogslam {
namespace {

double ratio(double corrected, double odometry) { return odometry > 0.0 ? corrected / odometry : 0.0; }

}  // namespace

HallwayRun run_hallway(const PathDriveConfig& drive, const PathCorrectionConfig& correction, std::uint32_t seed) {
  HallwayRun run{.looks = drive_path(hallway(), hallway_route(), drive, seed)};
  run.corrected = correct_path(run.looks, correction, seed);
  return run;
}

HallwayScore score_hallway(const HallwayRun& run, std::uint32_t seed) {
  std::vector<Pose2> odometry, corrected;
  for (const PathLook& look : run.looks) odometry.push_back(look.T_odom_base);
  HallwayScore score{.seed = seed};
  for (const CorrectedLook& look : run.corrected) {
    corrected.push_back(look.T_map_base);
    if (look.offset) score.links.add(*look.offset);
  }
  score.odometry = path_deviation(run.looks, odometry);
  score.corrected = path_deviation(run.looks, corrected);
  return score;
}

std::vector<HallwayScore> run_hallway_study(const HallwayStudy& study, Workers& workers) {
  std::vector<HallwayScore> scores(static_cast<std::size_t>(study.seeds));
  workers.for_each(scores.size(), [&](std::size_t i, int) {
    const std::uint32_t seed = study.first_seed + static_cast<std::uint32_t>(i);
    scores[i] = score_hallway(run_hallway(study.drive, study.correction, seed), seed);
  });
  for (const HallwayScore& score : scores) expect_overlap(score.links, study.correction.offset);
  return scores;
}

std::string hallway_table(const std::vector<HallwayScore>& scores) {
  std::string out =
      "                 heading [deg]               across [m]               along [m]               links\n"
      "   seed   odom  correct  ratio      odom  correct  ratio      odom  correct     all  none  apart  partly\n";
  double heading = 0.0, across = 0.0;
  for (const HallwayScore& s : scores) {
    const double heading_ratio = ratio(s.corrected.heading, s.odometry.heading);
    const double across_ratio = ratio(s.corrected.across, s.odometry.across);
    heading = std::max(heading, heading_ratio);
    across = std::max(across, across_ratio);
    out += fmt::format(
        "{:>7} {:>6.2f} {:>8.2f} {:>6.3f} {:>9.2f} {:>8.2f} {:>6.3f} {:>9.2f} {:>8.2f} {:>7} {:>5} {:>6} {:>7}\n",
        s.seed, degrees(s.odometry.heading), degrees(s.corrected.heading), heading_ratio, s.odometry.across,
        s.corrected.across, across_ratio, s.odometry.along, s.corrected.along, s.links.all, s.links.not_estimated,
        s.links.no_overlap, s.links.not_observed);
  }
  return out + fmt::format("worst ratio: heading {:.3f}, across {:.3f}\n", heading, across) +
         "links: none kept odometry, those apart as their maps do not overlap, partly in one direction or two\n";
}

std::string hallway_csv(const std::vector<HallwayScore>& scores) {
  std::string out =
      "seed,odometry_heading_deg,odometry_across_m,odometry_along_m,corrected_heading_deg,corrected_across_m,"
      "corrected_along_m,links,not_estimated,no_overlap,not_observed\n";
  for (const HallwayScore& s : scores) {
    out += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", s.seed, degrees(s.odometry.heading), s.odometry.across,
                       s.odometry.along, degrees(s.corrected.heading), s.corrected.across, s.corrected.along,
                       s.links.all, s.links.not_estimated, s.links.no_overlap, s.links.not_observed);
  }
  return out;
}

}  // namespace cogslam
