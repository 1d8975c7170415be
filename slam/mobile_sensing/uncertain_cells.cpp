#include "slam/mobile_sensing/uncertain_cells.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/check.hpp"
#include "slam/mobile_sensing/field_recovery.hpp"
#include "slam/mobile_sensing/nearest_sample.hpp"

namespace cogslam {
namespace {

/// The largest step from a cell to one of its four neighbours.
double largest_step(std::span<const double> field, int width, int height, std::uint32_t cell) {
  const int x = static_cast<int>(cell) % width, y = static_cast<int>(cell) / width;
  double largest = 0.0;
  const auto look = [&](bool exists, std::size_t neighbour) {
    if (exists) largest = std::max(largest, std::abs(field[neighbour] - field[cell]));
  };
  look(x > 0, cell - std::size_t{1});
  look(x + 1 < width, cell + std::size_t{1});
  look(y > 0, cell - static_cast<std::size_t>(width));
  look(y + 1 < height, cell + static_cast<std::size_t>(width));
  return largest;
}

/// Uncertainty of every cell beside an edge of the recovered map.
std::vector<double> edges(const UncertainCells& plan, const CellSamples& samples) {
  const std::vector<double> field =
      recover_field({.prior = FieldPrior::kTotalVariation, .stop_at_gap = plan.stop_at_gap}, samples).field;
  std::vector<double> uncertainty(field.size());
  for (std::uint32_t i = 0; i < field.size(); ++i) {
    uncertainty[i] = largest_step(field, samples.width, samples.height, i);
  }
  return uncertainty;
}

/// Uncertainty of every cell between samples that disagree; where all agree, far cells come first.
std::vector<double> disagreements(const CellSamples& samples) {
  constexpr double kFarther = 1e-6;  // cells where samples agree come behind all others
  const NearestSamples nearest = nearest_samples(samples);
  std::vector<double> field(samples.field_size()), uncertainty(samples.field_size());
  for (std::size_t i = 0; i < field.size(); ++i) field[i] = samples.values[nearest.sample[i]];
  for (std::uint32_t i = 0; i < field.size(); ++i) {
    const double step = largest_step(field, samples.width, samples.height, i);
    uncertainty[i] = step * (1.0 + nearest.distance[i]) + kFarther * nearest.distance[i];
  }
  return uncertainty;
}

class Rounds {
 public:
  Rounds(CellSamples samples, std::vector<std::uint32_t> order, const CellSensor& sensor)
      : samples_(std::move(samples)), rest_(std::move(order)), sensor_(sensor) {
    forget_sensed();
  }

  /// Senses the `count` cells of greatest uncertainty; the random order decides between equals.
  void sense_most(const std::vector<double>& uncertainty, std::size_t count) {
    std::ranges::stable_sort(rest_, std::greater{}, [&](std::uint32_t cell) { return uncertainty[cell]; });
    for (std::size_t i = 0; i < count; ++i) {
      samples_.cells.push_back(rest_[i]);
      samples_.values.push_back(sensor_(rest_[i]));
    }
    forget_sensed();
  }
  [[nodiscard]] const CellSamples& samples() const { return samples_; }

 private:
  void forget_sensed() {
    std::vector<bool> sensed(samples_.field_size(), false);
    for (const std::uint32_t cell : samples_.cells) sensed[cell] = true;
    std::erase_if(rest_, [&](std::uint32_t cell) { return sensed[cell]; });
  }

  CellSamples samples_;
  std::vector<std::uint32_t> rest_;
  const CellSensor& sensor_;
};

std::size_t share_of(double share, std::size_t count) {
  return static_cast<std::size_t>(std::ceil(share * static_cast<double>(count)));
}

}  // namespace

CellSamples sense_uncertain_cells(const UncertainCells& plan, int width, int height, std::size_t count,
                                  std::uint32_t seed, const CellSensor& sensor) {
  EXPECTS(plan.random_share > 0.0 && plan.random_share <= 1.0 && plan.rounds >= 1 && plan.stop_at_gap > 0.0);
  EXPECTS(plan.edge_share >= 0.0 && plan.edge_share <= 1.0);
  const std::size_t first = share_of(plan.random_share, count);
  Rounds rounds(sense_random_cells(width, height, first, seed, sensor),
                random_order(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), seed), sensor);
  for (int round = 1; round <= plan.rounds; ++round) {
    const std::size_t until =
        first + (count - first) * static_cast<std::size_t>(round) / static_cast<std::size_t>(plan.rounds);
    const std::size_t wanted = until - rounds.samples().cells.size(), beside = share_of(plan.edge_share, wanted);
    if (beside > 0) rounds.sense_most(edges(plan, rounds.samples()), beside);
    if (beside < wanted) rounds.sense_most(disagreements(rounds.samples()), wanted - beside);
  }
  return rounds.samples();
}

}  // namespace cogslam
