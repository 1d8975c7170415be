#include "core/printable.hpp"

#include <gtest/gtest.h>

namespace cogslam {
namespace {

TEST(Printable, LeavesTextAlone) {
  EXPECT_EQ(printable(""), "");
  EXPECT_EQ(printable("a b~"), "a b~");
  EXPECT_EQ(printable("m\u00fcde \u2713 \U0001F600"), "m\u00fcde \u2713 \U0001F600");
  EXPECT_EQ(in_quotes("x"), "'x'");
}

TEST(Printable, SpellsOutWhatCommandsATerminal) {
  EXPECT_EQ(printable("\x1b[2J\a\x7f\n"), "\\x1B[2J\\x07\\x7F\\x0A");
  EXPECT_EQ(printable("\xc2\x9b"), "\\xC2\\x9B") << "a control character in two bytes";
}

TEST(Printable, SpellsOutWhatIsNoUtf8) {
  EXPECT_EQ(printable("\x80"), "\\x80");
  EXPECT_EQ(printable("\xc3"), "\\xC3") << "cut off";
  EXPECT_EQ(printable("\xc0\xaf"), "\\xC0\\xAF") << "a slash in two bytes";
  EXPECT_EQ(printable("\xe0\x80\xaf"), "\\xE0\\x80\\xAF") << "in three";
  EXPECT_EQ(printable("\xf0\x80\x80\xaf"), "\\xF0\\x80\\x80\\xAF") << "in four";
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xED\\xA0\\x80") << "half of a pair";
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xF4\\x90\\x80\\x80") << "beyond the last character";
}

TEST(Printable, CutsBetweenCharacters) {
  EXPECT_EQ(printable("12345", 5), "12345");
  EXPECT_EQ(printable("123456", 5), "12345...");
  EXPECT_EQ(printable("1234\u00fc", 5), "1234...");
  EXPECT_EQ(printable("123\x01", 5), "123...");
}

}  // namespace
}  // namespace cogslam
