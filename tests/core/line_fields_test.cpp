#include "core/line_fields.hpp"

#include <gtest/gtest.h>

#include "tests/support/error_text.hpp"

namespace cogslam {
namespace {

const SourcePlace kPlace{"a.log", 12};

TEST(LineFields, TakesFieldsInOrder) {
  LineFields fields("ODOM  1.5\t-2 host \r", kPlace);
  EXPECT_EQ(fields.word("message"), "ODOM");
  EXPECT_EQ(fields.number("x"), 1.5);
  EXPECT_EQ(fields.whole_number("count"), -2);
  EXPECT_FALSE(fields.done());
  EXPECT_EQ(fields.place().text(), "a.log:12:14");
  EXPECT_EQ(fields.word("host"), "host");
  EXPECT_TRUE(fields.done());
  fields.finish();
}

TEST(LineFields, NamesThePlaceOfABadField) {
  LineFields fields("FLASER 3 1.0 2,0 99", kPlace);
  fields.word("message");
  fields.whole_number("count");
  fields.number("range[0]");
  EXPECT_EQ(error_text([&] { fields.number("range[1]"); }), "a.log:12:14: range[1]: expected a number, found '2,0'");
  EXPECT_EQ(error_text([&] { fields.fail("odd"); }), "a.log:12:14: odd");
  EXPECT_EQ(error_text([&] { fields.finish(); }), "a.log:12:18: expected the end of the line, found '99'");
  EXPECT_EQ(error_text([&] { fields.whole_number("age", 0, 10); }),
            "a.log:12:18: age: expected a whole number in [0, 10], found '99'");
  EXPECT_EQ(error_text([&] { fields.number("x"); }), "a.log:12:20: line ends where x was expected");
}

TEST(LineFields, RejectsWhatIsNoFiniteNumber) {
  for (const std::string bad : {"nan", "inf", "1e999", "1.5x", "--1"}) {
    LineFields fields(bad, kPlace);
    EXPECT_EQ(error_text([&] { fields.number("x"); }), "a.log:12:1: x: expected a number, found '" + bad + "'");
  }
  LineFields negative("-1", kPlace);
  EXPECT_EQ(error_text([&] { negative.whole_number("n", 0); }),
            "a.log:12:1: n: expected a whole number of at least 0, found '-1'");
  LineFields fraction("1.5", kPlace);
  EXPECT_EQ(error_text([&] { fraction.whole_number("n"); }), "a.log:12:1: n: expected a whole number, found '1.5'");
}

TEST(LineFields, ShortensALongFieldInMessages) {
  const std::string text = std::string(1000, '7') + "x";
  LineFields fields(text, kPlace);
  EXPECT_EQ(error_text([&] { fields.number("x"); }),
            "a.log:12:1: x: expected a number, found '" + std::string(60, '7') + "...'");
}

TEST(LineFields, AnEmptyLineHasNoField) {
  LineFields fields("  \t ", kPlace);
  EXPECT_TRUE(fields.done());
  EXPECT_EQ(error_text([&] { fields.word("message"); }), "a.log:12:5: line ends where message was expected");
}

}  // namespace
}  // namespace cogslam
