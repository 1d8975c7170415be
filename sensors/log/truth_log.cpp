#include "sensors/log/truth_log.hpp"

#include "sensors/log/plausible.hpp"
#include "sensors/log/reading_codec.hpp"
#include "sensors/log/record_file.hpp"

namespace cogslam {
namespace {

constexpr RecordFormat kFormat{"COGSTRUE", 1};
enum RecordKind : std::uint8_t { kHeader = 1, kWorld = 2, kPose = 3, kReference = 4, kHidden = 5 };
constexpr std::uint8_t kFloorKinds = static_cast<std::uint8_t>(FloorKind::kPlain) + 1;

void reject(const ByteReader& payload, const std::optional<std::string>& defect) {
  if (defect) payload.fail_whole(*defect);
}

void put_polygons(ByteWriter& out, const std::vector<Polygon>& polygons) {
  out.put_count(polygons.size());
  for (const Polygon& polygon : polygons) {
    out.put_count(polygon.size());
    for (const Eigen::Vector2d& p : polygon) {
      out.put(p.x());
      out.put(p.y());
    }
  }
}

Eigen::Vector2d take_point(ByteReader& in, const char* what) {
  const double x = in.take<double>(what), y = in.take<double>(what);
  return {x, y};
}

std::vector<Polygon> take_polygons(ByteReader& in, const char* what) {
  std::vector<Polygon> polygons(in.take_count(sizeof(std::uint64_t), what));
  for (Polygon& polygon : polygons) {
    polygon.resize(in.take_count(2 * sizeof(double), "the number of corners"));
    for (Eigen::Vector2d& p : polygon) p = take_point(in, "a corner");
  }
  return polygons;
}

void put_world(ByteWriter& out, const World& world) {
  put_polygons(out, world.walls);
  put_polygons(out, world.obstacles);
  out.put(world.floor.kind);
  out.put(world.floor.contrast);
  out.put(world.floor.seed);
  out.put_count(world.slip_patches.size());
  for (const SlipPatch& patch : world.slip_patches)
    for (const double v : {patch.centre.x(), patch.centre.y(), patch.radius, patch.friction}) out.put(v);
  put_pose(out, world.start);
}

World take_world(ByteReader& in) {
  World world;
  world.walls = take_polygons(in, "the number of walls");
  world.obstacles = take_polygons(in, "the number of obstacles");
  world.floor.kind = static_cast<FloorKind>(in.take_below(kFloorKinds, "the kind of floor"));
  world.floor.contrast = in.take<double>("the floor's contrast");
  world.floor.seed = in.take<std::uint32_t>("the floor's seed");
  world.slip_patches.resize(in.take_count(4 * sizeof(double), "the number of slip patches"));
  for (SlipPatch& patch : world.slip_patches) {
    patch.centre = take_point(in, "a slip patch");
    patch.radius = in.take<double>("a slip patch");
    patch.friction = in.take<double>("a slip patch");
  }
  world.start = take_pose(in, "the start");
  return world;
}

/// Glass and magnets: written only where there are any, so a file of any other world is as it always was.
void put_hidden(ByteWriter& out, const World& world) {
  out.put_count(world.panes.size());
  for (const Segment& pane : world.panes)
    for (const double v : {pane.a.x(), pane.a.y(), pane.b.x(), pane.b.y()}) out.put(v);
  out.put_count(world.magnets.size());
  for (const Magnet& magnet : world.magnets)
    for (const double v : {magnet.centre.x(), magnet.centre.y(), magnet.reach, magnet.axis}) out.put(v);
}

void take_hidden(ByteReader& in, World& world) {
  world.panes.resize(in.take_count(4 * sizeof(double), "the number of panes"));
  for (Segment& pane : world.panes) {
    pane.a = take_point(in, "a pane");
    pane.b = take_point(in, "a pane");
  }
  world.magnets.resize(in.take_count(4 * sizeof(double), "the number of magnets"));
  for (Magnet& magnet : world.magnets) {
    magnet.centre = take_point(in, "a magnet");
    magnet.reach = in.take<double>("a magnet");
    magnet.axis = in.take<double>("a magnet");
  }
}

TruePose take_true_pose(ByteReader& in) {
  TruePose pose;
  pose.sequence = in.take<std::uint64_t>("the sequence number");
  pose.stamp.ns = in.take<std::int64_t>("the stamp");
  pose.T_map_base = take_pose(in, "a true pose");
  return pose;
}

ReferenceFix take_reference(ByteReader& in) {
  ReferenceFix fix;
  fix.stamp.ns = in.take<std::int64_t>("the stamp");
  fix.T_map_base = take_pose(in, "a reference pose");
  fix.sigma = in.take<double>("a reference's sigma");
  return fix;
}

}  // namespace

void write_truth_log(const std::filesystem::path& file, const TruthLog& log) {
  RecordFileWriter out(kFormat);
  ByteWriter header, world;
  header.put_text(log.readings_hash);
  out.add(kHeader, header);
  put_world(world, log.world);
  out.add(kWorld, world);
  if (!log.world.panes.empty() || !log.world.magnets.empty()) {
    ByteWriter hidden;
    put_hidden(hidden, log.world);
    out.add(kHidden, hidden);
  }
  for (const TruePose& pose : log.poses) {
    ByteWriter bytes;
    bytes.put(pose.sequence);
    bytes.put(pose.stamp.ns);
    put_pose(bytes, pose.T_map_base);
    out.add(kPose, bytes);
  }
  for (const ReferenceFix& fix : log.references) {
    ByteWriter bytes;
    bytes.put(fix.stamp.ns);
    put_pose(bytes, fix.T_map_base);
    bytes.put(fix.sigma);
    out.add(kReference, bytes);
  }
  out.write(file);
}

TruthLog read_truth_log(const std::filesystem::path& file) {
  const RecordFile in(file, kFormat);
  TruthLog log;
  bool has_header = false, has_world = false;
  for (auto [kind, payload] : in.records()) {
    switch (kind) {
      case kHeader:
        log.readings_hash = payload.take_text("the readings' hash");
        has_header = true;
        break;
      case kWorld:
        log.world = take_world(payload);
        reject(payload, defect(log.world));
        has_world = true;
        break;
      case kPose:
        log.poses.push_back(take_true_pose(payload));
        reject(payload, defect(log.poses.back().T_map_base));
        break;
      case kReference:
        log.references.push_back(take_reference(payload));
        reject(payload, defect(log.references.back().T_map_base));
        break;
      case kHidden:
        if (!has_world) payload.fail("panes and magnets before the world, expected the world first");
        take_hidden(payload, log.world);
        break;
      default:
        payload.fail("record of kind " + std::to_string(kind) + ", expected 1 to 5");
    }
    payload.finish();
  }
  if (!has_header || !has_world) in.fail("no header or no world, expected a truth log");
  return log;
}

}  // namespace cogslam
