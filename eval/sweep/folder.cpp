#include "eval/sweep/folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "core/error.hpp"

namespace cogslam {
namespace {

constexpr std::array kParts{"readings", "baselines", "episodes"};
constexpr std::array kEndings{".bin", ".yaml", ".json", ".log", ".error"};

bool is_complete(const std::filesystem::path& file) {
  return std::any_of(kEndings.begin(), kEndings.end(), [&](const char* ending) { return file.extension() == ending; });
}

}  // namespace

void SweepFolder::make() const {
  for (const char* part : kParts) {
    std::error_code error;
    std::filesystem::create_directories(root / part, error);
    if (error) throw InputError({(root / part).string()}, "cannot be made: " + error.message());
  }
}

void SweepFolder::remove_leftovers() const {
  for (const char* part : kParts) {
    for (const auto& entry : std::filesystem::directory_iterator(root / part)) {
      std::error_code ignored;
      if (!is_complete(entry.path())) std::filesystem::remove(entry.path(), ignored);
    }
  }
}

SweepLock::SweepLock(const SweepFolder& folder) {
  const std::filesystem::path file = folder.root / "sweep.lock";
  // Not inherited: workers that outlive a killed sweep by a moment must not keep the next one out.
  descriptor_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw InputError({file.string()}, std::string("cannot be written: ") + std::strerror(errno));
  if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  const int reason = errno;
  close(descriptor_);
  if (reason != EWOULDBLOCK)
    throw InputError({file.string()}, std::string("cannot be locked: ") + std::strerror(reason));
  throw InputError({folder.root.string()},
                   "another sweep is at work in this folder; wait for it, or use another --out");
}

SweepLock::~SweepLock() { close(descriptor_); }

}  // namespace cogslam
