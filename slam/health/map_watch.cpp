#include "slam/health/map_watch.hpp"

#include <algorithm>

namespace cogslam {
namespace {

constexpr int kEnough = 20;             // probes in known cells, to judge a scan by
constexpr double kContradicted = 0.5;   // share of them
constexpr double kHeadingSigmas = 4.0;  // 1 heading of 16000 by chance
constexpr double kFewParticles = 1.5;

}  // namespace

void MapWatch::see(const BestLook& look, double effective, int particles, FilterHealth& health) {
  if (look.heading_sigmas) {
    ++health.headings;
    if (*look.heading_sigmas > kHeadingSigmas) ++health.headings_doubted;
  }
  if (particles > 1 && effective < kFewParticles) ++health.collapses;
  if (look.scan.known < kEnough) return;
  ++health.scans_judged;
  health.beams_known += look.scan.known;
  health.beams_doubted += look.scan.contradicted;
  const bool doubted = look.scan.contradicted > kContradicted * look.scan.known;
  in_a_row_ = doubted ? in_a_row_ + 1 : 0;
  if (doubted) ++health.scans_doubted;
  health.longest_doubt = std::max(health.longest_doubt, in_a_row_);
}

}  // namespace cogslam
