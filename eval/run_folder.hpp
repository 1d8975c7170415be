#pragma once

#include <filesystem>
#include <string>

#include "eval/episode.hpp"

namespace cogslam {

/// The page of a run.
enum class PageKind {
  kNone,
  kStatic,  ///< scores, pictures and curves
  kPlayer,  ///< and a replay, where the program was built with its script; else as kStatic
};

/// Everything that a run's folder is made of; it only looks at what others own.
struct RunFiles {
  const Episode& episode;
  const Recording& recording;
  const TruthLog* truth = nullptr;  ///< nothing: a log of a real robot
  std::string config_name;          ///< of the file with the resolved configuration: scenario.yaml, replay.yaml
  std::string config;               ///< its content
  PageKind page = PageKind::kPlayer;
  bool save_readings = false;  ///< also readings.bin and, where known, truth.bin
};

/// Writes the files of a run into `<parent>/<name>-<16 hex digits>` and returns that folder. The digits are a hash of
/// the configuration, the seed, the readings and the scores, so that the same run always lies in the same place and
/// runs that differ do not share one. In the folder:
///
///   scores.json, the configuration, page.html (eval/page/run_page.hpp)
///   world.{pgm,yaml}                              the map that the world was drawn from, where there was one
///   truth.tum, odometry.tum, reference.tum, <variant>_<cell size>m_{online,final}.tum
///   <variant>_<cell size>m.{pgm,yaml,npy}         the map
///   <variant>_<cell size>m_map.png, _paths.png     the map beside the true one, and the room with the paths
///   room.png                                       the paths of the first filter at its finest cell size
///
/// The folder appears whole or not at all: it is written under another name and then renamed. One that is already
/// there holds the same scores, and costs measured at another hour: it is replaced. Throws InputError where the folder
/// cannot be written; `begin` may throw to stop.
std::filesystem::path write_run_folder(const std::filesystem::path& parent, const RunFiles& files,
                                       const StageBegin& begin = {});

}  // namespace cogslam
