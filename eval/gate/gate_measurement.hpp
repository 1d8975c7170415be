#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "eval/episode.hpp"
#include "eval/gate/gate_config.hpp"

namespace cogslam {

/// One metric of one variant over the seeds.
struct GateFigure {
  std::string variant;
  double cell_size = 0.0;  ///< [m]
  std::string metric;
  std::vector<double> values;  ///< one per seed where `missing` is 0; positive and finite
  int missing = 0;             ///< seeds that did not give it
};

/// What a scenario gave over consecutive seeds: now, or once, as a baseline.
struct GateMeasurement {
  std::string program;   ///< "cogslam 0.1.0"
  std::string scenario;  ///< name in the gate
  std::string settings;  ///< Scenario::resolved
  std::string map_hash;  ///< of the map that the world was drawn from; empty without
  std::uint32_t first_seed = 1;
  std::vector<std::string> readings;  ///< a hash for each seed
  std::vector<GateFigure> figures;

  [[nodiscard]] std::size_t seeds() const { return readings.size(); }
  [[nodiscard]] bool has_seed(std::uint64_t seed) const { return seed >= first_seed && seed - first_seed < seeds(); }
  /// Nothing where that figure was not asked for.
  [[nodiscard]] const GateFigure* find(const std::string& variant, double cell_size, const std::string& metric) const;
};

/// Of the map that the world was drawn from; empty where there was none.
std::string hash_of_map(const World& world);

struct GateSeeds {
  std::uint32_t first = 1;
  int count = 0;
};

/// Runs the scenario with each seed, one after the other, and keeps what the demands speak of. The same for any number
/// of threads. `begin` may throw to stop.
GateMeasurement measure(const std::string& name, Scenario scenario, const std::vector<GateDemand>& demands,
                        const GateSeeds& seeds, const std::string& program, Workers& workers,
                        const StageBegin& begin = {});

}  // namespace cogslam
