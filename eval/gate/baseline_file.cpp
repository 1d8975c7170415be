#include "eval/gate/baseline_file.hpp"

#include <fmt/format.h>

#include <sstream>

#include "core/config_tree.hpp"
#include "core/number_text.hpp"
#include "core/text_file.hpp"

namespace cogslam {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 26;

std::string indented(const std::string& text) {
  std::istringstream lines(text);
  std::string out;
  for (std::string line; std::getline(lines, line);) out += "  " + line + "\n";
  return out;
}

std::string numbers(const std::vector<double>& values) {
  std::string out;
  for (const double v : values) out += (out.empty() ? "" : ", ") + number_text(v);
  return "[" + out + "]";
}

GateFigure read_figure(ConfigSection section, std::size_t seeds) {
  GateFigure figure;
  section.read("variant", figure.variant);
  section.read("cell_size_m", figure.cell_size, kPositive);
  section.read("metric", figure.metric);
  section.read("values", figure.values, kPositive);
  if (figure.values.size() != seeds) {
    section.fail("values",
                 fmt::format("values: expected one for each of {} seeds, found {}", seeds, figure.values.size()));
  }
  return figure;
}

}  // namespace

std::string baseline_text(const GateMeasurement& m) {
  std::string text = "# What `cogslam gate` holds scores against. Made by its option --update, not by hand.\n";
  text += fmt::format("schema: {}\nprogram: {}\nscenario: {}\n", kBaselineSchema, yaml_scalar(m.program),
                      yaml_scalar(m.scenario));
  if (!m.map_hash.empty()) text += "map_hash: \"" + m.map_hash + "\"\n";
  text += fmt::format("first_seed: {}\nreadings: \"{}\"\n", m.first_seed, fmt::join(m.readings, " "));
  std::string figures;
  for (const GateFigure& figure : m.figures) {
    if (figure.missing > 0) continue;
    figures +=
        fmt::format("  - variant: {}\n    cell_size_m: {}\n    metric: {}\n    values: {}\n",
                    yaml_scalar(figure.variant), number_text(figure.cell_size), figure.metric, numbers(figure.values));
  }
  text += figures.empty() ? "figures: []\n" : "figures:\n" + figures;
  return text + "settings: |\n" + indented(m.settings);
}

GateMeasurement read_baseline(const std::string& text, const std::string& name) {
  ConfigSection file = ConfigSection::parse(text, name);
  int schema = 0;
  file.read("schema", schema);
  if (schema != kBaselineSchema) {
    file.fail("schema", fmt::format("schema: expected {}, found {}: make the baseline anew with --update",
                                    kBaselineSchema, schema));
  }
  GateMeasurement m;
  file.read("program", m.program);
  file.read("scenario", m.scenario);
  file.read("map_hash", m.map_hash);
  file.read("first_seed", m.first_seed);
  std::string readings;
  file.read("readings", readings);
  std::istringstream words(readings);
  for (std::string word; words >> word;) m.readings.push_back(word);
  if (m.readings.size() < 2) file.fail("readings", "readings: expected a hash for each of at least two seeds");
  for (const ConfigSection& section : file.sections("figures")) {
    m.figures.push_back(read_figure(section, m.readings.size()));
  }
  file.read("settings", m.settings);
  file.finish();
  return m;
}

std::optional<GateMeasurement> load_baseline(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error) && !error) return std::nullopt;
  return read_baseline(read_text_file(file, kMostBytes), file.string());
}

}  // namespace cogslam
