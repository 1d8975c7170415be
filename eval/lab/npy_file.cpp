#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/text_file.hpp"
#include "eval/lab/map_source.hpp"

namespace cogslam {
namespace {

constexpr std::size_t kMostBytes = kMostFileCells * sizeof(double) + 65536 + 10;
constexpr std::size_t kPreamble = 10;  // magic, version, length of the header

std::uint64_t little_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

/// What stands in a header behind `'key': `, up to `end`.
std::string_view entry(std::string_view header, std::string_view key, char end) {
  const std::size_t at = header.find(key);
  if (at == std::string_view::npos) return {};
  std::string_view rest = header.substr(at + key.size());
  while (rest.starts_with(' ') || rest.starts_with(':')) rest.remove_prefix(1);
  return rest.substr(0, rest.find(end));
}

struct Shape {
  std::int64_t height = 0, width = 0;
};

/// "(40, 46" as rows and columns.
std::optional<Shape> shape_of(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (!text.starts_with('(') || comma == std::string_view::npos) return std::nullopt;
  std::string_view second = text.substr(comma + 1);
  while (second.starts_with(' ')) second.remove_prefix(1);
  const auto height = parse_whole_number(text.substr(1, comma - 1)), width = parse_whole_number(second);
  const std::int64_t most = 1 << 20;
  if (!height || !width || *height < 1 || *width < 1 || *height > most || *width > most) return std::nullopt;
  return Shape{*height, *width};
}

}  // namespace

Grid<float> read_npy(const std::filesystem::path& file) {
  const std::string bytes = read_text_file(file, kMostBytes);
  const auto fail = [&](const std::string& what) { throw InputError({file.string()}, what); };
  const std::string_view all(bytes);
  if (all.size() < kPreamble || !all.starts_with("\x93NUMPY\x01"))
    fail("is no NumPy file of version 1, expected one that begins with \\x93NUMPY\\x01");
  const std::size_t length = little_endian(all.substr(8, 2));
  if (all.size() < kPreamble + length)
    fail("cut off within its header, expected " + std::to_string(length) + " bytes of it");
  const std::string_view header = all.substr(kPreamble, length);
  const bool wide = entry(header, "'descr'", ',') == "'<f8'";
  if (!wide && entry(header, "'descr'", ',') != "'<f4'") fail("expected float32 or float64 values ('<f4' or '<f8')");
  if (entry(header, "'fortran_order'", ',') != "False") fail("expected C order ('fortran_order': False)");
  const auto shape = shape_of(entry(header, "'shape'", ')'));
  if (!shape)
    fail("has the shape " + printable(entry(header, "'shape'", ')')) + "), expected two dimensions, rows and columns");
  const std::size_t size = wide ? 8 : 4, cells = static_cast<std::size_t>(shape->height * shape->width);
  if (cells > kMostFileCells) fail("has " + std::to_string(cells) + " values, expected at most 67108864");
  const std::string_view data = all.substr(kPreamble + length);
  if (data.size() != cells * size) {
    fail("holds " + std::to_string(data.size()) + " bytes of values, expected " + std::to_string(cells * size));
  }
  Grid<float> map({.width = static_cast<int>(shape->width), .height = static_cast<int>(shape->height)});
  for (std::size_t i = 0; i < cells; ++i) {
    const std::uint64_t bits = little_endian(data.substr(i * size, size));
    const double value = wide ? std::bit_cast<double>(bits)
                              : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    map.values()[i] = static_cast<float>(value);
    if (!std::isfinite(map.values()[i]))
      fail("value " + std::to_string(i + 1) + " is " + number_text(value) + ", expected finite floats");
  }
  return map;
}

}  // namespace cogslam
