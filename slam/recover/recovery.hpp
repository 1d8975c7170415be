#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "slam/recover/fast_l2.hpp"
#include "slam/recover/kalman_cs.hpp"
#include "slam/recover/kalman_cs_p.hpp"
#include "slam/recover/map_view.hpp"
#include "slam/recover/nesta.hpp"
#include "slam/recover/pinv.hpp"
#include "slam/recover/recovered.hpp"
#include "slam/recover/total_variation.hpp"

namespace cogslam {

/// Every way from measurements y = A x back to x, on one page.
///
/// | name             | asks of A        | cost                        | finds                                      |
/// |------------------|------------------|-----------------------------|--------------------------------------------|
/// | pinv             | m n <= 2^24      | m^2 n                       | least norm (sec. 4.1)                      |
/// | fast_l2          | orthonormal rows | one product with A'         | the same (sec. 5.2)                        |
/// | nesta            | orthonormal rows | hundreds of products        | least l1 norm (sec. 4.2)                   |
/// | csekf            | n <= 4096        | tau n^2                     | towards least l1 norm (Alg. 5)             |
/// | csekf_p_printed  | n <= 4096        | tau n^2                     | towards least quasi-norm (Alg. 6 as printed) |
/// | csekf_p_gradient | n <= 4096        | tau n^2                     | the same with the true derivative          |
/// | csekf_p_power    | n <= 4096        | tau n^2                     | towards least sum of p-th powers           |
/// | tv               | distinct cells   | hundreds of passes over map | least total variation                      |
using Recovery = std::variant<PseudoInverse, FastL2, Nesta, KalmanCs, KalmanCsP, TotalVariation>;

/// Names for scenario files and the command line, in the order of the table.
inline constexpr std::array<std::string_view, 8> kRecoveryNames = {
    "pinv", "fast_l2", "nesta", "csekf", "csekf_p_printed", "csekf_p_gradient", "csekf_p_power", "tv"};

/// The recovery of a name, with its default parameters (total variation still needs the map's shape); nullopt for a
/// name that is not in the table.
[[nodiscard]] std::optional<Recovery> recovery_named(std::string_view name);

/// The name of a recovery.
[[nodiscard]] std::string_view name_of(const Recovery& recovery);

/// Why a recovery cannot be used with a map, as a sentence for the user; nullopt if it can.
[[nodiscard]] std::optional<std::string> why_not(const Recovery& recovery, const MapView& a);

/// Recovers x from y (a.rows() values). Throws InputError with the words of why_not.
[[nodiscard]] Recovered recover(const Recovery& recovery, const MapView& a, std::span<const double> y);

}  // namespace cogslam
