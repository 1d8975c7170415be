#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "slam/map/coefficient_map.hpp"
#include "slam/map/compression.hpp"
#include "slam/map/dense_map.hpp"
#include "slam/map/lattice.hpp"
#include "slam/map/measured_map.hpp"
#include "slam/map/tile_map.hpp"

namespace cogslam {

/// Every way to keep a particle's map, on one page.
enum class StoreKind {
  kDense,          ///< float log-odds, shared until written: FastSLAM OG (Alg. 1, 2)
  kCoefficients,   ///< measurements of the whole grid's coefficients, as shipped the largest ones of Haar: FastSLAM COG
                   ///< (Alg. 3, 4, 7, 8; eq. 22)
  kTiles,          ///< levels of log-odds in coded 32 x 32 tiles that maps share
  kTwoResolution,  ///< as kTiles, but with coarse cells in tiles where nothing is occupied: loses detail
  kLattice,        ///< the same levels, a byte per cell: the plain twin of kTiles
};

/// The kinds that keep levels of a LatticeModel: they load and commit Grid<std::int8_t>, floats only by conversion.
inline bool keeps_levels(StoreKind kind) {
  return kind == StoreKind::kTiles || kind == StoreKind::kTwoResolution || kind == StoreKind::kLattice;
}

struct StoreConfig {
  StoreKind kind = StoreKind::kDense;
  double percent_kept = 40.0;       ///< coefficients kept, of 100 per map cell (kCoefficients only), in (0, 100]
  CompressionConfig compression{};  ///< of kCoefficients
  int seal_after = 8;         ///< registered scans until an unchanged tile gets its dense code (kTiles); 0: at once
  double lattice_unit = 0.4;  ///< log-odds of one level (kTiles and kLattice), > 0
};

/// A map window in plain form, with what the stores need to fill it. One per thread.
struct MapScratch {
  Grid<float> log_odds;
  Grid<std::int8_t> levels;  ///< of kTiles and kLattice
  CoefficientScratch coefficients;
  MeasuredMap::Scratch measured;
};

/// A particle's map. No store is asked cell by cell: `load` fills a plain grid for the window that a scan can touch,
/// matching, weighing and the ray walk work on it, and `commit` writes the changed cells back. Copying shares.
///
/// Stores that keep levels offer a second pair, load_levels and commit_levels, without the way through floats. Both
/// pairs work on whole tiles, so that kTiles and kLattice hand out the same frames.
class MapStore {
 public:
  /// An empty map. `area` is required by kCoefficients; the others grow without it.
  MapStore(const StoreConfig& config, double cell_size, const std::optional<GridFrame>& area,
           std::shared_ptr<MemoryMeter> meter);

  /// Fills `scratch.log_odds` with at least the part of `window` that the map may hold.
  void load(const CellWindow& window, MapScratch& scratch) const;
  /// Takes over the lattice cells `changed` of `scratch.log_odds`, as loaded and then changed there.
  void commit(const CellWindow& changed, MapScratch& scratch);

  [[nodiscard]] bool has_levels() const;
  /// The same on `scratch.levels`; the map has levels.
  void load_levels(const CellWindow& window, MapScratch& scratch) const;
  void commit_levels(const CellWindow& changed, MapScratch& scratch);

  /// Once per registered scan, for the maps of all particles, one after another and beside no other call: codes what is
  /// out of use more densely (kTiles; the others do nothing). `scan` counts up. Changes bytes, never cells.
  void settle(std::uint64_t scan);

  /// A window outside which every cell is unknown.
  [[nodiscard]] CellWindow extent() const;
  void add_to(Hash& hash) const;

 private:
  std::variant<DenseMap, CoefficientMap, MeasuredMap, TileMap, LatticeMap> map_;
  double unit_;  ///< log-odds of one level
};

}  // namespace cogslam
