#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sensors/log/bytes.hpp"

namespace cogslam {

// Our binary files: magic (8 bytes), version (u32), records {kind u8, size u64, payload}, and at the end a record of
// kind kEndRecord whose payload is the FNV-1a hash (u64) of every byte before it. All little-endian.

constexpr std::uint8_t kEndRecord = 0;

/// Names a format: 8 characters and the one version that this program writes and reads.
struct RecordFormat {
  std::string_view magic;
  std::uint32_t version = 1;
};

/// Collects records, then writes them whole or not at all.
class RecordFileWriter {
 public:
  explicit RecordFileWriter(const RecordFormat& format);
  /// `kind` is not kEndRecord.
  void add(std::uint8_t kind, const ByteWriter& payload);
  void write(const std::filesystem::path& file) const;

 private:
  ByteWriter out_;
};

/// A file of records in memory, checked from magic to hash before the first one is handed out.
class RecordFile {
 public:
  struct Record {
    std::uint8_t kind;
    ByteReader payload;
  };

  /// Throws InputError naming file and byte where it is not such a file, cut off, damaged or of another version.
  RecordFile(const std::filesystem::path& file, const RecordFormat& format);

  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;

  /// In the order of the file; they look into this object.
  [[nodiscard]] const std::vector<Record>& records() const { return records_; }
  /// Complains about the file as a whole.
  [[noreturn]] void fail(const std::string& message) const { throw InputError({name_}, message); }

 private:
  void split(const RecordFormat& format);

  std::string name_;
  std::string bytes_;
  std::vector<Record> records_;
};

}  // namespace cogslam
