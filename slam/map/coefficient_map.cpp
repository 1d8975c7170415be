#include "slam/map/coefficient_map.hpp"

#include <cmath>

#include "core/check.hpp"

namespace cogslam {
namespace {

constexpr float kRounding = 1e-5F;  // log-odds; a hundred round trips of float stay below it

}  // namespace

CoefficientMap::Stored::Stored(std::shared_ptr<MemoryMeter> meter, const CoefficientCode& given)
    : counted(std::move(meter), static_cast<std::int64_t>(given.size() * (sizeof(std::uint32_t) + sizeof(float))),
              shared_block_bytes<Stored>() + heap_bytes(given.size() * sizeof(std::uint32_t)) +
                  heap_bytes(given.size() * sizeof(float))),
      code(given) {}  // copies of vectors hold no spare capacity

CoefficientMap::CoefficientMap(const GridFrame& area, double percent, std::shared_ptr<MemoryMeter> meter)
    : area_(area),
      canvas_(HaarCanvas::covering(area.width, area.height)),
      kept_(kept_count(area.size(), percent)),
      meter_(std::move(meter)) {
  EXPECTS(percent > 0.0 && percent <= 100.0);
}

void CoefficientMap::load(Grid<float>& scratch_grid, CoefficientScratch& scratch) const {
  scratch_grid.reset(area_, 0.0F);
  if (!code_) return;
  scratch.coefficients.resize(canvas_.size());
  scratch.transform.resize(canvas_.scratch_size());
  reconstruct_fast_l2(code_->code, scratch.coefficients);
  haar_inverse(canvas_, scratch.coefficients, scratch_grid.values(), scratch.transform);
}

void CoefficientMap::commit(const Grid<float>& scratch_grid, CoefficientScratch& scratch) {
  EXPECTS(scratch_grid.frame() == area_);
  scratch.coefficients.resize(canvas_.size());
  scratch.transform.resize(canvas_.scratch_size());
  haar_forward(canvas_, scratch_grid.values(), scratch.coefficients, scratch.transform);
  // What a round trip leaves in place of an exact zero is rounding, not map: it would take the place of data.
  for (float& c : scratch.coefficients) c = std::abs(c) < kRounding ? 0.0F : c;
  select_top_m(scratch.coefficients, kept_, scratch.code, scratch.selection);
  code_ = std::make_shared<Stored>(meter_, scratch.code);
}

void CoefficientMap::add_to(Hash& hash) const {
  if (!code_) return;
  hash.add(std::span<const std::uint32_t>(code_->code.indices)).add(std::span<const float>(code_->code.values));
}

}  // namespace cogslam
