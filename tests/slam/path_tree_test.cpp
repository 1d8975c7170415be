#include "slam/path_tree.hpp"

#include <gmock/gmock.h>

#include <set>

#include "core/rng.hpp"

namespace cogslam {
namespace {

std::vector<std::size_t> records_of(const std::vector<RegisteredPose>& path) {
  std::vector<std::size_t> records;
  for (const RegisteredPose& pose : path) {
    records.push_back(pose.record);
    EXPECT_EQ(pose.T_map_base.x, static_cast<double>(pose.record));
  }
  return records;
}

RegisteredPose pose_of(std::size_t record) { return {record, {static_cast<double>(record), 0.0, 0.0}}; }

/// A holder of a node, and its whole path written out: the slow twin.
struct Holder {
  PathTree::Node node = PathTree::kRoot;
  std::vector<std::size_t> path;
};

TEST(PathTree, EqualsFullCopiesOfThePathsOverRandomUse) {
  for (std::uint32_t round = 0; round < 20; ++round) {
    Rng rng({.seed = 44, .purpose = Purpose::kWorld, .entity = round});
    PathTree tree;
    std::vector<Holder> holders(5);
    std::size_t next = 0;
    for (int step = 0; step < 400; ++step) {
      Holder& one = holders[rng.below(5)];
      Holder& other = holders[rng.below(5)];
      switch (rng.below(4)) {
        case 0:  // a particle is drawn into another's slot
          tree.hold(other.node);
          tree.release(one.node);
          one = other;
          break;
        case 1:
          if (rng.below(20) == 0) {
            tree.release(one.node);
            one = {};
          }
          break;
        default: {
          const PathTree::Node leaf = tree.append(one.node, pose_of(next));
          tree.release(one.node);
          one.node = leaf;
          one.path.push_back(next++);
        }
      }
      std::set<std::size_t> alive;
      for (const Holder& holder : holders) alive.insert(holder.path.begin(), holder.path.end());
      ASSERT_EQ(tree.alive(), alive.size());
      ASSERT_EQ(records_of(tree.path_to(one.node)), one.path);
      const std::size_t back = rng.below(12);
      std::vector<std::size_t> shorter = one.path;
      shorter.resize(shorter.size() - std::min(back, shorter.size()));
      ASSERT_EQ(records_of(tree.path_to(tree.ancestor(one.node, static_cast<int>(back)))), shorter);
    }
    for (const Holder& holder : holders) {
      EXPECT_EQ(records_of(tree.path_to(holder.node)), holder.path);
      tree.release(holder.node);
    }
    EXPECT_EQ(tree.alive(), 0);
  }
}

TEST(PathTree, SharesThePast) {
  PathTree tree;
  const PathTree::Node trunk = tree.append(PathTree::kRoot, pose_of(1));
  const PathTree::Node left = tree.append(trunk, pose_of(2)), right = tree.append(trunk, pose_of(3));
  EXPECT_EQ(tree.alive(), 3);
  EXPECT_EQ(tree.ancestor(left, 1), tree.ancestor(right, 1));
  EXPECT_EQ(tree.ancestor(left, 0), left);
  EXPECT_EQ(tree.ancestor(left, 2), PathTree::kRoot);
  EXPECT_EQ(tree.ancestor(left, 99), PathTree::kRoot);
  tree.release(trunk);  // its children still hold it
  EXPECT_EQ(tree.alive(), 3);
  tree.release(left);
  tree.release(right);
  EXPECT_EQ(tree.alive(), 0);
}

TEST(PathTree, MovesTheLastPosesOfOnePathOnly) {
  for (const int steps : {0, 1, 3, 4, 9}) {
    PathTree tree;
    PathTree::Node leaf = PathTree::kRoot;
    for (std::size_t i = 0; i < 4; ++i) {
      const PathTree::Node next = tree.append(leaf, pose_of(i));
      tree.release(leaf);
      leaf = next;
    }
    tree.hold(leaf);  // another particle's
    const Pose2 T{10.0, 1.0, 0.5};
    const PathTree::Node moved = tree.moved(leaf, steps, T);
    const std::vector<RegisteredPose> path = tree.path_to(moved);
    ASSERT_EQ(path.size(), 4);
    for (std::size_t i = 0; i < 4; ++i) {
      const Pose2 old = pose_of(i).T_map_base;
      EXPECT_EQ(path[i].T_map_base, static_cast<int>(4 - i) <= steps ? T * old : old) << i << " of " << steps;
      EXPECT_EQ(path[i].record, i);
    }
    EXPECT_EQ(records_of(tree.path_to(leaf)).size(), 4);  // the other's stays
    EXPECT_EQ(tree.alive(), 4 + std::min(steps, 4));
    tree.release(leaf);
    tree.release(moved);
    EXPECT_EQ(tree.alive(), 0);
  }
}

TEST(PathTree, KnowsTheEmptyPath) {
  PathTree tree;
  tree.hold(PathTree::kRoot);
  tree.release(PathTree::kRoot);
  EXPECT_TRUE(tree.path_to(PathTree::kRoot).empty());
}

TEST(PathTree, UsesDroppedNodesAgain) {
  PathTree tree;
  PathTree::Node leaf = PathTree::kRoot;
  for (std::size_t i = 0; i < 1000; ++i) {
    tree.release(leaf);
    leaf = tree.append(PathTree::kRoot, pose_of(i));
    ASSERT_LE(leaf, 1);
  }
}

}  // namespace
}  // namespace cogslam
