#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "slam/mobile_sensing/cell_samples.hpp"
#include "slam/recover/recovered.hpp"

namespace cogslam {

/// What a field is taken to be when it is recovered from a few cells.
enum class FieldPrior {
  kHaar,            ///< few Haar coefficients: least l1 norm, eq. (4); sides padded to powers of two
  kDct,             ///< few DCT coefficients: the same in the basis of figure 6 (a); any sides
  kTotalVariation,  ///< few and short edges, eqs. (11), (12)
};

/// "haar", "dct", "tv", in the order of the paper.
inline constexpr std::array<std::string_view, 3> kFieldPriorNames = {"haar", "dct", "tv"};
[[nodiscard]] std::string_view name_of(FieldPrior prior);
[[nodiscard]] std::optional<FieldPrior> field_prior(std::string_view name);

/// How exactly to solve.
struct FieldRecovery {
  FieldPrior prior = FieldPrior::kTotalVariation;
  double stop_at_gap = 1e-3;  ///< relative duality gap that ends the run, > 0
  int max_iterations = 10000;
};

/// A recovered field.
struct RecoveredField {
  std::vector<double> field;  ///< width * height values, row-major; agrees with the samples
  double objective = 0.0;     ///< l1 norm of the coefficients, or total variation
  Recovered solver;           ///< how the solver ended; its x holds the coefficients, those of the padding included
};

/// Recovers all cells from at least one. Eq. (12) applies TV to coefficients; it is read as TV of the map they stand
/// for, and then no longer depends on a basis. Cells of a padded canvas are unknown, never sampled: the samples pick
/// cells of the cropped field, and the padding costs what its coefficients cost.
/// Throws InputError for no cells, and for fewer or more samples than cells.
[[nodiscard]] RecoveredField recover_field(const FieldRecovery& recovery, const CellSamples& samples);

}  // namespace cogslam
