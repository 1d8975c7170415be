// Simulates a moment of a scenario, runs the filter on it and prints what came out: every room of the library is used.
#include <iostream>
#include <string>

#include "eval/episode.hpp"
#include "eval/report/room_picture.hpp"
#include "worlds/map_contours.hpp"
#include "worlds/world_map.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const cogslam::Scenario scenario =
      cogslam::load_scenario(argv[1], {{"duration_s", "2"}, {"slam.particles", "5"}, {"slam.cell_sizes_m", "[0.2]"}});
  const cogslam::Drive drive = cogslam::record_drive(scenario);
  cogslam::Workers workers(1);
  const cogslam::Episode episode = cogslam::replay_variants(scenario.name, drive.recording, {.truth = &drive.truth},
                                                            scenario.variants, scenario.seed, workers, {});
  const cogslam::World again = cogslam::map_contours(cogslam::world_map(scenario.world, 0.1));
  std::cout << scenario.name << ": " << drive.recording.readings.size() << " readings, " << episode.runs.size()
            << " variants, " << again.segments().size() << " surfaces, a picture of "
            << cogslam::room_picture(scenario.world, {}).size() << " bytes\n";
  return episode.runs.empty() ? 1 : 0;
}
