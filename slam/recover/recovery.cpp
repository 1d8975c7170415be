#include "slam/recover/recovery.hpp"

#include "core/error.hpp"

namespace cogslam {
namespace {

using Why = std::optional<std::string>;
using Reading = KalmanCsP::Reading;

constexpr std::size_t kMostMatrixEntries = std::size_t{1} << 24;  // 128 MB of doubles
constexpr std::size_t kMostCovarianceColumns = 4096;              // likewise

Why ask_orthonormal(const MapView& a, const char* recovery) {
  if (a.orthonormal_rows()) return std::nullopt;
  return std::string(recovery) + " needs a measurement matrix with orthonormal rows, which this one has not; use pinv";
}

Why ask_small(const MapView& a) {
  if (a.cols() <= kMostCovarianceColumns) return std::nullopt;
  return "the Kalman recoveries keep an n x n covariance and take at most n = " +
         std::to_string(kMostCovarianceColumns) + ", here n = " + std::to_string(a.cols());
}

Why why(const PseudoInverse& /*any*/, const MapView& a) {
  if (a.rows() * a.cols() <= kMostMatrixEntries) return std::nullopt;
  return "pinv stores the m x n matrix and takes at most m n = " + std::to_string(kMostMatrixEntries) +
         ", here m = " + std::to_string(a.rows()) + ", n = " + std::to_string(a.cols());
}
Why why(const FastL2& /*any*/, const MapView& a) { return ask_orthonormal(a, "fast_l2"); }
Why why(const Nesta& /*any*/, const MapView& a) { return ask_orthonormal(a, "nesta"); }
Why why(const KalmanCs& /*any*/, const MapView& a) { return ask_small(a); }
Why why(const KalmanCsP& /*any*/, const MapView& a) { return ask_small(a); }
Why why(const TotalVariation& tv, const MapView& a) {
  if (!a.is_selection()) return "tv recovers a map from some of its cells; this matrix mixes cells";
  if (!a.orthonormal_rows()) return "tv takes each known cell once; this selection repeats a cell";
  if (a.rows() == 0) return "tv needs at least one known cell";
  if (tv.width * tv.height == a.cols() && tv.width > 0) return std::nullopt;
  return "tv is set up for a map of " + std::to_string(tv.width) + " x " + std::to_string(tv.height) +
         " cells, but the matrix has " + std::to_string(a.cols()) + " columns";
}

std::string_view name(const PseudoInverse& /*any*/) { return "pinv"; }
std::string_view name(const FastL2& /*any*/) { return "fast_l2"; }
std::string_view name(const Nesta& /*any*/) { return "nesta"; }
std::string_view name(const KalmanCs& /*any*/) { return "csekf"; }
std::string_view name(const KalmanCsP& csekf_p) {
  switch (csekf_p.reading) {
    case Reading::kAsPrinted:
      return "csekf_p_printed";
    case Reading::kTrueGradient:
      return "csekf_p_gradient";
    case Reading::kPowerSum:
      return "csekf_p_power";
  }
  return "csekf_p";
}
std::string_view name(const TotalVariation& /*any*/) { return "tv"; }

}  // namespace

std::optional<Recovery> recovery_named(std::string_view wanted) {
  const std::array<Recovery, kRecoveryNames.size()> all = {PseudoInverse{},
                                                           FastL2{},
                                                           Nesta{},
                                                           KalmanCs{},
                                                           KalmanCsP::of(Reading::kAsPrinted),
                                                           KalmanCsP::of(Reading::kTrueGradient),
                                                           KalmanCsP::of(Reading::kPowerSum),
                                                           TotalVariation{}};
  for (const Recovery& recovery : all) {
    if (name_of(recovery) == wanted) return recovery;
  }
  return std::nullopt;
}

std::string_view name_of(const Recovery& recovery) {
  return std::visit([](const auto& r) { return name(r); }, recovery);
}

std::optional<std::string> why_not(const Recovery& recovery, const MapView& a) {
  return std::visit([&](const auto& r) { return why(r, a); }, recovery);
}

Recovered recover(const Recovery& recovery, const MapView& a, std::span<const double> y) {
  if (const auto reason = why_not(recovery, a)) throw InputError(*reason);
  return std::visit([&](const auto& r) { return recover(r, a, y); }, recovery);
}

}  // namespace cogslam
