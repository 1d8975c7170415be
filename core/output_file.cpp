#include "core/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "core/error.hpp"

namespace cogslam {
namespace {

/// A file under a temporary name, gone again unless it is moved to its own.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& target)
      : target_(target), name_(target.string() + ".XXXXXX"), descriptor_(mkstemp(name_.data())) {
    if (descriptor_ < 0) throw_reason();
    // mkstemp leaves the file readable by its owner alone; results are for everybody the umask allows.
    const mode_t mask = umask(0);
    umask(mask);
    fchmod(descriptor_, 0666 & ~mask);
  }
  ~TemporaryFile() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!name_.empty()) unlink(name_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t count = ::write(descriptor_, content.data(), content.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) throw_reason();
      content.remove_prefix(static_cast<std::size_t>(count));
    }
  }

  void move_to_target() {
    if (fsync(descriptor_) != 0) throw_reason();
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (close(descriptor) != 0) throw_reason();
    if (rename(name_.c_str(), target_.c_str()) != 0) throw_reason();
    name_.clear();
  }

 private:
  [[noreturn]] void throw_reason() {
    throw InputError({target_.string()}, std::string("cannot be written: ") + std::strerror(errno));
  }

  std::filesystem::path target_;
  std::string name_;
  int descriptor_;
};

}  // namespace

void write_file(const std::filesystem::path& file, std::string_view content) {
  TemporaryFile temporary(file);
  temporary.write(content);
  temporary.move_to_target();
}

}  // namespace cogslam
