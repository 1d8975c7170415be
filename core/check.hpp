#pragma once

#include <stdexcept>
#include <string>

namespace cogslam {

/// A promise between our own functions was broken: a defect, never a user's mistake.
class ContractViolation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

[[noreturn]] inline void contract_violated(const char* what, const char* file, int line) {
  throw ContractViolation(std::string(file) + ":" + std::to_string(line) + ": contract violated: " + what);
}

}  // namespace cogslam

/// What a function needs from its caller. Checked in every build: each costs less than what it guards.
#define EXPECTS(condition) \
  ((condition) ? static_cast<void>(0) : ::cogslam::contract_violated(#condition, __FILE__, __LINE__))
/// What a function promises to its caller.
#define ENSURES(condition) EXPECTS(condition)
