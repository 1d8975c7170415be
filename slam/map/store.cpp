#include "slam/map/store.hpp"

#include <algorithm>

#include "core/check.hpp"

namespace cogslam {
namespace {

using Map = std::variant<DenseMap, CoefficientMap, MeasuredMap, TileMap, LatticeMap>;

Map make_coefficients(const StoreConfig& config, const GridFrame& area, std::shared_ptr<MemoryMeter> meter) {
  if (config.compression.is_papers_choice()) return CoefficientMap(area, config.percent_kept, std::move(meter));
  EXPECTS(!trouble_of(config.compression, config.percent_kept, area.width, area.height));
  return MeasuredMap(
      std::make_shared<const MeasuringPlan>(MeasuringPlan{area, config.percent_kept, config.compression}),
      std::move(meter));
}

Map make(const StoreConfig& config, double cell_size, const std::optional<GridFrame>& area,
         std::shared_ptr<MemoryMeter> meter) {
  switch (config.kind) {
    case StoreKind::kDense:
      return DenseMap(cell_size, area, std::move(meter));
    case StoreKind::kTiles:
    case StoreKind::kTwoResolution:
      return TileMap(
          cell_size, area,
          std::make_shared<TileStore>(std::move(meter),
                                      TileStoreConfig{config.kind == StoreKind::kTwoResolution, config.seal_after}));
    case StoreKind::kLattice:
      return LatticeMap(cell_size, area, std::move(meter));
    case StoreKind::kCoefficients:
      break;
  }
  EXPECTS(area.has_value());
  return make_coefficients(config, *area, std::move(meter));
}

}  // namespace

MapStore::MapStore(const StoreConfig& config, double cell_size, const std::optional<GridFrame>& area,
                   std::shared_ptr<MemoryMeter> meter)
    : map_(make(config, cell_size, area, std::move(meter))), unit_(config.lattice_unit) {}

bool MapStore::has_levels() const {
  return std::holds_alternative<TileMap>(map_) || std::holds_alternative<LatticeMap>(map_);
}

void MapStore::load_levels(const CellWindow& window, MapScratch& scratch) const {
  if (const auto* tiles = std::get_if<TileMap>(&map_)) {
    tiles->load(whole_tiles(window), scratch.levels);
  } else {
    std::get<LatticeMap>(map_).load(whole_tiles(window), scratch.levels);
  }
}

void MapStore::commit_levels(const CellWindow& changed, MapScratch& scratch) {
  if (auto* tiles = std::get_if<TileMap>(&map_)) {
    tiles->commit(scratch.levels, changed);
  } else {
    std::get<LatticeMap>(map_).commit(scratch.levels, changed);
  }
}

void MapStore::load(const CellWindow& window, MapScratch& scratch) const {
  if (const auto* dense = std::get_if<DenseMap>(&map_)) {
    dense->load(window, scratch.log_odds);
  } else if (const auto* coefficients = std::get_if<CoefficientMap>(&map_)) {
    coefficients->load(scratch.log_odds, scratch.coefficients);
  } else if (const auto* measured = std::get_if<MeasuredMap>(&map_)) {
    measured->load(scratch.log_odds, scratch.measured);
  } else {
    load_levels(window, scratch);
    scratch.log_odds.reshape(scratch.levels.frame());
    std::transform(scratch.levels.values().begin(), scratch.levels.values().end(), scratch.log_odds.values().begin(),
                   [this](std::int8_t level) { return log_odds_of(level, unit_); });
  }
}

void MapStore::commit(const CellWindow& changed, MapScratch& scratch) {
  if (auto* dense = std::get_if<DenseMap>(&map_)) {
    dense->commit(scratch.log_odds, changed);
  } else if (auto* coefficients = std::get_if<CoefficientMap>(&map_)) {
    coefficients->commit(scratch.log_odds, scratch.coefficients);
  } else if (auto* measured = std::get_if<MeasuredMap>(&map_)) {
    measured->commit(scratch.log_odds, scratch.measured);
  } else {
    scratch.levels.reshape(scratch.log_odds.frame());
    std::transform(scratch.log_odds.values().begin(), scratch.log_odds.values().end(), scratch.levels.values().begin(),
                   [this](float log_odds) { return level_of(log_odds, unit_); });
    commit_levels(changed, scratch);
  }
}

void MapStore::settle(std::uint64_t scan) {
  if (auto* tiles = std::get_if<TileMap>(&map_)) tiles->settle(scan);
}

CellWindow MapStore::extent() const {
  return std::visit([](const auto& map) { return map.extent(); }, map_);
}

void MapStore::add_to(Hash& hash) const {
  std::visit([&](const auto& map) { map.add_to(hash); }, map_);
}

}  // namespace cogslam
