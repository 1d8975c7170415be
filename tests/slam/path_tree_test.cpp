#include "slam/path_tree.hpp"

#include <gmock/gmock.h>

#include <set>

#include "core/rng.hpp"
#include "slam/waiting_poses.hpp"

namespace cogslam {
namespace {

using Path = std::vector<RegisteredPose>;

bool same(const Path& a, const Path& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const RegisteredPose& p, const RegisteredPose& q) {
    return p.record == q.record && p.T_map_base == q.T_map_base;
  });
}

/// The slow twin: every path written out. All poses that are appended differ.
struct FullPaths {
  std::vector<Path> paths;

  void resample(const std::vector<std::size_t>& chosen) {
    std::vector<Path> next;
    for (const std::size_t slot : chosen) next.push_back(paths[slot]);
    paths = std::move(next);
  }
  [[nodiscard]] std::size_t different(std::size_t steps) const {
    std::set<double> poses;
    for (const Path& path : paths) poses.insert(path[path.size() - 1 - steps].T_map_base.x);
    return poses.size();
  }
};

std::vector<StoredPose> next_poses(std::size_t particles, std::size_t& appended) {
  std::vector<StoredPose> poses;
  for (std::size_t i = 0; i < particles; ++i) poses.emplace_back(Pose2{static_cast<double>(appended++), 0.5, -0.25});
  return poses;
}

std::vector<std::size_t> drawn_slots(std::size_t particles, Rng& rng) {
  std::vector<std::size_t> slots;
  for (std::size_t i = 0; i < particles; ++i) slots.push_back(rng.below(static_cast<std::uint32_t>(particles)));
  return slots;
}

void expect_equal(const PathTree& tree, const FullPaths& twin) {
  ASSERT_EQ(tree.length(), twin.paths[0].size());
  std::size_t poses = 0;
  for (std::size_t back = 0; back < tree.length(); ++back) {
    ASSERT_EQ(tree.ancestors(back), twin.different(back)) << back << " of " << tree.length();
    poses += twin.different(back);
  }
  ASSERT_EQ(tree.poses(), poses);
  for (std::size_t i = 0; i < twin.paths.size(); ++i) ASSERT_TRUE(same(tree.path_of(i), twin.paths[i])) << "slot " << i;
}

TEST(PathTree, EqualsFullCopiesOfThePathsOverRandomUse) {
  for (std::uint32_t round = 0; round < 20; ++round) {
    Rng rng({.seed = 44, .purpose = Purpose::kWorld, .entity = round});
    const std::size_t particles = 1 + rng.below(7);
    PathTree tree(particles);
    FullPaths twin{std::vector<Path>(particles)};
    std::size_t appended = 0;
    for (std::size_t step = 0; step < 200; ++step) {
      if (rng.below(3) == 0) {
        const std::vector<std::size_t> chosen = drawn_slots(particles, rng);
        tree.resample(chosen);
        twin.resample(chosen);
      } else {
        const std::vector<StoredPose> poses = next_poses(particles, appended);
        tree.append(3 * step, poses);
        for (std::size_t i = 0; i < particles; ++i) twin.paths[i].push_back({3 * step, poses[i].pose()});
      }
      ASSERT_NO_FATAL_FAILURE(expect_equal(tree, twin)) << "step " << step << " of round " << round;
    }
  }
}

TEST(PathTree, SharesThePast) {
  PathTree tree(3);
  std::size_t appended = 0;
  tree.append(7, next_poses(3, appended));
  tree.resample(std::vector<std::size_t>{1, 1, 1});
  EXPECT_EQ(tree.poses(), 1);
  tree.append(8, next_poses(3, appended));
  EXPECT_EQ(tree.poses(), 4);
  EXPECT_EQ(tree.ancestors(0), 3);
  EXPECT_EQ(tree.ancestors(1), 1);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(tree.path_of(i)[0].T_map_base, (Pose2{1.0, 0.5, -0.25}));
    EXPECT_EQ(tree.path_of(i)[0].record, 7);
  }
}

TEST(PathTree, KnowsTheEmptyPath) {
  PathTree tree(2);
  tree.resample(std::vector<std::size_t>{1, 0});
  EXPECT_EQ(tree.length(), 0);
  EXPECT_TRUE(tree.path_of(1).empty());
}

/// Where all particles go on from one of them at every step, a pose takes its own 16 bytes and little more.
TEST(PathTree, ReturnsTheMemoryOfDroppedPaths) {
  PathTree tree(50);
  std::size_t appended = 0;
  for (std::size_t step = 0; step < 4000; ++step) {
    tree.append(step, next_poses(50, appended));
    tree.resample(std::vector<std::size_t>(50, step % 50));
    ASSERT_EQ(tree.poses(), step + 1);
  }
  EXPECT_GT(tree.bytes(), 4000 * 16);
  EXPECT_LT(tree.bytes(), 4000 * 16 * 9 / 8 + 2000);
}

void expect_near(const Pose2& a, const Pose2& b) {
  EXPECT_NEAR(a.x, b.x, 1e-4);
  EXPECT_NEAR(a.y, b.y, 1e-4);
  EXPECT_NEAR(wrap_angle(a.theta - b.theta), 0.0, 1e-5);
}

TEST(WaitingPoses, EqualAQueueOfMovedPoses) {
  Rng rng({.seed = 45, .purpose = Purpose::kWorld});
  const auto some_pose = [&] { return Pose2{30.0 * rng.normal(), 30.0 * rng.normal(), rng.uniform()}; };
  for (const std::size_t waiting : {1U, 2U, 5U}) {
    WaitingPoses poses;
    std::vector<Pose2> twin;
    for (std::size_t i = 0; i < waiting; ++i) {
      twin.push_back(some_pose());
      poses.add(twin.back());
    }
    for (int i = 0; i < 40; ++i) {
      const Pose2 newest = some_pose();
      twin.push_back(newest);
      expect_near(poses.exchange(newest).pose(), twin.front());
      twin.erase(twin.begin());
      const Pose2 T{0.1 * rng.normal(), 0.1 * rng.normal(), 0.01 * rng.normal()};
      poses.move(T);
      for (Pose2& pose : twin) pose = T * pose;
      ASSERT_EQ(poses.size(), waiting);
      for (std::size_t k = 0; k < waiting; ++k) expect_near(poses[k], twin[k]);
    }
  }
}

TEST(WaitingPoses, LetTheNewestGoWhereNoneWaits) {
  WaitingPoses poses;
  expect_near(poses.exchange({1.0, 2.0, 3.0}).pose(), {1.0, 2.0, 3.0});
  EXPECT_EQ(poses.size(), 0);
}

}  // namespace
}  // namespace cogslam
