// Us and MRPT's rbpf-slam (Debian's mrpt-apps) on the same scans of one log: accuracy by the benchmark's relations, CPU
// time and memory of the whole process, as the system counts them for either. Run it by the script bench/slam_peers,
// which finds or installs MRPT.
//
//   bench_slam_peers LOG RELATIONS FOLDER EVERY SEEDS PARTICLES CELL_M SETTINGS
//
// FOLDER takes the files in between. Every EVERY-th scan is kept (0: so many that at most 1800 are left) and all
// odometry; seeds 1 to SEEDS. SETTINGS, with commas between: `grid` and `icp` are MRPT's shipped gridmapping_intel.ini
// and gridmapping_RBPF_ICPbased_intel.ini with our number of particles and, for the grid, our cell size;
// `grid-shipped` and `icp-shipped` keep also those.
//
// Conclusion, every 5th scan of Intel, one seed, 2 virtual cores of an Intel Xeon at 2.6 GHz: `grid` takes 12 times our
// CPU and 29 times our memory; local error 1.6 times ours. Its loops stay open, since MRPT 2.5.8 spaces beams by
// aperture / n in the grid and by aperture / (n - 1) in the points that it matches, so that its map turns with each
// scan: with beams of 1 deg some 0.3 deg. `icp` has no such fault. See docs/results.md, "Beside MRPT".

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "bench/child_process.hpp"
#include "bench/mrpt.hpp"
#include "bench/peer_scores.hpp"
#include "bench/rawlog.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "eval/episode.hpp"
#include "eval/replay_source.hpp"

namespace cogslam::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kEnoughScans = 1800;  // some minutes of rbpf-slam

struct Arguments {
  std::string log, relations;
  fs::path folder;
  std::size_t every;
  int seeds;
  std::string particles, cell_m;
  std::vector<std::string> settings;
};

std::size_t count_scans(const Recording& recording) {
  std::size_t scans = 0;
  for (const Reading& reading : recording.readings) scans += reading.scan.has_value() ? 1 : 0;
  return scans;
}

// --- Child processes of this program. Its parent stays small, since a child's peak begins with its parent's size.

/// Thins the log and writes it for both programs.
int prepare(const std::string& log, const fs::path& folder, std::size_t every) {
  Recording recording = load_log(log, {});
  const std::size_t scans = count_scans(recording);
  if (every == 0) every = std::max<std::size_t>(1, (scans + kEnoughScans - 1) / kEnoughScans);
  std::size_t i = 0;
  for (Reading& reading : recording.readings) {
    if (reading.scan && i++ % every != 0) reading.scan.reset();
  }
  write_recording(folder / "log.recording", recording);
  write_rawlog(folder / "log.rawlog", recording);
  fmt::print("every {}. of {} scans: {} scans, {} records of odometry\n", every, scans, count_scans(recording),
             recording.readings.size());
  return 0;
}

/// Replays the log as `cogslam replay` does, on one thread; prints scans that were registered, bytes and RSS, then one
/// line of poses (online, final) for each record.
int replay(const std::string& file, std::uint32_t seed, const std::string& particles, const std::string& cell_m) {
  ConfigSection section = ConfigSection::parse("", "defaults");
  section.override_value("slam.store.kind", "tiles");
  section.override_value("slam.particles", particles);
  section.override_value("slam.cell_sizes_m", "[" + cell_m + "]");
  const ReplayConfig config = read_replay_config(std::move(section));
  const Recording recording = load_log(file, config.log);
  Workers workers(1);
  const Episode episode = replay_variants("log", recording, {}, config.variants, seed, workers);
  const VariantRun& run = episode.runs.at(0);
  fmt::print("{} {} {}\n", run.record.scores.registered.value(), run.record.scores.bytes.value(),
             run.record.costs.rss_bytes_above_start.value_or(0));
  for (std::size_t i = 0; i < run.final.size(); ++i) {
    const Pose2 &a = run.online[i], &b = run.final[i];
    fmt::print("{} {} {} {} {} {}\n", a.x, a.y, a.theta, b.x, b.y, b.theta);
  }
  return 0;
}

// --- The parent.

/// A child that has ended.
struct Finished {
  ProcessCosts costs;
  fs::path output;  ///< ours: what it printed; MRPT's: its folder
};

Finished run_ours(const Arguments& arguments, int seed) {
  const fs::path printed = arguments.folder / fmt::format("ours_{}.txt", seed);
  const std::string recording = arguments.folder / "log.recording";
  return {run_child({"/proc/self/exe", "ours", recording, std::to_string(seed), arguments.particles, arguments.cell_m},
                    printed),
          printed};
}

