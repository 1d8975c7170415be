#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cogslam {

/// Runs of equal floats (equal in every bit): per run 2 bytes of length, at most 65535, and 4 bytes of value.
std::string run_length_encoded(const std::vector<float>& values);
std::vector<float> run_length_decoded(std::string_view bytes);

}  // namespace cogslam
