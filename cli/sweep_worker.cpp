#include <csignal>
#include <memory>

#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "eval/sweep/worker.hpp"

namespace cogslam {

Command sweep_worker_command(CLI::App& program) {
  auto folder = std::make_shared<std::filesystem::path>();
  auto list = std::make_shared<std::filesystem::path>();
  CLI::App* parser = program.add_subcommand("sweep-worker", "do jobs of a sweep");
  parser->group("");  // started by `sweep`
  parser->add_option("FOLDER", *folder, "of the sweep")->required();
  parser->add_option("--list", *list, "file with jobs; without it they come over standard input");
  return {parser, [folder, list] {
            if (!list->empty()) return do_listed_jobs(*list, {*folder}) == 0 ? kOk : kRunFailed;
            std::signal(SIGINT, SIG_IGN);  // the sweep answers for all
            serve_jobs(0, {*folder});
            return kOk;
          }};
}

}  // namespace cogslam
