#include "core/output_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/text_file.hpp"
#include "tests/support/error_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cogslam {
namespace {

using testing::ElementsAre;

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().filename());
  return names;
}

TEST(OutputFile, WritesBytesAsTheyAreAndReplacesWhatWasThere) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "out.bin";
  std::string content(300'000, 'x');
  content[7] = '\0';
  write_file(file, "old");
  write_file(file, content);
  EXPECT_EQ(read_text_file(file, 1 << 20), content);
  EXPECT_THAT(names_in(folder.path()), ElementsAre("out.bin"));
}

TEST(OutputFile, IsReadableAsAnyOtherFile) {
  const TemporaryFolder folder;
  write_file(folder.path() / "ours", "a");
  const auto other = folder.file("other", "a");
  EXPECT_EQ(std::filesystem::status(folder.path() / "ours").permissions(),
            std::filesystem::status(other).permissions());
}

TEST(OutputFile, NamesTheFileAndTheReasonAndLeavesNothingBehind) {
  const TemporaryFolder folder;
  const std::string name = folder.path().string();
  EXPECT_EQ(error_text([&] { write_file(folder.path() / "no" / "out", "a"); }),
            name + "/no/out: cannot be written: No such file or directory");
  std::filesystem::create_directory(folder.path() / "taken");
  EXPECT_EQ(error_text([&] { write_file(folder.path() / "taken", "a"); }),
            name + "/taken: cannot be written: Is a directory");
  EXPECT_THAT(names_in(folder.path()), ElementsAre("taken"));
}

}  // namespace
}  // namespace cogslam
