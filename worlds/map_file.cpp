#include "worlds/map_file.hpp"

#include <cmath>

#include "core/angle.hpp"
#include "core/config.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "worlds/map_image.hpp"

namespace cogslam {
namespace {

enum class MapMode { kTrinary, kScale, kRaw };

constexpr std::size_t kLongestName = 1000;  // of a file, in messages
constexpr double kFarthest = 1000.0;        // physics in floats keeps a tenth of a millimetre there [m]

struct MapHead {
  std::filesystem::path image;
  MapMode mode = MapMode::kTrinary;
  double resolution = 0.0;
  Pose2 T_map_image{};
  int negate = 0;
  double occupied_thresh = 0.65;
  double free_thresh = 0.196;
};

void expect_key(const ConfigSection& section, const std::string& key) {
  if (!section.has(key)) section.fail(key, "no '" + key + "', expected image, resolution and origin");
}

Pose2 read_origin(ConfigSection& section) {
  std::vector<double> origin;
  section.read("origin", origin, {-kFarthest, kFarthest});
  if (origin.size() != 3) section.fail("origin", "origin: expected three numbers [x, y, yaw]");
  return {origin[0], origin[1], wrap_angle(origin[2])};
}

MapHead read_head(ConfigSection& section) {
  MapHead head;
  for (const char* key : {"image", "resolution", "origin"}) expect_key(section, key);
  section.read("image", head.image);
  section.read_choice("mode", head.mode,
                      {{"trinary", MapMode::kTrinary}, {"scale", MapMode::kScale}, {"raw", MapMode::kRaw}});
  section.read("resolution", head.resolution, {0.001, 100.0});
  head.T_map_image = read_origin(section);
  section.read("negate", head.negate, {0, 1});
  section.read("occupied_thresh", head.occupied_thresh, {0.0, 1.0});
  section.read("free_thresh", head.free_thresh, {0.0, 1.0});
  section.finish();
  if (head.free_thresh > head.occupied_thresh) {
    section.fail("free_thresh", "free_thresh: " + number_text(head.free_thresh) +
                                    " is above occupied_thresh, expected at most " + number_text(head.occupied_thresh));
  }
  if (head.mode == MapMode::kRaw && head.negate != 0) section.fail("negate", "negate: expected 0 where mode is raw");
  return head;
}

MapCell cell_of_pixel(const MapHead& head, const MapImage& image, std::size_t i) {
  if (!image.clear.empty() && image.clear[i] != 0) return MapCell::kUnknown;
  double p = 0.0;
  if (head.mode == MapMode::kRaw) {
    const double value = std::round(255.0 * image.grey[i] / image.white);
    if (value > 100.0) return MapCell::kUnknown;
    p = value / 100.0;
  } else {
    p = static_cast<double>(head.negate != 0 ? image.grey[i] : image.white - image.grey[i]) / image.white;
  }
  if (p > head.occupied_thresh) return MapCell::kOccupied;
  return p < head.free_thresh ? MapCell::kFree : MapCell::kUnknown;
}

char pixel(MapCell cell) {
  constexpr unsigned char kPixels[] = {254, 0, 205};
  return static_cast<char>(kPixels[static_cast<std::size_t>(cell)]);
}

OccupancyMap map_of(const MapHead& head, const MapImage& image) {
  OccupancyMap map{
      .width = image.width, .height = image.height, .resolution = head.resolution, .T_map_image = head.T_map_image};
  map.cells.reserve(image.grey.size());
  for (int y = image.height - 1; y >= 0; --y) {
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width);
    for (std::size_t x = 0; x < static_cast<std::size_t>(image.width); ++x) {
      map.cells.push_back(cell_of_pixel(head, image, row + x));
    }
  }
  return map;
}

}  // namespace

OccupancyMap read_map_file(const std::filesystem::path& yaml) {
  ConfigSection section = ConfigSection::load(yaml);
  const MapHead head = read_head(section);
  std::error_code ignored;
  if (!std::filesystem::exists(head.image, ignored)) {
    section.fail("image", "image: there is no " + printable(head.image.string(), kLongestName));
  }
  return map_of(head, read_map_image(head.image));
}

OccupancyMap read_map_picture(const std::filesystem::path& picture, double resolution) {
  return map_of({.resolution = resolution}, read_map_image(picture));
}

std::string map_pgm_bytes(const OccupancyMap& map) {
  std::string bytes = "P5\n" + std::to_string(map.width) + " " + std::to_string(map.height) + "\n255\n";
  bytes.reserve(bytes.size() + map.cells.size());
  for (int y = map.height - 1; y >= 0; --y) {
    for (int x = 0; x < map.width; ++x) bytes += pixel(map.at({x, y}));
  }
  return bytes;
}

std::string map_yaml_text(const OccupancyMap& map, const std::string& image) {
  const Pose2& origin = map.T_map_image;
  return "image: " + image + "\nmode: trinary\nresolution: " + number_text(map.resolution) + "\norigin: [" +
         number_text(origin.x) + ", " + number_text(origin.y) + ", " + number_text(origin.theta) +
         "]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}

}  // namespace cogslam
