#include "slam/codec/haar.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "core/check.hpp"
#include "core/rng.hpp"
#include "tests/support/slow_haar.hpp"

namespace cogslam {
namespace {

Rng random_stream(std::uint32_t seed) { return Rng({.seed = seed, .purpose = Purpose::kWorld}); }

template <class T>
std::vector<T> random_values(std::size_t count, Rng& rng) {
  std::vector<T> values(count);
  for (T& value : values) {
    value = static_cast<T>(rng.normal());
  }
  return values;
}

// Buffers start as NaN, so that a value that is read before it is written, or never written, shows.
template <class T>
std::vector<T> unset(std::size_t count) {
  return std::vector<T>(count, std::numeric_limits<T>::quiet_NaN());
}

template <class T>
std::vector<T> forward(const HaarCanvas& canvas, const std::vector<T>& values) {
  std::vector<T> coefficients = unset<T>(canvas.size());
  std::vector<T> scratch = unset<T>(canvas.scratch_size());
  haar_forward(canvas, values, coefficients, scratch);
  return coefficients;
}

template <class T>
std::vector<T> inverse(const HaarCanvas& canvas, const std::vector<T>& coefficients) {
  std::vector<T> values = unset<T>(canvas.cells());
  std::vector<T> scratch = unset<T>(canvas.scratch_size());
  haar_inverse(canvas, coefficients, values, scratch);
  return values;
}

template <class T>
double dot(const std::vector<T>& a, const std::vector<T>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

template <class T>
void expect_near(const std::vector<T>& actual, const std::vector<T>& expected, double tolerance) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) {
    ASSERT_NEAR(actual[i], expected[i], tolerance) << "at " << i;
  }
}

std::vector<double> read_csv(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<double> values;
  for (std::string line; std::getline(file, line);) {
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) {
      values.push_back(std::stod(field));
    }
  }
  return values;
}

std::filesystem::path oracle() { return std::filesystem::path(COGSLAM_SOURCE_DIR) / "../shared/oracle"; }

// Sides of every kind: one, odd, just above and below powers of two, long and thin, at random.
std::vector<HaarCanvas> assorted_canvases() {
  std::vector<HaarCanvas> canvases;
  for (const auto& [width, height] : {std::pair{1, 1},
                                      {1, 2},
                                      {2, 1},
                                      {1, 13},
                                      {13, 1},
                                      {2, 2},
                                      {3, 3},
                                      {4, 4},
                                      {5, 3},
                                      {16, 16},
                                      {17, 15},
                                      {40, 46},
                                      {33, 2},
                                      {2, 33},
                                      {64, 8},
                                      {8, 64}}) {
    canvases.push_back(HaarCanvas::covering(width, height));
  }
  Rng rng = random_stream(11);
  for (int i = 0; i < 30; ++i) {
    const int width = 1 + static_cast<int>(rng.below(70));
    canvases.push_back(HaarCanvas::covering(width, 1 + static_cast<int>(rng.below(70))));
  }
  return canvases;
}

std::string name_of(const HaarCanvas& canvas) {
  return std::to_string(canvas.map_width) + " x " + std::to_string(canvas.map_height);
}

TEST(HaarCanvas, GrowsEachSideToAPowerOfTwo) {
  const HaarCanvas canvas = HaarCanvas::covering(40, 70);
  EXPECT_EQ(canvas.width, 64);
  EXPECT_EQ(canvas.height, 128);
  EXPECT_EQ(canvas.levels, 7);
  EXPECT_EQ(canvas.square_levels(), 6);
  EXPECT_EQ(canvas.cells(), 2800U);
  EXPECT_EQ(canvas.size(), 8192U);
}

TEST(HaarCanvas, RefusesAMapWithoutCells) {
  EXPECT_THROW(HaarCanvas::covering(0, 4), ContractViolation);
  EXPECT_THROW(HaarCanvas::covering(4, 40000), ContractViolation);
}

