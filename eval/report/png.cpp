#include "eval/report/png.hpp"

#include <png.h>

#include "core/check.hpp"

namespace cogslam {

std::string png_bytes(int width, int height, std::span<const std::uint8_t> rgb) {
  EXPECTS(width > 0 && height > 0);
  EXPECTS(rgb.size() == 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB;
  // Called twice, as libpng asks: once for the size, once for the bytes.
  png_alloc_size_t size = 0;
  ENSURES(png_image_write_to_memory(&image, nullptr, &size, 0, rgb.data(), 0, nullptr) != 0);
  std::string bytes(size, '\0');
  ENSURES(png_image_write_to_memory(&image, bytes.data(), &size, 0, rgb.data(), 0, nullptr) != 0);
  bytes.resize(size);
  return bytes;
}

}  // namespace cogslam
