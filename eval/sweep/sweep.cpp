#include "eval/sweep/sweep.hpp"

#include <algorithm>
#include <map>

#include "core/output_file.hpp"
#include "core/text_file.hpp"
#include "eval/page/sweep_page.hpp"
#include "eval/sweep/episode_job.hpp"
#include "eval/sweep/export.hpp"
#include "eval/sweep/summary.hpp"

namespace cogslam {
namespace {

constexpr std::size_t kMaxResultBytes = 10'000'000;

const SweepFolder& made(const SweepFolder& folder) {
  folder.make();
  return folder;
}

}  // namespace

Sweep::Sweep(SweepPlan plan, SweepFolder folder)
    : plan_(std::move(plan)), folder_(made(folder)), lock_(folder_), database_(folder_.database()) {
  database_.set_plan(plan_);
  for (const PlannedEpisode* episode : missing()) take_in(*episode);
}

std::vector<const PlannedEpisode*> Sweep::missing() const {
  std::map<std::string, std::size_t> first;  // of the readings, in the order of the plan
  for (std::size_t i = 0; i < plan_.episodes.size(); ++i) first.emplace(plan_.episodes[i].readings_key, i);
  std::vector<const PlannedEpisode*> missing;
  for (const PlannedEpisode& episode : plan_.episodes) {
    if (!database_.has_episode(episode.key)) missing.push_back(&episode);
  }
  std::stable_sort(missing.begin(), missing.end(),
                   [&](const auto* a, const auto* b) { return first.at(a->readings_key) < first.at(b->readings_key); });
  return missing;
}

bool Sweep::take_in(const PlannedEpisode& episode) {
  const std::filesystem::path file = folder_.episode(episode.key, ".json");
  if (!std::filesystem::exists(file)) return false;
  try {
    database_.add_episode(episode.key, read_text_file(file, kMaxResultBytes));
    return true;
  } catch (const InputError&) {
    return false;  // damaged: it is measured again
  }
}

void Sweep::note_failure(const PlannedEpisode& episode, const std::string& error) {
  database_.note_failure(episode.key, error);
}

std::size_t Sweep::of_other_builds() const {
  const EpisodeTable table = database_.results();
  const std::string program = program_hash();
  std::size_t others = 0;
  for (std::size_t row = 0; row < table.rows.size(); ++row) others += table.text(row, "program") == program ? 0 : 1;
  return others;
}

void Sweep::export_results() const {
  const EpisodeTable table = database_.results();
  write_file(folder_.root / "scores.csv", table_csv(table, ColumnKind::kScore));
  write_file(folder_.root / "costs.csv", table_csv(table, ColumnKind::kCost));
  std::vector<VariantSummary> summary = summarize(table);
  write_file(folder_.root / "summary.csv", summary_csv(summary));
  const SweepPageData page{
      .name = plan_.name, .planned = plan_.episodes.size(), .table = table, .summary = std::move(summary)};
  write_file(folder_.root / "page.html", sweep_page(page, sweep_page_parts()));
}

}  // namespace cogslam
