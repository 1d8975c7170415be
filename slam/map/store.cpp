#include "slam/map/store.hpp"

#include "core/check.hpp"

namespace cogslam {
namespace {

std::variant<DenseMap, CoefficientMap, MeasuredMap> make(const StoreConfig& config, double cell_size,
                                                         const std::optional<GridFrame>& area,
                                                         std::shared_ptr<MemoryMeter> meter) {
  if (config.kind == StoreKind::kDense) return DenseMap(cell_size, area, std::move(meter));
  EXPECTS(area.has_value());
  if (config.compression.is_papers_choice()) return CoefficientMap(*area, config.percent_kept, std::move(meter));
  EXPECTS(!trouble_of(config.compression, config.percent_kept, area->width, area->height));
  return MeasuredMap(
      std::make_shared<const MeasuringPlan>(MeasuringPlan{*area, config.percent_kept, config.compression}),
      std::move(meter));
}

}  // namespace

MapStore::MapStore(const StoreConfig& config, double cell_size, const std::optional<GridFrame>& area,
                   std::shared_ptr<MemoryMeter> meter)
    : map_(make(config, cell_size, area, std::move(meter))) {}

void MapStore::load(const CellWindow& window, MapScratch& scratch) const {
  if (const auto* dense = std::get_if<DenseMap>(&map_)) {
    dense->load(window, scratch.log_odds);
  } else if (const auto* coefficients = std::get_if<CoefficientMap>(&map_)) {
    coefficients->load(scratch.log_odds, scratch.coefficients);
  } else {
    std::get<MeasuredMap>(map_).load(scratch.log_odds, scratch.measured);
  }
}

void MapStore::commit(const CellWindow& changed, MapScratch& scratch) {
  if (auto* dense = std::get_if<DenseMap>(&map_)) {
    dense->commit(scratch.log_odds, changed);
  } else if (auto* coefficients = std::get_if<CoefficientMap>(&map_)) {
    coefficients->commit(scratch.log_odds, scratch.coefficients);
  } else {
    std::get<MeasuredMap>(map_).commit(scratch.log_odds, scratch.measured);
  }
}

CellWindow MapStore::extent() const {
  return std::visit([](const auto& map) { return map.extent(); }, map_);
}

void MapStore::add_to(Hash& hash) const {
  std::visit([&](const auto& map) { map.add_to(hash); }, map_);
}

}  // namespace cogslam
