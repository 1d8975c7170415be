#include "slam/weight/scan_likelihood.hpp"

#include <algorithm>
#include <cmath>

#include "core/check.hpp"
#include "slam/map/expected_range.hpp"

namespace cogslam {
namespace {

/// A sum of logarithms, taken of products: a logarithm per beam would cost more than the field.
class LogSum {
 public:
  void add(double density) {
    product_ *= density;
    if (product_ < kSmall) flush();
  }
  [[nodiscard]] double value() {
    flush();
    return sum_;
  }

 private:
  static constexpr double kSmall = 1e-200;  // densities lie above 1e-5, so products cannot vanish before
  void flush() {
    sum_ += std::log(product_);
    product_ = 1.0;
  }
  double product_ = 1.0;
  double sum_ = 0.0;
};

constexpr float kFar = 0.05F;   // value of the field 2.4 sigma from an occupied cell
constexpr double kFlat = 1e-3;  // per metre: a gentler relative slope has no direction

}  // namespace

ScanLikelihood::ScanLikelihood(const ScanLikelihoodConfig& config, double cell_size)
    : config_(config), field_(config.field, cell_size) {
  EXPECTS(config.beams > 0 && config.effective_beams > 0.0 && config.hit_share > 0.0 && config.hit_share < 1.0);
}

std::vector<Beam> ScanLikelihood::probes_of(const std::vector<Beam>& sweep) const {
  std::vector<Beam> hits;
  for (const Beam& beam : sweep) {
    if (beam.hit) hits.push_back(beam);
  }
  const auto wanted = static_cast<std::size_t>(config_.beams);
  if (hits.size() <= wanted) return hits;
  std::vector<Beam> probes;
  for (std::size_t i = 0; i < wanted; ++i) probes.push_back(hits[(2 * i + 1) * hits.size() / (2 * wanted)]);
  return probes;
}

void ScanLikelihood::look_at(const Grid<float>& log_odds) {
  map_ = &log_odds;
  field_.draw(log_odds);
}

void ScanLikelihood::look_at(const Grid<std::int8_t>& levels, double unit) {
  EXPECTS(config_.model == ScanModel::kLikelihoodField);
  field_.draw(levels, unit);
}

double ScanLikelihood::log_likelihood(const std::vector<Beam>& probes, const Pose2& T_map_base) const {
  return config_.model == ScanModel::kBeam ? beam_log_likelihood(probes, T_map_base)
                                           : field_log_likelihood(probes, T_map_base);
}

double ScanLikelihood::field_log_likelihood(const std::vector<Beam>& probes, const Pose2& T_map_base) const {
  if (probes.empty()) return 0.0;
  const double c = std::cos(T_map_base.theta), s = std::sin(T_map_base.theta);
  const double hit = config_.hit_share, random = 1.0 - hit, unknown = config_.unknown_value;
  LogSum sum;
  for (const Beam& beam : probes) {
    const double x = T_map_base.x + c * beam.end.x() - s * beam.end.y();
    const double y = T_map_base.y + s * beam.end.x() + c * beam.end.y();
    double value = field_.at(x, y);
    if (value < unknown && field_.unknown_at(x, y)) value = unknown;
    sum.add(hit * value + random);
  }
  return config_.effective_beams * sum.value() / static_cast<double>(probes.size());
}

PoseFit ScanLikelihood::field_fit(const std::vector<Beam>& probes, const Pose2& T_map_base) const {
  PoseFit fit;
  LogSum sum;
  if (probes.empty()) return fit;
  const double c = std::cos(T_map_base.theta), s = std::sin(T_map_base.theta);
  const double hit = config_.hit_share, random = 1.0 - hit, unknown = config_.unknown_value;
  const double per_variance = 1.0 / (config_.field.sigma * config_.field.sigma);
  for (const Beam& beam : probes) {
    const double ex = beam.end.x(), ey = beam.end.y();
    const double x = T_map_base.x + c * ex - s * ey, y = T_map_base.y + s * ex + c * ey;
    const LikelihoodField::Slope field = field_.slope_at(x, y);
    if (field.value < unknown && field_.unknown_at(x, y)) {
      sum.add(hit * unknown + random);
      continue;
    }
    const double density = hit * field.value + random;
    sum.add(density);
    const Eigen::Vector2d slope(c * field.dx + s * field.dy, c * field.dy - s * field.dx);  // seen from the base
    const double steepness = slope.norm();
    if (!(steepness > kFlat * field.value)) continue;
    const Eigen::Vector2d normal = slope / steepness;
    const Eigen::Vector3d across(normal.x(), normal.y(), ex * normal.y() - ey * normal.x());
    fit.gradient += hit * steepness / density * across;
    fit.information += hit * field.value / density * per_variance * across * across.transpose();
  }
  const double share = config_.effective_beams / static_cast<double>(probes.size());
  fit.value = share * sum.value();
  fit.gradient *= share;
  fit.information *= share;
  return fit;
}

ScanAgreement ScanLikelihood::agreement(const std::vector<Beam>& probes, const Pose2& T_map_base) const {
  ScanAgreement agreement;
  for (const Beam& beam : probes) {
    const Eigen::Vector2d p_map = T_map_base * beam.end;
    const float value = field_.at(p_map.x(), p_map.y());
    if (value < kFar && field_.unknown_at(p_map.x(), p_map.y())) continue;
    ++agreement.known;
    if (value < kFar) ++agreement.contradicted;
  }
  return agreement;
}

double ScanLikelihood::beam_log_likelihood(const std::vector<Beam>& probes, const Pose2& T_map_base) const {
  if (probes.empty()) return 0.0;
  double sum = 0.0;
  for (const Beam& beam : probes) {
    const ExpectedRange expected = expected_range(*map_, T_map_base * beam.origin, T_map_base * beam.end);
    double value = config_.unknown_value;
    if (expected.known) {
      // The surface may stand anywhere between entering and leaving its cell: no error inside that span.
      const double error = std::max({0.0, expected.enter - beam.range, beam.range - expected.leave});
      value = std::exp(-0.5 * error * error / (config_.range_sigma * config_.range_sigma));
    }
    sum += std::log(config_.hit_share * value + 1.0 - config_.hit_share);
  }
  return config_.effective_beams * sum / static_cast<double>(probes.size());
}

}  // namespace cogslam
