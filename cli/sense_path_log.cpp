#include <fmt/format.h>

#include "cli/exit_codes.hpp"
#include "cli/sense_path.hpp"
#include "core/error.hpp"
#include "eval/sense/path_log_study.hpp"

namespace cogslam {
namespace {

struct LogArguments {
  SenseOptions options;
  std::filesystem::path log, relations;
  LogPathConfig config;
};

int run(const LogArguments& arguments) {
  expect_right(arguments.config.check());
  const CarmenLog log = read_carmen_log(arguments.log);
  const std::vector<Relation> relations = read_relations(arguments.relations);
  const LogPath path = correct_log(log, arguments.log, arguments.config);
  std::vector<Time> stamps;
  for (const Reading& reading : log.readings) stamps.push_back(reading.stamp);
  const RelationErrors odometry = relation_errors(relations, stamps, log.odometry, log.odometry);
  const RelationErrors corrected = relation_errors(relations, stamps, log.odometry, path.poses);
  fmt::print("{}: {} records, {} scans\n{}", arguments.log.filename().string(), log.readings.size(), log.scans,
             log_table(path, odometry, corrected));
  if (corrected.unmatched > 0) {
    fmt::print("{} relations name a stamp that no record has: left out\n", corrected.unmatched);
  }
  return kOk;
}

}  // namespace

Command sense_log_command(CLI::App& sense) {
  auto arguments = std::make_shared<LogArguments>();
  CLI::App* parser = sense.add_subcommand("log", "the path of a CARMEN log, corrected by its partial maps");
  LogPathConfig& config = arguments->config;
  parser->add_option("LOG", arguments->log, "CARMEN log, plain or .gz")->required();
  parser->add_option("--relations", arguments->relations, "score against this SLAM-benchmark file")
      ->type_name("FILE")
      ->required();
  parser->add_option("--samples", config.samples, "K: cells sampled of each partial map")
      ->type_name("K")
      ->capture_default_str();
  parser->add_option("--seed", config.seed, "of the sampled cells")->capture_default_str();
  parser->add_option("--step", config.step_m, "from one partial map to the next [m]")->capture_default_str();
  parser->add_option("--cell-size", config.map.cell_size_m, "[m]")->capture_default_str();
  add_sense_options(*parser, arguments->options);
  return {parser, [arguments] { return run(*arguments); }};
}

}  // namespace cogslam
