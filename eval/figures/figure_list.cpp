#include <algorithm>

#include "core/error.hpp"
#include "core/output_file.hpp"
#include "eval/figures/experiment_figure.hpp"

namespace cogslam {
namespace {

using Make = LabFigure (*)(const FigureInputs&, const std::string&);

ExperimentFigure of_room(int number, const std::string& room, const std::string& shows, Make make) {
  return {std::to_string(number), shows, {"rooms"}, [room, make](const FigureInputs& in) { return make(in, room); }};
}

}  // namespace

const std::vector<ExperimentFigure>& experiment_figures() {
  static const std::vector<ExperimentFigure> kFigures{
      {"12", "path and map of FastSLAM OG, the baseline", {"paper_l2"}, figure_baseline},
      {"13", "path and map by l2 from 40 % of the data", {"paper_l2"}, figure_l2_path_and_map},
      {"14", "path and map by compressed sensing from 40 % of the data", {"paper_cs"}, figure_cs_path_and_map},
      {"15", "errors beside OG over the data kept", {"paper_l2", "paper_cs"}, figure_mse_by_percent_kept},
      {"16", "maps by l2 from less and less data", {"paper_l2"}, figure_l2_map_series},
      {"17", "maps by compressed sensing from less and less data", {"paper_cs"}, figure_cs_map_series},
      {"18", "time of an iteration over the data kept", {"paper_cs"}, figure_step_time},
      of_room(19, "simple", "map of the empty room", figure_room_map),
      of_room(20, "simple", "error over the data kept, empty room, four cell sizes", figure_room_compression),
      of_room(21, "cornered", "map of the room with corners", figure_room_map),
      of_room(22, "cornered", "error over the data kept, room with corners, four cell sizes", figure_room_compression),
      of_room(23, "cluttered", "map of the room with boxes", figure_room_map),
      of_room(24, "cluttered", "error over the data kept, room with boxes, four cell sizes", figure_room_compression),
      {"bytes", "error over real bytes, every store", {"bytes"}, figure_error_by_bytes},
      {"particles", "error over particles, and for the same bytes", {"particles"}, figure_error_by_particles},
      {"forty", "how much data is enough, over room size and clamping", {"forty_percent"}, figure_forty_percent},
      {"matched", "figure 15 by the filter as shipped", {"compression"}, figure_mse_by_percent_kept_matched, true},
  };
  return kFigures;
}

const ExperimentFigure& experiment_figure(const std::string& name) {
  const std::vector<ExperimentFigure>& all = experiment_figures();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& figure) { return figure.name == name; });
  if (found != all.end()) return *found;
  std::string names;
  for (const ExperimentFigure& figure : all) names += (names.empty() ? "" : ", ") + figure.name;
  throw InputError("no figure '" + name + "', expected one of " + names);
}

void write_experiment_figure(const std::filesystem::path& folder, const ExperimentFigure& which,
                             const LabFigure& figure) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError({folder.string()}, "cannot be written: " + error.message());
  const std::filesystem::path stem = folder / ("figure_" + which.name);
  write_file(stem.string() + ".csv", figure.csv);
  write_file(stem.string() + ".svg", chart_svg(figure.sheet));
  write_file(stem.string() + ".png", chart_png(figure.sheet));
}

}  // namespace cogslam
