#include "sensors/log/record_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <span>

#include "core/check.hpp"
#include "core/hash.hpp"
#include "core/input_file.hpp"
#include "core/output_file.hpp"

namespace cogslam {
namespace {

constexpr std::size_t kMagicSize = 8;
constexpr std::size_t kHeadSize = kMagicSize + sizeof(std::uint32_t);
constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 32;

std::uint64_t hash_of(std::string_view bytes) {
  Hash hash;
  hash.add(std::span<const char>(bytes.data(), bytes.size()));
  return hash.value();
}

void put_record(ByteWriter& out, std::uint8_t kind, std::string_view payload) {
  out.put(kind);
  out.put_text(payload);
}

/// Takes magic and version off, and complains where they are not those of `format`.
void take_head(ByteReader& in, const RecordFormat& format) {
  if (in.take_raw(kMagicSize, "the magic") != format.magic)
    throw InputError({in.file()},
                     "byte 0: wrong magic, expected a file that begins with '" + std::string(format.magic) + "'");
  if (const auto version = in.take<std::uint32_t>("the version"); version != format.version)
    throw InputError({in.file()},
                     "byte 8: version " + std::to_string(version) + ", expected " + std::to_string(format.version));
}

std::string load(const std::filesystem::path& file, const std::string& name, const RecordFormat& format) {
  check_input_file(file);
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError({name}, std::string("cannot be opened: ") + std::strerror(errno));
  std::string bytes(kHeadSize, '\0');
  in.read(bytes.data(), kHeadSize);
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  ByteReader head(bytes, name);
  take_head(head, format);  // before memory is asked for what may be no such file
  const auto size = std::filesystem::file_size(file);
  if (size > kMostBytes)
    throw InputError({name}, "file is too large, expected at most " + std::to_string(kMostBytes) + " bytes");
  bytes.resize(static_cast<std::size_t>(size));
  in.clear();
  in.seekg(0);
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

}  // namespace

RecordFileWriter::RecordFileWriter(const RecordFormat& format) {
  EXPECTS(format.magic.size() == kMagicSize);
  out_.put_raw(format.magic);
  out_.put(format.version);
}

void RecordFileWriter::add(std::uint8_t kind, const ByteWriter& payload) {
  EXPECTS(kind != kEndRecord);
  put_record(out_, kind, payload.bytes());
}

void RecordFileWriter::write(const std::filesystem::path& file) const {
  ByteWriter hash;
  hash.put(hash_of(out_.bytes()));
  ByteWriter whole = out_;
  put_record(whole, kEndRecord, hash.bytes());
  write_file(file, whole.bytes());
}

RecordFile::RecordFile(const std::filesystem::path& file, const RecordFormat& format)
    : name_(file.string()), bytes_(load(file, name_, format)) {
  split(format);
}

void RecordFile::split(const RecordFormat& format) {
  ByteReader in(bytes_, name_);
  take_head(in, format);
  while (true) {
    const std::size_t start = in.offset();
    const auto kind = in.take<std::uint8_t>("a record's kind");
    const std::size_t size = in.take_count(1, "a record's size");
    ByteReader payload(std::string_view(bytes_).substr(in.offset(), size), name_, in.offset());
    in.take_raw(size, "a record");
    if (kind != kEndRecord) {
      records_.push_back({kind, payload});
      continue;
    }
    const std::size_t at = payload.offset();
    const auto hash = payload.take<std::uint64_t>("the hash");
    payload.finish();
    in.finish();
    if (hash != hash_of(std::string_view(bytes_).substr(0, start)))
      throw InputError({name_},
                       "byte " + std::to_string(at) + ": the hash does not fit the content: the file is damaged");
    return;
  }
}

}  // namespace cogslam
