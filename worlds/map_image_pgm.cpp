#include <algorithm>
#include <cctype>

#include "core/error.hpp"
#include "worlds/map_image.hpp"

namespace cogslam {
namespace {

/// The words of a PGM, its comments left out.
class PgmText {
 public:
  PgmText(const std::string& bytes, const std::string& name) : bytes_(bytes), name_(name) { at_ = 2; }

  /// The next whole number, at most `most`.
  std::uint32_t number(const char* what, std::uint32_t most) {
    skip_space();
    const std::size_t begin = at_;
    std::uint64_t value = 0;
    while (at_ < bytes_.size() && std::isdigit(byte(at_)) != 0 && at_ - begin < 10) {
      value = 10 * value + static_cast<std::uint64_t>(bytes_[at_++] - '0');
    }
    const std::string expected = "expected a whole number up to " + std::to_string(most);
    if (at_ == begin) fail(begin, std::string(what) + ": " + expected);
    if (value > most || (at_ < bytes_.size() && std::isspace(byte(at_)) == 0 && bytes_[at_] != '#')) {
      while (at_ < bytes_.size() && std::isgraph(byte(at_)) != 0 && at_ - begin < 20) ++at_;
      fail(begin, std::string(what) + ": " + expected + ", found '" + bytes_.substr(begin, at_ - begin) + "'");
    }
    return static_cast<std::uint32_t>(value);
  }

  /// Where binary pixels begin: one white space after the last number.
  [[nodiscard]] std::size_t pixels_begin() const { return at_ + 1; }

  /// Whether nothing but white space and comments is left.
  bool at_end() {
    skip_space();
    return at_ == bytes_.size();
  }

 private:
  [[nodiscard]] int byte(std::size_t i) const { return static_cast<unsigned char>(bytes_[i]); }

  void skip_space() {
    while (at_ < bytes_.size()) {
      if (bytes_[at_] == '#') {
        while (at_ < bytes_.size() && bytes_[at_] != '\n') ++at_;
      } else if (std::isspace(byte(at_)) != 0) {
        ++at_;
      } else {
        return;
      }
    }
  }

  [[noreturn]] void fail(std::size_t at, const std::string& message) const {
    SourcePlace place{name_, 1, 1};
    for (std::size_t i = 0; i < at; ++i) {
      place.column = bytes_[i] == '\n' ? 1 : place.column + 1;
      place.line += bytes_[i] == '\n' ? 1 : 0;
    }
    throw InputError(place, message);
  }

  const std::string& bytes_;
  const std::string& name_;
  std::size_t at_ = 0;
};

[[noreturn]] void fail_size(const MapImage& image, std::size_t found, const std::string& name) {
  throw InputError({name}, "cut off after " + std::to_string(found) + " pixels, expected " +
                               std::to_string(image.width) + " x " + std::to_string(image.height));
}

void take_binary(const std::string& bytes, std::size_t begin, std::size_t count, MapImage& image,
                 const std::string& name) {
  const std::size_t width = image.white > 255 ? 2 : 1;
  const std::size_t found = begin < bytes.size() ? (bytes.size() - begin) / width : 0;
  if (found < count) fail_size(image, found, name);
  image.grey.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < width; ++k)
      value = value << 8 | static_cast<unsigned char>(bytes[begin + i * width + k]);
    if (value > image.white) {
      throw InputError({name}, "pixel " + std::to_string(i) + " is " + std::to_string(value) + ", expected at most " +
                                   std::to_string(image.white));
    }
    image.grey[i] = static_cast<std::uint16_t>(value);
  }
  if (bytes.size() - begin > count * width) {
    throw InputError({name}, std::to_string(bytes.size() - begin - count * width) + " bytes follow the " +
                                 std::to_string(image.width) + " x " + std::to_string(image.height) +
                                 " pixels, expected the end of the file");
  }
}

}  // namespace

MapImage decode_pgm(const std::string& bytes, const std::string& name) {
  PgmText text(bytes, name);
  const std::uint32_t width = text.number("width", 1'000'000'000), height = text.number("height", 1'000'000'000);
  check_image_size(width, height, name);
  MapImage image{.width = static_cast<int>(width), .height = static_cast<int>(height)};
  image.white = text.number("the value of white", 65535);
  if (image.white == 0) throw InputError({name}, "the value of white is 0, expected at least 1");
  const std::size_t count = std::size_t{width} * height;
  if (bytes[1] == '5') {
    take_binary(bytes, text.pixels_begin(), count, image, name);
    return image;
  }
  image.grey.reserve(std::min(count, bytes.size()));  // a header may promise much more than follows
  for (std::size_t i = 0; i < count; ++i) {
    if (text.at_end()) fail_size(image, i, name);
    image.grey.push_back(static_cast<std::uint16_t>(text.number("a pixel", image.white)));
  }
  if (!text.at_end()) throw InputError({name}, "text follows the last pixel, expected the end of the file");
  return image;
}

}  // namespace cogslam
