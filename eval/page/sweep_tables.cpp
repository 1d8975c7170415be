#include "eval/page/sweep_tables.hpp"

#include <fmt/format.h>

#include <array>

#include "core/number_text.hpp"
#include "eval/report/markup.hpp"

namespace cogslam {
namespace {

struct Shown {
  const char* figure;
  const char* title;
};

constexpr std::array kShown{Shown{"path_mse_m2", "path error [m²]"}, Shown{"heading_mse_rad2", "heading error [rad²]"},
                            Shown{"grid_mse", "map error"}, Shown{"payload_bytes", "map bytes"},
                            Shown{"bytes", "all bytes"}};

constexpr const char* kNotMeasured = "<td class=\"number\"><span title=\"not measured\">–</span></td>";

std::string head(std::string_view text) { return fmt::format("<th scope=\"col\">{}</th>", text); }

std::string exact_cell(const std::string& key, double value, const std::string& text) {
  return fmt::format("<td class=\"number\" data-key=\"{}\" data-value=\"{}\">{}</td>", key, number_text(value), text);
}

std::string interval_cell(const std::string& key, const MeanInterval& interval) {
  std::string text = fmt::format("{:.4g}", interval.mean);
  if (interval.count > 1) text += fmt::format("<span class=\"part\"><i>±</i> {:.2g}</span>", interval.half_width);
  return exact_cell(key, interval.mean, text);
}

std::string figure_cells(const VariantSummary& variant, const Shown& shown) {
  const FigureSummary* figure = variant.find(shown.figure);
  std::string html = figure == nullptr ? kNotMeasured : interval_cell(shown.figure, figure->mean);
  const bool paired = figure != nullptr && figure->against_baseline.has_value();
  return html + (paired ? interval_cell(std::string(shown.figure) + " - baseline", figure->against_baseline->difference)
                        : kNotMeasured);
}

std::string number_cell(const EpisodeTable& table, std::size_t row, const std::string& column) {
  const auto value = table.number(row, column);
  return value ? exact_cell(column, *value, fmt::format("{:.4g}", *value)) : kNotMeasured;
}

std::string link(const std::string& file, const char* text) {
  return fmt::format("<a href=\"{}\">{}</a> ", markup_text(file), text);
}

std::string files_cell(const SweepPageData& data, std::size_t row) {
  const std::string episode = "episodes/" + data.table.text(row, "key");
  const std::string readings = "readings/" + data.table.text(row, "readings_key");
  std::string html = "<td>";
  if (data.pages.contains(data.table.text(row, "key"))) html += link(episode + ".html", "page");
  html += link(episode + ".yaml", "scenario") + link(episode + ".json", "scores") + link(episode + ".log", "log");
  return html + fmt::format(
                    "<details class=\"command\"><summary>replay</summary><code>cogslam replay {0}.bin --truth "
                    "{0}.truth.bin --scenario {1}.yaml</code></details></td>",
                    markup_text(readings), markup_text(episode));
}

}  // namespace

std::string variants_table(const SweepPageData& data) {
  std::string html =
      "<div class=\"scroll\"><table class=\"sortable\" id=\"variants\"><caption>A row per variant: mean over n seeds "
      "with its 95 % interval (Student's t), and the mean difference to the baseline on the same "
      "readings.</caption><thead><tr>";
  for (const char* title : {"variant", "world", "cell [m]", "n", "baseline"}) html += head(title);
  for (const Shown& shown : kShown) html += head(shown.title) + head("− baseline");
  html += "</tr></thead><tbody>\n";
  for (const VariantSummary& variant : data.summary) {
    html += fmt::format(
        "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td>"
        "<td>{}</td>",
        markup_text(variant.variant), markup_text(variant.world), number_text(variant.cell_size), variant.count,
        variant.baseline.empty() ? "–" : markup_text(variant.baseline));
    for (const Shown& shown : kShown) html += figure_cells(variant, shown);
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string episodes_table(const SweepPageData& data) {
  const std::size_t listed = std::min(data.table.rows.size(), kEpisodesListed);
  std::string html = fmt::format(
      "<div class=\"scroll\"><table class=\"sortable\" id=\"episodes\"><caption>{} of {} episodes. Commands are to be "
      "given in this page's folder.</caption><thead><tr>",
      listed, data.table.rows.size());
  for (const char* title : {"variant", "world", "cell [m]", "seed"}) html += head(title);
  for (const Shown& shown : kShown) html += head(shown.title);
  html += head("files") + "</tr></thead><tbody>\n";
  for (std::size_t row = 0; row < listed; ++row) {
    html += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td>", markup_text(data.table.text(row, "variant")),
                        markup_text(data.table.text(row, "world")));
    html += number_cell(data.table, row, "cell_size_m") + number_cell(data.table, row, "seed");
    for (const Shown& shown : kShown) html += number_cell(data.table, row, shown.figure);
    html += files_cell(data, row) + "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace cogslam
