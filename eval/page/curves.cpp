#include "eval/page/curves.hpp"

#include <algorithm>
#include <cmath>

#include "core/angle.hpp"
#include "eval/report/chart.hpp"

namespace cogslam {
namespace {

constexpr std::size_t kPoints = 300;  // of a curve: a chart is narrower
constexpr std::size_t kMostRuns = 6;  // and odometry: as many as there are looks

std::vector<const VariantRun*> drawn_runs(const std::vector<VariantRun>& runs) {
  double finest = runs.front().record.cell_size_m;
  for (const VariantRun& run : runs) finest = std::min(finest, run.record.cell_size_m);
  std::vector<const VariantRun*> drawn;
  for (const VariantRun& run : runs) {
    if (run.record.cell_size_m == finest && run.trace && drawn.size() < kMostRuns) drawn.push_back(&run);
  }
  return drawn;
}

class Curves {
 public:
  explicit Curves(const RunFiles& files)
      : files_(files), runs_(drawn_runs(files.episode.runs)), frames_(frame_records(files.recording, kPoints)) {}

  [[nodiscard]] ChartSheet sheet() const {
    ChartSheet sheet{.heading = "Over time", .columns = 2};
    if (files_.truth != nullptr) {
      sheet.charts.push_back(errors("Position error", "error [m]", [](const Pose2& truth, const Pose2& pose) {
        return (pose.position() - truth.position()).norm();
      }));
      sheet.charts.push_back(errors("Heading error", "error [deg]", [](const Pose2& truth, const Pose2& pose) {
        return degrees(std::abs(wrap_angle(pose.theta - truth.theta)));
      }));
    }
    sheet.charts.push_back(
        figures("Effective particles", "N_eff", true, [](const LastScan& scan) { return scan.effective_particles; }));
    sheet.charts.push_back(
        figures("Map bytes per particle", "bytes", false, [](const LastScan& scan) { return scan.payload_bytes; }));
    return sheet;
  }

 private:
  [[nodiscard]] double seconds(std::size_t record) const {
    return (files_.recording.readings[record].stamp - files_.recording.readings[frames_.front()].stamp).seconds();
  }
  [[nodiscard]] static Chart chart(const char* title, const char* label) {
    return {.title = title, .x = {.label = "time [s]"}, .y = {.label = label, .min = 0.0}};
  }

  template <class Error>
  [[nodiscard]] Chart errors(const char* title, const char* label, const Error& error) const {
    Chart chart = Curves::chart(title, label);
    const auto add = [&](const std::string& name, const std::vector<Pose2>& path) {
      Series series{.name = name, .style = SeriesStyle::kLineOnly};
      for (const std::size_t record : frames_) {
        series.x.push_back(seconds(record));
        series.y.push_back(error(files_.truth->poses[record].T_map_base, path[record]));
      }
      chart.series.push_back(std::move(series));
    };
    add("odometry alone", odometry_path(files_.recording));
    for (const VariantRun* run : runs_) {
      if (!run->online.empty()) add(label_of(*run), run->online);
    }
    return chart;
  }

  template <class Figure>
  [[nodiscard]] Chart figures(const char* title, const char* label, bool filters_only, const Figure& figure) const {
    Chart chart = Curves::chart(title, label);
    for (const VariantRun* run : runs_) {
      if (filters_only && run->online.empty()) continue;
      Series series{.name = label_of(*run), .style = SeriesStyle::kLineOnly};
      const auto& registered = run->trace->registered;
      const std::size_t step = std::max<std::size_t>(1, registered.size() / kPoints);
      for (std::size_t i = 0; i < registered.size(); i += step) {
        series.x.push_back(seconds(registered[i].record));
        series.y.push_back(figure(registered[i].scan));
      }
      chart.series.push_back(std::move(series));
    }
    return chart;
  }
  [[nodiscard]] static std::string label_of(const VariantRun& run) { return cogslam::label(run.record); }

  const RunFiles& files_;
  std::vector<const VariantRun*> runs_;
  std::vector<std::size_t> frames_;
};

}  // namespace

std::string curves_svg(const RunFiles& files) {
  if (files.episode.runs.empty() || !files.episode.runs.front().trace) return {};
  return chart_svg(Curves(files).sheet());
}

}  // namespace cogslam
