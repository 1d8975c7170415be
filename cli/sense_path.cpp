#include "cli/sense_path.hpp"

#include "core/error.hpp"

namespace cogslam {

void expect_right(const std::string& wrong) {
  if (!wrong.empty()) throw InputError(wrong);
}

}  // namespace cogslam
