#pragma once

#include "core/config.hpp"
#include "core/time.hpp"

namespace cogslam {

/// When a fault lasts: from <= t < to.
struct FaultSpan {
  Time from{};
  Time to = Time::from_seconds(1e6);

  [[nodiscard]] bool holds(Time t) const { return from <= t && t < to; }
};

/// `from_s`, `to_s`; the whole run where they are left out. InputError where it ends before it begins.
FaultSpan read_fault_span(ConfigSection& section);

}  // namespace cogslam
