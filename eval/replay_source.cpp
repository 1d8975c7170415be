#include "eval/replay_source.hpp"

#include <optional>

#include "core/angle.hpp"

namespace cogslam {
namespace {

std::optional<Rectangle> read_area(ConfigSection section) {
  std::vector<double> corners;
  section.read("area_m", corners, {-1e6, 1e6});
  if (corners.empty()) return std::nullopt;
  if (corners.size() != 4 || corners[0] >= corners[2] || corners[1] >= corners[3]) {
    section.fail("area_m", "area_m: expected [x0, y0, x1, y1] with x0 < x1 and y0 < y1");
  }
  return Rectangle{{corners[0], corners[1]}, {corners[2], corners[3]}};
}

}  // namespace

SlamConfig log_defaults() {
  SlamConfig slam;
  slam.particles = 30;
  slam.cell_size = 0.05;
  slam.proposal = Proposal::kScanMatched;
  slam.registration = {.distance = 0.5, .turn = radians(20.0)};
  slam.likelihood.field.sigma = 0.05;
  return slam;
}

ReplayConfig read_replay_config(ConfigSection file) {
  ReplayConfig config;
  file.read("seed", config.seed);
  ConfigSection log = file.section("log");
  config.log = read_carmen_log_config(log);
  SlamConfig base = log_defaults();
  base.area = read_area(file.section("map"));
  config.variants = read_variants(file, base);
  file.finish();
  config.resolved = file.resolved();
  return config;
}

Recording load_log(const std::filesystem::path& file, const CarmenLogConfig& config) {
  if (is_recording(file)) return read_recording(file);
  CarmenLog log = read_carmen_log(file, config);
  return {.source = "CARMEN log: " + file.filename().string(), .start = {}, .readings = std::move(log.readings)};
}

void start_at(const Pose2& T_map_base, std::vector<VariantConfig>& variants) {
  for (VariantConfig& variant : variants) variant.slam.start = T_map_base;
}

std::string log_name(const std::filesystem::path& file) {
  std::filesystem::path name = file.filename();
  if (name.extension() == ".gz") name = name.stem();
  return name.stem().string();
}

}  // namespace cogslam
