#pragma once

#include <filesystem>

namespace cogslam {

/// A folder that appears whole or not at all: filled under a temporary name beside its own, then renamed. Gone with the
/// object unless it was moved to its own name.
class NewFolder {
 public:
  /// Makes the folders above `target` where they are missing. Throws InputError naming the reason where it cannot.
  explicit NewFolder(const std::filesystem::path& target);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  /// Where to write until then.
  [[nodiscard]] const std::filesystem::path& path() const { return temporary_; }
  /// Puts the folder into its place; a folder that is there already is replaced. Throws InputError where it cannot.
  void move_to_target();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
};

}  // namespace cogslam
