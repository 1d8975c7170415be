#include "core/hash.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cogslam {
namespace {

// Published FNV-1a 64 values (Fowler, Noll, Vo: test suite of their page).
TEST(Hash, MeetsThePublishedValues) {
  EXPECT_EQ(Hash().value(), 0xcbf29ce484222325ULL);
  EXPECT_EQ(Hash().add('a').value(), 0xaf63dc4c8601ec8cULL);
  Hash foobar;
  for (const char c : {'f', 'o', 'o', 'b', 'a', 'r'}) foobar.add(c);
  EXPECT_EQ(foobar.value(), 0x85944171f73967e8ULL);
  EXPECT_EQ(foobar.hex(), "85944171f73967e8");
}

TEST(Hash, DependsOnOrderTypeAndLength) {
  EXPECT_NE(Hash().add(1).add(2).value(), Hash().add(2).add(1).value());
  EXPECT_NE(Hash().add(1).value(), Hash().add(std::int64_t{1}).value());
  EXPECT_NE(Hash().add(0.0).value(), Hash().add(-0.0).value());
  EXPECT_NE(Hash().add(std::string("ab")).add(std::string("c")).value(),
            Hash().add(std::string("a")).add(std::string("bc")).value());
}

TEST(Hash, WritesLeadingZeros) {
  EXPECT_EQ(Hash().hex().size(), 16U);
  EXPECT_EQ(Hash().hex(), "cbf29ce484222325");
}

}  // namespace
}  // namespace cogslam
