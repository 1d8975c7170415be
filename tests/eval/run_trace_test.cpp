#include "eval/run_trace.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/rng.hpp"
#include "eval/metrics/map_error.hpp"
#include "eval/variant_run.hpp"

namespace cogslam {
namespace {

using testing::ElementsAre;

GridFrame frame_at(int x, int y, int width, int height) {
  return {.cell_size = 0.5, .lattice_min = {x, y}, .width = width, .height = height};
}

/// All changes up to a state, applied one after the other.
std::vector<std::uint8_t> played(const MapTrace& map, std::size_t states) {
  std::vector<std::uint8_t> levels(map.frame().size(), kUnknownLevel);
  for (std::size_t s = 0; s < states; ++s) {
    const MapChange& change = map.changes()[s];
    for (std::size_t i = 0; i < change.cells.size(); ++i) levels.at(change.cells[i]) = change.levels[i];
  }
  return levels;
}

Recording recording_of(const std::vector<bool>& scans) {
  Recording recording;
  for (const bool scan : scans) {
    Reading reading;
    if (scan) reading.scan.emplace();
    recording.readings.push_back(reading);
  }
  return recording;
}

TEST(MapLevel, KeepsTheClassOfEveryLogOdds) {
  for (int i = -4000; i <= 4000; ++i) {
    const auto l = static_cast<float>(i) * 1e-3F;
    const int level = map_level(l);
    const CellClass shown = level <= 6 ? CellClass::kFree : level >= 14 ? CellClass::kOccupied : CellClass::kUnknown;
    EXPECT_EQ(shown, classify(static_cast<double>(l))) << l;
    EXPECT_LE(std::abs(level / 20.0 - scored_probability(static_cast<double>(l))), 0.0501) << l;
  }
  EXPECT_EQ(map_level(0.0F), kUnknownLevel);
  EXPECT_EQ(map_level(-1e-5F), kUnknownLevel) << "what a lossy store makes of unknown";
  EXPECT_EQ(map_level(std::nanf("")), kUnknownLevel);
  EXPECT_EQ(map_level(1e30F), map_level(3.2F)) << "saturated";
}

TEST(MapTrace, PlaysBackEveryStateOfMapsThatGrowAndShrink) {
  Rng rng({7, Purpose::kWorld, 0, 0});
  for (int round = 0; round < 20; ++round) {
    MapTrace map;
    std::vector<Grid<std::uint8_t>> states;
    for (std::size_t s = 0; s < 8; ++s) {
      const auto below = [&](int n) { return static_cast<int>(rng.uniform(0.0, n)); };
      Grid<std::uint8_t> levels(frame_at(below(9) - 4, below(9) - 4, 1 + below(6), 1 + below(6)));
      for (std::uint8_t& level : levels.values()) level = static_cast<std::uint8_t>(below(21));
      map.add(s, levels);
      states.push_back(levels);
    }
    for (std::size_t s = 0; s < states.size(); ++s) {
      Grid<std::uint8_t> expected(map.frame(), kUnknownLevel);
      const GridFrame& part = states[s].frame();
      for (int y = 0; y < part.height; ++y) {
        for (int x = 0; x < part.width; ++x) {
          const Cell c{x + part.lattice_min.x - map.frame().lattice_min.x,
                       y + part.lattice_min.y - map.frame().lattice_min.y};
          expected[c] = states[s][{x, y}];
        }
      }
      EXPECT_EQ(played(map, s + 1), expected.values()) << "round " << round << ", state " << s;
    }
    EXPECT_EQ(played(map, states.size()), map.last().values());
  }
}

TEST(MapTrace, ShowsTheSameWhenThinned) {
  MapTrace map;
  std::vector<std::vector<std::uint8_t>> states;
  Rng rng({8, Purpose::kWorld, 0, 0});
  Grid<std::uint8_t> levels(frame_at(0, 0, 5, 4), kUnknownLevel);
  for (std::size_t s = 0; s < 10; ++s) {
    for (int i = 0; i < 6; ++i) {
      levels.values()[static_cast<std::size_t>(rng.uniform(0.0, 20.0))] =
          static_cast<std::uint8_t>(rng.uniform(0.0, 21.0));
    }
    map.add(10 * s, levels);
    states.push_back(levels.values());
  }
  map.thin(4);
  std::vector<std::size_t> records;
  for (const MapChange& change : map.changes()) {
    records.push_back(change.record);
    EXPECT_TRUE(std::is_sorted(change.cells.begin(), change.cells.end()));
  }
  EXPECT_THAT(records, ElementsAre(0, 40, 80, 90)) << "every fourth and the last";
  EXPECT_EQ(played(map, 1), states[0]);
  EXPECT_EQ(played(map, 2), states[4]);
  EXPECT_EQ(played(map, 3), states[8]);
  EXPECT_EQ(played(map, 4), states[9]);
}

TEST(FrameRecords, AreEveryKthScanAndTheLast) {
  std::vector<bool> scans(20, true);
  scans[0] = scans[7] = false;
  EXPECT_THAT(frame_records(recording_of(scans), 100), testing::SizeIs(18));
  EXPECT_THAT(frame_records(recording_of(scans), 4), ElementsAre(1, 6, 12, 17, 19));
  EXPECT_THAT(frame_records(recording_of({false, false}), 4), testing::IsEmpty());
  EXPECT_THAT(frame_records(recording_of({true}), 4), ElementsAre(0));
}

TEST(TraceRecorder, KeepsSomeOfManyParticlesAndFewStates) {
  const Recording recording = recording_of(std::vector<bool>(30, true));
  TraceRecorder recorder(recording, {.frames = 10, .particles = 3, .maps = 2});
  int asked = 0;
  const TraceRecorder::Belief belief{.cloud =
                                         [] {
                                           return std::vector<Pose2>(7, Pose2{1.0, 0.0, 0.0});
                                         },
                                     .map =
                                         [&] {
                                           ++asked;
                                           return Grid<float>(frame_at(0, 0, 2, 2), 3.0F);
                                         }};
  for (std::size_t i = 0; i < 30; ++i) {
    recorder.note(i, i % 4 == 0, {.effective_particles = static_cast<double>(i)});
    if (recorder.due(i)) recorder.look(i, belief);
  }
  const RunTrace trace = recorder.finish(Grid<float>(frame_at(0, 0, 2, 2), -2.0F));
  EXPECT_THAT(trace.registered, testing::SizeIs(8));
  EXPECT_EQ(trace.registered[2].scan.effective_particles, 8.0);
  EXPECT_LE(asked, 2);
  for (const CloudTrace& cloud : trace.clouds) EXPECT_THAT(cloud.T_map_base, testing::SizeIs(3));
  EXPECT_EQ(trace.map.changes().back().record, 29U);
  EXPECT_THAT(trace.map.last().values(), testing::Each(map_level(-2.0F))) << "the final map, whatever was seen before";
}

/// Two seconds of driving through filters with every kind of store.
TEST(RunTrace, ChangesNoScoreOfAnyStoreWithAnyNumberOfThreads) {
  const Scenario scenario = read_scenario(ConfigSection::parse(R"(
duration_s: 3
world: {kind: simple}
sensors: {camera: {enabled: false}, lidar: {beams: 61}}
drive: {waypoints: [{x_m: 1, y_m: 0}]}
slam: {particles: 5, cell_sizes_m: [0.2]}
variants:
  - {name: dense}
  - {name: cog, slam: {store: {kind: coefficients}}}
  - {name: measured, slam: {store: {kind: coefficients, compressor: hadamard, percent_kept: 80}}}
  - {name: tiles, slam: {store: {kind: tiles}}}
  - {name: truth, true_poses: true}
)",
                                                               "short.yaml"),
                                          "short");
  const Drive drive = record_drive(scenario);
  for (const VariantConfig& variant : scenario.variants) {
    Workers one(1), three(3);
    const VariantRun plain = run_variant(variant, 1, drive.recording, {.truth = &drive.truth}, one);
    const VariantRun traced =
        run_variant(variant, 1, drive.recording, {.truth = &drive.truth}, three, {}, TraceLimits{.maps = 50});
    EXPECT_EQ(scores_json({.variants = {plain.record}}), scores_json({.variants = {traced.record}})) << variant.name;
    EXPECT_FALSE(plain.trace.has_value());
    ASSERT_TRUE(traced.trace.has_value());
    EXPECT_EQ(traced.trace->map.last(), map_levels(traced.map)) << variant.name;
    EXPECT_EQ(traced.trace->registered.size(), *traced.record.scores.registered);
    EXPECT_EQ(traced.trace->clouds.empty(), variant.true_poses);
  }
}

}  // namespace
}  // namespace cogslam
