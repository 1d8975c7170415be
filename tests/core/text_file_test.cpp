#include "core/text_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>
#include <vector>

#include "tests/support/error_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cogslam {
namespace {

using testing::ElementsAre;

std::filesystem::path gzipped(const TemporaryFolder& folder, const std::string& name, const std::string& content) {
  const std::filesystem::path path = folder.path() / name;
  gzFile file = gzopen(path.c_str(), "wb");
  gzwrite(file, content.data(), static_cast<unsigned>(content.size()));
  gzclose(file);
  return path;
}

std::vector<std::string> lines_of(const std::filesystem::path& file, TextLimits limits = {}) {
  LineReader reader(file, limits);
  std::vector<std::string> lines;
  while (reader.next()) {
    lines.emplace_back(reader.line());
    EXPECT_EQ(reader.place().line, static_cast<int>(lines.size()));
  }
  EXPECT_EQ(reader.place().line, static_cast<int>(lines.size()));
  return lines;
}

TEST(TextFile, ReadsLinesWithAnyEnd) {
  const TemporaryFolder folder;
  EXPECT_THAT(lines_of(folder.file("a", "one\ntwo\r\n\nlast")), ElementsAre("one", "two", "", "last"));
  EXPECT_THAT(lines_of(folder.file("b", "one\n")), ElementsAre("one"));
  EXPECT_THAT(lines_of(folder.file("c", "\n\n")), ElementsAre("", ""));
  EXPECT_THAT(lines_of(folder.file("d", "")), ElementsAre());
}

TEST(TextFile, ReadsGzippedAndPlainAlikeWhateverTheName) {
  const TemporaryFolder folder;
  std::string content;
  for (int i = 0; i < 50'000; ++i) content += "line " + std::to_string(i) + "\n";  // several pieces of the reader
  const auto plain = folder.file("plain.gz", content), packed = gzipped(folder, "packed.log", content);
  EXPECT_LT(std::filesystem::file_size(packed), content.size() / 2);
  EXPECT_EQ(read_text_file(plain, 1 << 20), content);
  EXPECT_EQ(read_text_file(packed, 1 << 20), content);
  const auto lines = lines_of(packed);
  EXPECT_EQ(lines, lines_of(plain));
  EXPECT_EQ(lines.size(), 50'000U);
  EXPECT_EQ(lines.back(), "line 49999");
}

TEST(TextFile, NamesAFileThatCannotBeOpened) {
  const TemporaryFolder folder;
  const std::string name = folder.path().string();
  EXPECT_EQ(error_text([&] { LineReader reader(folder.path()); }), name + ": is a folder, expected a file");
  EXPECT_EQ(error_text([&] { LineReader reader(folder.path() / "no"); }),
            name + "/no: cannot be opened: No such file or directory");
}

TEST(TextFile, NamesTheLineWhereGzipDataEndsTooEarlyOrBreaks) {
  const TemporaryFolder folder;
  std::string content;
  for (int i = 0; i < 1000; ++i) content += std::to_string(i * 7919 % 65537) + "\n";
  const auto good = gzipped(folder, "good.gz", content);
  std::filesystem::resize_file(good, std::filesystem::file_size(good) / 2);
  const std::string name = folder.path().string();
  EXPECT_EQ(error_text([&] { lines_of(good); }), name + "/good.gz:1: gzip data is cut off");
  EXPECT_EQ(error_text([&] { read_text_file(good, 1 << 20); }), name + "/good.gz: gzip data is cut off");

  const auto broken = gzipped(folder, "broken.gz", content);
  std::fstream(broken, std::ios::in | std::ios::out | std::ios::binary).seekp(100).write("\xff\xff\xff\xff", 4);
  EXPECT_THAT(error_text([&] { read_text_file(broken, 1 << 20); }),
              testing::StartsWith(name + "/broken.gz: gzip data is broken: "));
}

TEST(TextFile, StopsAtItsLimits) {
  const TemporaryFolder folder;
  const std::string name = folder.path().string();
  const auto file = folder.file("a", "12345\n1234567\n");
  EXPECT_EQ(read_text_file(file, 14).size(), 14U);
  EXPECT_EQ(error_text([&] { read_text_file(file, 13); }), name + "/a: file is too large, expected at most 13 bytes");
  EXPECT_EQ(error_text([&] { lines_of(file, {.line_bytes = 6}); }),
            name + "/a:2: line is too long, expected at most 6 bytes");
  const auto bomb = gzipped(folder, "bomb.gz", std::string(10'000'000, 'a'));
  EXPECT_EQ(error_text([&] { lines_of(bomb); }), name + "/bomb.gz:1: line is too long, expected at most 1048576 bytes");
  EXPECT_EQ(error_text([&] { read_text_file(bomb, 1'000'000); }),
            name + "/bomb.gz: file is too large, expected at most 1000000 bytes");
}

}  // namespace
}  // namespace cogslam
