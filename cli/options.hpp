#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "eval/run_folder.hpp"
#include "eval/scenario.hpp"

namespace cogslam {

/// Options that `run` and `replay` share.
struct Options {
  std::optional<std::uint32_t> seed;
  int threads = 0;  ///< filled in with all cores
  std::optional<int> particles;
  std::optional<double> cell_size;     ///< [m]
  std::optional<std::string> store;    ///< as in the file: dense, coefficients, tiles, two_resolution, lattice
  std::optional<double> percent_kept;  ///< of coefficients
  std::vector<std::string> settings;   ///< --set key=value
  std::filesystem::path out = "runs";
  PageKind page = PageKind::kPlayer;
  bool no_files = false;
  bool save_readings = false;
  bool json = false;
  bool quiet = false;
};

void add_options(CLI::App& parser, Options& options);
CLI::Option* add_set_option(CLI::App& parser, Options& options);
void add_threads_option(CLI::App& parser, Options& options);
/// --seed and --set alone: what a scenario can be told without running it.
void add_setting_options(CLI::App& parser, Options& options);

/// What the options say about the configuration in `file` (an empty name: nothing but defaults), in the words of
/// --set; the user's own --set come last and win. A figure that every variant shall have is also set in each variant
/// of the file. Throws InputError for a --set without '='.
Overrides overrides_of(const Options& options, const std::filesystem::path& file);

/// Throws InputError where `out` names a place that cannot be written to, before hours are spent on a run.
void check_out_folder(const std::filesystem::path& out);

/// CLI::Range for figures, but it takes no NaN.
CLI::Validator number_in(double min, double max);

/// The variants that --store leaves. Throws InputError where none is left.
std::vector<VariantConfig> chosen_variants(const Options& options, const std::vector<VariantConfig>& variants);

/// What the page needs to be kept while the filters run: nothing where no page is written.
std::optional<TraceLimits> trace_limits(const Options& options);

/// The options that choose among variants or say what is done, as a comment line for the resolved file; empty where
/// there is nothing to say.
std::string choice_comment(const Options& options);

}  // namespace cogslam
