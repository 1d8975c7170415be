#include <fmt/format.h>

#include <memory>

#include "cli/exit_codes.hpp"
#include "cli/options.hpp"
#include "cli/world.hpp"
#include "core/error.hpp"
#include "core/output_file.hpp"
#include "eval/report/world_svg.hpp"
#include "worlds/map_file.hpp"
#include "worlds/world_map.hpp"

namespace cogslam {
namespace {

constexpr double kMostCells = 1 << 24;

struct ExportArguments {
  Options options;
  std::filesystem::path scenario;
  std::filesystem::path svg, map;
  double scale = 50.0;
  double cell_size = 0.05;
};

void export_map(const World& world, const ExportArguments& arguments) {
  const Eigen::Vector2d size = world.bounds().max - world.bounds().min;
  if (size.prod() / (arguments.cell_size * arguments.cell_size) > kMostCells) {
    throw InputError(fmt::format("--cell-size {}: the map would have more than {} cells", arguments.cell_size,
                                 static_cast<int>(kMostCells)));
  }
  std::filesystem::path image = arguments.map;
  image.replace_extension(".pgm");
  // A world that is a map already keeps its own cells where it is asked for their size.
  const auto own = world.map && world.map->resolution == arguments.cell_size ? world.map->frame() : std::nullopt;
  const OccupancyMap map = own ? world_map(world, *own) : world_map(world, arguments.cell_size);
  write_file(image, map_pgm_bytes(map));
  write_file(arguments.map, map_yaml_text(map, image.filename().string()));
}

int run(const ExportArguments& arguments) {
  if (arguments.svg.empty() && arguments.map.empty()) {
    throw InputError("nothing to export, expected --svg FILE or --map FILE");
  }
  if (!arguments.map.empty() && arguments.map.extension() != ".yaml") {
    throw InputError("--map " + arguments.map.string() + ": expected a name that ends with .yaml");
  }
  const Scenario scenario = load_scenario(arguments.scenario, overrides_of(arguments.options, arguments.scenario));
  if (!arguments.svg.empty()) write_file(arguments.svg, world_svg(scenario.world, scenario.name, arguments.scale));
  if (!arguments.map.empty()) export_map(scenario.world, arguments);
  return kOk;
}

}  // namespace

Command world_export_command(CLI::App& world) {
  auto arguments = std::make_shared<ExportArguments>();
  CLI::App* parser = world.add_subcommand("export", "draw a world to scale, or write it as a map for ROS");
  parser->add_option("SCENARIO", arguments->scenario, "scenario file (YAML)")->required();
  parser->add_option("--svg", arguments->svg, "draw it into this file, to scale")->type_name("FILE");
  parser->add_option("--scale", arguments->scale, "of the drawing: 50 is 1:50, a metre becomes 20 mm")
      ->check(CLI::Range(1.0, 10000.0))
      ->capture_default_str();
  parser->add_option("--map", arguments->map, "write a map_server map: FILE.yaml and FILE.pgm")->type_name("FILE");
  parser->add_option("--cell-size", arguments->cell_size, "of the map [m]")
      ->check(CLI::Range(0.005, 100.0))
      ->capture_default_str();
  add_setting_options(*parser, arguments->options);
  return {parser, [arguments] { return run(*arguments); }};
}

}  // namespace cogslam
