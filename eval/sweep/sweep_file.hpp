#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "eval/scenario.hpp"
#include "eval/sweep/axis.hpp"

namespace cogslam {

/// A scenario with what a sweep changes in it, and its filter's starting point.
struct SweepWorld {
  std::string name;
  Scenario scenario{};  ///< its own variants play no part
};

/// One filter of a sweep.
struct SweepVariant {
  VariantConfig config{};
  std::string resolved;  ///< its entry of `variants:` in a scenario, every default filled in
};

/// What a sweep file says. Worlds and variants are read one by one, since a variant starts from the filter of a world.
class SweepFile {
 public:
  static SweepFile load(const std::filesystem::path& file);

  std::string name;
  std::vector<std::uint32_t> seeds;
  std::vector<double> cell_sizes;  ///< [m]
  bool true_poses = true;          ///< every variant also maps from the true poses

  /// Every scenario at every combination of its axes. Names are unique.
  [[nodiscard]] std::vector<SweepWorld> worlds() const;
  /// Every variant at every combination of its axes, over the filter of a world; each followed by its twin with true
  /// poses, where wanted. Names are unique. Checks, at last, that the file holds no key that nobody reads.
  [[nodiscard]] std::vector<SweepVariant> variants(const SlamConfig& base) const;

 private:
  [[nodiscard]] ConfigSection parse() const;

  std::string text_;
  std::string file_;
};

}  // namespace cogslam
