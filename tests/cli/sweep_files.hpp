#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.hpp"

namespace cogslam {

/// A sweep of a second, beside its scenario: two variants and their twins on four drives.
class ShortSweep {
 public:
  static constexpr int kEpisodes = 16;

  [[nodiscard]] const std::filesystem::path& root() const { return folder_.path(); }
  [[nodiscard]] std::filesystem::path out(const std::string& name) const { return folder_.path() / name; }
  /// The words of the command line for a sweep into `name`.
  [[nodiscard]] std::vector<std::string> words(const std::string& name,
                                               const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"sweep", file_, "--out", out(name), "-j", "2"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  void write_scenario(const std::string& text) const { (void)folder_.file("room.yaml", text); }

  static constexpr const char* kScenario = R"(name: room
duration_s: 5
world: {kind: simple, start: {x_m: 0, y_m: -1.3, heading_deg: 0}}
drive: {waypoints: [{x_m: 1, y_m: -1.3}, {x_m: 1, y_m: 1.3}]}
sensors: {camera: {enabled: false}, lidar: {beams: 361}}
slam: {particles: 20}
)";

 private:
  TemporaryFolder folder_;
  std::string scenario_ = folder_.file("room.yaml", kScenario);
  std::string file_ = folder_.file("sweep.yaml", R"(seeds: {count: 4}
worlds: [{scenario: room.yaml}]
cell_sizes_m: [0.2]
variants:
  - {name: og, slam: {store: {kind: dense}}}
  - {name: cog, slam: {store: {kind: coefficients, percent_kept: 20}}}
)");
};

inline std::string content_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace cogslam
