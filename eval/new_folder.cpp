#include "eval/new_folder.hpp"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include "core/error.hpp"

namespace cogslam {
namespace {

[[noreturn]] void fail(const std::filesystem::path& folder, const std::string& reason) {
  throw InputError({folder.string()}, "cannot be written: " + reason);
}

}  // namespace

NewFolder::NewFolder(const std::filesystem::path& target) : target_(target) {
  std::error_code error;
  const std::filesystem::path parent = target.has_parent_path() ? target.parent_path() : ".";
  std::filesystem::create_directories(parent, error);
  if (error) fail(parent, error.message());
  std::string name = target.string() + ".XXXXXX";
  if (mkdtemp(name.data()) == nullptr) fail(target, std::strerror(errno));
  temporary_ = name;
  // mkdtemp leaves the folder to its owner alone; results are for everybody the umask allows.
  const mode_t mask = umask(0);
  umask(mask);
  chmod(name.c_str(), 0777 & ~mask);
}

NewFolder::~NewFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(temporary_, ignored);
}

void NewFolder::move_to_target() {
  const auto rename_with = [&](unsigned flags) {
    return renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target_.c_str(), flags) == 0;
  };
  // A plain rename replaces nothing but an empty folder, so an old one is exchanged; it then goes with this object.
  if (rename_with(0)) return;
  if ((errno == EEXIST || errno == ENOTEMPTY) && rename_with(RENAME_EXCHANGE)) return;
  fail(target_, std::strerror(errno));
}

}  // namespace cogslam
