#pragma once

#include <filesystem>
#include <string>

#include "worlds/occupancy_map.hpp"

namespace cogslam {

/// Reads a map of the ROS map_server (ROS 1 and nav2): a YAML file that names an image.
///
///     image: floor.pgm               # PGM or PNG, relative to this file
///     mode: trinary | scale | raw    # default trinary
///     resolution: 0.05               # side of a cell [m]
///     origin: [-10, -10, 0]          # lower-left corner of the lower-left cell [m, m, rad]
///     negate: 0                      # 1: white is occupied
///     occupied_thresh: 0.65
///     free_thresh: 0.196
///
/// With p = the darkness of a pixel (its lightness where negate is 1) a cell is occupied where p > occupied_thresh,
/// free where p < free_thresh, else unknown: a world has no half-occupied cells, so `scale` differs from `trinary` in
/// nothing. In `raw`, p = value / 100 up to 100, and larger values are unknown. Pixels that are not opaque are unknown.
///
/// Image, resolution and origin must be there, other keys than these must not. Throws InputError with
/// file:line:column of the key, or naming the image (map_image.hpp).
OccupancyMap read_map_file(const std::filesystem::path& yaml);

/// The picture of such a map without its YAML file: mode and thresholds as by default, origin 0. `resolution`: side of
/// a cell [m].
OccupancyMap read_map_picture(const std::filesystem::path& picture, double resolution);

/// The image of a map as binary PGM: 0 occupied, 254 free, 205 unknown, the top row first.
std::string map_pgm_bytes(const OccupancyMap& map);

/// The YAML file that goes with it. Read back, the map is the same to the last bit.
std::string map_yaml_text(const OccupancyMap& map, const std::string& image);

}  // namespace cogslam
