#include "cli/world.hpp"

namespace cogslam {

Command world_command(CLI::App& program) {
  CLI::App* world = program.add_subcommand("world", "the world of a scenario, without driving through it");
  world->require_subcommand(1);
  const Command part = world_export_command(*world);
  return {world, part.run};
}

}  // namespace cogslam
