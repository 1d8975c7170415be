#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "slam/registered_pose.hpp"
#include "slam/stored_pose.hpp"

namespace cogslam {

/// The paths of all particles. They share their past: each pose is kept once for all paths through it, and poses that
/// no path goes through are dropped.
///
/// A generation holds the different poses of one registered scan. Far enough back there is one only, which all paths
/// share: the trunk.
class PathTree {
 public:
  explicit PathTree(std::size_t particles) : leaves_(particles, 0) {}

  /// Every path goes on: one pose for each particle, in the order of their slots. Records are below 2^32.
  void append(std::size_t record, std::span<const StoredPose> T_map_base);
  /// The particle in slot i goes on with the path of the one that was in slot chosen[i].
  void resample(std::span<const std::size_t> chosen);

  /// Poses of each path.
  [[nodiscard]] std::size_t length() const { return trunk_.size() + generations_.size(); }
  /// A particle's path, oldest pose first.
  [[nodiscard]] std::vector<RegisteredPose> path_of(std::size_t slot) const;
  /// How many different poses the paths have `steps` before their last one; `steps` below `length`.
  [[nodiscard]] std::size_t ancestors(std::size_t steps) const;
  /// Poses held, each counted once.
  [[nodiscard]] std::size_t poses() const;
  /// Bytes held, spare room included.
  [[nodiscard]] std::int64_t bytes() const;

 private:
  struct TrunkPose {
    StoredPose T_map_base;
    std::uint32_t record;
  };
  struct Branch {
    StoredPose T_map_base;
    std::uint32_t parent;  ///< its place in the generation before
  };
  struct Generation {
    std::uint32_t record;
    std::vector<Branch> branches;
  };
  void drop_unused();
  void grow_trunk();

  std::vector<TrunkPose> trunk_;
  std::vector<Generation> generations_;
  std::vector<std::uint32_t> leaves_;  ///< of each particle: its place in the last generation
};

}  // namespace cogslam
