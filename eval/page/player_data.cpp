#include "eval/page/player_data.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "core/angle.hpp"
#include "eval/page/packed.hpp"
#include "slam/sweep.hpp"

namespace cogslam {
namespace {

using Json = nlohmann::ordered_json;
using Column = std::vector<double>;

constexpr double kPathUnit = 1e-4, kHitUnit = 1e-2, kCloudUnit = 1e-3, kTimeUnit = 1e-3;
constexpr int kBeams = 90;                     // of a scan
constexpr std::size_t kMostRegistered = 4000;  // points of a curve
constexpr unsigned kCoarsest = 6;

std::size_t count_scans(const Recording& recording) {
  return static_cast<std::size_t>(std::count_if(recording.readings.begin(), recording.readings.end(),
                                                [](const Reading& reading) { return reading.scan.has_value(); }));
}

void add_path(const std::string& name, const std::vector<Pose2>& path, const std::vector<std::size_t>& records,
              PackedColumns& columns) {
  Column x, y, theta;
  for (const std::size_t record : records) {
    x.push_back(path[record].x);
    y.push_back(path[record].y);
    theta.push_back(path[record].theta);
  }
  columns.add(name + "_x", x, kPathUnit, Packing::kDifference);
  columns.add(name + "_y", y, kPathUnit, Packing::kDifference);
  columns.add(name + "_theta", theta, kPathUnit, Packing::kDifference);
}

/// Where beams of the frames' scans ended, seen from the base.
void add_scans(const Recording& recording, const std::vector<std::size_t>& records, PackedColumns& columns) {
  Column count, x, y;
  for (const std::size_t record : records) {
    const std::size_t before = x.size();
    for (const Beam& beam : sweep_of(recording.readings[record], {.beams = kBeams})) {
      if (!beam.hit) continue;
      x.push_back(beam.end.x());
      y.push_back(beam.end.y());
    }
    count.push_back(static_cast<double>(x.size() - before));
  }
  columns.add("hits", count, 1.0, Packing::kPlain);
  columns.add("hit_x", x, kHitUnit, Packing::kDifference);
  columns.add("hit_y", y, kHitUnit, Packing::kDifference);
}

PackedColumns shared_columns(const RunFiles& files, const std::vector<std::size_t>& records) {
  PackedColumns columns;
  Column record, time;
  for (const std::size_t r : records) {
    record.push_back(static_cast<double>(r));
    time.push_back((files.recording.readings[r].stamp - files.recording.readings[records.front()].stamp).seconds());
  }
  columns.add("record", record, 1.0, Packing::kDifference);
  columns.add("time", time, kTimeUnit, Packing::kDifference);
  add_path("odometry", odometry_path(files.recording), records, columns);
  if (files.truth != nullptr) {
    std::vector<Pose2> truth;
    for (const TruePose& pose : files.truth->poses) truth.push_back(pose.T_map_base);
    add_path("truth", truth, records, columns);
  }
  add_scans(files.recording, records, columns);
  return columns;
}

void add_registered(const std::vector<RegisteredTrace>& registered, PackedColumns& columns) {
  const std::size_t step = std::max<std::size_t>(1, (registered.size() + kMostRegistered - 1) / kMostRegistered);
  Column record, effective, resampled, payload, bytes;
  for (std::size_t i = 0; i < registered.size(); i += step) {
    record.push_back(static_cast<double>(registered[i].record));
    effective.push_back(registered[i].scan.effective_particles);
    resampled.push_back(registered[i].scan.resampled ? 1.0 : 0.0);
    payload.push_back(registered[i].scan.payload_bytes);
    bytes.push_back(registered[i].scan.bytes);
  }
  columns.add("registered_record", record, 1.0, Packing::kDifference);
  columns.add("effective", effective, 1e-2, Packing::kPlain);
  columns.add("resampled", resampled, 1.0, Packing::kPlain);
  columns.add("payload", payload, 1.0, Packing::kDifference);
  columns.add("bytes", bytes, 1.0, Packing::kDifference);
}

/// Clouds at frames that are shown, as differences from the estimate.
void add_clouds(const VariantRun& run, const std::vector<std::size_t>& records, PackedColumns& columns) {
  Column record, count, x, y, theta;
  for (const CloudTrace& cloud : run.trace->clouds) {
    if (!std::binary_search(records.begin(), records.end(), cloud.record)) continue;
    const Pose2& T_map_best = run.online[cloud.record];
    record.push_back(static_cast<double>(cloud.record));
    count.push_back(static_cast<double>(cloud.T_map_base.size()));
    for (const Pose2& T : cloud.T_map_base) {
      x.push_back(T.x - T_map_best.x);
      y.push_back(T.y - T_map_best.y);
      theta.push_back(wrap_angle(T.theta - T_map_best.theta));
    }
  }
  columns.add("cloud_record", record, 1.0, Packing::kDifference);
  columns.add("cloud_count", count, 1.0, Packing::kPlain);
  columns.add("cloud_x", x, kCloudUnit, Packing::kPlain);
  columns.add("cloud_y", y, kCloudUnit, Packing::kPlain);
  columns.add("cloud_theta", theta, kCloudUnit, Packing::kPlain);
}

/// Each state as runs of changed cells: how many cells were passed over since the last run, how long the run is.
void add_map(const MapTrace& map, PackedColumns& columns) {
  Column record, runs, gap, length, level;
  for (const MapChange& change : map.changes()) {
    const std::size_t before = gap.size();
    std::uint32_t end = 0;
    for (std::size_t i = 0; i < change.cells.size(); ++i) {
      const std::uint32_t cell = change.cells[i];
      if (i == 0 || cell != end) {
        gap.push_back(static_cast<double>(cell - end));
        length.push_back(0.0);
      }
      length.back() += 1.0;
      level.push_back(static_cast<double>(change.levels[i]) - kUnknownLevel);
      end = cell + 1;
    }
    record.push_back(static_cast<double>(change.record));
    runs.push_back(static_cast<double>(gap.size() - before));
  }
  columns.add("map_record", record, 1.0, Packing::kDifference);
  columns.add("map_runs", runs, 1.0, Packing::kPlain);
  columns.add("map_gap", gap, 1.0, Packing::kPlain);
  columns.add("map_length", length, 1.0, Packing::kPlain);
  columns.add("map_level", level, 1.0, Packing::kPlain);
}

Json heads(const PackedColumns& columns) {
  Json list = Json::array();
  for (const ColumnHead& head : columns.heads()) {
    list.push_back({{"name", head.name},
                    {"count", head.count},
                    {"unit", head.unit},
                    {"difference", head.packing == Packing::kDifference}});
  }
  return list;
}

Json loops(const std::vector<Polygon>& polygons) {
  Json list = Json::array();
  for (const Polygon& polygon : polygons) {
    Json corners = Json::array();
    for (const Eigen::Vector2d& p : polygon) corners.push_back({p.x(), p.y()});
    list.push_back(std::move(corners));
  }
  return list;
}

Json world_json(const TruthLog* truth) {
  if (truth == nullptr) return nullptr;
  std::vector<Polygon> walls = truth->world.walls;
  for (const Segment& pane : truth->world.panes) walls.push_back({pane.a, pane.b});  // drawn as a loop of no width
  return {{"walls", loops(walls)}, {"obstacles", loops(truth->world.obstacles)}};
}

Json variant_json(const VariantRun& run, const MapTrace& map, const PackedColumns& columns) {
  const GridFrame& frame = map.frame();
  return {{"label", label(run.record)},
          {"particles", run.record.particles},
          {"estimate", !run.online.empty()},
          {"map",
           {{"cell_size_m", frame.cell_size},
            {"origin_m", {frame.origin().x(), frame.origin().y()}},
            {"width", frame.width},
            {"height", frame.height},
            {"states", map.changes().size()}}},
          {"columns", heads(columns)}};
}

}  // namespace

std::size_t PlayerData::bytes() const {
  std::size_t sum = json.size();
  for (const std::string& pack : packs) sum += pack.size();
  return sum;
}

PlayerData player_data(const RunFiles& files, unsigned coarser, std::size_t variants) {
  const std::vector<VariantRun>& runs = files.episode.runs;
  if (runs.empty() || !runs.front().trace) return {};
  const std::vector<std::size_t> records = frame_records(files.recording, TraceLimits{}.frames >> coarser);
  const PackedColumns shared = shared_columns(files, records);
  PlayerData data{.packs = {shared.text()}};
  Json described = Json::array();
  for (std::size_t v = 0; v < std::min(variants, runs.size()); ++v) {
    MapTrace map = runs[v].trace->map;
    map.thin(std::size_t{1} << coarser);
    PackedColumns columns;
    if (!runs[v].online.empty()) add_path("estimate", runs[v].online, records, columns);
    add_registered(runs[v].trace->registered, columns);
    add_clouds(runs[v], records, columns);
    add_map(map, columns);
    described.push_back(variant_json(runs[v], map, columns));
    data.packs.push_back(columns.text());
  }
  const Json json{
      {"frames", records.size()},         {"scans", count_scans(files.recording)}, {"beams", kBeams},
      {"cloud", TraceLimits{}.particles}, {"variants_of_run", runs.size()},        {"world", world_json(files.truth)},
      {"columns", heads(shared)},         {"variants", std::move(described)}};
  data.json = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return data;
}

PlayerData player_data_within(const RunFiles& files, std::size_t most) {
  PlayerData data;
  for (unsigned coarser = 0; coarser <= kCoarsest; ++coarser) {
    data = player_data(files, coarser, files.episode.runs.size());
    if (data.bytes() <= most) return data;
  }
  for (std::size_t variants = files.episode.runs.size() - 1; variants > 0; --variants) {
    data = player_data(files, kCoarsest, variants);
    if (data.bytes() <= most) return data;
  }
  return {};
}

}  // namespace cogslam
