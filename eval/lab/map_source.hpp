#pragma once

#include <filesystem>
#include <string>

#include "core/grid.hpp"

namespace cogslam {

/// A map of log-odds for the laboratory, out of
/// - a NumPy file (.npy) of two dimensions, float32 or float64, little-endian, C order, as the program writes it;
/// - a text file of numbers separated by commas, a line per row (any other file that exists);
/// - the name of a room, simple, cornered or cluttered: its ideal map (ideal_room_map) in cells of `cell_size` [m].
///
/// The first row of a file is row 0 of the grid. Throws InputError with file, line and column; an unknown name gets a
/// suggestion. Values must be finite, rows of one length, at least one cell.
Grid<float> lab_map(const std::string& name, double cell_size);

/// Cells of a map out of a file [8192 x 8192].
constexpr std::size_t kMostFileCells = std::size_t{1} << 26;

Grid<float> read_npy(const std::filesystem::path& file);
Grid<float> read_csv(const std::filesystem::path& file);

/// What a filter would hold that has seen everything for long: each observable cell at the clamp of LogOddsModel, the
/// others 0. "simple", "cornered" or "cluttered"; InputError for other names.
Grid<float> ideal_room_map(const std::string& room, double cell_size);

/// `map` in the middle of a frame of width x height cells, at least as large; the cells around it are 0.
Grid<float> centred_in(const Grid<float>& map, int width, int height);

}  // namespace cogslam
