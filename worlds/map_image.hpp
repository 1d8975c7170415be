#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cogslam {

/// Grey values of a picture, exactly as they stand in the file.
struct MapImage {
  static constexpr int kMaxSide = 16384;
  static constexpr std::size_t kMaxPixels = std::size_t{1} << 24;

  int width = 0;
  int height = 0;
  std::uint32_t white = 255;        ///< the value of white; 3 x 255 where a pixel is the sum of red, green and blue
  std::vector<std::uint16_t> grey;  ///< row-major, the top row first, 0 to white
  std::vector<std::uint8_t> clear;  ///< 1 where a pixel is not opaque; empty where all are
};

/// Reads a PGM (P2 or P5, up to 16 bits) or a PNG (any kind; of 16 bits the upper 8 count), told apart by content;
/// plain or gzipped. Throws InputError naming the file, and for the text part of a PGM line and column, where it cannot
/// be read, is neither, is cut off, or is larger than kMaxSide or kMaxPixels.
MapImage read_map_image(const std::filesystem::path& file);

/// The parts of it: `name` stands for the file in errors.
MapImage decode_pgm(const std::string& bytes, const std::string& name);
MapImage decode_png(const std::string& bytes, const std::string& name);

/// Throws InputError where a picture of this size has no pixel or too many.
void check_image_size(std::uint64_t width, std::uint64_t height, const std::string& name);

}  // namespace cogslam
