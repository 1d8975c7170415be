#include "eval/page/score_tables.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/angle.hpp"
#include "eval/episode.hpp"
#include "eval/page/html.hpp"
#include "eval/page/score_words.hpp"
#include "eval/report/markup.hpp"

namespace cogslam {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kNotMeasured = "<span title=\"not measured\">–</span>";

std::string number_in_text(const Json& value) {
  if (!value.is_number_float()) return value.dump();
  const double number = value.get<double>();
  return std::abs(number) < 1000.0 ? fmt::format("{:.4g}", number) : fmt::format("{:.0f}", number);
}

std::vector<std::string> texts_of(const Json& list) { return list.get<std::vector<std::string>>(); }

/// A mean of squares also as its root, in the unit that people think in.
std::string root_in_html(std::string_view key, const Json& value) {
  if (!value.is_number()) return {};
  const double root = std::sqrt(value.get<double>());
  const auto ends_with = [&](std::string_view end) { return key.size() > end.size() && key.ends_with(end); };
  if (ends_with("_m2")) return fmt::format("<span class=\"part\"><i>root</i> {:.3g} m</span>", root);
  if (ends_with("_rad2")) return fmt::format("<span class=\"part\"><i>root</i> {:.3g}°</span>", degrees(root));
  return {};
}

/// A score as people read it, HTML; nested ones as lines.
std::string value_in_html(const Json& value) {
  if (value.is_null()) return kNotMeasured;
  if (value.is_string()) return "<code>" + markup_text(value.get<std::string>()) + "</code>";
  if (value.is_array())
    return value.empty() ? "none" : markup_text(fmt::format("{}", fmt::join(texts_of(value), ", ")));
  if (!value.is_object()) return number_in_text(value);
  std::string lines;
  for (const auto& [name, part] : value.items()) {
    lines += fmt::format("<span class=\"part\"><i>{}</i> {}</span>", markup_text(name), value_in_html(part));
  }
  return lines;
}

Json scores_of(const RunRecord& record, std::size_t v) {
  return Json::parse(scores_json({.variants = {record.variants[v]}}))[0];
}

std::string score_cell(const Json& scores, std::string_view key, std::size_t variant) {
  const Json& value = scores.at(std::string(key));
  return fmt::format("<td class=\"{}\" data-key=\"{}\" data-variant=\"{}\" data-value=\"{}\">{}{}</td>",
                     value.is_number() || value.is_null() ? "number" : "words", key, variant, markup_text(value.dump()),
                     value_in_html(value), root_in_html(key, value));
}

struct Headline {
  const char* name;
  const char* key;
  const char* derived;  ///< "root", "root_deg", or nothing: the score itself
  int digits;
};

constexpr Headline kHeadlines[] = {
    {"path RMSE [m]", "path_mse_m2", "root", 4},
    {"heading RMSE [deg]", "heading_mse_rad2", "root_deg", 3},
    {"odometry RMSE [m]", "odometry_path_mse_m2", "root", 4},
    {"map error", "grid_mse", "", 4},
    {"map bytes", "payload_bytes", "", 0},
    {"all bytes", "bytes", "", 0},
    {"registered", "registered", "", 0},
    {"resamplings", "resamplings", "", 0},
};

std::string headline_cell(const Json& scores, const Headline& headline, std::size_t variant) {
  const Json& value = scores.at(headline.key);
  std::string text = kNotMeasured, sorted;
  if (!value.is_null()) {
    const double number = value.get<double>();
    const double root = std::string_view(headline.derived).empty() ? number : std::sqrt(number);
    const double shown = std::string_view(headline.derived) == "root_deg" ? degrees(root) : root;
    text = fmt::format("{:.{}f}", shown, headline.digits);
    sorted = fmt::format(" data-sort=\"{}\"", shown);
  }
  const std::string exact = *headline.derived != 0 ? fmt::format("data-derived=\"{}\"", headline.derived)
                                                   : fmt::format("data-value=\"{}\"", markup_text(value.dump()));
  return fmt::format("<td class=\"number\" data-key=\"{}\" data-variant=\"{}\" {}{}>{}</td>", headline.key, variant,
                     exact, sorted, text);
}

std::string kept_as(const VariantRecord& v) {
  std::string text = v.store;
  if (v.recovery) text = fmt::format("{}/{}/{}", v.basis.value_or("-"), v.compressor.value_or("-"), *v.recovery);
  return v.percent_kept ? fmt::format("{}, {} %", text, *v.percent_kept) : text;
}

std::string variant_head(const VariantRecord& v, std::size_t i) {
  return fmt::format("<tr data-variant=\"{}\"><th scope=\"row\">{}</th><td class=\"number\" data-sort=\"{}\">{}</td>",
                     i, markup_text(v.name), v.cell_size_m, v.cell_size_m);
}

std::string percent_of(double part, double whole) { return fmt::format("{:.0f} %", 100.0 * part / whole); }

}  // namespace

