#pragma once

#include <filesystem>

namespace cogslam {

/// Throws InputError, with the file's name and the system's reason, unless `file` is a regular file or a link to one:
/// a folder holds no text, and a pipe or a device might never end or never begin.
void check_input_file(const std::filesystem::path& file);

}  // namespace cogslam
