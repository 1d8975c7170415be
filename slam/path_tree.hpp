#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "slam/registered_pose.hpp"

namespace cogslam {

/// The paths of all particles: they share their past, so it is a tree that grows at its leaves. Branches without a
/// living particle are dropped, and their nodes used again.
class PathTree {
 public:
  using Node = std::int32_t;
  static constexpr Node kRoot = -1;  ///< before the first registered pose

  /// A new leaf after `parent`, held by the caller until `release`; `parent` stays held too.
  Node append(Node parent, const RegisteredPose& pose);
  void hold(Node node);
  void release(Node node);
  /// The path of `leaf` with its last `steps` poses moved, T * pose, as a new leaf that takes over the caller's hold.
  /// A shorter path is moved as a whole. Paths that share those poses keep theirs.
  [[nodiscard]] Node moved(Node leaf, int steps, const Pose2& T);

  /// The path that ends in `node`, oldest pose first.
  [[nodiscard]] std::vector<RegisteredPose> path_to(Node node) const;
  /// Of a node that is not kRoot.
  [[nodiscard]] const RegisteredPose& pose(Node node) const { return entries_[static_cast<std::size_t>(node)].pose; }
  /// The node `steps` poses before, or kRoot where the path is shorter.
  [[nodiscard]] Node ancestor(Node node, int steps) const;
  /// Bytes held, nodes to be used again and spare room included.
  [[nodiscard]] std::int64_t bytes() const {
    return static_cast<std::int64_t>(entries_.capacity() * sizeof(Entry) + free_.capacity() * sizeof(Node));
  }
  /// Nodes of living paths.
  [[nodiscard]] std::size_t alive() const { return alive_; }

 private:
  struct Entry {
    RegisteredPose pose;
    Node parent = kRoot;
    std::int32_t holders = 0;  ///< particles and children
  };

  std::vector<Entry> entries_;
  std::vector<Node> free_;
  std::size_t alive_ = 0;
};

}  // namespace cogslam
