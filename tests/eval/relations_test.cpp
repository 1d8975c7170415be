#include "eval/metrics/relations.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/rng.hpp"
#include "tests/support/error_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cogslam {
namespace {

/// The error in a file of this text, without the name of the file.
std::string message_of(const std::string& text) {
  const TemporaryFolder folder;
  const auto file = folder.file("broken.relations", text);
  return error_text([&] { (void)read_relations(file); }).substr(file.string().size());
}

Time at(double seconds) { return Time::from_seconds(seconds); }

/// Ten records, a second and a metre apart.
struct Line {
  std::vector<Time> stamps;
  std::vector<Pose2> odometry;

  Line() {
    for (int i = 0; i < 10; ++i) {
      stamps.push_back(at(i));
      odometry.push_back({1.0 * i, 0, 0});
    }
  }
};

TEST(Relations, AreReadWithCommentsAndBothLineEnds) {
  const TemporaryFolder folder;
  const auto relations =
      read_relations(folder.file("two.relations", "# two\n1.5 2.25 1 -2 0 0 0 0.5\r\n\n   \n3 4 0 0 0.000 0 0 7\n"));
  ASSERT_EQ(relations.size(), 2U);
  EXPECT_EQ(relations[0].from.ns, 1'500'000'000);
  EXPECT_EQ(relations[0].to.ns, 2'250'000'000);
  EXPECT_EQ(relations[0].T_from_to, (Pose2{1, -2, 0.5}));
  EXPECT_NEAR(relations[1].T_from_to.theta, 7 - 2 * M_PI, 1e-12);
}

TEST(Relations, OfBrokenFilesAreRejectedWithTheirPlace) {
  EXPECT_EQ(message_of("1 2 3 4 0 0 0\n"), ":1:14: line ends where yaw was expected");
  EXPECT_EQ(message_of("1 2 3 4 0 0 0 0 9\n"), ":1:17: expected the end of the line, found '9'");
  EXPECT_EQ(message_of("#\n1 2 x 4 0 0 0 0\n"), ":2:5: x: expected a number, found 'x'");
  EXPECT_EQ(message_of("1 2 3 nan 0 0 0 0\n"), ":1:7: y: expected a number, found 'nan'");
  EXPECT_EQ(message_of("1 2 3 4 0.1 0 0 0\n"), ":1:9: z: expected 0, since relations lie in the plane");
  EXPECT_EQ(message_of("1e30 2 3 4 0 0 0 0\n"), ":1:1: t1: expected seconds, found more than 140 years");
  EXPECT_THROW((void)read_relations("there/is/no/such.relations"), InputError);
}

TEST(RelationErrors, AreMeansOfSizesByHand) {
  const Line line;
  // Errors of 0.3 m and 0.5 m nearby, of 1 m and 90 degrees far away.
  const std::vector<Relation> relations{
      {at(0), at(1), {0.7, 0, 0}}, {at(2), at(1), {-1.3, 0.4, 0}}, {at(0), at(9), {9, 1, radians(90)}}};
  const auto errors = relation_errors(relations, line.stamps, line.odometry, line.odometry);
  EXPECT_EQ(errors.local.count, 2U);
  EXPECT_NEAR(errors.local.trans_mean, 0.4, 1e-12);
  EXPECT_NEAR(errors.local.trans_std, 0.1, 1e-12);
  EXPECT_EQ(errors.global.count, 1U);
  EXPECT_NEAR(errors.global.trans_mean, 1.0, 1e-12);
  EXPECT_NEAR(errors.global.rot_mean, radians(90), 1e-12);
  EXPECT_EQ(errors.all.count, 3U);
  EXPECT_NEAR(errors.all.trans_mean, 0.6, 1e-12);
  EXPECT_NEAR(errors.all.rot_mean, radians(30), 1e-12);
  EXPECT_NEAR(errors.all.rot_std, radians(90) * std::sqrt(2.0) / 3.0, 1e-12);
  EXPECT_EQ(errors.unmatched, 0U);
}

TEST(RelationErrors, SplitAtFiveMetresOfOdometricTravel) {
  const Line line;
  const std::vector<Relation> relations{{at(0), at(5), {}}, {at(7), at(1), {}}};
  // The path says otherwise than odometry: it must not matter.
  const auto errors = relation_errors(relations, line.stamps, line.odometry, std::vector<Pose2>(10));
  EXPECT_EQ(errors.local.count, 1U);
  EXPECT_EQ(errors.global.count, 1U);
}

TEST(RelationErrors, CountRelationsWithoutARecordApart) {
  const Line line;
  const std::vector<Relation> relations{{at(0.021), at(1), {}}, {at(0.019), at(1), {}}, {at(0), at(99), {}}};
  const auto errors = relation_errors(relations, line.stamps, line.odometry, line.odometry);
  EXPECT_EQ(errors.unmatched, 2U);
  EXPECT_EQ(errors.all.count, 1U);
  EXPECT_EQ(errors.global.count, 0U);
}

TEST(RelationErrors, TakeTheFirstOfSeveralRecordsWithOneStamp) {
  Line line;
  line.stamps[7] = line.stamps[2];  // jumps back
  for (const double near : {2.0, 1.999, 2.001}) {
    const std::vector<Relation> relations{{at(0), at(near), {2, 0, 0}}};
    const auto errors = relation_errors(relations, line.stamps, line.odometry, line.odometry);
    EXPECT_NEAR(errors.all.trans_mean, 0.0, 1e-12) << near;
  }
}

TEST(RelationErrors, FindTheNearestStampAsALinearSearchDoes) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Rng rng({.seed = seed});
    std::vector<Time> stamps;
    std::vector<Pose2> odometry;
    for (int i = 0; i < 60; ++i) {
      stamps.push_back(at(rng.uniform(0, 1)));
      odometry.push_back({1.0 * i, 0, 0});
    }
    for (int n = 0; n < 50; ++n) {
      const Time stamp = at(rng.uniform(-0.05, 1.05));
      const auto nearer = [&](Time a, Time b) { return std::abs((a - stamp).ns) < std::abs((b - stamp).ns); };
      const auto nearest = std::min_element(stamps.begin(), stamps.end(), nearer);
      const std::vector<Relation> relations{{stamps[0], stamp, {}}};
      const auto errors = relation_errors(relations, stamps, odometry, odometry);
      if (std::abs((*nearest - stamp).ns) > 20'000'000) {
        EXPECT_EQ(errors.unmatched, 1U);
      } else {
        EXPECT_NEAR(errors.all.trans_mean, static_cast<double>(nearest - stamps.begin()), 1e-9) << "seed " << seed;
      }
    }
  }
}

TEST(RelationErrors, AreZeroOnATruePathWhereverTheMapLies) {
  Rng rng({.seed = 5});
  std::vector<Pose2> truth{{}}, odometry(30);
  std::vector<Time> stamps(30);
  while (truth.size() < 30) truth.push_back(truth.back() * Pose2{rng.uniform(0, 0.5), rng.normal(), rng.normal()});
  for (std::size_t i = 0; i < 30; ++i) stamps[i] = at(0.1 * static_cast<double>(i));
  std::vector<Relation> relations;
  for (std::size_t i = 0; i < 29; ++i) {
    relations.push_back({stamps[i], stamps[29 - i], truth[i].inverse() * truth[29 - i]});
  }
  for (Pose2& T : truth) T = Pose2{3, 4, 2} * T;
  const auto errors = relation_errors(relations, stamps, odometry, truth);
  EXPECT_EQ(errors.all.count, 29U);
  EXPECT_NEAR(errors.all.trans_mean, 0.0, 1e-9);
  EXPECT_NEAR(errors.all.rot_mean, 0.0, 1e-9);
}

TEST(RelationErrors, RejectSpansOfDifferentLength) {
  const Line line;
  EXPECT_THROW((void)relation_errors({}, line.stamps, line.odometry, {}), ContractViolation);
}

}  // namespace
}  // namespace cogslam
