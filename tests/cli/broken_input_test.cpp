#include "tests/cli/broken_input.hpp"

#include <gmock/gmock.h>

#include <cctype>
#include <fstream>
#include <sstream>

#include "cli/exit_codes.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/temporary_folder.hpp"

// Every broken input of tests/broken through the real program: its exact message and exit code, in bounded time and
// memory, and nothing left in the output folder.

namespace cogslam {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kMebibyte = std::int64_t{1} << 20;

// Sanitizers slow a program down and keep shadows of its memory.
Conditions bounds() { return {.memory_bytes = 1024 * kMebibyte, .cpu_s = is_sanitized() ? 100 : 10, .wall_s = 500}; }
std::int64_t most_memory() { return (is_sanitized() ? 2048 : 256) * kMebibyte; }

bool nobody_can_run() {
  Conditions conditions;
  conditions.as_nobody = true;
  return run_program({"--help"}, conditions).code == kOk;
}

class Broken : public testing::TestWithParam<BrokenInput> {
 protected:
  Broken() {
    fs::create_directory(out_);
    // Who has no rights of root's must still get as far as the input.
    fs::permissions(folder_.path(), fs::perms::all);
    fs::permissions(out_, fs::perms::all);
  }

  Outcome run(const BrokenInput& input, const fs::path& file) const {
    std::vector<std::string> arguments;
    std::istringstream words(input.run);
    for (std::string word; words >> word;) {
      word = replaced(replaced(word, "FILE", file.string()), "OUT", out_.string());
      arguments.push_back(replaced(word, "GOOD", kGood));
    }
    Conditions conditions = bounds();
    conditions.as_nobody = input.as == "nobody";
    return run_program(arguments, conditions);
  }

  /// What was said, with names in place of paths.
  static std::string told(const Outcome& outcome, const fs::path& file) {
    return replaced(replaced(replaced(outcome.err, file.string(), "FILE"), kGood, "GOOD"), kBroken, "BROKEN");
  }

  static inline const std::string kBroken = COGSLAM_SOURCE_DIR "/tests/broken";
  static inline const std::string kGood = COGSLAM_SOURCE_DIR "/tests/broken/good";
  TemporaryFolder folder_;
  fs::path out_ = folder_.path() / "out";
};

TEST_P(Broken, IsToldSo) {
  const BrokenInput& input = GetParam();
  if (input.as == "nobody" && !nobody_can_run()) GTEST_SKIP() << "cannot run the program without root's rights";
  const fs::path file = input_file(input, folder_.path());
  const Outcome outcome = run(input, file);
  EXPECT_EQ(told(outcome, file), input.message);
  EXPECT_EQ(outcome.code, input.exit);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(fs::is_empty(out_)) << "something was left in the output folder";
  EXPECT_LE(outcome.rss_bytes, most_memory());
}

INSTANTIATE_TEST_SUITE_P(Input, Broken, testing::ValuesIn(broken_inputs()),
                         [](const auto& input) { return replaced(replaced(input.param.name, "/", "_"), "-", "_"); });

}  // namespace
}  // namespace cogslam
