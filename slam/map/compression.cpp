#include "slam/map/compression.hpp"

#include <algorithm>
#include <span>

#include "slam/codec/haar.hpp"
#include "slam/codec/top_m.hpp"

namespace cogslam {
namespace {

constexpr std::size_t kMostMatrixEntries = std::size_t{1} << 24;  // 128 MB of doubles

/// The outside of an H that is not made: what a recovery is asked whether it can work with.
struct Outline {
  std::size_t m;
  std::size_t n;
  bool picks;

  [[nodiscard]] std::size_t rows() const { return m; }
  [[nodiscard]] std::size_t cols() const { return n; }
  [[nodiscard]] bool orthonormal_rows() const { return true; }
  [[nodiscard]] bool is_selection() const { return picks; }
  void apply(std::span<const double> /*x*/, std::span<double> /*out*/) {}
  void apply_transpose(std::span<const double> /*y*/, std::span<double> /*out*/) {}
};

void read_parameters(ConfigSection section, Nesta& nesta) {
  section.read("eps", nesta.eps, kNotNegative);
  section.read("mu_final", nesta.mu_final, {0.0, 0.9});
  section.read("continuation", nesta.continuation, {1, 1000});
  section.read("tolerance", nesta.tolerance, kPositive);
  section.read("stop_at_gap", nesta.stop_at_gap, kNotNegative);
  section.read("max_iterations", nesta.max_iterations, {1, 1e9});
}

template <class Kalman>
void read_variances(ConfigSection& section, Kalman& kalman) {
  section.read("measurement_variance", kalman.measurement_variance, kPositive);
  section.read("process_variance", kalman.process_variance, kNotNegative);
  section.read("norm_variance", kalman.norm_variance, kPositive);
  section.read("tau", kalman.tau, {1, 1e9});
}

void read_parameters(ConfigSection section, KalmanCs& csekf) { read_variances(section, csekf); }

void read_parameters(ConfigSection section, KalmanCsP& csekf_p) {
  section.read("p", csekf_p.p, {1e-6, 1.0 - 1e-6});
  read_variances(section, csekf_p);
  section.read("floor", csekf_p.floor, kPositive);
}

void read_parameters(ConfigSection section, TotalVariation& tv) {
  section.read("stop_at_gap", tv.stop_at_gap, kPositive);
  section.read("max_iterations", tv.max_iterations, {1, 1e9});
}

void read_recovery(ConfigSection& section, Recovery& recovery) {
  std::string_view name = name_of(recovery);
  section.read_choice<std::string_view>("recovery", name,
                                        {{"pinv", "pinv"},
                                         {"fast_l2", "fast_l2"},
                                         {"nesta", "nesta"},
                                         {"csekf", "csekf"},
                                         {"csekf_p_printed", "csekf_p_printed"},
                                         {"csekf_p_gradient", "csekf_p_gradient"},
                                         {"csekf_p_power", "csekf_p_power"},
                                         {"tv", "tv"}});
  if (name != name_of(recovery)) recovery = *recovery_named(name);
  if (auto* nesta = std::get_if<Nesta>(&recovery)) read_parameters(section.section("nesta"), *nesta);
  if (auto* csekf = std::get_if<KalmanCs>(&recovery)) read_parameters(section.section("csekf"), *csekf);
  if (auto* csekf_p = std::get_if<KalmanCsP>(&recovery)) read_parameters(section.section("csekf_p"), *csekf_p);
  if (auto* tv = std::get_if<TotalVariation>(&recovery)) read_parameters(section.section("tv"), *tv);
}

std::string text(std::string_view name) { return "'" + std::string(name) + "'"; }

}  // namespace

bool CompressionConfig::is_papers_choice() const {
  return basis == BasisKind::kHaar && compressor == CompressorKind::kTopM && std::holds_alternative<FastL2>(recovery);
}

std::optional<CompressionTrouble> trouble_of(const CompressionConfig& config) {
  const bool cells = config.basis == BasisKind::kIdentity && config.compressor == CompressorKind::kSelection;
  if (std::holds_alternative<TotalVariation>(config.recovery) && !cells) {
    return CompressionTrouble{"recovery",
                              "'tv' fills in a map between cells that were kept: it needs basis 'identity' and "
                              "compressor 'selection', here " +
                                  text(name_of(config.basis)) + " and " + text(name_of(config.compressor))};
  }
  return std::nullopt;
}

std::optional<CompressionTrouble> trouble_of(const CompressionConfig& config, double percent, int width, int height) {
  if (auto trouble = trouble_of(config)) return trouble;
  if (config.basis == BasisKind::kHaar && std::max(width, height) > HaarCanvas::kMaxSide) {
    return CompressionTrouble{"basis", "'haar' takes maps of at most " + std::to_string(HaarCanvas::kMaxSide) +
                                           " cells on a side, here " + std::to_string(width) + " x " +
                                           std::to_string(height) + "; 'haar_1d' takes any"};
  }
  const Basis basis(config.basis, width, height);
  const std::size_t n = basis.size(), m = kept_count(basis.cells(), percent);
  if (!exists_for(config.compressor, n)) {
    return CompressionTrouble{"compressor", text(name_of(config.compressor)) +
                                                " needs a power of two of coefficients, but basis " +
                                                text(name_of(config.basis)) + " has " + std::to_string(n) +
                                                " for this map; the Haar bases and 'hadamard' pad to one"};
  }
  if (config.compressor == CompressorKind::kGaussian && m * n > kMostMatrixEntries) {
    return CompressionTrouble{"compressor", "'gaussian' stores m x n numbers, at most " +
                                                std::to_string(kMostMatrixEntries) + ", here " + std::to_string(m) +
                                                " x " + std::to_string(n)};
  }
  const bool picks = config.compressor == CompressorKind::kTopM || config.compressor == CompressorKind::kSelection;
  Outline outline{m, n, picks};
  if (const auto reason = why_not(recovery_for(config, width, height), outline)) {
    return CompressionTrouble{"recovery", *reason};
  }
  return std::nullopt;
}

Recovery recovery_for(const CompressionConfig& config, int width, int height) {
  Recovery recovery = config.recovery;
  if (auto* tv = std::get_if<TotalVariation>(&recovery)) {
    tv->width = static_cast<std::size_t>(width);
    tv->height = static_cast<std::size_t>(height);
  }
  return recovery;
}

void read_compression(ConfigSection& section, CompressionConfig& config) {
  section.read_choice("basis", config.basis,
                      {{"haar", BasisKind::kHaar},
                       {"haar_standard", BasisKind::kHaarStandard},
                       {"haar_1d", BasisKind::kHaar1d},
                       {"dct", BasisKind::kDct},
                       {"dct_1d", BasisKind::kDct1d},
                       {"hadamard", BasisKind::kHadamard},
                       {"identity", BasisKind::kIdentity}});
  section.read_choice("compressor", config.compressor,
                      {{"top_m", CompressorKind::kTopM},
                       {"selection", CompressorKind::kSelection},
                       {"gaussian", CompressorKind::kGaussian},
                       {"hadamard", CompressorKind::kHadamard},
                       {"dct", CompressorKind::kDct},
                       {"noiselet", CompressorKind::kNoiselet}});
  section.read("compressor_seed", config.compressor_seed);
  read_recovery(section, config.recovery);
  if (const auto trouble = trouble_of(config)) section.fail(trouble->key, trouble->message);
}

}  // namespace cogslam
