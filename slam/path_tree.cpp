#include "slam/path_tree.hpp"

#include <algorithm>

#include "core/check.hpp"

namespace cogslam {

PathTree::Node PathTree::append(Node parent, const RegisteredPose& pose) {
  hold(parent);
  ++alive_;
  const Entry entry{.pose = pose, .parent = parent, .holders = 1};
  if (free_.empty()) {
    entries_.push_back(entry);
    return static_cast<Node>(entries_.size() - 1);
  }
  const Node node = free_.back();
  free_.pop_back();
  entries_[static_cast<std::size_t>(node)] = entry;
  return node;
}

void PathTree::hold(Node node) {
  if (node != kRoot) ++entries_[static_cast<std::size_t>(node)].holders;
}

void PathTree::release(Node node) {
  while (node != kRoot) {
    Entry& entry = entries_[static_cast<std::size_t>(node)];
    EXPECTS(entry.holders > 0);
    if (--entry.holders > 0) return;
    free_.push_back(node);
    --alive_;
    node = entry.parent;
  }
}

PathTree::Node PathTree::moved(Node leaf, int steps, const Pose2& T) {
  std::vector<RegisteredPose> last;
  Node node = leaf;
  for (; node != kRoot && steps > 0; --steps) {
    last.push_back(pose(node));
    node = ancestor(node, 1);
  }
  hold(node);
  for (; !last.empty(); last.pop_back()) {
    const Node next = append(node, {last.back().record, T * last.back().T_map_base});
    release(node);
    node = next;
  }
  release(leaf);
  return node;
}

std::vector<RegisteredPose> PathTree::path_to(Node node) const {
  std::vector<RegisteredPose> path;
  for (; node != kRoot; node = entries_[static_cast<std::size_t>(node)].parent) {
    path.push_back(entries_[static_cast<std::size_t>(node)].pose);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

PathTree::Node PathTree::ancestor(Node node, int steps) const {
  for (; node != kRoot && steps > 0; --steps) node = entries_[static_cast<std::size_t>(node)].parent;
  return node;
}

}  // namespace cogslam
