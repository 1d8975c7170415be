#include "slam/map/measured_map.hpp"

#include <algorithm>
#include <cmath>

#include "core/check.hpp"
#include "slam/codec/top_m.hpp"

namespace cogslam {
namespace {

constexpr double kRounding = 1e-5;  // log-odds: as CoefficientMap, what round trips leave in place of an exact zero

std::size_t rows_of(const MeasuringPlan& plan) { return kept_count(plan.area.size(), plan.percent); }

}  // namespace

MapMeasurer::MapMeasurer(std::shared_ptr<const MeasuringPlan> plan)
    : plan_(std::move(plan)),
      recovery_(recovery_for(plan_->compression, plan_->area.width, plan_->area.height)),
      basis_(plan_->compression.basis, plan_->area.width, plan_->area.height),
      map_(basis_.cells()),
      coefficients_(basis_.size()) {
  const CompressionConfig& how = plan_->compression;
  if (how.compressor != CompressorKind::kTopM) {
    fixed_ = make_compressor(how.compressor, rows_of(*plan_), basis_.size(), how.compressor_seed);
  }
}

void MapMeasurer::measure(std::span<const float> map, CoefficientCode& code) {
  std::copy(map.begin(), map.end(), map_.begin());
  basis_.forward(map_, coefficients_);
  if (fixed_) {
    measurements_.resize(fixed_->rows());
    fixed_->apply(coefficients_, measurements_);
    code.indices.clear();
  } else {
    for (double& c : coefficients_) c = std::abs(c) < kRounding ? 0.0 : c;
    Compressor largest = make_top_m(coefficients_, rows_of(*plan_));
    measurements_.resize(largest.rows());
    largest.apply(coefficients_, measurements_);
    code.indices.assign(largest.indices().begin(), largest.indices().end());
  }
  code.values.assign(measurements_.begin(), measurements_.end());
}

void MapMeasurer::recover(const CoefficientCode& code, std::span<float> map) {
  measurements_.assign(code.values.begin(), code.values.end());
  if (fixed_) {
    basis_.inverse(cogslam::recover(recovery_, *fixed_, measurements_).x, map_);
  } else {
    Compressor largest = Compressor::selection(code.indices, basis_.size());
    basis_.inverse(cogslam::recover(recovery_, largest, measurements_).x, map_);
  }
  std::transform(map_.begin(), map_.end(), map.begin(), [](double value) { return static_cast<float>(value); });
}

MeasuredMap::Stored::Stored(std::shared_ptr<MemoryMeter> meter, const CoefficientCode& given)
    : counted(
          std::move(meter),
          static_cast<std::int64_t>(given.indices.size() * sizeof(std::uint32_t) + given.values.size() * sizeof(float)),
          shared_block_bytes<Stored>() + heap_bytes(given.indices.size() * sizeof(std::uint32_t)) +
              heap_bytes(given.values.size() * sizeof(float))),
      code(given) {}

MeasuredMap::MeasuredMap(std::shared_ptr<const MeasuringPlan> plan, std::shared_ptr<MemoryMeter> meter)
    : plan_(std::move(plan)), meter_(std::move(meter)) {
  EXPECTS(plan_->percent > 0.0 && plan_->percent <= 100.0);
}

MapMeasurer& MeasuredMap::measurer(Scratch& scratch) const {
  if (!scratch || scratch->plan() != plan_.get()) scratch.emplace(plan_);
  return *scratch;
}

void MeasuredMap::load(Grid<float>& grid, Scratch& scratch) const {
  grid.reset(plan_->area, 0.0F);
  if (code_) measurer(scratch).recover(code_->code, grid.values());
}

void MeasuredMap::commit(const Grid<float>& grid, Scratch& scratch) {
  EXPECTS(grid.frame() == plan_->area);
  CoefficientCode code;
  measurer(scratch).measure(grid.values(), code);
  code_ = std::make_shared<Stored>(meter_, code);
}

void MeasuredMap::add_to(Hash& hash) const {
  if (!code_) return;
  hash.add(std::span<const std::uint32_t>(code_->code.indices)).add(std::span<const float>(code_->code.values));
}

}  // namespace cogslam
