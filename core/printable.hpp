#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cogslam {

/// Bytes of the printable UTF-8 character that `text`, which is not empty, begins with; 0 where it begins with none.
std::size_t printable_size(std::string_view text);

/// `text` as a message can show it: bytes that are no printable UTF-8 become "\xNN", and after `longest` bytes it ends
/// with "...". So a binary file neither floods a terminal nor commands it.
std::string printable(std::string_view text, std::size_t longest = 60);

/// The same in single quotes.
std::string in_quotes(std::string_view text, std::size_t longest = 60);

}  // namespace cogslam
