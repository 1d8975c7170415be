#pragma once

#include <functional>
#include <string>
#include <vector>

#include "eval/sweep/database.hpp"
#include "eval/sweep/folder.hpp"
#include "eval/sweep/plan.hpp"

namespace cogslam {

/// A sweep in its folder: what is planned, what is there, what is missing. Only one at a time works in a folder.
class Sweep {
 public:
  /// Makes or opens the folder, and takes in results that lie there without a row, as after a sweep that was killed.
  /// Throws InputError where the folder cannot be used, or another sweep is at work in it.
  Sweep(SweepPlan plan, SweepFolder folder);

  [[nodiscard]] const SweepPlan& plan() const { return plan_; }
  [[nodiscard]] const SweepFolder& folder() const { return folder_; }
  /// Episodes without a row, those with the same readings together.
  [[nodiscard]] std::vector<const PlannedEpisode*> missing() const;
  /// Takes in `episodes/<key>.json`; gives false where there is none that can be read.
  bool take_in(const PlannedEpisode& episode);
  /// Notes why an episode has no result.
  void note_failure(const PlannedEpisode& episode, const std::string& error);
  /// Of this plan's episodes that have a row: how many were measured by another build of the program.
  [[nodiscard]] std::size_t of_other_builds() const;
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> failures() const { return database_.failures(); }
  [[nodiscard]] EpisodeTable results() const { return database_.results(); }
  /// Writes scores.csv, costs.csv, summary.csv and page.html.
  void export_results() const;

 private:
  SweepPlan plan_;
  SweepFolder folder_;
  SweepLock lock_;
  SweepDatabase database_;
};

}  // namespace cogslam
