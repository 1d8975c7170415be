#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "slam/map/coefficient_map.hpp"
#include "slam/map/compression.hpp"
#include "slam/map/dense_map.hpp"
#include "slam/map/measured_map.hpp"

namespace cogslam {

/// Every way to keep a particle's map, on one page.
enum class StoreKind {
  kDense,         ///< float log-odds, shared until written: FastSLAM OG (Alg. 1, 2)
  kCoefficients,  ///< measurements of the whole grid's coefficients, as shipped the largest ones of Haar: FastSLAM COG
                  ///< (Alg. 3, 4, 7, 8; eq. 22)
};

struct StoreConfig {
  StoreKind kind = StoreKind::kDense;
  double percent_kept = 40.0;       ///< coefficients kept, of 100 per map cell (kCoefficients only), in (0, 100]
  CompressionConfig compression{};  ///< of kCoefficients
};

/// A map window in plain form, with what the stores need to fill it. One per thread.
struct MapScratch {
  Grid<float> log_odds;
  CoefficientScratch coefficients;
  MeasuredMap::Scratch measured;
};

/// A particle's map. No store is asked cell by cell: `load` fills a plain grid for the window that a scan can touch,
/// matching, weighing and the ray walk work on it, and `commit` writes the changed cells back. Copying shares.
class MapStore {
 public:
  /// An empty map. `area` is required by kCoefficients; kDense grows without it.
  MapStore(const StoreConfig& config, double cell_size, const std::optional<GridFrame>& area,
           std::shared_ptr<MemoryMeter> meter);

  /// Fills `scratch.log_odds` with at least the part of `window` that the map may hold.
  void load(const CellWindow& window, MapScratch& scratch) const;
  /// Takes over the lattice cells `changed` of `scratch.log_odds`, as loaded and then changed there.
  void commit(const CellWindow& changed, MapScratch& scratch);

  /// A window outside which every cell is unknown.
  [[nodiscard]] CellWindow extent() const;
  void add_to(Hash& hash) const;

 private:
  std::variant<DenseMap, CoefficientMap, MeasuredMap> map_;
};

}  // namespace cogslam
