#pragma once

#include <string>

#include "core/error.hpp"

namespace cogslam {

/// The text of the InputError that `action` throws; "no error" where it throws none.
template <class Action>
std::string error_text(Action&& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace cogslam
