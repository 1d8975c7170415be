#include "core/text_file.hpp"

#include <zlib.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "core/input_file.hpp"

namespace cogslam {
namespace {

struct CloseGzip {
  void operator()(gzFile file) const { gzclose(file); }
};

/// The unpacked bytes of a file, piece by piece.
class ByteSource {
 public:
  ByteSource(const std::filesystem::path& file, std::size_t max_bytes) : name_(file.string()), left_(max_bytes) {
    check_input_file(file);
    errno = 0;
    gzip_.reset(gzopen(name_.c_str(), "rb"));
    if (!gzip_) throw InputError({name_}, std::string("cannot be opened: ") + std::strerror(errno));
  }

  /// The next piece; empty at the end. Valid until the next call.
  std::string_view read(const SourcePlace& place) {
    errno = 0;
    const int count = gzread(gzip_.get(), buffer_.data(), static_cast<unsigned>(buffer_.size()));
    int code = Z_OK;
    std::string_view why = gzerror(gzip_.get(), &code);
    if (why.starts_with(name_ + ": ")) why.remove_prefix(name_.size() + 2);
    // zlib reports a file that ends too early as a buffer error, with the bytes it could still unpack.
    if (code == Z_BUF_ERROR) throw InputError(place, "gzip data is cut off");
    if (code == Z_ERRNO) throw InputError(place, std::string("cannot be read: ") + std::strerror(errno));
    if (count < 0) throw InputError(place, "gzip data is broken: " + std::string(why));
    const auto size = static_cast<std::size_t>(count);
    if (size > left_) throw InputError({name_}, "file is too large, expected at most " + limit_text());
    left_ -= size;
    total_ += size;
    return {buffer_.data(), size};
  }

  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  [[nodiscard]] std::string limit_text() const { return std::to_string(left_ + total_) + " bytes"; }

  std::string name_;
  std::size_t left_;
  std::size_t total_ = 0;
  std::unique_ptr<gzFile_s, CloseGzip> gzip_;
  std::array<char, 1 << 16> buffer_;
};

/// Text may come in any encoding that keeps ASCII: hosts and comments of old logs are Latin-1. Blanks aside, none holds
/// control characters.
void reject_binary(std::string_view line, SourcePlace place) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    const auto byte = static_cast<unsigned char>(line[i]);
    if ((byte >= 0x20 && byte != 0x7F) || (byte >= '\t' && byte <= '\r')) continue;
    place.column = static_cast<int>(i) + 1;
    throw InputError(place, "expected a text file, found binary content");
  }
}

}  // namespace

struct LineReader::State {
  ByteSource source;
  std::size_t line_bytes;
  int lines;
  std::string_view piece{};  // what is left of the last piece read
  std::string line{};
  int number = 0;
};

LineReader::LineReader(const std::filesystem::path& file, TextLimits limits)
    : state_(new State{ByteSource(file, limits.file_bytes), limits.line_bytes, limits.lines}) {}
LineReader::~LineReader() = default;
LineReader::LineReader(LineReader&&) noexcept = default;
LineReader& LineReader::operator=(LineReader&&) noexcept = default;

bool LineReader::next() {
  State& s = *state_;
  ++s.number;
  s.line.clear();
  bool ended = false;
  while (!ended) {
    if (s.piece.empty()) s.piece = s.source.read(place());
    if (s.piece.empty()) break;
    const std::size_t end = s.piece.find('\n');
    ended = end != std::string_view::npos;
    s.line += s.piece.substr(0, end);
    s.piece.remove_prefix(ended ? end + 1 : s.piece.size());
    if (s.line.size() > s.line_bytes) {
      throw InputError(place(), "line is too long, expected at most " + std::to_string(s.line_bytes) + " bytes");
    }
  }
  const bool found = ended || !s.line.empty();
  if (!s.line.empty() && s.line.back() == '\r') s.line.pop_back();
  if (!found) --s.number;
  if (s.number > s.lines) throw InputError(place(), "too many lines, expected at most " + std::to_string(s.lines));
  reject_binary(s.line, place());
  return found;
}

std::string_view LineReader::line() const { return state_->line; }

SourcePlace LineReader::place() const { return {state_->source.name(), state_->number, 0}; }

std::string read_text_file(const std::filesystem::path& file, std::size_t max_bytes) {
  ByteSource source(file, max_bytes);
  std::string text;
  for (;;) {
    const std::string_view piece = source.read({source.name()});
    if (piece.empty()) return text;
    text += piece;
  }
}

}  // namespace cogslam
