#pragma once

#include <string>
#include <string_view>

namespace cogslam {

/// JSON as the content of a <script>: no '<' is left that could end it. Still the same JSON.
std::string json_in_html(std::string_view json);

/// What every page is made with.
struct PageParts {
  std::string_view style;    ///< CSS
  std::string_view script;   ///< JavaScript; empty: the page is static
  std::string_view notices;  ///< copyright notices of what is bundled in the script
};

/// The parts that were built into the program; without a script where npm was absent (cmake/page.cmake).
PageParts run_page_parts();
PageParts sweep_page_parts();
/// The same without script.
PageParts static_parts();

/// A whole HTML document that asks for nothing from outside, and is forbidden to. `body` is HTML; the script runs after
/// it.
std::string html_document(std::string_view title, std::string_view body, const PageParts& parts);

/// <img> with the picture inside; `alt` and `type` ("image/png") are text.
std::string embedded_image(std::string_view type, std::string_view bytes, std::string_view alt);

}  // namespace cogslam
