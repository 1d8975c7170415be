#include "eval/sense/path_offset_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/check.hpp"
#include "eval/sense/path_look.hpp"
#include "worlds/clearance.hpp"
#include "worlds/free_space.hpp"
#include "worlds/hallway.hpp"
#include "worlds/polygon.hpp"

namespace cogslam {
namespace {

constexpr int kPointsPerSide = 4;
constexpr double kHalfWall = 0.125;  // of drawn surfaces: walls one cell thick, as in the reference's maps [m]
constexpr double kRoomAround = 0.9;  // of the first pose: the second is up to 0.75 m off each way [m]
constexpr double kRoomAroundSecond = 0.05;

struct Places {
  Pose2 T_map_first, T_first_second;
};

/// The `index`-th random pair of places on the floor.
Places draw_places(const OffsetStudy& study, const World& world, const FreeSpace& floor, std::size_t index) {
  Rng rng({.seed = study.seed, .purpose = Purpose::kWorld, .entity = static_cast<std::uint32_t>(index)});
  const Rectangle area = world.bounds();
  const double most = study.most_cells * study.map.cell_size_m;
  for (;;) {
    const Pose2 first{rng.uniform(area.min.x(), area.max.x()), rng.uniform(area.min.y(), area.max.y()),
                      rng.uniform(-std::numbers::pi, std::numbers::pi)};
    const Pose2 offset{rng.uniform(-most, most), rng.uniform(-most, most),
                       rng.uniform(-study.most_turn, study.most_turn)};
    const Eigen::Vector2d second = (first * offset).position();
    if (!floor.contains(first.position()) || clearance(world, first.position()) < kRoomAround) continue;
    if (!floor.contains(second) || clearance(world, second) < kRoomAroundSecond) continue;
    return {first, offset};
  }
}

PartialMap drawn_map(const OffsetStudy& study, const World& world, const Pose2& T_map_base) {
  PartialMap map{drawn_occupancy(world, T_map_base, study.map.frame(), kHalfWall),
                 Grid<double>(study.map.frame(), 1.0)};
  return map;
}

}  // namespace

std::string OffsetStudy::check() const {
  if (const std::string wrong = map.check(); !wrong.empty()) return wrong;
  if (samples < 0 || samples > map.cells()) {
    return fmt::format("samples: expected 0 (all) to {}, the cells of a partial map, found {}", map.cells(), samples);
  }
  if (draws < 1) return "draws: expected at least 1";
  return offset.check();
}

Grid<double> drawn_occupancy(const World& world, const Pose2& T_map_frame, const GridFrame& frame, double half_wall_m) {
  Grid<double> out(frame);
  const Pose2 T_frame_map = T_map_frame.inverse();
  const double step = frame.cell_size / kPointsPerSide;
  std::vector<bool> hit(frame.size() * kPointsPerSide * kPointsPerSide, false);
  const int width = frame.width * kPointsPerSide, height = frame.height * kPointsPerSide;
  const Eigen::Vector2d first = frame.origin() + Eigen::Vector2d::Constant(0.5 * step);
  for (const Segment& wall : world.segments()) {
    const Segment s{T_frame_map * wall.a, T_frame_map * wall.b};
    const Eigen::Array2d low = (s.a.cwiseMin(s.b) - first).array() / step - half_wall_m / step;
    const Eigen::Array2d high = (s.a.cwiseMax(s.b) - first).array() / step + half_wall_m / step;
    for (int y = std::max(0, static_cast<int>(std::ceil(low.y()))); y <= std::min<double>(height - 1, high.y()); ++y) {
      for (int x = std::max(0, static_cast<int>(std::ceil(low.x()))); x <= std::min<double>(width - 1, high.x()); ++x) {
        const std::size_t i =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
        if (hit[i] || distance(s, first + step * Eigen::Vector2d(x, y)) > half_wall_m) continue;
        hit[i] = true;
        out[{x / kPointsPerSide, y / kPointsPerSide}] += 1.0 / (kPointsPerSide * kPointsPerSide);
      }
    }
  }
  return out;
}

std::vector<OffsetDraw> run_offset_study(const OffsetStudy& study, Workers& workers) {
  EXPECTS(study.check().empty());
  const World world = hallway();
  const FreeSpace floor(world);
  const Lidar lidar(LidarConfig::lms200(), world, study.seed);
  const int samples = study.samples == 0 ? study.map.cells() : study.samples;
  std::vector<OffsetDraw> draws(static_cast<std::size_t>(study.draws));
  workers.for_each(draws.size(), [&](std::size_t i, int) {
    const Places places = draw_places(study, world, floor, i);
    const auto map_at = [&](const Pose2& T_map_base, std::size_t index) {
      const PartialMap map = study.source == OffsetSource::kDrawn
                                 ? drawn_map(study, world, T_map_base)
                                 : partial_map(study.map, look_from(lidar, T_map_base, index));
      return recover_from_samples(map, samples, study.seed, static_cast<std::uint32_t>(index));
    };
    OffsetDraw draw{places.T_map_first, places.T_first_second};
    draw.found = estimate_offset(map_at(places.T_map_first, 2 * i),
                                 map_at(places.T_map_first * places.T_first_second, 2 * i + 1), {}, study.offset);
    const Pose2 error = places.T_first_second.inverse() * draw.found.T_first_second;
    draw.error_cells = error.position().norm() / study.map.cell_size_m;
    draw.error_turn = std::abs(error.theta);
    draws[i] = draw;
  });
  return draws;
}

OffsetSummary summarise(const std::vector<OffsetDraw>& draws) {
  EXPECTS(!draws.empty());
  OffsetSummary s{.draws = static_cast<int>(draws.size())};
  std::vector<double> cells, turns;
  for (const OffsetDraw& draw : draws) {
    cells.push_back(draw.error_cells);
    turns.push_back(draw.error_turn);
    s.succeeded += draw.succeeded() ? 1 : 0;
    s.claimed += draw.claims_all() ? 1 : 0;
    s.claimed_succeeded += draw.claims_all() && draw.succeeded() ? 1 : 0;
    s.not_estimated += draw.found.estimated ? 0 : 1;
    s.partly += draw.found.estimated && !draw.claims_all() ? 1 : 0;
  }
  const auto middle = static_cast<std::ptrdiff_t>(draws.size() / 2);
  std::nth_element(cells.begin(), cells.begin() + middle, cells.end());
  std::nth_element(turns.begin(), turns.begin() + middle, turns.end());
  s.median_cells = cells[static_cast<std::size_t>(middle)];
  s.median_turn = turns[static_cast<std::size_t>(middle)];
  return s;
}

std::string offset_table(const OffsetSummary& s) {
  const auto percent = [](int part, int all) { return all > 0 ? 100.0 * part / all : 0.0; };
  return fmt::format(
      "median error              {:.4f} cells, {:.4f} deg\n"
      "below 0.5 cell and 1 deg  {} of {} ({:.1f} %)\n"
      "  where all is observed   {} of {} ({:.1f} %)\n"
      "partly observed           {}\n"
      "not estimated             {}\n",
      s.median_cells, degrees(s.median_turn), s.succeeded, s.draws, percent(s.succeeded, s.draws), s.claimed_succeeded,
      s.claimed, percent(s.claimed_succeeded, s.claimed), s.partly, s.not_estimated);
}

std::string offset_csv(const std::vector<OffsetDraw>& draws) {
  std::string out = "x_m,y_m,heading_deg,dx_m,dy_m,dtheta_deg,error_cells,error_deg,estimated,observed\n";
  for (const OffsetDraw& d : draws) {
    out +=
        fmt::format("{},{},{},{},{},{},{},{},{},{}\n", d.T_map_first.x, d.T_map_first.y, degrees(d.T_map_first.theta),
                    d.T_first_second.x, d.T_first_second.y, degrees(d.T_first_second.theta), d.error_cells,
                    degrees(d.error_turn), d.found.estimated ? 1 : 0, d.found.observed_directions);
  }
  return out;
}

}  // namespace cogslam