TEST(HaarCanvas, SupportCountsTheCoefficientsThatCanDifferFromZero) {
  EXPECT_EQ(HaarCanvas::covering(40, 46).support(), 1873U);
  EXPECT_EQ(HaarCanvas::covering(64, 64).support(), 4096U);
  Rng rng = random_stream(12);
  for (const HaarCanvas& canvas : assorted_canvases()) {
    const std::vector<double> coefficients = forward(canvas, random_values<double>(canvas.cells(), rng));
    const auto zeros = std::count(coefficients.begin(), coefficients.end(), 0.0);
    EXPECT_EQ(canvas.size() - static_cast<std::size_t>(zeros), canvas.support()) << name_of(canvas);
  }
}

TEST(Haar, IsTheInnerProductWithEachHaarFunction) {
  Rng rng = random_stream(1);
  for (const auto& [width, height] : {std::pair{1, 1}, {4, 4}, {8, 8}, {7, 5}, {2, 8}, {16, 4}, {1, 8}, {9, 1}}) {
    const HaarCanvas canvas = HaarCanvas::covering(width, height);
    const std::vector<double> map = random_values<double>(canvas.cells(), rng);
    const std::vector<double> image = slow::padded(map, width, height, canvas.width, canvas.height);
    const std::vector<double> coefficients = forward(canvas, map);
    for (int row = 0; row < canvas.height; ++row) {
      for (int column = 0; column < canvas.width; ++column) {
        EXPECT_NEAR(coefficients[static_cast<std::size_t>(row * canvas.width + column)],
                    dot(slow::haar_function(canvas.width, canvas.height, column, row), image), 1e-13)
            << name_of(canvas) << ", coefficient " << column << ", " << row;
      }
    }
  }
}

TEST(Haar, EqualsTheTextbookTransformOfThePaddedMap) {
  Rng rng = random_stream(2);
  for (const HaarCanvas& canvas : assorted_canvases()) {
    SCOPED_TRACE(name_of(canvas));
    const std::vector<double> map = random_values<double>(canvas.cells(), rng);
    std::vector<double> twin = slow::padded(map, canvas.map_width, canvas.map_height, canvas.width, canvas.height);
    slow::haar_rows_then_columns(canvas.width, canvas.height, twin);
    expect_near(forward(canvas, map), twin, 1e-13);
    const std::vector<float> map_float(map.begin(), map.end());
    expect_near(forward(canvas, map_float), std::vector<float>(twin.begin(), twin.end()), 3e-6);
  }
}

TEST(Haar, KeepsTheNorm) {
  Rng rng = random_stream(3);
  for (const HaarCanvas& canvas : assorted_canvases()) {
    const std::vector<double> map = random_values<double>(canvas.cells(), rng);
    const std::vector<double> coefficients = forward(canvas, map);
    EXPECT_NEAR(dot(coefficients, coefficients), dot(map, map), 1e-12 * dot(map, map)) << name_of(canvas);
  }
}

TEST(Haar, InverseUndoesForward) {
  Rng rng = random_stream(4);
  for (const HaarCanvas& canvas : assorted_canvases()) {
    SCOPED_TRACE(name_of(canvas));
    const std::vector<double> map = random_values<double>(canvas.cells(), rng);
    expect_near(inverse(canvas, forward(canvas, map)), map, 1e-13);
    const std::vector<float> map_float(map.begin(), map.end());
    expect_near(inverse(canvas, forward(canvas, map_float)), map_float, 3e-6);
  }
}

TEST(Haar, InverseIsTheAdjointOfForward) {
  Rng rng = random_stream(5);
  for (const HaarCanvas& canvas : assorted_canvases()) {
    const std::vector<double> map = random_values<double>(canvas.cells(), rng);
    const std::vector<double> coefficients = random_values<double>(canvas.size(), rng);
    EXPECT_NEAR(dot(forward(canvas, map), coefficients), dot(map, inverse(canvas, coefficients)), 1e-11)
        << name_of(canvas);
  }
}

