// What a scan costs with each map store, all in one run: bytes, time and difference of the maps; with and without
// sharing; in a small and in a large world. A scan is 1081 beams of 5 m in an office, cells of 0.05 m, one thread.

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <string>

#include "bench/office.hpp"
#include "core/check.hpp"
#include "eval/metrics/timing.hpp"
#include "slam/codec/coefficient_code.hpp"
#include "slam/codec/haar.hpp"
#include "slam/map/inverse_sensor_model.hpp"
#include "slam/map/store.hpp"

namespace cogslam {
namespace {

using bench::Office;
constexpr double kCell = Office::kCell;

struct Times {
  double load = 0.0, walk = 0.0, commit = 0.0;  ///< [s]
  [[nodiscard]] double all() const { return load + walk + commit; }
};

/// One map under one store, and what its scans cost.
struct Mapper {
  std::shared_ptr<MemoryMeter> meter = std::make_shared<MemoryMeter>();
  MapStore map;
  MapScratch scratch;
  MapUpdater updater;
  Times times;

  Mapper(StoreKind kind, const std::optional<GridFrame>& area)
      : map({.kind = kind, .percent_kept = 40.0}, kCell, area, meter) {}

  void scan(MapStore& to, const std::vector<Beam>& sweep, const Pose2& pose) {
    const CellWindow window = window_of(sweep, pose, kCell);
    const bool levels = to.has_levels();
    const Stopwatch load(Clock::kThreadCpu);
    levels ? to.load_levels(window, scratch) : to.load(window, scratch);
    times.load += load.seconds();
    const Stopwatch walk(Clock::kThreadCpu);
    const CellWindow changed = levels ? updater.integrate(sweep, pose, LatticeModel{}, scratch.levels)
                                      : updater.integrate(sweep, pose, LogOddsModel{}, scratch.log_odds);
    times.walk += walk.seconds();
    const Stopwatch commit(Clock::kThreadCpu);
    levels ? to.commit_levels(changed, scratch) : to.commit(changed, scratch);
    times.commit += commit.seconds();
  }
  void scan(const std::vector<Beam>& sweep, const Pose2& pose) { scan(map, sweep, pose); }

