#pragma once

#include <filesystem>
#include <string>

namespace cogslam {

/// Where a sweep keeps what. Every file appears whole or not at all, so a sweep may be killed at any moment.
struct SweepFolder {
  std::filesystem::path root;

  [[nodiscard]] std::filesystem::path database() const { return root / "sweep.sqlite"; }
  [[nodiscard]] std::filesystem::path readings(const std::string& key) const {
    return root / "readings" / (key + ".bin");
  }
  [[nodiscard]] std::filesystem::path truth(const std::string& key) const {
    return root / "readings" / (key + ".truth.bin");
  }
  [[nodiscard]] std::filesystem::path baseline(const std::string& key) const {
    return root / "baselines" / (key + ".bin");
  }
  /// `ending`: ".yaml" the scenario, ".json" the result, ".log" what happened, ".error" why a task of Slurm failed.
  [[nodiscard]] std::filesystem::path episode(const std::string& key, const std::string& ending) const {
    return root / "episodes" / (key + ending);
  }

  /// Makes the folders. Throws InputError naming the reason where it cannot.
  void make() const;
  /// Removes what a killed sweep left half written. Nobody else may be at work here.
  void remove_leftovers() const;
};

/// Held by the one sweep that works in a folder, as long as this object lives or its process.
class SweepLock {
 public:
  /// Throws InputError where another sweep holds it, or the folder cannot be written to.
  explicit SweepLock(const SweepFolder& folder);
  ~SweepLock();
  SweepLock(const SweepLock&) = delete;
  SweepLock& operator=(const SweepLock&) = delete;

 private:
  int descriptor_ = -1;
};

}  // namespace cogslam
