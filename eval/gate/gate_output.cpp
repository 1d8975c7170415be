#include "eval/gate/gate_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/number_text.hpp"
#include "eval/report/markup.hpp"

namespace cogslam {
namespace {

using Json = nlohmann::ordered_json;

std::string percent(double ratio) { return fmt::format("{:+.2f} %", 100.0 * ratio); }

std::string seeds_text(std::uint32_t first, std::size_t count) {
  return fmt::format("{} to {}", first, std::uint64_t{first} + count - 1);
}

std::string heading(const GateResult& result) {
  if (!result.problem.empty()) return result.scenario + ": " + result.problem + "\n";
  std::string text = fmt::format("{}: seeds {} against {} of the baseline, {}\n", result.scenario,
                                 seeds_text(result.seeds.first, static_cast<std::size_t>(result.seeds.count)),
                                 result.baseline_seeds, result.paired ? "paired: the same seeds" : "other seeds");
  for (const std::string& note : result.notes) text += "  note: " + note + "\n";
  return text;
}

std::string row_text(const GateRow& row) {
  std::string text =
      fmt::format("  {:<24}{:<24}", fmt::format("{} {} m", row.variant, number_text(row.cell_size)), row.metric);
  if (row.change) {
    const Change& c = *row.change;
    text += fmt::format("{:>11.4g}{:>11.4g}{:>11}{:>11}{:>11}{:>11}", c.baseline, c.now, percent(c.change),
                        percent(c.at_least), percent(c.resolves), percent(row.limits.effect));
  } else {
    text += fmt::format("{:>11}{:>11}{:>11}{:>11}{:>11}{:>11}", "-", "-", "-", "-", "-", "-");
  }
  text += "  " + name_of(row.verdict);
  if (!row.reason.empty()) text += ": " + row.reason;
  if (row.change && row.change->better) text += ", and better for certain: --update would hold it there";
  return text + "\n";
}

std::string column_names() {
  return fmt::format("  {:<24}{:<24}{:>11}{:>11}{:>11}{:>11}{:>11}{:>11}  verdict\n", "variant", "metric", "baseline",
                     "now", "change", "at least", "resolves", "asked");
}

Json json_of(const GateRow& row) {
  Json json{{"variant", row.variant}, {"cell_size_m", row.cell_size}, {"metric", row.metric}};
  json["verdict"] = name_of(row.verdict);
  json["reason"] = row.reason.empty() ? Json(nullptr) : Json(row.reason);
  json["tolerance"] = row.limits.tolerance;
  json["effect"] = row.limits.effect;
  const auto figure = [&](double Change::*member) { return row.change ? Json((*row.change).*member) : Json(nullptr); };
  json["baseline"] = figure(&Change::baseline);
  json["now"] = figure(&Change::now);
  json["change"] = figure(&Change::change);
  json["at_least"] = figure(&Change::at_least);
  json["resolves"] = figure(&Change::resolves);
  json["p_value"] = figure(&Change::p_value);
  json["better"] = row.change ? Json(row.change->better) : Json(nullptr);
  return json;
}

Json json_of(const GateResult& result) {
  Json json{{"scenario", result.scenario}, {"verdict", name_of(result.verdict())}};
  json["problem"] = result.problem.empty() ? Json(nullptr) : Json(result.problem);
  json["baseline"] = result.baseline_file;
  json["paired"] = result.paired;
  json["first_seed"] = result.seeds.first;
  json["seeds"] = result.seeds.count;
  json["baseline_seeds"] = result.baseline_seeds;
  json["notes"] = result.notes;
  json["figures"] = Json::array();
  for (const GateRow& row : result.rows) json["figures"].push_back(json_of(row));
  return json;
}

/// XML knows no control characters, not even escaped.
std::string xml(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20; }, ' ');
  return markup_text(text);
}

std::string case_text(const GateResult& result, const std::string& of, const std::string& name, Verdict verdict,
                      const std::string& message) {
  std::string text =
      fmt::format("    <testcase classname=\"{}\" name=\"{}\"", xml(result.scenario + "." + of), xml(name));
  if (verdict == Verdict::kPass) return text + "/>\n";
  const bool failed = verdict == Verdict::kFail;
  return text + fmt::format(">\n      <{0} type=\"{1}\" message=\"{2}\"/>\n    </testcase>\n",
                            failed ? "failure" : "error", failed ? "worse" : "not measured", xml(message));
}

std::string message_of(const GateRow& row) {
  if (row.verdict == Verdict::kNotMeasured || !row.change) return row.reason;
  const Change& c = *row.change;
  return fmt::format("{:.4g} -> {:.4g}: {}, at least {}; tolerated {}", c.baseline, c.now, percent(c.change),
                     percent(c.at_least), percent(row.limits.tolerance));
}

std::string suite_text(const GateResult& result) {
  const std::size_t cases = result.problem.empty() ? result.rows.size() : 1;
  std::size_t failures = result.problem.empty() ? 0 : 1, errors = 0;
  std::string text;
  if (!result.problem.empty()) text = case_text(result, "baseline", "comparable", Verdict::kFail, result.problem);
  for (const GateRow& row : result.rows) {
    failures += row.verdict == Verdict::kFail ? 1 : 0;
    errors += row.verdict == Verdict::kNotMeasured ? 1 : 0;
    text += case_text(result, fmt::format("{} {} m", row.variant, number_text(row.cell_size)), row.metric, row.verdict,
                      message_of(row));
  }
  return fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\">\n", xml(result.scenario),
                     cases, failures, errors) +
         text + "  </testsuite>\n";
}

}  // namespace

std::string gate_table(const GateReport& report) {
  std::string text;
  for (const GateResult& result : report.results) {
    text += heading(result);
    if (!result.rows.empty()) text += column_names();
    for (const GateRow& row : result.rows) text += row_text(row);
    text += "\n";
  }
  text += fmt::format("gate {}: {}. {} passed, {} failed, {} not measured.\n", report.gate, name_of(report.verdict()),
                      report.count(Verdict::kPass), report.count(Verdict::kFail), report.count(Verdict::kNotMeasured));
  const auto compared = [](const GateResult& result) { return !result.rows.empty(); };
  if (std::none_of(report.results.begin(), report.results.end(), compared)) return text;
  return text + fmt::format(
                    "Failed: proved worse than tolerated; {} tests share a false alarm rate of {}. Passed: a change of "
                    "`asked` would be found with probability {} or more. Change: of geometric means over seeds; at "
                    "least: lower end of its one-sided interval; resolves: smallest change found so surely.\n",
                    report.tests, report.false_alarm, report.power);
}

std::string gate_json(const GateReport& report) {
  Json json{{"schema", 1}, {"gate", report.gate}, {"program", report.program}};
  json["verdict"] = name_of(report.verdict());
  json["false_alarm"] = report.false_alarm;
  json["tests"] = report.tests;
  json["power"] = report.power;
  json["results"] = Json::array();
  for (const GateResult& result : report.results) json["results"].push_back(json_of(result));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string gate_junit(const GateReport& report) {
  std::string suites;
  for (const GateResult& result : report.results) suites += suite_text(result);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"" + xml("cogslam gate " + report.gate) +
         "\">\n" + suites + "</testsuites>\n";
}

}  // namespace cogslam
