#pragma once

#include <memory>
#include <vector>

#include "core/grid.hpp"
#include "core/hash.hpp"
#include "slam/codec/coefficient_code.hpp"
#include "slam/codec/haar.hpp"
#include "slam/codec/top_m.hpp"
#include "slam/map/cell_window.hpp"
#include "slam/map/memory_meter.hpp"

namespace cogslam {

/// Memory that encoding and decoding reuse; one per thread.
struct CoefficientScratch {
  std::vector<float> coefficients;
  std::vector<float> transform;
  TopMScratch selection;
  CoefficientCode code;
};

/// The compressed map of FastSLAM COG: the largest Haar coefficients of the whole grid. Every load reconstructs the
/// grid (Alg. 8), every commit transforms and selects anew (eqs. 20, 22; Alg. 7), so truncation errors add up over
/// time, as in the paper. Copies share one code until they commit.
class CoefficientMap {
 public:
  /// An empty (unknown) map of `area`, of whose n cells `percent` in (0, 100] coefficients are kept:
  /// m = floor(n percent / 100 + 1/2).
  CoefficientMap(const GridFrame& area, double percent, std::shared_ptr<MemoryMeter> meter);

  /// Fills `scratch_grid` with the whole area: c = H_r y, m = Phi c (eq. 14).
  void load(Grid<float>& scratch_grid, CoefficientScratch& scratch) const;
  /// y = H Phi^T m of a grid m that covers the area: eq. (22), whose bracket is Phi^T of the updated grid. What an
  /// earlier selection let leak into the padding of the canvas is not in m, and so is dropped.
  void commit(const Grid<float>& scratch_grid, CoefficientScratch& scratch);

  [[nodiscard]] CellWindow extent() const { return window_of(area_); }
  [[nodiscard]] std::size_t coefficients() const { return code_ ? code_->code.size() : 0; }
  void add_to(Hash& hash) const;

 private:
  /// A code and its accounting: payload as in memory, a u32 index and a float for each coefficient.
  struct Stored {
    Stored(std::shared_ptr<MemoryMeter> meter, const CoefficientCode& code);
    MeteredBlock counted;
    CoefficientCode code;
  };

  GridFrame area_;
  HaarCanvas canvas_;
  std::size_t kept_;
  std::shared_ptr<MemoryMeter> meter_;
  std::shared_ptr<const Stored> code_;  ///< nothing: all zero
};

}  // namespace cogslam
