#include <png.h>

#include <csetjmp>
#include <cstring>

#include "core/error.hpp"
#include "worlds/map_image.hpp"

namespace cogslam {
namespace {

/// What libpng reads from, and what it said when it gave up.
struct PngBytes {
  const std::string& bytes;
  std::size_t at = 0;
  char reason[120] = {};
};

void give(png_structp png, png_bytep to, std::size_t count) {
  auto& source = *static_cast<PngBytes*>(png_get_io_ptr(png));
  if (source.bytes.size() - source.at < count) png_error(png, "cut off");
  std::memcpy(to, source.bytes.data() + source.at, count);
  source.at += count;
}

[[noreturn]] void note_error(png_structp png, png_const_charp message) {
  auto& source = *static_cast<PngBytes*>(png_get_error_ptr(png));
  std::strncpy(source.reason, message, sizeof source.reason - 1);
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

/// A reader that is gone again with the object.
struct PngReader {
  explicit PngReader(PngBytes& source)
      : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, note_error, ignore_warning)),
        info(png != nullptr ? png_create_info_struct(png) : nullptr) {
    if (info == nullptr) throw std::bad_alloc();
    png_set_read_fn(png, &source, give);
    png_set_user_limits(png, MapImage::kMaxSide, MapImage::kMaxSide);
  }
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  png_structp png;
  png_infop info;
};

/// libpng leaves by longjmp: between here and there nothing may need a destructor. False where it did.
bool read_header(PngReader& reader) {
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  png_read_info(reader.png, reader.info);
  png_set_expand(reader.png);  // palettes and few bits to 8, a transparent colour to alpha
  png_set_scale_16(reader.png);
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  return true;
}

bool read_rows(PngReader& reader, png_bytepp rows) {
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  png_read_image(reader.png, rows);
  png_read_end(reader.png, nullptr);
  return true;
}

/// libpng would only say that the header is invalid. The size stands behind the magic, and a chunk's length and name.
void check_promised_size(const std::string& bytes, const std::string& name) {
  constexpr std::size_t kHead = 16;
  if (bytes.size() < kHead + 8) return;
  const auto word = [&](std::size_t at) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
  };
  check_image_size(word(kHead), word(kHead + 4), name);
}

}  // namespace

MapImage decode_png(const std::string& bytes, const std::string& name) {
  check_promised_size(bytes, name);
  PngBytes source{bytes};
  PngReader reader(source);
  const auto fail = [&] {
    throw InputError({name}, std::string("broken PNG: ") + source.reason + ", expected a whole picture");
  };
  if (!read_header(reader)) fail();
  const png_uint_32 width = png_get_image_width(reader.png, reader.info);
  const png_uint_32 height = png_get_image_height(reader.png, reader.info);
  check_image_size(width, height, name);

  const std::size_t row_bytes = png_get_rowbytes(reader.png, reader.info);
  std::vector<png_byte> pixels(row_bytes * height);
  std::vector<png_bytep> rows(height);
  for (std::size_t y = 0; y < height; ++y) rows[y] = pixels.data() + y * row_bytes;
  if (!read_rows(reader, rows.data())) fail();

  const std::size_t channels = png_get_channels(reader.png, reader.info), colours = channels < 3 ? 1 : 3;
  MapImage image{.width = static_cast<int>(width), .height = static_cast<int>(height)};
  image.white = 255 * static_cast<std::uint32_t>(colours);
  image.grey.resize(std::size_t{width} * height);
  if (channels > colours) image.clear.resize(image.grey.size());
  for (std::size_t i = 0; i < image.grey.size(); ++i) {
    const png_byte* pixel = rows[i / width] + i % width * channels;
    for (std::size_t k = 0; k < colours; ++k) image.grey[i] = static_cast<std::uint16_t>(image.grey[i] + pixel[k]);
    if (channels > colours) image.clear[i] = pixel[colours] < 255 ? 1 : 0;
  }
  return image;
}

}  // namespace cogslam
