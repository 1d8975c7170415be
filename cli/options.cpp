#include "cli/options.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <map>
#include <thread>

#include "eval/variant_run.hpp"

namespace cogslam {
namespace {

std::size_t variants_in(const std::filesystem::path& file) {
  return file.empty() ? 0 : ConfigSection::load(file).sections("variants").size();
}

/// Sets a figure of the filter for all variants, whatever each says of its own.
void set_in_all(const std::string& key, const std::string& value, std::size_t variants, Overrides& overrides) {
  overrides.emplace_back("slam." + key, value);
  for (std::size_t i = 0; i < variants; ++i) overrides.emplace_back(fmt::format("variants.{}.slam.{}", i, key), value);
}

int all_cores() {
  const unsigned cores = std::thread::hardware_concurrency();
  return cores > 0 ? static_cast<int>(cores) : 1;
}

}  // namespace

CLI::Option* add_set_option(CLI::App& parser, Options& options) {
  return parser
      .add_option("--set", options.settings,
                  "key=value: a value in place of the file's, as in --set slam.particles=30;"
                  " may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void add_setting_options(CLI::App& parser, Options& options) {
  parser.add_option("--seed", options.seed, "seed of every random stream, in place of the file's");
  add_set_option(parser, options);
}

void add_threads_option(CLI::App& parser, Options& options) {
  options.threads = all_cores();
  parser.add_option("-j,--threads", options.threads, "threads; the scores do not depend on it")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
}

void add_options(CLI::App& parser, Options& options) {
  add_setting_options(parser, options);
  add_threads_option(parser, options);
  parser.add_option("--particles", options.particles, "particles of every variant")->check(CLI::Range(1, 1000000));
  parser.add_option("--cell-size", options.cell_size, "run at this one cell size [m]")->check(number_in(0.005, 100.0));
  parser
      .add_option("--store", options.store,
                  "run only the variants that keep their maps so; where the file lists none, the store to use")
      ->check(CLI::IsMember({"dense", "coefficients", "tiles", "two_resolution", "lattice"}));
  parser.add_option("--percent", options.percent_kept, "coefficients kept, of 100 per map cell")
      ->check(number_in(1e-6, 100.0));
  parser.add_option("--out", options.out, "folder that the run's folder is put into")
      ->type_name("DIR")
      ->capture_default_str();
  const std::map<std::string, PageKind> pages{
      {"none", PageKind::kNone}, {"static", PageKind::kStatic}, {"player", PageKind::kPlayer}};
  parser.add_option("--page", options.page, "page.html of the run: with a replay, static without script, or none")
      ->transform(CLI::CheckedTransformer(pages).description("none|static|player"))
      ->default_str("player");
  parser.add_flag("--no-files", options.no_files, "write no folder");
  parser.add_flag("--save-readings", options.save_readings, "also save readings.bin and truth.bin, to replay them");
  parser.add_flag("--json", options.json, "print one JSON object (as scores.json) in place of the table");
  parser.add_flag("--quiet", options.quiet, "no progress and no notes");
}

Overrides overrides_of(const Options& options, const std::filesystem::path& file) {
  Overrides overrides;
  const std::size_t variants = variants_in(file);
  if (options.seed) overrides.emplace_back("seed", std::to_string(*options.seed));
  if (options.particles) set_in_all("particles", std::to_string(*options.particles), variants, overrides);
  if (options.percent_kept) {
    set_in_all("store.percent_kept", fmt::format("{}", *options.percent_kept), variants, overrides);
  }
  if (options.cell_size) overrides.emplace_back("slam.cell_sizes_m", fmt::format("[{}]", *options.cell_size));
  if (options.store && variants == 0) overrides.emplace_back("slam.store.kind", *options.store);
  for (const std::string& setting : options.settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw InputError("--set " + setting + ": expected key=value, as in --set slam.particles=30");
    }
    overrides.emplace_back(setting.substr(0, equals), setting.substr(equals + 1));
  }
  return overrides;
}

void check_out_folder(const std::filesystem::path& out) {
  if (out.empty()) throw InputError("--out: expected a folder, found nothing");
  std::error_code error;
  std::filesystem::path at = std::filesystem::absolute(out, error);
  // A link that leads nowhere is there, and no folder can be made in its place.
  const auto missing = [&] { return symlink_status(at, error).type() == std::filesystem::file_type::not_found; };
  while (missing() && at.has_relative_path()) at = at.parent_path();
  const std::string expected = ", expected a folder that can be written to";
  if (!std::filesystem::is_directory(at, error)) {
    throw InputError("--out " + out.string() + ": " + (error ? error.message() : "Not a directory") + expected);
  }
  if (access(at.c_str(), W_OK | X_OK) != 0) {
    throw InputError("--out " + out.string() + ": " + std::strerror(errno) + expected);
  }
}

CLI::Validator number_in(double min, double max) {
  const std::string range = fmt::format("FLOAT in [{} - {}]", min, max);
  return {[=](std::string& text) {
            double value = 0.0;
            if (CLI::detail::lexical_cast(text, value) && value >= min && value <= max) return std::string{};
            return fmt::format("Value {} not in range {} to {}", text, min, max);
          },
          range};
}

std::vector<VariantConfig> chosen_variants(const Options& options, const std::vector<VariantConfig>& variants) {
  std::vector<VariantConfig> chosen;
  for (const VariantConfig& variant : variants) {
    if (!options.store || store_name(variant.slam.store.kind) == *options.store) chosen.push_back(variant);
  }
  if (chosen.empty()) throw InputError("--store " + options.store.value_or("") + ": no variant has this store");
  return chosen;
}

std::optional<TraceLimits> trace_limits(const Options& options) {
  if (options.no_files || options.page == PageKind::kNone) return std::nullopt;
  return TraceLimits{};
}

std::string choice_comment(const Options& options) {
  return options.store ? "# run with --store " + *options.store + "\n" : "";
}

}  // namespace cogslam
