#include "slam/map/store.hpp"

#include "core/check.hpp"

namespace cogslam {
namespace {

std::variant<DenseMap, CoefficientMap> make(const StoreConfig& config, double cell_size,
                                            const std::optional<GridFrame>& area, std::shared_ptr<MemoryMeter> meter) {
  if (config.kind == StoreKind::kDense) return DenseMap(cell_size, area, std::move(meter));
  EXPECTS(area.has_value());
  return CoefficientMap(*area, config.percent_kept, std::move(meter));
}

}  // namespace

MapStore::MapStore(const StoreConfig& config, double cell_size, const std::optional<GridFrame>& area,
                   std::shared_ptr<MemoryMeter> meter)
    : map_(make(config, cell_size, area, std::move(meter))) {}

void MapStore::load(const CellWindow& window, MapScratch& scratch) const {
  if (const auto* dense = std::get_if<DenseMap>(&map_)) {
    dense->load(window, scratch.log_odds);
  } else {
    std::get<CoefficientMap>(map_).load(scratch.log_odds, scratch.coefficients);
  }
}

void MapStore::commit(const CellWindow& changed, MapScratch& scratch) {
  if (auto* dense = std::get_if<DenseMap>(&map_)) {
    dense->commit(scratch.log_odds, changed);
  } else {
    std::get<CoefficientMap>(map_).commit(scratch.log_odds, scratch.coefficients);
  }
}

CellWindow MapStore::extent() const {
  return std::visit([](const auto& map) { return map.extent(); }, map_);
}

void MapStore::add_to(Hash& hash) const {
  std::visit([&](const auto& map) { map.add_to(hash); }, map_);
}

}  // namespace cogslam
