#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/error.hpp"

// What the fuzz targets share. A target hands arbitrary bytes to one reader. Either it reads them, and then what it
// read must hold what its docstring promises, or it throws InputError. All else is a finding: any other exception, a
// sanitizer's report, more than the seconds and bytes that `./dev fuzz` allows.

namespace cogslam {

/// A file that lives in memory, for readers that want a path; gone with the object.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view content) : descriptor_(memfd_create("fuzz", 0)) {
    if (descriptor_ < 0) throw std::runtime_error("cannot make a file in memory");
    while (!content.empty()) {
      const ssize_t count = ::write(descriptor_, content.data(), content.size());
      if (count <= 0) throw std::runtime_error("cannot write to a file in memory");
      content.remove_prefix(static_cast<std::size_t>(count));
    }
  }
  ~MemoryFile() { close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Runs `read`, which may throw InputError with a message for people: not empty, one line, not a screenful.
template <class Read>
void read_or_complain(Read&& read) {
  constexpr std::size_t kLongestMessage = 1000;
  try {
    read();
  } catch (const InputError& error) {
    const std::string_view message = error.what();
    for (const char c : message) {
      if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) std::abort();
    }
    if (message.empty() || message.size() > kLongestMessage) std::abort();
  }
}

/// Ends the target where a promise does not hold.
inline void promise(bool holds) {
  if (!holds) std::abort();
}

}  // namespace cogslam
