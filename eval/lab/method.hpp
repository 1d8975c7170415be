#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "slam/recover/recovery.hpp"

namespace cogslam {

/// A way to bring coefficients back from y = H c, with the parameters of the paper where it states them.
struct LabMethod {
  std::string name;   ///< for the command line and tables
  std::string label;  ///< for plots: says which reading it is
  std::function<Recovered(const MapView&, std::span<const double> y)> recover;
};

/// The recoveries of slam/recover/recovery.hpp by their names there, all but total variation. `pinv` takes singular
/// values, as sec. 4.1 has it; CSEKF-p has p = 0.4.
const std::vector<LabMethod>& lab_methods();

/// Those of these names, in the order asked for; all for an empty list. InputError for an unknown name.
std::vector<LabMethod> lab_methods_named(const std::vector<std::string>& names);

/// CSEKF-p in one reading at any p in (0, 1).
LabMethod csekf_p_method(KalmanCsP::Reading reading, double p);

/// The one of `known` that is called `name`. Else InputError: "unknown `what` 'name'", with the nearest or all names.
std::size_t index_of_name(const std::string& what, const std::string& name, const std::vector<std::string>& known);

}  // namespace cogslam
