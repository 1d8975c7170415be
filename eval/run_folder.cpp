#include "eval/run_folder.hpp"

#include <fmt/format.h>

#include "core/hash.hpp"
#include "core/output_file.hpp"
#include "eval/export.hpp"
#include "eval/new_folder.hpp"
#include "eval/page/run_page.hpp"
#include "eval/report/map_picture.hpp"
#include "eval/report/room_picture.hpp"
#include "worlds/map_file.hpp"

namespace cogslam {
namespace {

/// What every file of one variant begins with.
std::string stem(const VariantRun& run) { return fmt::format("{}_{}m", run.record.name, run.record.cell_size_m); }

/// The map that the world was drawn from, or nothing.
const OccupancyMap* world_map_of(const RunFiles& files) {
  return files.truth != nullptr ? files.truth->world.map.get() : nullptr;
}

/// The configuration; a map that it names lies beside it in the folder, whatever its name was.
std::string config_of(const RunFiles& files) {
  if (world_map_of(files) == nullptr) return files.config;
  const std::string before = "  kind: map\n  map: ";  // as a resolved file always has it
  const std::size_t at = files.config.find(before);
  if (at == std::string::npos) return files.config;
  std::string text = files.config;
  const std::size_t name = at + before.size();
  return text.replace(name, text.find('\n', name) - name, "world.yaml");
}

/// The same for the same configuration, readings and scores; costs play no part.
std::string content_name(const RunFiles& files) {
  const RunRecord& record = files.episode.record;
  Hash hash;
  hash.add(config_of(files)).add(record.seed).add(record.readings_hash.value_or("")).add(files.save_readings);
  if (const OccupancyMap* map = world_map_of(files))
    hash.add(map_yaml_text(*map, "world.pgm")).add(map_pgm_bytes(*map));
  for (const VariantRun& run : files.episode.runs) hash.add(stem(run)).add(scores_json({.variants = {run.record}}));
  return record.scenario + "-" + hash.hex();
}

std::vector<Time> reading_stamps(const Recording& recording) {
  std::vector<Time> stamps;
  for (const Reading& reading : recording.readings) stamps.push_back(reading.stamp);
  return stamps;
}

/// Writes the parts of one run into one folder.
class FolderWriter {
 public:
  FolderWriter(const std::filesystem::path& folder, const RunFiles& files)
      : folder_(folder),
        files_(files),
        stamps_(reading_stamps(files.recording)),
        odometry_(odometry_path(files.recording)) {
    if (files.truth == nullptr) return;
    for (const TruePose& pose : files.truth->poses) truth_.push_back(pose.T_map_base);
  }

  void write_shared() const {
    write_file(folder_ / files_.config_name, config_of(files_));
    if (const OccupancyMap* map = world_map_of(files_)) {
      write_file(folder_ / "world.yaml", map_yaml_text(*map, "world.pgm"));
      write_file(folder_ / "world.pgm", map_pgm_bytes(*map));
    }
    write_file(folder_ / "scores.json", to_json(files_.episode.record));
    write_trajectory(folder_ / "odometry.tum", stamps_, odometry_);
    if (files_.save_readings) write_recording(folder_ / "readings.bin", files_.recording);
    if (files_.truth == nullptr) return;
    write_trajectory(folder_ / "truth.tum", stamps_, truth_);
    write_reference();
    if (files_.save_readings) write_truth_log(folder_ / "truth.bin", *files_.truth);
  }

  void write_variant(std::size_t v) {
    const VariantRun& run = files_.episode.runs[v];
    const std::string name = stem(run);
    if (!run.map.values().empty()) {
      write_map(folder_ / name, run.map);
      write_picture(name + "_map.png", {v, true, picture_of_map(run.map)});
    }
    if (run.online.empty()) return;  // it was given the true poses
    write_trajectory(folder_ / (name + "_online.tum"), stamps_, run.online);
    write_trajectory(folder_ / (name + "_final.tum"), stamps_, run.final);
    write_picture(name + "_paths.png", {v, false, picture_of_paths(run)});
  }

  void write_room() const {
    const VariantRun* finest = nullptr;
    for (const VariantRun& run : files_.episode.runs) {
      const bool finer = finest == nullptr || run.record.cell_size_m < finest->record.cell_size_m;
      if (!run.online.empty() && finer) finest = &run;
    }
    if (finest != nullptr) write_file(folder_ / "room.png", picture_of_paths(*finest));
  }

  void write_page() const {
    if (files_.page == PageKind::kNone) return;
    const PageParts parts = files_.page == PageKind::kPlayer ? run_page_parts() : static_parts();
    write_file(folder_ / "page.html", run_page(files_, pictures_, parts));
  }

 private:
  void write_picture(const std::string& name, PagePicture picture) {
    write_file(folder_ / name, picture.png);
    pictures_.push_back(std::move(picture));
  }

  void write_reference() const {
    std::vector<Time> stamps;
    std::vector<Pose2> path;
    for (const ReferenceFix& fix : files_.truth->references) {
      stamps.push_back(fix.stamp);
      path.push_back(fix.T_map_base);
    }
    write_trajectory(folder_ / "reference.tum", stamps, path);
  }

  [[nodiscard]] std::string picture_of_map(const Grid<float>& map) const {
    if (files_.truth == nullptr) return map_picture(map);
    return map_picture(map, truth_grid(files_.truth->world, map.frame().cell_size));
  }

  [[nodiscard]] std::string picture_of_paths(const VariantRun& run) const {
    const World world = files_.truth != nullptr ? files_.truth->world : World{};
    return room_picture(world, {.truth = truth_, .odometry = odometry_, .estimate = run.online});
  }

  std::filesystem::path folder_;
  const RunFiles& files_;
  std::vector<Time> stamps_;
  std::vector<Pose2> odometry_;
  std::vector<Pose2> truth_;
  std::vector<PagePicture> pictures_;
};

}  // namespace

std::filesystem::path write_run_folder(const std::filesystem::path& parent, const RunFiles& files,
                                       const StageBegin& begin) {
  const std::filesystem::path target = parent / content_name(files);
  NewFolder folder(target);
  FolderWriter writer(folder.path(), files);
  const Progress progress = begin ? begin("files") : Progress{};
  writer.write_shared();
  for (std::size_t i = 0; i < files.episode.runs.size(); ++i) {
    if (progress) progress(static_cast<double>(i) / static_cast<double>(files.episode.runs.size()));
    writer.write_variant(i);
  }
  writer.write_room();
  writer.write_page();
  folder.move_to_target();
  return target;
}

}  // namespace cogslam
