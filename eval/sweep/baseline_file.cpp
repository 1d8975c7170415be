#include "eval/sweep/baseline_file.hpp"

#include "sensors/log/reading_codec.hpp"
#include "sensors/log/record_file.hpp"

namespace cogslam {
namespace {

constexpr RecordFormat kFormat{"COGSBASE", 1};
enum RecordKind : std::uint8_t { kPath = 1, kMap = 2 };

void put_map(ByteWriter& out, const Grid<float>& map) {
  const GridFrame& frame = map.frame();
  out.put(frame.cell_size);
  for (const int number : {frame.lattice_min.x, frame.lattice_min.y, frame.width, frame.height}) out.put(number);
  for (const float value : map.values()) out.put(value);
}

Grid<float> take_map(ByteReader& in) {
  GridFrame frame{.cell_size = in.take<double>("the cell size")};
  for (int* number : {&frame.lattice_min.x, &frame.lattice_min.y, &frame.width, &frame.height}) {
    *number = in.take<int>("the frame");
  }
  if (frame.width < 0 || frame.height < 0 || frame.size() * sizeof(float) != in.left()) {
    in.fail("a frame of other size than the map");
  }
  Grid<float> map(frame);
  for (float& value : map.values()) value = in.take<float>("a cell");
  return map;
}

}  // namespace

void write_baseline(const std::filesystem::path& file, const VariantRun& run) {
  ByteWriter path, map;
  path.put_count(run.online.size());
  for (const Pose2& pose : run.online) put_pose(path, pose);
  put_map(map, run.map);
  RecordFileWriter out(kFormat);
  out.add(kPath, path);
  out.add(kMap, map);
  out.write(file);
}

VariantRun read_baseline(const std::filesystem::path& file) {
  const RecordFile in(file, kFormat);
  if (in.records().size() != 2 || in.records()[0].kind != kPath || in.records()[1].kind != kMap) {
    in.fail("expected a path, then a map");
  }
  ByteReader path = in.records()[0].payload, map = in.records()[1].payload;
  VariantRun run;
  run.online.resize(path.take_count(3 * sizeof(double), "the number of poses"));
  for (Pose2& pose : run.online) pose = take_pose(path, "a pose");
  run.map = take_map(map);
  path.finish();
  map.finish();
  return run;
}

}  // namespace cogslam
