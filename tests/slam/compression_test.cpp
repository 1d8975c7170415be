#include "slam/map/compression.hpp"

#include <gmock/gmock.h>

#include <array>

#include "tests/support/error_text.hpp"

namespace cogslam {
namespace {

constexpr std::array kBases{BasisKind::kHaar,  BasisKind::kHaarStandard, BasisKind::kHaar1d,  BasisKind::kDct,
                            BasisKind::kDct1d, BasisKind::kHadamard,     BasisKind::kIdentity};
constexpr std::array kCompressors{CompressorKind::kTopM,     CompressorKind::kSelection, CompressorKind::kGaussian,
                                  CompressorKind::kHadamard, CompressorKind::kDct,       CompressorKind::kNoiselet};

TEST(Compression, NamesWhatCannotGoTogether) {
  const auto trouble = [](const CompressionConfig& config, double percent, int width, int height) {
    const auto found = trouble_of(config, percent, width, height);
    return found ? found->key + ": " + found->message : "none";
  };
  EXPECT_EQ(trouble({.recovery = TotalVariation{}}, 40.0, 10, 10),
            "recovery: 'tv' fills in a map between cells that were kept: it needs basis 'identity' and compressor "
            "'selection', here 'haar' and 'top_m'");
  EXPECT_EQ(trouble({.basis = BasisKind::kDct, .compressor = CompressorKind::kHadamard}, 40.0, 10, 10),
            "compressor: 'hadamard' needs a power of two of coefficients, but basis 'dct' has 100 for this map; the "
            "Haar bases and 'hadamard' pad to one");
  EXPECT_EQ(trouble({.basis = BasisKind::kDct, .compressor = CompressorKind::kHadamard}, 40.0, 8, 16), "none");
  EXPECT_EQ(trouble({.compressor = CompressorKind::kGaussian}, 40.0, 300, 300),
            "compressor: 'gaussian' stores m x n numbers, at most 16777216, here 36000 x 262144");
  EXPECT_EQ(trouble({}, 40.0, 2, 40000),
            "basis: 'haar' takes maps of at most 32768 cells on a side, here 2 x 40000; 'haar_1d' takes any");
  const CompressionConfig tv{BasisKind::kIdentity, CompressorKind::kSelection, TotalVariation{}};
  EXPECT_EQ(trouble(tv, 0.1, 10, 10), "recovery: tv needs at least one known cell");
  EXPECT_EQ(trouble(tv, 1.0, 10, 10), "none");
  EXPECT_EQ(trouble({.recovery = KalmanCs{}}, 40.0, 100, 100).substr(0, 10), "recovery: ");
  EXPECT_EQ(trouble({.recovery = Nesta{}}, 40.0, 1000, 1000), "none");
}

CompressionConfig read_text(const std::string& text) {
  ConfigSection section = ConfigSection::parse(text, "store.yaml");
  CompressionConfig config;
  read_compression(section, config);
  section.finish();
  return config;
}

TEST(Compression, ReadsEveryPart) {
  EXPECT_TRUE(read_text("{}").is_papers_choice());
  const CompressionConfig cs = read_text(
      "{basis: dct_1d, compressor: noiselet, compressor_seed: 7, recovery: nesta, nesta: {eps: 0.5, continuation: 4}}");
  EXPECT_FALSE(cs.is_papers_choice());
  EXPECT_EQ(cs.basis, BasisKind::kDct1d);
  EXPECT_EQ(cs.compressor, CompressorKind::kNoiselet);
  EXPECT_EQ(cs.compressor_seed, 7U);
  EXPECT_EQ(std::get<Nesta>(cs.recovery).eps, 0.5);
  EXPECT_EQ(std::get<Nesta>(cs.recovery).continuation, 4);
  const CompressionConfig csekf_p = read_text("{recovery: csekf_p_gradient, csekf_p: {tau: 5}}");
  EXPECT_EQ(std::get<KalmanCsP>(csekf_p.recovery).reading, KalmanCsP::Reading::kTrueGradient);
  EXPECT_EQ(std::get<KalmanCsP>(csekf_p.recovery).tau, 5);
  EXPECT_EQ(std::get<KalmanCsP>(csekf_p.recovery).norm_variance, 1e8);
}

TEST(Compression, KnowsTheNamesOfAllParts) {
  for (const BasisKind kind : kBases) {
    EXPECT_EQ(read_text("basis: " + std::string(name_of(kind))).basis, kind);
  }
  for (const CompressorKind kind : kCompressors) {
    EXPECT_EQ(read_text("compressor: " + std::string(name_of(kind))).compressor, kind);
  }
  for (const std::string_view name : kRecoveryNames) {
    const std::string text = "{basis: identity, compressor: selection, recovery: " + std::string(name) + "}";
    EXPECT_EQ(name_of(read_text(text).recovery), name);
  }
}

TEST(Compression, RefusesParametersOutOfRange) {
  const auto error = [](const std::string& text) { return error_text([&] { read_text(text); }); };
  EXPECT_EQ(error("{recovery: csekf_p_printed, csekf_p: {p: 1}}"),
            "store.yaml:1:42: p: expected a number in [1e-06, 0.999999], found '1'");
  EXPECT_EQ(error("{recovery: csekf_p_printed, csekf_p: {p: 0}}"),
            "store.yaml:1:42: p: expected a number in [1e-06, 0.999999], found '0'");
  EXPECT_EQ(error("{recovery: csekf_p_power, csekf_p: {floor: 0}}"),
            "store.yaml:1:44: floor: expected a number above 0, found '0'");
  EXPECT_EQ(error("{recovery: csekf_p_gradient, csekf_p: {norm_variance: 0}}"),
            "store.yaml:1:55: norm_variance: expected a number above 0, found '0'");
  EXPECT_EQ(error("{recovery: csekf, csekf: {measurement_variance: 0}}"),
            "store.yaml:1:49: measurement_variance: expected a number above 0, found '0'");
  EXPECT_EQ(error("{recovery: csekf, csekf: {process_variance: -1}}"),
            "store.yaml:1:45: process_variance: expected a number of at least 0, found '-1'");
  EXPECT_EQ(error("{recovery: csekf, csekf: {tau: 0}}"),
            "store.yaml:1:32: tau: expected a whole number in [1, 1000000000], found '0'");
  EXPECT_EQ(error("{recovery: nesta, nesta: {eps: -1}}"),
            "store.yaml:1:32: eps: expected a number of at least 0, found '-1'");
  EXPECT_EQ(error("{recovery: nesta, nesta: {mu_final: 1}}"),
            "store.yaml:1:37: mu_final: expected a number in [0, 0.9], found '1'");
  EXPECT_EQ(error("{recovery: nesta, nesta: {continuation: 0}}"),
            "store.yaml:1:41: continuation: expected a whole number in [1, 1000], found '0'");
  EXPECT_EQ(error("{recovery: nesta, nesta: {tolerance: 0}}"),
            "store.yaml:1:38: tolerance: expected a number above 0, found '0'");
  EXPECT_EQ(error("{recovery: nesta, nesta: {max_iterations: 0}}"),
            "store.yaml:1:43: max_iterations: expected a whole number in [1, 1000000000], found '0'");
  EXPECT_EQ(error("{basis: identity, compressor: selection, recovery: tv, tv: {stop_at_gap: 0}}"),
            "store.yaml:1:74: stop_at_gap: expected a number above 0, found '0'");
}

TEST(Compression, SaysWhichKeyIsWrongAndWhere) {
  EXPECT_THAT(error_text([] { read_text("{basis: haar, recovery: tv}"); }),
              testing::AllOf(testing::StartsWith("store.yaml:1:"), testing::HasSubstr("'identity'")));
  EXPECT_THAT(error_text([] { read_text("{recovery: nesta, csekf: {tau: 5}}"); }), testing::HasSubstr("csekf"));
  EXPECT_THAT(error_text([] { read_text("{compressor: hadamart}"); }), testing::HasSubstr("hadamard"));
}

}  // namespace
}  // namespace cogslam
