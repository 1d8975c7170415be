#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bench/child_process.hpp"
#include "core/line_fields.hpp"
#include "core/output_file.hpp"
#include "core/text_file.hpp"
#include "slam/registered_pose.hpp"

// MRPT's rbpf-slam 2.5.8, Debian's packages mrpt-apps and mrpt-common, as another program sees it.

namespace cogslam::bench {

/// Where mrpt-common keeps the settings that MRPT ships.
inline const std::filesystem::path kMrptSettings = "/usr/share/mrpt/config_files/rbpf-slam";

using IniValues = std::vector<std::pair<std::string, std::string>>;

/// Copies a settings file with some values replaced: `known` where the file has them, `more` put into its first
/// section.
inline void write_settings(const std::filesystem::path& from, const std::filesystem::path& to, const IniValues& known,
                           const IniValues& more) {
  std::string text;
  bool begun = false;
  for (LineReader in(from); in.next();) {
    std::string line(in.line());
    const std::string key = line.substr(0, line.find_first_of(" \t="));
    for (const auto& [name, value] : known) {
      if (name == key) line.assign(name).append(" = ").append(value);
    }
    text += line + "\n";
    if (begun || !line.starts_with('[')) continue;
    begun = true;
    for (const auto& [name, value] : more) text.append(name).append(" = ").append(value).append("\n");
  }
  write_file(to, text);
}

/// What one run of rbpf-slam left behind.
struct MrptRun {
  std::vector<RegisteredPose> online;  ///< the mean of the particles after each scan, at that time
  std::vector<RegisteredPose> final;   ///< the best particle's path at the end, where the filter took a scan
  double rss_growth_bytes = 0.0;       ///< from the first scan to the peak, by its own count after each scan
};

/// Which scans moved the particles, by what rbpf-slam prints; it takes a scan only after some motion.
inline std::vector<std::size_t> filtered_scans(const std::filesystem::path& printed) {
  std::vector<std::size_t> scans;
  std::size_t step = 0;
  for (LineReader in(printed); in.next();) {
    if (in.line().find("New pose=") != std::string_view::npos) scans.push_back(step);
    if (in.line().find("------------- STEP ") != std::string_view::npos) ++step;
  }
  return scans;
}

/// log_estimated_path.txt: one line "step x y z yaw pitch roll stamp" for each scan. `records` are the scans' records.
inline std::vector<RegisteredPose> read_online(const std::filesystem::path& file,
                                               const std::vector<std::size_t>& records) {
  std::vector<RegisteredPose> poses;
  for (LineReader in(file); in.next();) {
    LineFields fields(in.line(), in.place());
    const auto step = static_cast<std::size_t>(fields.whole_number("step", 0));
    if (step != poses.size() || step >= records.size()) fields.fail("step: not the next of the scans that were given");
    const double x = fields.number("x"), y = fields.number("y");
    fields.number("z");
    poses.push_back({records[step], {x, y, fields.number("yaw")}});
  }
  // It ends as if all were well where it cannot read on.
  if (poses.size() != records.size())
    throw std::runtime_error(fmt::format("{}: {} of {} scans", file.string(), poses.size(), records.size()));
  return poses;
}

/// most_likely_path.txt: lines "x y yaw", to 1 mm and 1 mrad; the start, then one for each scan of `filtered`.
inline std::vector<RegisteredPose> read_final(const std::filesystem::path& file,
                                              const std::vector<std::size_t>& records,
                                              const std::vector<std::size_t>& filtered) {
  std::vector<RegisteredPose> poses;
  std::size_t lines = 0;
  for (LineReader in(file); in.next(); ++lines) {
    LineFields fields(in.line(), in.place());
    const double x = fields.number("x"), y = fields.number("y"), yaw = fields.number("yaw");
    if (lines > 0 && lines <= filtered.size()) poses.push_back({records.at(filtered[lines - 1]), {x, y, yaw}});
  }
  if (lines != filtered.size() + 1)
    throw std::runtime_error(
        fmt::format("{}: {} poses, not one for each of {} scans and the start", file.string(), lines, filtered.size()));
  return poses;
}

/// log_MemoryUsage.txt: lines "step bytes".
inline double read_rss_growth(const std::filesystem::path& file) {
  double first = -1.0, peak = 0.0;
  for (LineReader in(file); in.next();) {
    LineFields fields(in.line(), in.place());
    fields.number("step");
    peak = std::max(peak, fields.number("bytes"));
    if (first < 0.0) first = peak;
  }
  return peak - first;
}

/// `folder` is where rbpf-slam wrote, `printed` what it printed, `records` the record of each scan it was given.
inline MrptRun read_mrpt(const std::filesystem::path& folder, const std::filesystem::path& printed,
                         const std::vector<std::size_t>& records) {
  return {.online = read_online(folder / "log_estimated_path.txt", records),
          .final = read_final(folder / "most_likely_path.txt", records, filtered_scans(printed)),
          .rss_growth_bytes = read_rss_growth(folder / "log_MemoryUsage.txt")};
}

}  // namespace cogslam::bench
