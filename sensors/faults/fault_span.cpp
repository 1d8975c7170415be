#include "sensors/faults/fault_span.hpp"

namespace cogslam {

FaultSpan read_fault_span(ConfigSection& section) {
  double from_s = 0.0, to_s = 1e6;
  section.read("from_s", from_s, {0.0, 1e6});
  section.read("to_s", to_s, {0.0, 1e6});
  if (from_s >= to_s) section.fail("to_s", "the fault ends before it begins, expected from_s < to_s");
  return {Time::from_seconds(from_s), Time::from_seconds(to_s)};
}

}  // namespace cogslam
