#pragma once

#include "core/config.hpp"
#include "worlds/world.hpp"

namespace cogslam {

// What a world drawn from a map may have at most, so that it is there within a few seconds and 500 MB.
constexpr std::size_t kMostMapCorners = 1'000'000;  ///< of its cells, before loops are made simpler
constexpr std::size_t kMostMapSurfaces = 50'000;
constexpr std::size_t kMostMapPieces = 10'000'000;  ///< that the slabs of FreeSpace cut them into

/// Reads what a `world:` of kind `map` has of its own, and draws the surfaces of the map (map_contours.hpp):
///
///     map: floor.yaml             # of map_server, see map_file.hpp; relative to the scenario
///     unknown: empty | solid      # what stands in unknown cells: nothing, or walls, as also beyond the image
///     simplify_m: 0               # how far surfaces may run beside those of the cells, to have fewer of them
///
/// The start is the map's origin of coordinates unless the scenario says otherwise. Throws InputError where the map
/// cannot be read, where nothing is occupied, and where surfaces are too many.
World read_map_world(ConfigSection& section);

/// Throws InputError where the start of a world with a map lies in a cell that is solid.
void check_map_start(const ConfigSection& section, const World& world);

}  // namespace cogslam