  [[nodiscard]] Grid<float> cells(const CellWindow& window) {
    map.load(window, scratch);
    return scratch.log_odds;
  }
};

/// Scans that fill a world of `rooms` x `rooms` rooms, from the doors of every row.
void for_each_scan(int rooms, const std::function<void(const std::vector<Beam>&, const Pose2&)>& visit) {
  Rng rng({.seed = 1, .purpose = Purpose::kWorld});
  for (int j = 0; j < rooms; ++j) {
    for (int i = 0; i < rooms; ++i) {
      for (int quarter = 0; quarter < 4; ++quarter) {
        Pose2 pose = Office::door(i, j, quarter * std::numbers::pi / 2);
        pose.x += 0.8 * quarter;
        visit(Office::scan(pose, rng), pose);
      }
    }
  }
}

/// A walk along the rooms of the middle row, a scan every 0.3 m.
void walk(int rooms, int steps, const std::function<void(const std::vector<Beam>&, const Pose2&)>& visit) {
  Rng rng({.seed = 2, .purpose = Purpose::kWorld});
  for (int step = 0; step < steps; ++step) {
    Pose2 pose = Office::door(rooms / 2, rooms / 2, 0.02 * step);
    pose.x += 0.3 * (step % 20);
    visit(Office::scan(pose, rng), pose);
  }
}

int class_of(float log_odds) { return log_odds > 0.619F ? 2 : (log_odds < -0.619F ? 0 : 1); }  // p > 0.65, p < 0.35

double percent_different(const Grid<float>& a, const Grid<float>& b, const CellWindow& window) {
  const auto at = [](const Grid<float>& grid, Cell c) {
    const Cell in_frame{c.x - grid.frame().lattice_min.x, c.y - grid.frame().lattice_min.y};
    return grid.frame().contains(in_frame) ? grid[in_frame] : 0.0F;
  };
  std::size_t different = 0;
  for (int y = window.min.y; y <= window.max.y; ++y) {
    for (int x = window.min.x; x <= window.max.x; ++x) {
      different += class_of(at(a, {x, y})) != class_of(at(b, {x, y})) ? 1 : 0;
    }
  }
  return 100.0 * static_cast<double>(different) / (static_cast<double>(window.width()) * window.height());
}

const std::map<StoreKind, const char*> kNames{{StoreKind::kDense, "dense float"},
                                              {StoreKind::kLattice, "lattice"},
                                              {StoreKind::kTiles, "tiles"},
                                              {StoreKind::kTwoResolution, "two resolutions"},
                                              {StoreKind::kCoefficients, "COG 40 %"}};

/// Every store on a grid of `side` x `side` cells, filled before.
void compare_stores(int side) {
  const int rooms = side / 120;
  const GridFrame area{.cell_size = kCell, .lattice_min = {-16, -16}, .width = side, .height = side};
  Mapper dense(StoreKind::kDense, area);
  for_each_scan(rooms, [&](const auto& sweep, const Pose2& pose) { dense.scan(sweep, pose); });
  const Grid<float> filled = dense.cells(window_of(area));
  const int steps = side > 1000 ? 10 : 40;
  const double float_bytes = 4.0 * static_cast<double>(area.size());
  std::printf("\n%d x %d cells (%.0f m), %d scans on a filled map\n", side, side, side * kCell, steps);
  std::printf("%-16s %12s %8s %12s | %8s %8s %8s %9s us | %s\n", "store", "payload", "% float", "all-in", "load",
              "walk", "commit", "step", "cells of another class than dense float");
  Grid<float> reference;
  for (const StoreKind kind : {StoreKind::kDense, StoreKind::kLattice, StoreKind::kTiles, StoreKind::kTwoResolution,
                               StoreKind::kCoefficients}) {
    Mapper mapper(kind, area);
    mapper.map.load(window_of(area), mapper.scratch);
    mapper.scratch.log_odds = filled;
    mapper.map.commit(window_of(area), mapper.scratch);
    for (std::uint64_t scan = 1; scan <= 12; ++scan) mapper.map.settle(scan);
    walk(rooms, steps, [&](const auto& sweep, const Pose2& pose) { mapper.scan(sweep, pose); });
    const Grid<float> cells = mapper.cells(window_of(area));
    if (kind == StoreKind::kDense) reference = cells;
    const auto payload = static_cast<double>(mapper.meter->payload());
    std::printf("%-16s %12.0f %8.2f %12.0f | %8.1f %8.1f %8.1f %9.1f    | %.3f %%\n", kNames.at(kind), payload,
                100.0 * payload / float_bytes, static_cast<double>(mapper.meter->total()),
                1e6 * mapper.times.load / steps, 1e6 * mapper.times.walk / steps, 1e6 * mapper.times.commit / steps,
                1e6 * mapper.times.all() / steps, percent_different(reference, cells, window_of(area)));
    if (kind == StoreKind::kCoefficients) {
      const double bitmap = payload / 2 + static_cast<double>(HaarCanvas::covering(side, side).support() + 7) / 8;
      std::printf("%-16s %12.0f %8.2f   (a bit per position in place of 4 bytes per index)\n", "", bitmap,
                  100.0 * bitmap / float_bytes);
    }
  }
}

/// Twenty particles with poses of their own; every fifth step half of them are replaced by copies of the others.
Mapper particles(StoreKind kind, bool resampled) {
  Mapper mapper(kind, std::nullopt);
  std::vector<MapStore> maps(20, mapper.map);
  Rng jitter({.seed = 3, .purpose = Purpose::kWorld});
  std::uint64_t step = 0;
  walk(4, 120, [&](const auto& sweep, Pose2 pose) {
    for (MapStore& map : maps) {
      pose.x += 0.002 * jitter.normal();
      pose.y += 0.002 * jitter.normal();
      mapper.scan(map, sweep, pose);
    }
    ++step;
    for (MapStore& map : maps) map.settle(step);
    if (!resampled || step % 5 != 0) return;
    for (std::size_t p = 0; p < 10; ++p) maps[jitter.below(20)] = maps[jitter.below(20)];
  });
  return mapper;
}

void compare_sharing() {
  std::printf("\n20 particles, 120 scans, maps that grow; us per particle and scan\n");
  for (const bool resampled : {true, false}) {
    std::map<StoreKind, Times> sums;
    for (const StoreKind kind : {StoreKind::kTiles, StoreKind::kLattice, StoreKind::kDense}) {
      Times& best = sums[kind];
      for (int round = 0; round < 3; ++round) {
        const Times times = particles(kind, resampled).times;
        if (round == 0 || times.all() < best.all()) best = times;
      }
      const double scans = 20.0 * 120.0;
      std::printf("%-10s %-12s load %6.1f  walk %6.1f  commit %6.1f  step %6.1f\n", resampled ? "resampled" : "alone",
                  kNames.at(kind), 1e6 * best.load / scans, 1e6 * best.walk / scans, 1e6 * best.commit / scans,
                  1e6 * best.all() / scans);
    }
    std::printf("  tiles / lattice: step %.2f; tiles / dense float: step %.2f\n",
                sums[StoreKind::kTiles].all() / sums[StoreKind::kLattice].all(),
                sums[StoreKind::kTiles].all() / sums[StoreKind::kDense].all());
  }
}

void compare_worlds() {
  std::printf("\ntiles in a filled world, 40 scans\n");
  double small = 0.0;
  for (const int rooms : {3, 33}) {
    Mapper mapper(StoreKind::kTiles, std::nullopt);
    std::uint64_t scans = 0;
    for_each_scan(rooms, [&](const auto& sweep, const Pose2& pose) {
      mapper.scan(sweep, pose);
      mapper.map.settle(++scans);
    });
    double best = 1e9;
    for (int round = 0; round < 5; ++round) {
      mapper.times = {};
      walk(rooms, 40, [&](const auto& sweep, const Pose2& pose) {
        mapper.scan(sweep, pose);
        mapper.map.settle(++scans);
      });
      best = std::min(best, mapper.times.all());
    }
    std::printf("%3.0f x %3.0f m: %8lld bytes all-in, %6.1f us per scan", 6.0 * rooms, 6.0 * rooms,
                static_cast<long long>(mapper.meter->total()), 1e6 * best / 40);
    std::printf(rooms == 3 ? "\n" : "  (%.2f x)\n", best / small);
    small = best;
  }
}

}  // namespace
}  // namespace cogslam

int main() {
  cogslam::compare_stores(512);
  cogslam::compare_stores(2048);
  cogslam::compare_sharing();
  cogslam::compare_worlds();
  return 0;
}
