#include "eval/page/packed.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <limits>

#include "core/rng.hpp"

namespace cogslam {
namespace {

std::string unbase64(const std::string& text) {
  std::string bytes;
  std::uint32_t group = 0;
  int bits = 0;
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (const char c : text) {
    if (c == '=') break;
    group = group << 6 | static_cast<std::uint32_t>(digits.find(c));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>((group >> bits) & 0xFF);
  }
  return bytes;
}

std::string inflated(const std::string& bytes) {
  std::string out(1 << 20, '\0');
  uLongf size = out.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                       bytes.size()),
            Z_OK);
  out.resize(size);
  return out;
}

/// The slow reader: what the page's script does.
std::vector<double> read_back(const PackedColumns& columns) {
  const std::string bytes = inflated(unbase64(columns.text()));
  std::vector<double> values;
  std::size_t at = 0;
  for (const ColumnHead& head : columns.heads()) {
    std::int64_t steps = 0;
    for (std::size_t i = 0; i < head.count; ++i) {
      std::uint64_t number = 0;
      for (unsigned shift = 0;; shift += 7) {
        const auto byte = static_cast<std::uint8_t>(bytes.at(at++));
        number |= static_cast<std::uint64_t>(byte & 0x7F) << shift;
        if (byte < 0x80) break;
      }
      const auto value = static_cast<std::int64_t>(number >> 1) ^ -static_cast<std::int64_t>(number & 1);
      steps = head.packing == Packing::kDifference ? steps + value : value;
      values.push_back(steps == PackedColumns::kMissing ? std::nan("") : static_cast<double>(steps) * head.unit);
    }
  }
  EXPECT_EQ(at, bytes.size());
  return values;
}

TEST(Base64, GivesTheVectorsOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xFF\x00\xFE", 3)), "/wD+");
}

TEST(PackedColumns, ReadBackWithinHalfAStep) {
  Rng rng({3, Purpose::kWorld, 0, 0});
  std::vector<double> plain, path;
  for (int i = 0; i < 500; ++i) {
    plain.push_back(rng.uniform(-100.0, 100.0));
    path.push_back((path.empty() ? 0.0 : path.back()) + rng.uniform(-0.1, 0.1));
  }
  PackedColumns columns;
  columns.add("plain", plain, 0.01, Packing::kPlain);
  columns.add("path", path, 1e-4, Packing::kDifference);
  const std::vector<double> back = read_back(columns);
  ASSERT_EQ(back.size(), 1000U);
  for (std::size_t i = 0; i < 500; ++i) {
    EXPECT_NEAR(back[i], plain[i], 0.00501);
    EXPECT_NEAR(back[500 + i], path[i], 0.0000501);
  }
}

TEST(PackedColumns, KeepWhatIsNotFiniteApartAndCutOffWhatIsHuge) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (const Packing packing : {Packing::kPlain, Packing::kDifference}) {
    PackedColumns columns;
    columns.add("odd", {1.0, nan, -2.0, inf, -inf, 1e300, -1e300, 0.0}, 1.0, packing);
    const double most = std::ldexp(1.0, 30);
    EXPECT_THAT(read_back(columns), testing::ElementsAre(1.0, testing::IsNan(), -2.0, testing::IsNan(),
                                                         testing::IsNan(), most, -most, 0.0));
  }
}

TEST(PackedColumns, HoldNothingAsNothing) {
  PackedColumns columns;
  columns.add("none", {}, 1.0, Packing::kPlain);
  EXPECT_TRUE(read_back(columns).empty());
  EXPECT_EQ(columns.heads().front().count, 0U);
}

}  // namespace
}  // namespace cogslam
