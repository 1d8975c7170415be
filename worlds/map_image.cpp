#include "worlds/map_image.hpp"

#include "core/error.hpp"
#include "core/text_file.hpp"

namespace cogslam {
namespace {

// A P2 of the largest picture, each pixel five digits and a space, and a line of comment.
constexpr std::size_t kMaxFileBytes = 6 * MapImage::kMaxPixels + 1'000;

}  // namespace

MapImage read_map_image(const std::filesystem::path& file) {
  const std::string bytes = read_text_file(file, kMaxFileBytes), name = file.string();
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return decode_png(bytes, name);
  if (bytes.starts_with("P2") || bytes.starts_with("P5")) return decode_pgm(bytes, name);
  throw InputError({name}, "neither PGM (P2, P5) nor PNG, expected one of them");
}

void check_image_size(std::uint64_t width, std::uint64_t height, const std::string& name) {
  const std::uint64_t side = MapImage::kMaxSide, most = MapImage::kMaxPixels;
  const std::string found = std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (width == 0 || height == 0) throw InputError({name}, found + ", expected at least one");
  if (width > side || height > side || width * height > most) {
    throw InputError({name}, found + ", expected at most " + std::to_string(side) + " each way and " +
                                 std::to_string(most) + " in all");
  }
}

}  // namespace cogslam
