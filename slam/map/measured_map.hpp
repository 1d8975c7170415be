#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/grid.hpp"
#include "core/hash.hpp"
#include "slam/codec/coefficient_code.hpp"
#include "slam/map/cell_window.hpp"
#include "slam/map/compression.hpp"
#include "slam/map/memory_meter.hpp"

namespace cogslam {

/// What all particles of a filter share: how maps are measured.
struct MeasuringPlan {
  GridFrame area;
  double percent = 40.0;  ///< rows of H, of 100 per map cell, in (0, 100]
  CompressionConfig compression;
};

/// Basis, H and memory for measuring and recovering the maps of one plan; one per thread.
class MapMeasurer {
 public:
  explicit MapMeasurer(std::shared_ptr<const MeasuringPlan> plan);

  [[nodiscard]] const MeasuringPlan* plan() const { return plan_.get(); }
  /// y = H Phi' m; `code.indices` names the rows of an H that depends on the map, and is empty for a fixed H.
  void measure(std::span<const float> map, CoefficientCode& code);
  /// m = Phi c with c recovered from y. A recovery that has not converged gives its best c.
  void recover(const CoefficientCode& code, std::span<float> map);

 private:
  std::shared_ptr<const MeasuringPlan> plan_;
  Recovery recovery_;
  Basis basis_;
  std::optional<Compressor> fixed_;  ///< nothing: H depends on the map
  std::vector<double> map_, coefficients_, measurements_;
};

/// The compressed map of FastSLAM COG for any basis, compressor and recovery: the general path, in double and without
/// matrices, beside CoefficientMap, which is the fast one for the paper's choice. Every load recovers the whole grid,
/// every commit measures it anew (eq. 22). Copies share one code until they commit.
class MeasuredMap {
 public:
  using Scratch = std::optional<MapMeasurer>;

  /// An empty (unknown) map. The plan has no trouble (trouble_of).
  MeasuredMap(std::shared_ptr<const MeasuringPlan> plan, std::shared_ptr<MemoryMeter> meter);

  /// Fills `grid` with the whole area.
  void load(Grid<float>& grid, Scratch& scratch) const;
  /// Takes over a grid that covers the area.
  void commit(const Grid<float>& grid, Scratch& scratch);

  [[nodiscard]] CellWindow extent() const { return window_of(plan_->area); }
  [[nodiscard]] std::size_t measurements() const { return code_ ? code_->code.values.size() : 0; }
  void add_to(Hash& hash) const;

 private:
  /// A code and its accounting: a float for each measurement, and a u32 where the row has to be named. Rows of a fixed
  /// H follow from the seed.
  struct Stored {
    Stored(std::shared_ptr<MemoryMeter> meter, const CoefficientCode& code);
    MeteredBlock counted;
    CoefficientCode code;
  };
  MapMeasurer& measurer(Scratch& scratch) const;

  std::shared_ptr<const MeasuringPlan> plan_;
  std::shared_ptr<MemoryMeter> meter_;
  std::shared_ptr<const Stored> code_;  ///< nothing: all zero
};

}  // namespace cogslam