std::string headline_table(const RunRecord& record) {
  std::string html =
      "<div class=\"scroll\"><table class=\"sortable\" id=\"headlines\"><caption>A row per variant. Same readings, "
      "same "
      "draws; a dash is a figure that was not measured.</caption><thead><tr><th scope=\"col\">variant</th>"
      "<th scope=\"col\">cell [m]</th><th scope=\"col\">map kept as</th><th scope=\"col\">particles</th>";
  for (const Headline& headline : kHeadlines) html += fmt::format("<th scope=\"col\">{}</th>", headline.name);
  html += "</tr></thead><tbody>\n";
  for (std::size_t i = 0; i < record.variants.size(); ++i) {
    const VariantRecord& v = record.variants[i];
    const Json scores = scores_of(record, i);
    html += variant_head(v, i) +
            fmt::format("<td>{}</td><td class=\"number\">{}</td>", markup_text(kept_as(v)), v.particles);
    for (const Headline& headline : kHeadlines) html += headline_cell(scores, headline, i);
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string all_scores_table(const RunRecord& record) {
  std::string html =
      "<div class=\"scroll\"><table class=\"sortable\" id=\"all-scores\"><caption>Every score, by its name in "
      "<code>scores.json</code>.</caption><thead><tr><th scope=\"col\">variant</th><th scope=\"col\">cell [m]</th>";
  for (const ScoreWords& words : score_words())
    html += fmt::format("<th scope=\"col\"><code>{}</code></th>", words.key);
  html += "</tr></thead><tbody>\n";
  for (std::size_t i = 0; i < record.variants.size(); ++i) {
    const Json scores = scores_of(record, i);
    html += variant_head(record.variants[i], i);
    for (const ScoreWords& words : score_words()) html += score_cell(scores, words.key, i);
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string explained_table(const RunRecord& record, std::size_t shown) {
  const Json scores = scores_of(record, shown);
  std::string html = fmt::format(
      "<div class=\"scroll\"><table id=\"explained\"><caption>Scores of <b "
      "class=\"chosen-name\">{}</b></caption><thead>"
      "<tr><th scope=\"col\">score</th><th scope=\"col\">value</th><th scope=\"col\">what it means</th><th "
      "scope=\"col\">"
      "what is good</th></tr></thead><tbody>\n",
      markup_text(label(record.variants[shown])));
  for (const ScoreWords& words : score_words()) {
    const std::string unit = words.unit.empty() ? "" : fmt::format(" <span class=\"unit\">[{}]</span>", words.unit);
    html += fmt::format("<tr><th scope=\"row\">{}{}</th>{}<td>{}</td><td>{}</td></tr>\n", words.name, unit,
                        score_cell(scores, words.key, shown), words.meaning, words.good);
  }
  return html + "</tbody></table></div>\n";
}

std::string score_summary(const VariantRecord& v) {
  const Scores& s = v.scores;
  std::string text = fmt::format("<b>{}</b>", markup_text(label(v)));
  if (s.path_mse_m2) {
    text += fmt::format(" was {:.1f} cm from the true position (RMSE)", 100.0 * std::sqrt(*s.path_mse_m2));
    if (s.heading_mse_rad2)
      text += fmt::format(" and {:.2f}° from the true heading", degrees(std::sqrt(*s.heading_mse_rad2)));
    if (s.odometry_path_mse_m2) {
      text += fmt::format("; odometry alone was {:.1f} cm off", 100.0 * std::sqrt(*s.odometry_path_mse_m2));
    }
  } else if (s.relations_final && s.relations_final->all.count > 0) {
    text += fmt::format(" missed the benchmark's relations by {:.3f} m on average", s.relations_final->all.trans_mean);
  } else {
    text += " has no true path to be held against";
  }
  text += ".";
  if (s.grid_confusion) {
    const auto& n = *s.grid_confusion;
    const auto sum = [&](std::size_t t) { return static_cast<double>(n[t][0] + n[t][1] + n[t][2]); };
    if (sum(0) > 0.0 && sum(1) > 0.0) {
      text += fmt::format(" Its map calls {} of the free cells free and {} of the occupied ones occupied.",
                          percent_of(static_cast<double>(n[0][0]), sum(0)),
                          percent_of(static_cast<double>(n[1][2]), sum(1)));
    }
  }
  if (s.payload_bytes) text += fmt::format(" A particle's map took {:.0f} bytes on average.", *s.payload_bytes);
  return text;
}

}  // namespace cogslam
