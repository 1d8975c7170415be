#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>

#include "cli/exit_codes.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/temporary_folder.hpp"

// Output that fails: what is said, and that nothing half-written stays.

namespace cogslam {
namespace {

namespace fs = std::filesystem;
using testing::EndsWith;
using testing::HasSubstr;

std::vector<std::string> replay_into(const fs::path& out) {
  return {"replay", COGSLAM_SOURCE_DIR "/tests/broken/good/readings.bin", "--out", out, "--quiet", "-j", "1"};
}

/// Everybody may look into it, but only who owns it may write.
class OutputFolder : public testing::Test {
 protected:
  OutputFolder() {
    fs::create_directory(out_);
    fs::permissions(folder_.path(), fs::perms::all);
  }
  TemporaryFolder folder_;
  fs::path out_ = folder_.path() / "out";
};

TEST_F(OutputFolder, OfAGoodReplayHoldsOneRun) {
  const Outcome outcome = run_program(replay_into(out_));
  EXPECT_EQ(outcome.code, kOk) << outcome.err;
  EXPECT_EQ(std::distance(fs::directory_iterator(out_), fs::directory_iterator()), 1);
}

TEST_F(OutputFolder, ThatIsReadOnlyIsFoundBeforeTheRun) {
  Conditions conditions;
  conditions.as_nobody = true;
  if (run_program({"--help"}, conditions).code != kOk) GTEST_SKIP() << "cannot run the program without root's rights";
  fs::permissions(out_, fs::perms::owner_read | fs::perms::owner_exec);
  const Outcome outcome = run_program(replay_into(out_ / "below"), conditions);
  EXPECT_EQ(outcome.err, "cogslam: --out " + (out_ / "below").string() +
                             ": Permission denied, expected a folder that can be written to\n");
  EXPECT_EQ(outcome.code, kUsageError);
}

TEST_F(OutputFolder, ThatIsALoopOfLinksIsFoundBeforeTheRun) {
  const fs::path loop = folder_.path() / "loop";
  fs::create_symlink(loop, loop);
  for (const fs::path& out : {loop, loop / "below"}) {
    const Outcome outcome = run_program(replay_into(out));
    EXPECT_EQ(outcome.err, "cogslam: --out " + out.string() +
                               ": Too many levels of symbolic links, expected a folder that can be written to\n");
    EXPECT_EQ(outcome.code, kUsageError);
  }
}

TEST_F(OutputFolder, ThatALinkNamesInVainIsFoundBeforeTheRun) {
  const fs::path link = folder_.path() / "link";
  fs::create_symlink(folder_.path() / "nowhere", link);
  const Outcome outcome = run_program(replay_into(link));
  EXPECT_THAT(outcome.err, HasSubstr("--out " + link.string() + ": "));
  EXPECT_EQ(outcome.code, kUsageError);
}

TEST_F(OutputFolder, OfFiguresIsCheckedToo) {
  const std::string file = folder_.file("file", "");
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"lab", "figures", "1", "--out", file},
                                                    {"lab", "signal", "--out", file},
                                                    {"sense", "figures", "2", "--out", file}}) {
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.err, "cogslam: --out " + file + ": Not a directory, expected a folder that can be written to\n");
    EXPECT_EQ(outcome.code, kUsageError);
  }
}

TEST_F(OutputFolder, StaysEmptyWhereAFileCannotGrow) {
  for (const std::int64_t bytes : {1, 1500, 4000}) {
    const Outcome outcome = run_program(replay_into(out_), {.file_bytes = bytes});
    if (bytes > 1) EXPECT_THAT(outcome.err, HasSubstr(": cannot be written: File too large\n"));  // else cut off too
    EXPECT_EQ(outcome.code, kUsageError);
    EXPECT_TRUE(fs::is_empty(out_)) << bytes;
  }
}

/// Mounts a disk of so many bytes over `at`, seen by nobody else, and runs `body`; 77 where that is not allowed.
int on_small_disk(const fs::path& at, int bytes, const std::function<bool()>& body) {
  const pid_t child = fork();
  if (child == 0) {
    const std::string size = "size=" + std::to_string(bytes);
    const bool mounted = unshare(CLONE_NEWNS) == 0 && mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
                         mount("tmpfs", at.c_str(), "tmpfs", 0, size.c_str()) == 0;
    _exit(!mounted ? 77 : body() ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

TEST_F(OutputFolder, StaysEmptyWhereTheDiskIsFull) {
  const int result = on_small_disk(out_, 8192, [&] {
    const Outcome outcome = run_program(replay_into(out_));
    EXPECT_THAT(outcome.err, EndsWith(": cannot be written: No space left on device\n"));
    EXPECT_EQ(outcome.code, kUsageError);
    EXPECT_TRUE(fs::is_empty(out_));
    return !testing::Test::HasFailure();
  });
  if (result == 77) GTEST_SKIP() << "cannot mount a small disk without root's rights";
  EXPECT_EQ(result, 0) << "see above";
}

TEST_F(OutputFolder, KeepsTheRunWhereStandardOutputIsFull) {
  const Outcome outcome = run_program(replay_into(out_), {.standard_output = "/dev/full"});
  EXPECT_EQ(outcome.err, "cogslam: standard output cannot be written\n");
  EXPECT_EQ(outcome.code, kRunFailed);
  EXPECT_FALSE(fs::is_empty(out_)) << "the files come before the table";
}

TEST(StandardOutput, ThatIsFullEndsEveryCommandAlike) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"validate", COGSLAM_SOURCE_DIR "/scenarios/cluttered.yaml"},
        {"lab", "map", "simple", "--percent", "5", "--quiet"},
        {"--help"}}) {
    const Outcome outcome = run_program(arguments, {.standard_output = "/dev/full"});
    EXPECT_EQ(outcome.err, "cogslam: standard output cannot be written\n") << arguments[0];
    EXPECT_EQ(outcome.code, kRunFailed) << arguments[0];
  }
}

TEST(Figures, ThatAreNoNumbersAreNoOptions) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"lab", "map", "simple", "--cell-size", "nan"},
        {"replay", "a.log", "--cell-size", "nan"},
        {"sense", "recover", "a.csv", "--gap", "nan"}}) {
    const Outcome outcome = run_program(arguments);
    EXPECT_THAT(outcome.err, HasSubstr("Value nan not in range ")) << arguments[0];
    EXPECT_EQ(outcome.code, kUsageError) << arguments[0];
  }
}

}  // namespace
}  // namespace cogslam
