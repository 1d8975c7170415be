#include "core/input_file.hpp"

#include <string>
#include <system_error>

#include "core/error.hpp"

namespace cogslam {

void check_input_file(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_type type = std::filesystem::status(file, error).type();
  const auto fail = [&](const std::string& message) { throw InputError({file.string()}, message); };
  switch (type) {
    case std::filesystem::file_type::regular:
      return;
    case std::filesystem::file_type::directory:
      fail("is a folder, expected a file");
      break;
    case std::filesystem::file_type::fifo:
    case std::filesystem::file_type::socket:
      fail("is a pipe, expected a regular file");
      break;
    case std::filesystem::file_type::character:
    case std::filesystem::file_type::block:
      fail("is a device, expected a regular file");
      break;
    default:
      fail("cannot be opened: " + (error ? error.message() : "not a file"));
  }
}

}  // namespace cogslam
