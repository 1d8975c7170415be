#include "slam/codec/coefficient_code.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <vector>

#include "core/check.hpp"

namespace cogslam {
namespace {

using testing::Each;
using testing::ElementsAre;

TEST(FastL2, PutsValuesInTheirPlacesAndZerosElsewhere) {
  std::vector<float> coefficients(6, std::numeric_limits<float>::quiet_NaN());
  reconstruct_fast_l2({{1, 4}, {-2.0F, 3.5F}}, coefficients);
  EXPECT_THAT(coefficients, ElementsAre(0.0F, -2.0F, 0.0F, 0.0F, 3.5F, 0.0F));
  reconstruct_fast_l2({}, coefficients);
  EXPECT_THAT(coefficients, Each(0.0F));
}

TEST(FastL2, EqualsTheTransposeOfTheSelectionMatrix) {
  const CoefficientCode code{{0, 2, 3}, {1.5F, -4.0F, 8.0F}};
  constexpr std::size_t kSize = 5;
  std::vector<float> transposed(kSize, 0.0F);
  for (std::size_t i = 0; i < code.size(); ++i) {
    for (std::size_t j = 0; j < kSize; ++j) {
      const float h_ij = code.indices[i] == j ? 1.0F : 0.0F;
      transposed[j] += h_ij * code.values[i];
    }
  }
  std::vector<float> coefficients(kSize);
  reconstruct_fast_l2(code, coefficients);
  EXPECT_EQ(coefficients, transposed);
}

TEST(FastL2, RefusesACodeOfALargerMap) {
  std::vector<float> coefficients(4);
  EXPECT_THROW(reconstruct_fast_l2({{4}, {1.0F}}, coefficients), ContractViolation);
  EXPECT_THROW(reconstruct_fast_l2({{1, 2}, {1.0F}}, coefficients), ContractViolation);
}

TEST(PayloadBytes, CountsValuesAndPositions) {
  EXPECT_EQ(payload_bytes(736, 1873, IndexCoding::kU32), 736U * 8);
  EXPECT_EQ(payload_bytes(736, 1873, IndexCoding::kU16), 736U * 6);
  EXPECT_EQ(payload_bytes(736, 1873, IndexCoding::kBitmap), 736U * 4 + 235);
  EXPECT_EQ(payload_bytes(0, 8, IndexCoding::kBitmap), 1U);
  EXPECT_EQ(payload_bytes(0, 9, IndexCoding::kBitmap), 2U);
}

TEST(PayloadBytes, SaysWhereACodingCannotCountThatFar) {
  EXPECT_EQ(payload_bytes(3, 65536, IndexCoding::kU16), 18U);
  EXPECT_EQ(payload_bytes(3, 65537, IndexCoding::kU16), std::nullopt);
  EXPECT_EQ(payload_bytes(3, (std::size_t{1} << 32) + 1, IndexCoding::kU32), std::nullopt);
  EXPECT_THROW(payload_bytes(5, 4, IndexCoding::kBitmap), ContractViolation);
}

TEST(CheapestPayload, IsTheBitmapForManyAndAnIndexForFew) {
  EXPECT_EQ(cheapest_payload(736, 1873), (Payload{IndexCoding::kBitmap, 736 * 4 + 235}));
  EXPECT_EQ(cheapest_payload(10, 1873), (Payload{IndexCoding::kU16, 60}));
  EXPECT_EQ(cheapest_payload(10, 1U << 20), (Payload{IndexCoding::kU32, 80}));
  EXPECT_EQ(cheapest_payload(0, 1873), (Payload{IndexCoding::kU32, 0}));
}

}  // namespace
}  // namespace cogslam
