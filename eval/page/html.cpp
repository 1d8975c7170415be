#include "eval/page/html.hpp"

#include <fmt/format.h>

#include "core/check.hpp"
#include "eval/page/built_in.hpp"
#include "eval/page/packed.hpp"
#include "eval/report/markup.hpp"

namespace cogslam {
namespace {

// Nothing may be fetched: a page opened years later, or by somebody else, shows what it showed.
constexpr std::string_view kPolicy =
    "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'";

bool holds(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

}  // namespace

std::string json_in_html(std::string_view json) {
  std::string out;
  for (const char c : json) {
    if (c == '<') {
      out += "\\u003c";  // in JSON it stands in strings only
    } else {
      out += c;
    }
  }
  return out;
}

PageParts run_page_parts() { return {kPageStyle, kRunPageScript, kPageNotices}; }

PageParts sweep_page_parts() { return {kPageStyle, kSweepPageScript, kPageNotices}; }

PageParts static_parts() { return {kPageStyle, {}, {}}; }

std::string html_document(std::string_view title, std::string_view body, const PageParts& parts) {
  EXPECTS(!holds(parts.script, "</script") && !holds(parts.script, "<!--") && !holds(parts.style, "</style"));
  EXPECTS(!holds(parts.notices, "--"));
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{}</title>\n<link rel=\"icon\" href=\"data:,\">\n",
      kPolicy, markup_text(title));
  if (!parts.notices.empty()) page += fmt::format("<!--\n{}\n-->\n", parts.notices);
  page += fmt::format("<style>\n{}</style>\n</head>\n<body>\n{}", parts.style, body);
  if (!parts.script.empty()) page += fmt::format("<script>\n{}</script>\n", parts.script);
  return page + "</body>\n</html>\n";
}

std::string embedded_image(std::string_view type, std::string_view bytes, std::string_view alt) {
  return fmt::format("<img src=\"data:{};base64,{}\" alt=\"{}\">", type, base64(bytes), markup_text(alt));
}

}  // namespace cogslam
