#include "eval/page/sweep_page.hpp"

#include <fmt/format.h>

#include <set>

#include "eval/page/sweep_curves.hpp"
#include "eval/page/sweep_tables.hpp"
#include "eval/report/markup.hpp"

namespace cogslam {
namespace {

std::string section(const char* id, const char* title, const std::string& content) {
  return fmt::format("<section id=\"{0}\" aria-labelledby=\"{0}-title\"><h2 id=\"{0}-title\">{1}</h2>\n{2}</section>\n",
                     id, title, content);
}

std::string intro(const SweepPageData& data) {
  std::set<std::string> worlds;
  std::set<double> seeds;
  for (std::size_t row = 0; row < data.table.rows.size(); ++row) {
    worlds.insert(data.table.text(row, "world"));
    seeds.insert(data.table.number(row, "seed").value_or(0.0));
  }
  std::string html = fmt::format(
      "<header><h1>{}</h1>\n<p class=\"facts\">{} of {} planned episodes: {} variants, {} worlds, {} seeds</p>\n",
      markup_text(data.name), data.table.rows.size(), data.planned, data.summary.size(), worlds.size(), seeds.size());
  if (data.table.rows.size() < data.planned) {
    html += "<p class=\"summary\">The sweep is not complete: means are over the seeds that are there.</p>\n";
  }
  return html + "</header>\n";
}

std::string curves(const SweepPageData& data, bool scripted) {
  if (scripted) return "<noscript><p>The curves need JavaScript.</p></noscript>";
  const std::string svg = sweep_curves_svg(data);
  return svg.empty()
             ? std::string("<p>Nothing to draw.</p>")
             : "<figure>" + embedded_image("image/svg+xml", svg, "Errors and bytes by compression") + "</figure>";
}

std::string about(bool scripted) {
  return std::string(
             "<footer id=\"about\"><h2>About this page</h2>\n<p>Made by cogslam out of <code>sweep.sqlite</code> in "
             "its "
             "folder; <code>scores.csv</code>, <code>costs.csv</code> and <code>summary.csv</code> hold the same and "
             "what "
             "it cost in time. The page asks for nothing from outside and may be sent alone, but links lead to files "
             "beside it.</p>\n") +
         (scripted ? "<p>Curves are drawn with uPlot (MIT licence, &copy; Leon Sorokin); its notice stands in this "
                     "page's source.</p>\n"
                   : "<p>This is the static page: no script.</p>\n") +
         "</footer>\n";
}

}  // namespace

std::string sweep_page(const SweepPageData& data, const PageParts& parts) {
  const bool scripted = !parts.script.empty() && !data.table.rows.empty();
  std::string body = "<main>\n" + intro(data);
  if (!data.table.rows.empty()) {
    body += section("curves", "Error and compression", curves(data, scripted)) +
            section("by-variant", "Variants", variants_table(data)) +
            section("by-episode", "Episodes", episodes_table(data));
  }
  body += about(scripted) + "</main>\n";
  if (!scripted) return html_document(data.name + " - cogslam", body, {parts.style, {}, {}});
  body +=
      "<script type=\"application/json\" id=\"sweep-data\">" + json_in_html(sweep_curves_json(data)) + "</script>\n";
  return html_document(data.name + " - cogslam", body, parts);
}

}  // namespace cogslam
