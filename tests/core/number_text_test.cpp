#include "core/number_text.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "core/rng.hpp"

namespace cogslam {
namespace {

TEST(NumberText, ParsesTheWholeTextOrNothing) {
  EXPECT_EQ(parse_number("-1.5e3"), -1500.0);
  EXPECT_EQ(parse_number("7"), 7.0);
  for (const char* bad : {"", " 1", "1 ", "1x", "+1", "nan", "inf", "-inf", "1e999", "0x10", "1,5"}) {
    EXPECT_EQ(parse_number(bad), std::nullopt) << bad;
  }
  EXPECT_EQ(parse_whole_number("-12"), -12);
  for (const char* bad : {"", "1.0", "1e3", "9223372036854775808", "0x1"}) {
    EXPECT_EQ(parse_whole_number(bad), std::nullopt) << bad;
  }
}

TEST(NumberText, IsShortAndReadsBackExactly) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(40.0), "40");
  Rng rng({.seed = 41, .purpose = Purpose::kWorld});
  for (int i = 0; i < 10000; ++i) {
    const auto value = std::bit_cast<double>(rng.bits64());
    if (!std::isfinite(value)) continue;
    ASSERT_EQ(parse_number(number_text(value)), value);
  }
}

}  // namespace
}  // namespace cogslam
