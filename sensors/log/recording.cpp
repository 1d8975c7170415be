#include "sensors/log/recording.hpp"

#include <fstream>

#include "core/hash.hpp"
#include "sensors/log/plausible.hpp"
#include "sensors/log/reading_codec.hpp"
#include "sensors/log/record_file.hpp"

namespace cogslam {
namespace {

constexpr RecordFormat kFormat{"COGSREAD", 1};
enum RecordKind : std::uint8_t { kHeader = 1, kReading = 2 };

void reject(const ByteReader& payload, const std::optional<std::string>& defect) {
  if (defect) payload.fail_whole(*defect);
}

}  // namespace

void write_recording(const std::filesystem::path& file, const Recording& recording) {
  RecordFileWriter out(kFormat);
  ByteWriter header;
  header.put_text(recording.source);
  put_pose(header, recording.start);
  out.add(kHeader, header);
  for (const Reading& reading : recording.readings) {
    ByteWriter bytes;
    put_reading(bytes, reading);
    out.add(kReading, bytes);
  }
  out.write(file);
}

bool is_recording(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return false;
  std::string begin(kFormat.magic.size(), '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return in && begin == kFormat.magic;
}

Recording read_recording(const std::filesystem::path& file) {
  const RecordFile in(file, kFormat);
  Recording recording;
  bool has_header = false;
  for (auto [kind, payload] : in.records()) {
    if (kind == kHeader && !has_header) {
      recording.source = payload.take_text("the source");
      recording.start = take_pose(payload, "the start");
      reject(payload, defect(recording.start));
      has_header = true;
    } else if (kind == kReading && has_header) {
      recording.readings.push_back(take_reading(payload));
      reject(payload, defect(recording.readings.back()));
    } else {
      payload.fail("record of kind " + std::to_string(kind) + ", expected one header (1), then readings (2)");
    }
    payload.finish();
  }
  if (!has_header) in.fail("no header, expected a recording of readings");
  return recording;
}

std::string readings_hash(const std::vector<Reading>& readings) {
  Hash hash;
  hash.add(static_cast<std::uint64_t>(readings.size()));
  for (const Reading& reading : readings) {
    ByteWriter bytes;
    put_reading(bytes, reading);
    hash.add(bytes.bytes());
  }
  return hash.hex();
}

}  // namespace cogslam