TEST(Haar, ForwardUndoesInverseOnAMapThatFillsItsCanvas) {
  Rng rng = random_stream(6);
  for (const auto& [width, height] : {std::pair{1, 1}, {32, 32}, {8, 64}, {64, 8}, {1, 16}}) {
    const HaarCanvas canvas = HaarCanvas::covering(width, height);
    const std::vector<double> coefficients = random_values<double>(canvas.size(), rng);
    expect_near(forward(canvas, inverse(canvas, coefficients)), coefficients, 1e-13);
  }
}

TEST(Haar, IsLinear) {
  Rng rng = random_stream(7);
  for (const HaarCanvas& canvas : assorted_canvases()) {
    SCOPED_TRACE(name_of(canvas));
    const std::vector<double> a = random_values<double>(canvas.cells(), rng);
    const std::vector<double> b = random_values<double>(canvas.cells(), rng);
    const std::vector<double> c_a = forward(canvas, a);
    const std::vector<double> c_b = forward(canvas, b);
    std::vector<double> sum(a.size());
    std::vector<double> c_sum(c_a.size());
    std::transform(a.begin(), a.end(), b.begin(), sum.begin(), [](double x, double y) { return 2.5 * x - 0.3 * y; });
    std::transform(c_a.begin(), c_a.end(), c_b.begin(), c_sum.begin(),
                   [](double x, double y) { return 2.5 * x - 0.3 * y; });
    expect_near(forward(canvas, sum), c_sum, 1e-13);
  }
}

TEST(Haar, GivesAFlatCanvasOneCoefficient) {
  for (const auto& [width, height] : {std::pair{16, 16}, {4, 64}, {128, 2}}) {
    const HaarCanvas canvas = HaarCanvas::covering(width, height);
    const std::vector<float> coefficients = forward(canvas, std::vector<float>(canvas.cells(), 3.0F));
    EXPECT_NEAR(coefficients[0], 3.0 * std::sqrt(width * height), 1e-4);
    EXPECT_EQ(std::count(coefficients.begin(), coefficients.end(), 0.0F), width * height - 1);
  }
}

TEST(Haar, RefusesBuffersOfTheWrongSize) {
  const HaarCanvas canvas = HaarCanvas::covering(5, 5);
  std::vector<float> map(25);
  std::vector<float> coefficients(64);
  std::vector<float> scratch(canvas.scratch_size() - 1);
  EXPECT_THROW(haar_forward(canvas, map, coefficients, scratch), ContractViolation);
  EXPECT_THROW(haar_inverse(canvas, coefficients, map, scratch), ContractViolation);
  scratch.resize(canvas.scratch_size());
  EXPECT_THROW(haar_forward(canvas, coefficients, coefficients, scratch), ContractViolation);
  EXPECT_THROW(haar_inverse(canvas, map, map, scratch), ContractViolation);
}

TEST(Haar, ReproducesTheReferenceCoefficients) {
  const std::vector<double> map = read_csv(oracle() / "maps/room64_ideal_logodds.csv");
  const std::vector<double> reference = read_csv(oracle() / "golden/haar2d_ideal.csv");
  if (map.empty() || reference.empty()) {
    GTEST_SKIP() << "reference files not found under " << oracle();
  }
  const HaarCanvas canvas = HaarCanvas::covering(64, 64);
  const std::vector<double> coefficients = forward(canvas, map);
  expect_near(coefficients, reference, 1e-12);
  expect_near(inverse(canvas, reference), map, 1e-12);
  EXPECT_NEAR(dot(coefficients, coefficients), 43824.0, 1e-9);
  EXPECT_EQ(canvas.size() - static_cast<std::size_t>(std::count(coefficients.begin(), coefficients.end(), 0.0)), 423U);
}

}  // namespace
}  // namespace cogslam