Finished run_mrpt(const Arguments& arguments, const std::string& settings, int seed) {
  const bool grid = settings.starts_with("grid");
  const fs::path out = arguments.folder / fmt::format("mrpt_{}_{}", settings, seed), ini = fs::path(out).concat(".ini");
  IniValues known{{"logOutput_dir", out}, {"LOG_FREQUENCY", "0"},           {"SAVE_MAP_IMAGES", "0"},
                  {"SAVE_3D_SCENE", "0"}, {"SHOW_PROGRESS_IN_WINDOW", "0"}, {"verbosity_level", "INFO"}};
  if (!settings.ends_with("-shipped")) {
    known.emplace_back("sampleSize", arguments.particles);
    known.emplace_back("resolution", arguments.cell_m);
  }
  write_settings(kMrptSettings / (grid ? "gridmapping_intel.ini" : "gridmapping_RBPF_ICPbased_intel.ini"), ini, known,
                 {{"RANDOM_SEED", std::to_string(seed)}});
  return {run_child({"rbpf-slam", ini, arguments.folder / "log.rawlog"}, fs::path(out).concat(".txt")), out};
}

/// One program after the other, for every seed; ours first, then one for each of MRPT's settings.
std::vector<std::vector<Finished>> run_all(const Arguments& arguments) {
  std::vector<std::vector<Finished>> runs(1 + arguments.settings.size());
  for (int seed = 1; seed <= arguments.seeds; ++seed) {
    runs[0].push_back(run_ours(arguments, seed));
    fmt::print(stderr, "seed {}: cogslam {:.1f} s of CPU\n", seed, runs[0].back().costs.cpu_s);
    for (std::size_t i = 1; i < runs.size(); ++i) {
      runs[i].push_back(run_mrpt(arguments, arguments.settings[i - 1], seed));
      fmt::print(stderr, "seed {}: MRPT {} {:.1f} s of CPU\n", seed, arguments.settings[i - 1],
                 runs[i].back().costs.cpu_s);
    }
  }
  return runs;
}

int compare(const Arguments& arguments) {
  const fs::path prepared = arguments.folder / "prepare.txt";
  run_child({"/proc/self/exe", "prepare", arguments.log, arguments.folder, std::to_string(arguments.every)}, prepared);
  const std::vector<std::vector<Finished>> runs = run_all(arguments);

  const Judge judge(arguments.folder / "log.recording", arguments.relations);
  const double particles = parse_number(arguments.particles).value_or(0.0);
  std::vector<Column> columns{{"cogslam", particles}};
  for (const Finished& f : runs[0]) columns[0].outcomes.push_back(judge.ours(f.costs, f.output));
  for (std::size_t i = 1; i < runs.size(); ++i) {
    const std::string& settings = arguments.settings[i - 1];
    columns.push_back({"MRPT " + settings, particles_of(settings, particles)});
    for (const Finished& f : runs[i]) columns[i].outcomes.push_back(judge.mrpt(f.costs, f.output));
  }
  fmt::print("{}: {}seeds 1 to {}, {} particles, cells of {} m\n", log_name(arguments.log),
             read_text_file(prepared, 1000), arguments.seeds, arguments.particles, arguments.cell_m);
  print_table(columns, judge);
  return 0;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ',')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

int dispatch(const std::vector<std::string>& words) {
  const auto whole = [&](std::size_t i) { return parse_whole_number(words[i]).value_or(-1); };
  if (words.size() == 4 && words[0] == "prepare")
    return prepare(words[1], words[2], static_cast<std::size_t>(whole(3)));
  if (words.size() == 5 && words[0] == "ours")
    return replay(words[1], static_cast<std::uint32_t>(whole(2)), words[3], words[4]);
  if (words.size() != 8 || whole(3) < 0 || whole(4) < 1 || whole(5) < 1) {
    fmt::print(stderr, "usage: bench_slam_peers LOG RELATIONS FOLDER EVERY SEEDS PARTICLES CELL_M SETTINGS\n");
    return 2;
  }
  return compare({.log = words[0],
                  .relations = words[1],
                  .folder = fs::absolute(words[2]).lexically_normal(),  // "//" begins a comment in settings
                  .every = static_cast<std::size_t>(whole(3)),
                  .seeds = static_cast<int>(whole(4)),
                  .particles = words[5],
                  .cell_m = words[6],
                  .settings = split(words[7])});
}

}  // namespace
}  // namespace cogslam::bench

int main(int argc, char** argv) {
  try {
    return cogslam::bench::dispatch({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
