#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace cogslam {

/// Writes a whole file or nothing: to a temporary name beside it, synced, then renamed over `file`.
/// Throws InputError naming the file and the system's reason; the temporary file is then removed.
void write_file(const std::filesystem::path& file, std::string_view content);

}  // namespace cogslam
