#include "slam/map/lattice.hpp"

#include <cmath>

#include "core/check.hpp"
#include "core/number_text.hpp"

namespace cogslam {
namespace {

constexpr double kRounding = 1e-4;  // levels: configurations are decimal, floats are not

std::int8_t nearest_level(double log_odds, double unit) {
  return static_cast<std::int8_t>(std::lround(std::clamp(log_odds / unit, -128.0, 127.0)));
}

std::optional<LatticeTrouble> trouble_of(const std::string& key, float value, double unit) {
  const double levels = static_cast<double>(value) / unit;
  const std::string found = number_text(std::round(static_cast<double>(value) * 1e6) / 1e6);  // 0.7F is 0.69999998...
  if (std::abs(levels - std::round(levels)) > kRounding) {
    return LatticeTrouble{key,
                          "expected a multiple of the store's lattice_unit " + number_text(unit) + ", found " + found};
  }
  if (std::round(levels) == 0.0 || levels < -128.5 || levels > 127.5) {
    return LatticeTrouble{
        key, "expected at most 127 times the store's lattice_unit " + number_text(unit) + " and not 0, found " + found};
  }
  return std::nullopt;
}

}  // namespace

std::optional<LatticeTrouble> lattice_trouble(const LogOddsModel& model, double unit) {
  if (!model.clamped) return LatticeTrouble{"clamped", "expected true: the store keeps levels between min and max"};
  if (auto trouble = trouble_of("hit", model.hit, unit)) return trouble;
  if (auto trouble = trouble_of("free", model.free, unit)) return trouble;
  if (auto trouble = trouble_of("min", model.min, unit)) return trouble;
  return trouble_of("max", model.max, unit);
}

LatticeModel lattice_model(const LogOddsModel& model, double unit) {
  EXPECTS(!lattice_trouble(model, unit));
  return {.unit = unit,
          .hit = nearest_level(model.hit, unit),
          .free = nearest_level(model.free, unit),
          .min = nearest_level(model.min, unit),
          .max = nearest_level(model.max, unit),
          .rule = model.rule};
}

std::int8_t level_of(float log_odds, double unit) { return nearest_level(log_odds, unit); }

}  // namespace cogslam
