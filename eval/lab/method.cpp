#include "eval/lab/method.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/config.hpp"
#include "core/error.hpp"

namespace cogslam {
namespace {

std::string label_of(const Recovery& recovery) {
  const std::string name(name_of(recovery));
  if (name == "fast_l2") return "l2 (H' y)";
  if (name == "pinv") return "l2 (pinv, SVD)";
  if (name == "nesta") return "CS (NESTA)";
  if (name == "csekf_p_printed") return "CSEKF-p R1 (as printed)";
  if (name == "csekf_p_gradient") return "CSEKF-p R2 (true gradient)";
  if (name == "csekf_p_power") return "CSEKF-p R3 (power sum)";
  return "CSEKF";
}

LabMethod method_of(const Recovery& recovery) {
  return {std::string(name_of(recovery)), label_of(recovery),
          [recovery](const MapView& a, std::span<const double> y) { return recover(recovery, a, y); }};
}

std::vector<LabMethod> make_methods() {
  std::vector<LabMethod> methods;
  for (const std::string_view name : kRecoveryNames) {
    if (name == "tv") continue;  // recovers maps, not coefficients
    Recovery recovery = *recovery_named(name);
    if (name == "pinv") recovery = PseudoInverse{PseudoInverse::Decomposition::kSvd};
    methods.push_back(method_of(recovery));
  }
  return methods;
}

}  // namespace

LabMethod csekf_p_method(KalmanCsP::Reading reading, double p) {
  KalmanCsP solver = KalmanCsP::of(reading);
  solver.p = p;
  return method_of(solver);
}

const std::vector<LabMethod>& lab_methods() {
  static const std::vector<LabMethod> kMethods = make_methods();
  return kMethods;
}

std::size_t index_of_name(const std::string& what, const std::string& name, const std::vector<std::string>& known) {
  const auto found = std::find(known.begin(), known.end(), name);
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  const std::string near = nearest_name(name, known);
  throw InputError(near.empty() ? fmt::format("unknown {} '{}', expected one of {}", what, name, fmt::join(known, ", "))
                                : fmt::format("unknown {} '{}'; did you mean '{}'?", what, name, near));
}

std::vector<LabMethod> lab_methods_named(const std::vector<std::string>& names) {
  if (names.empty()) return lab_methods();
  std::vector<std::string> known;
  for (const LabMethod& m : lab_methods()) known.push_back(m.name);
  std::vector<LabMethod> chosen;
  for (const std::string& name : names) chosen.push_back(lab_methods()[index_of_name("method", name, known)]);
  return chosen;
}

}  // namespace cogslam
