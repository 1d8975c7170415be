#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/child_process.hpp"
#include "bench/mrpt.hpp"
#include "core/angle.hpp"
#include "core/line_fields.hpp"
#include "core/text_file.hpp"
#include "eval/metrics/path_completion.hpp"
#include "eval/metrics/relations.hpp"
#include "eval/replay_source.hpp"
#include "eval/variant_run.hpp"

namespace cogslam::bench {

/// What one program did with the log once.
struct Outcome {
  RelationErrors online, final;
  ProcessCosts process;
  double filtered = 0.0;        ///< scans that moved the particles
  double rss_growth = 0.0;      ///< [bytes], from before the first scan (MRPT: after it) to the peak
  std::optional<double> bytes;  ///< per particle, all-in, mean; nothing where the program does not tell
};

/// Scores paths of the thinned log, the same way for both programs.
class Judge {
 public:
  Judge(const std::filesystem::path& log, const std::filesystem::path& relations)
      : recording_(load_log(log, {})), odometry_(odometry_path(recording_)), relations_(read_relations(relations)) {
    for (std::size_t i = 0; i < recording_.readings.size(); ++i) {
      stamps_.push_back(recording_.readings[i].stamp);
      if (recording_.readings[i].scan) scans_.push_back(i);
    }
  }

  [[nodiscard]] std::size_t scans() const { return scans_.size(); }
  [[nodiscard]] RelationErrors odometry() const { return score(odometry_); }

  [[nodiscard]] Outcome ours(const ProcessCosts& process, const std::filesystem::path& printed) const {
    Outcome outcome{.process = process};
    LineReader in(printed);
    in.next();
    LineFields figures(in.line(), in.place());
    outcome.filtered = figures.number("registered");
    outcome.bytes = figures.number("bytes");
    outcome.rss_growth = figures.number("rss");
    std::vector<Pose2> online, final;
    while (in.next()) {
      LineFields fields(in.line(), in.place());
      for (std::vector<Pose2>* path : {&online, &final}) {
        const double x = fields.number("x"), y = fields.number("y");
        path->push_back({x, y, fields.number("theta")});
      }
    }
    outcome.online = score(online);
    outcome.final = score(final);
    return outcome;
  }

  [[nodiscard]] Outcome mrpt(const ProcessCosts& process, const std::filesystem::path& folder) const {
    const MrptRun run = read_mrpt(folder, std::filesystem::path(folder).concat(".txt"), scans_);
    return {.online = score(complete_path(odometry_, run.online)),
            .final = score(complete_path(odometry_, run.final)),
            .process = process,
            .filtered = static_cast<double>(run.final.size()),
            .rss_growth = run.rss_growth_bytes,
            .bytes = std::nullopt};
  }

 private:
  [[nodiscard]] RelationErrors score(std::span<const Pose2> path) const {
    return relation_errors(relations_, stamps_, odometry_, path);
  }

  Recording recording_;
  std::vector<Pose2> odometry_;
  std::vector<Relation> relations_;
  std::vector<Time> stamps_;
  std::vector<std::size_t> scans_;
};

/// A line of the table; where there are no global relations theirs mean nothing.
struct Row {
  const char* name;
  int digits;
  double (*figure)(const Outcome&, double particles, double scans);
};

inline const Row kRows[] = {
    {"local [m]", 4, [](const Outcome& o, double, double) { return o.final.local.trans_mean; }},
    {"local [deg]", 3, [](const Outcome& o, double, double) { return degrees(o.final.local.rot_mean); }},
    {"global [m]", 4, [](const Outcome& o, double, double) { return o.final.global.trans_mean; }},
    {"global [deg]", 3, [](const Outcome& o, double, double) { return degrees(o.final.global.rot_mean); }},
    {"online: local [m]", 4, [](const Outcome& o, double, double) { return o.online.local.trans_mean; }},
    {"online: global [m]", 4, [](const Outcome& o, double, double) { return o.online.global.trans_mean; }},
    {"scans that moved particles", 0, [](const Outcome& o, double, double) { return o.filtered; }},
    {"CPU [s]", 2, [](const Outcome& o, double, double) { return o.process.cpu_s; }},
    {"CPU ms per scan of the log", 2, [](const Outcome& o, double, double n) { return 1e3 * o.process.cpu_s / n; }},
    {"CPU ms per scan so used", 2, [](const Outcome& o, double, double) { return 1e3 * o.process.cpu_s / o.filtered; }},
    {"peak RSS [MB]", 1, [](const Outcome& o, double, double) { return 1e-6 * o.process.peak_rss_bytes; }},
    {"RSS growth [MB]", 1, [](const Outcome& o, double, double) { return 1e-6 * o.rss_growth; }},
    {"RSS growth [kB / particle]", 0, [](const Outcome& o, double n, double) { return 1e-3 * o.rss_growth / n; }},
};

/// The particles of a column: those of the shipped files where they are kept.
inline double particles_of(const std::string& settings, double ours) {
  return !settings.ends_with("-shipped") ? ours : settings.starts_with("grid") ? 20.0 : 10.0;
}

/// One program under one setting, over the seeds.
struct Column {
  std::string name;
  double particles;
  std::vector<Outcome> outcomes{};

  [[nodiscard]] double mean(const Row& row, std::size_t scans) const {
    double sum = 0.0;
    for (const Outcome& o : outcomes) sum += row.figure(o, particles, static_cast<double>(scans));
    return sum / static_cast<double>(outcomes.size());
  }
};

inline void print_table(const std::vector<Column>& columns, const Judge& judge) {
  const RelationErrors odometry = judge.odometry();
  fmt::print("{} local and {} global relations, {} without a record; odometry alone: local {:.4f} m, global {:.4f} m\n",
             odometry.local.count, odometry.global.count, odometry.unmatched, odometry.local.trans_mean,
             odometry.global.trans_mean);
  fmt::print("\n{:28}", "mean over the seeds");
  for (const Column& column : columns)
    fmt::print("{:>14}{}", column.name, &column == columns.data() ? "" : "   / ours");
  fmt::print("\n");
  for (const Row& row : kRows) {
    fmt::print("{:28}", row.name);
    const double ours = columns.front().mean(row, judge.scans());
    for (const Column& column : columns) {
      const double figure = column.mean(row, judge.scans());
      fmt::print("{:14.{}f}", figure, row.digits);
      if (&column != columns.data()) fmt::print("{:>9}", ours > 0.0 ? fmt::format("{:.2f}", figure / ours) : "-");
    }
    fmt::print("\n");
  }
  double bytes = 0.0;
  for (const Outcome& o : columns.front().outcomes) bytes += o.bytes.value();
  fmt::print("{:28}{:14.0f}  (MRPT does not tell: not measured)\n", "map bytes per particle",
             bytes / static_cast<double>(columns.front().outcomes.size()));
}

}  // namespace cogslam::bench
