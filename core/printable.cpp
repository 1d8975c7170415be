#include "core/printable.hpp"

#include <algorithm>

namespace cogslam {

std::size_t printable_size(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7F ? 1 : 0;
  const std::size_t size = first >= 0xF5 ? 0 : first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC2 ? 2 : 0;
  if (size == 0 || size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i) {
    if (byte(i) < 0x80 || byte(i) > 0xBF) return 0;
  }
  const bool control = first == 0xC2 && byte(1) < 0xA0;
  const bool overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
  const bool no_character = (first == 0xED && byte(1) >= 0xA0) || (first == 0xF4 && byte(1) >= 0x90);
  return control || overlong || no_character ? 0 : size;
}

std::string printable(std::string_view text, std::size_t longest) {
  static constexpr char kDigits[] = "0123456789ABCDEF";
  std::string out;
  while (!text.empty()) {
    const std::size_t size = printable_size(text);
    std::string piece(text.substr(0, size));
    if (size == 0) {
      const auto byte = static_cast<unsigned char>(text[0]);
      piece = {'\\', 'x', kDigits[byte >> 4], kDigits[byte & 0xF]};
    }
    if (out.size() + piece.size() > longest) return out + "...";
    out += piece;
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return out;
}

std::string in_quotes(std::string_view text, std::size_t longest) { return "'" + printable(text, longest) + "'"; }

}  // namespace cogslam
