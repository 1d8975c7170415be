#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cogslam {

/// Standard base64 with padding (RFC 4648, section 4).
std::string base64(std::string_view bytes);

/// A zlib stream (RFC 1950) of the bytes.
std::string deflated(std::string_view bytes);

/// How the numbers of a column follow each other.
enum class Packing {
  kPlain,       ///< as they are
  kDifference,  ///< each less the one before: for paths
};

/// One column as the page reads it: numbers are steps of `unit`.
struct ColumnHead {
  std::string name;
  std::size_t count = 0;
  double unit = 1.0;
  Packing packing = Packing::kPlain;
};

/// Columns of numbers for a browser: whole steps of a unit, as zigzag LEB128 numbers (as in Protocol Buffers), one
/// column after the other, deflated and in base64. `eval/page/web/src/packed.js` reads them.
class PackedColumns {
 public:
  /// In place of a number that is not finite.
  static constexpr std::int64_t kMissing = -(std::int64_t{1} << 31);

  /// Rounds to steps of `unit`; steps beyond +-2^30 are cut off there.
  void add(const std::string& name, const std::vector<double>& values, double unit, Packing packing);

  [[nodiscard]] const std::vector<ColumnHead>& heads() const { return heads_; }
  [[nodiscard]] std::string text() const { return base64(deflated(bytes_)); }

 private:
  std::vector<ColumnHead> heads_;
  std::string bytes_;
};

}  // namespace cogslam
