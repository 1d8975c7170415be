#include "eval/page/run_page.hpp"

#include <fmt/format.h>

#include "eval/page/curves.hpp"
#include "eval/page/player_data.hpp"
#include "eval/page/score_tables.hpp"
#include "eval/report/markup.hpp"

namespace cogslam {
namespace {

/// The first filter at its finest cell size; else the first run.
std::size_t first_shown(const std::vector<VariantRun>& runs) {
  std::size_t best = 0;
  for (std::size_t v = 1; v < runs.size(); ++v) {
    const bool filter = !runs[v].online.empty(), best_filter = !runs[best].online.empty();
    const bool finer = runs[v].record.cell_size_m < runs[best].record.cell_size_m;
    if ((filter && !best_filter) || (filter == best_filter && finer)) best = v;
  }
  return best;
}

std::string intro(const RunFiles& files, std::size_t shown) {
  const RunRecord& record = files.episode.record;
  const std::string span = record.simulated_s ? fmt::format("{:.0f} s", *record.simulated_s) : "no time";
  return fmt::format(
      "<header><h1>{}</h1>\n<p class=\"facts\">{}, seed {}, {} of readings, <code>{}</code></p>\n"
      "<p class=\"summary\">{}</p></header>\n",
      markup_text(record.scenario), markup_text(files.recording.source), record.seed, span,
      markup_text(record.readings_hash.value_or("-")), score_summary(record.variants[shown]));
}

std::string curves_section(const RunFiles& files, bool scripted) {
  const std::string heading =
      "<section id=\"curves\" aria-labelledby=\"curves-title\"><h2 id=\"curves-title\">Over time</h2>\n";
  if (scripted) return heading + "<noscript><p>The curves and the replay need JavaScript.</p></noscript></section>\n";
  const std::string svg = curves_svg(files);
  if (svg.empty()) return {};
  return heading +
         "<p>Error of position and heading where the truth is known, effective number of particles (how many share the "
         "weight), and bytes of a particle's map, of the variants at the finest cell size.</p><figure>" +
         embedded_image("image/svg+xml", svg, "Curves over time: errors, effective particles, bytes") +
         "</figure></section>\n";
}

std::string scores_section(const RunRecord& record, std::size_t shown) {
  return "<section id=\"scores\" aria-labelledby=\"scores-title\"><h2 id=\"scores-title\">Scores</h2>\n" +
         headline_table(record) + explained_table(record, shown) +
         "<details id=\"everything\"><summary>Every score of every variant</summary>\n" + all_scores_table(record) +
         "</details></section>\n";
}

std::string figure(const RunRecord& record, const PagePicture& picture) {
  const std::string name = label(record.variants[picture.variant]);
  const std::string alt = (picture.map ? "Map of " : "Paths of ") + name;
  const char* caption = picture.map
                            ? "{}: the map at the end (white free, black occupied, grey unknown), beside the true one "
                              "where it is known"
                            : "{}: true (broad), odometric and estimated (dark) path";
  return fmt::format("<figure data-variant=\"{}\" data-kind=\"{}\">{}<figcaption>{}</figcaption></figure>\n",
                     picture.variant, picture.map ? "map" : "paths", embedded_image("image/png", picture.png, alt),
                     fmt::format(fmt::runtime(caption), markup_text(name)));
}

/// Beside a player the paths of one variant are enough: pictures of paths are large.
bool needed(const PagePicture& picture, bool scripted, std::size_t shown) {
  return picture.map || !scripted || picture.variant == shown;
}

std::string pictures_section(const RunRecord& record, const std::vector<PagePicture>& pictures, bool scripted,
                             std::size_t shown) {
  std::string html =
      "<section id=\"pictures\" aria-labelledby=\"pictures-title\"><h2 id=\"pictures-title\">Pictures</h2>\n"
      "<div class=\"gallery\">\n";
  for (const PagePicture& picture : pictures) {
    if (needed(picture, scripted, shown)) html += figure(record, picture);
  }
  return html + "</div></section>\n";
}

std::string data_scripts(const RunRecord& record, const PlayerData& player) {
  std::string html =
      "<script type=\"application/json\" id=\"record\">" + json_in_html(lasting_json(record)) + "</script>\n";
  if (player.packs.empty()) return html;
  html += "<script type=\"application/json\" id=\"player-data\">" + json_in_html(player.json) + "</script>\n";
  for (std::size_t i = 0; i < player.packs.size(); ++i) {
    html += fmt::format("<script type=\"text/plain\" id=\"pack-{}\">{}</script>\n", i, player.packs[i]);
  }
  return html;
}

std::string about_section(const RunFiles& files, bool scripted) {
  std::string html = fmt::format(
      "<footer id=\"about\"><h2>About this page</h2>\n<p>Made by cogslam out of the files in its folder: "
      "<code>scores.json</code> has all figures, and what the run cost in time and memory, which this page leaves out "
      "so that the same run makes the same page; <code>{}</code> has every setting. The page asks for nothing "
      "from outside and may be sent alone.</p>\n",
      markup_text(files.config_name));
  if (scripted) {
    html +=
        "<p>Curves are drawn with uPlot (MIT licence, &copy; Leon Sorokin); its notice stands in this page's "
        "source.</p>\n";
  } else {
    html += "<p>This is the static page: no replay, no script.</p>\n";
  }
  return html + "</footer>\n";
}

}  // namespace

std::string run_page(const RunFiles& files, const std::vector<PagePicture>& pictures, const PageParts& parts,
                     std::size_t player_bytes_most) {
  const RunRecord& record = files.episode.record;
  const bool scripted = !parts.script.empty();
  std::string body = "<main>\n";
  if (record.variants.empty()) {
    body += fmt::format("<header><h1>{}</h1><p>Nothing was measured: the readings hold no scan.</p></header>\n",
                        markup_text(record.scenario));
    return html_document(record.scenario, body + about_section(files, false) + "</main>\n", {parts.style, {}, {}});
  }
  const std::size_t shown = first_shown(files.episode.runs);
  PlayerData player;
  if (scripted) player = player_data_within(files, player_bytes_most);
  body += intro(files, shown);
  if (scripted) body += fmt::format("<section id=\"player\" data-variant=\"{}\"></section>\n", shown);
  body += curves_section(files, scripted);
  body += scores_section(record, shown) + pictures_section(record, pictures, scripted, shown) +
          about_section(files, scripted) + "</main>\n";
  if (scripted) body += data_scripts(record, player);
  return html_document(record.scenario + " - cogslam", body, parts);
}

}  // namespace cogslam
