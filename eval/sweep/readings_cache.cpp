#include "eval/sweep/readings_cache.hpp"

#include <fmt/format.h>

namespace cogslam {
namespace {

CachedReadings load(const SweepFolder& folder, const std::string& key) {
  CachedReadings found{read_recording(folder.readings(key)), read_truth_log(folder.truth(key)), "found"};
  if (found.truth.readings_hash != readings_hash(found.recording.readings)) {
    throw InputError({folder.truth(key).string()}, "the truth of other readings");
  }
  return found;
}

std::string note_of(const std::string& reason, const Drive& drive) {
  std::string note = "made" + reason;
  if (drive.camera_spans_without > 0) {
    note += fmt::format("; no estimate from the camera in {} of {} spans: wheels stood in", drive.camera_spans_without,
                        drive.camera_spans);
  }
  if (drive.stuck) note += "; the vehicle was stuck for 5 s at some time: look at the route";
  return note;
}

}  // namespace

bool has_readings(const SweepFolder& folder, const std::string& key) {
  return std::filesystem::exists(folder.readings(key)) && std::filesystem::exists(folder.truth(key));
}

CachedReadings cached_readings(const SweepFolder& folder, const std::string& key, const Scenario& scenario) {
  std::string reason;
  if (has_readings(folder, key)) {
    try {
      return load(folder, key);
    } catch (const InputError& error) {
      reason = std::string(" anew, for ") + error.what();
    }
  }
  Drive drive = record_drive(scenario);
  write_recording(folder.readings(key), drive.recording);
  write_truth_log(folder.truth(key), drive.truth);
  const std::string note = note_of(reason, drive);
  return {std::move(drive.recording), std::move(drive.truth), note};
}

}  // namespace cogslam
