#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cogslam {

/// The finite number that the whole of `text` spells in the C locale ("1.5", "-2e3"), or nothing.
std::optional<double> parse_number(std::string_view text);

/// The whole number that the whole of `text` spells in base ten, or nothing. "3.0" and "1e3" spell none.
std::optional<std::int64_t> parse_whole_number(std::string_view text);

/// The shortest text that reads back as exactly `value`.
std::string number_text(double value);

}  // namespace cogslam
