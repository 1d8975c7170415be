#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "slam/codec/compressor.hpp"

namespace cogslam {

/// A few cells of a field, and what was sensed there: y = Phi m, eq. (3).
struct CellSamples {
  int width = 0;                     ///< of the field, cells per row
  int height = 0;                    ///< rows
  std::vector<std::uint32_t> cells;  ///< l_i: indices y * width + x, each once
  std::vector<double> values;        ///< y_i = m(l_i)

  [[nodiscard]] std::size_t field_size() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

/// Tells the value of a cell: the sensor, as far as recovery knows it.
using CellSensor = std::function<double(std::uint32_t cell)>;

/// Phi of eq. (3): row i has its 1 in column l_i.
[[nodiscard]] Compressor selection_of(const CellSamples& samples);

/// Senses these cells, each once and below width * height.
[[nodiscard]] CellSamples sense_cells(int width, int height, std::vector<std::uint32_t> cells,
                                      const CellSensor& sensor);

/// The paper's choice: `count` <= cells of the field, drawn uniformly and mutually excluded. The cells for a count are
/// the first ones for any larger count of the same seed.
[[nodiscard]] CellSamples sense_random_cells(int width, int height, std::size_t count, std::uint32_t seed,
                                             const CellSensor& sensor);

}  // namespace cogslam
