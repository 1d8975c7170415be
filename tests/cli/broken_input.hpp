#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace cogslam {

/// A broken input under tests/broken with what the program has to say to it.
///
/// `NAME.expected` begins with lines `key: value`, then comes an empty line and the exact standard error:
///
///   run: replay FILE --out OUT --quiet     arguments; FILE is the input, OUT an empty folder, GOOD tests/broken/good
///   exit: 2                                exit code
///   make: pipe                             how `make_broken_input` makes the input; absent: the other NAME.* file is
///   as: nobody                             without root's rights
struct BrokenInput {
  std::string name;  ///< "carmen/jump": its folder and NAME
  std::string run;
  std::string make;
  std::string as;
  int exit = 0;
  std::string message;  ///< with FILE, GOOD and BROKEN (tests/broken) in place of paths
};

inline void PrintTo(const BrokenInput& input, std::ostream* out) { *out << input.name; }

/// All of them, by name.
std::vector<BrokenInput> broken_inputs();

/// The file or whatever stands in its place: that of the repository, or one made in `folder`.
std::filesystem::path input_file(const BrokenInput& input, const std::filesystem::path& folder);

/// `text` with every `from` replaced.
std::string replaced(std::string text, const std::string& from, const std::string& to);

}  // namespace cogslam
