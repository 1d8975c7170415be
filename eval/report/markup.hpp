#pragma once

#include <string>
#include <string_view>

namespace cogslam {

/// Text as it stands in HTML, SVG and XML, also within quotes.
std::string markup_text(std::string_view text);

}  // namespace cogslam
