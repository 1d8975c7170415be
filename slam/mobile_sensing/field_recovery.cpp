#include "slam/mobile_sensing/field_recovery.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/check.hpp"
#include "core/error.hpp"
#include "slam/recover/basis_pursuit.hpp"
#include "slam/recover/total_variation.hpp"

namespace cogslam {
namespace {

RecoveredField by_total_variation(const FieldRecovery& recovery, const CellSamples& samples) {
  const auto width = static_cast<std::size_t>(samples.width), height = static_cast<std::size_t>(samples.height);
  Compressor phi = selection_of(samples);
  RecoveredField result;
  result.solver =
      recover(TotalVariation{width, height, recovery.stop_at_gap, recovery.max_iterations}, phi, samples.values);
  result.field = result.solver.x;
  result.objective = total_variation(result.field, width);
  return result;
}

RecoveredField by_sparsity(BasisKind kind, const FieldRecovery& recovery, const CellSamples& samples) {
  Basis basis(kind, samples.width, samples.height);
  InverseThenCompress theta(basis, selection_of(samples));
  RecoveredField result;
  result.solver = recover(BasisPursuit{.stop_at_gap = recovery.stop_at_gap, .max_iterations = recovery.max_iterations},
                          theta, samples.values);
  result.field.resize(basis.cells());
  basis.inverse(result.solver.x, result.field);
  for (const double c : result.solver.x) result.objective += std::abs(c);
  return result;
}

}  // namespace

std::string_view name_of(FieldPrior prior) { return kFieldPriorNames[static_cast<std::size_t>(prior)]; }

std::optional<FieldPrior> field_prior(std::string_view name) {
  const auto found = std::find(kFieldPriorNames.begin(), kFieldPriorNames.end(), name);
  if (found == kFieldPriorNames.end()) return std::nullopt;
  return static_cast<FieldPrior>(found - kFieldPriorNames.begin());
}

RecoveredField recover_field(const FieldRecovery& recovery, const CellSamples& samples) {
  if (samples.cells.empty()) throw InputError("no cell was sensed, expected at least one");
  if (samples.values.size() != samples.cells.size()) {
    throw InputError(std::to_string(samples.values.size()) + " samples for the " +
                     std::to_string(samples.cells.size()) + " cells asked for, expected one each");
  }
  switch (recovery.prior) {
    case FieldPrior::kHaar:
      return by_sparsity(BasisKind::kHaar, recovery, samples);
    case FieldPrior::kDct:
      return by_sparsity(BasisKind::kDct, recovery, samples);
    case FieldPrior::kTotalVariation:
      break;
  }
  return by_total_variation(recovery, samples);
}

}  // namespace cogslam
