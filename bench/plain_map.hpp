#pragma once

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/grid.hpp"
#include "slam/codec/tile_cells.hpp"
#include "slam/map/lattice.hpp"

namespace cogslam::bench {

/// Reads a map as runs save it: .npy, version 1.0, little-endian float32, row-major. Where it lies is not in the file.
inline Grid<float> read_npy(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string lead(10, ' ');
  file.read(lead.data(), 10);
  std::string header(static_cast<unsigned char>(lead[8]) + 256U * static_cast<unsigned char>(lead[9]), ' ');
  file.read(header.data(), static_cast<std::streamsize>(header.size()));
  GridFrame frame;
  const std::size_t shape = header.find("'shape': (");
  if (!file || header.find("'<f4'") == std::string::npos || shape == std::string::npos ||
      std::sscanf(header.c_str() + shape, "'shape': (%d, %d)", &frame.height, &frame.width) != 2) {
    throw std::runtime_error(path + ": not a map of float32");
  }
  Grid<float> map(frame);
  file.read(reinterpret_cast<char*>(map.values().data()),
            static_cast<std::streamsize>(map.values().size() * sizeof(float)));
  return map;
}

/// The tiles of a map that are not unknown all over, as levels of unit 0.4.
inline std::vector<TileCells> tiles_of(const Grid<float>& map) {
  std::vector<TileCells> tiles;
  const GridFrame& frame = map.frame();
  for (int y0 = 0; y0 < frame.height; y0 += kTileSide) {
    for (int x0 = 0; x0 < frame.width; x0 += kTileSide) {
      TileCells tile;
      for (int y = y0; y < std::min(y0 + kTileSide, frame.height); ++y) {
        for (int x = x0; x < std::min(x0 + kTileSide, frame.width); ++x) {
          tile.levels[static_cast<std::size_t>((y - y0) * kTileSide + x - x0)] =
              level_of(map[{x, y}], LatticeModel{}.unit);
        }
      }
      if (tile != TileCells{}) tiles.push_back(tile);
    }
  }
  return tiles;
}

}  // namespace cogslam::bench
