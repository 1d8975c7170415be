#include "eval/lab/map_study.hpp"

#include <cmath>

#include "core/check.hpp"
#include "eval/lab/method.hpp"
#include "eval/metrics/timing.hpp"
#include "slam/codec/coefficient_code.hpp"
#include "slam/codec/haar.hpp"
#include "slam/codec/top_m.hpp"
#include "slam/map/compression.hpp"
#include "slam/map/log_odds.hpp"

namespace cogslam {
namespace {

struct Combination {
  BasisKind basis;
  CompressorKind compressor;
  std::string recovery;
  double percent;
};

std::vector<Combination> combinations(const MapStudy& study) {
  std::vector<Combination> all;
  for (const BasisKind basis : study.bases) {
    for (const CompressorKind compressor : study.compressors) {
      for (const std::string& recovery : study.recoveries) {
        for (const double percent : study.percents) all.push_back({basis, compressor, recovery, percent});
      }
    }
  }
  return all;
}

/// Coefficients among which positions must be told apart.
std::size_t positions(const Basis& basis, const GridFrame& frame) {
  if (basis.kind() != BasisKind::kHaar) return basis.size();
  return HaarCanvas::covering(frame.width, frame.height).support();
}

void count_bytes(const Combination& combination, std::size_t among, MapScore& score) {
  if (combination.compressor == CompressorKind::kTopM) {
    score.bytes_u32 = payload_bytes(score.m, among, IndexCoding::kU32);
    score.bytes_u16 = payload_bytes(score.m, among, IndexCoding::kU16);
    score.bytes_bitmap = payload_bytes(score.m, among, IndexCoding::kBitmap);
  } else {
    const std::size_t bytes = sizeof(float) * score.m + sizeof(std::uint32_t);
    score.bytes_u32 = score.bytes_u16 = score.bytes_bitmap = bytes;
  }
}

void measure(const Combination& combination, const MapStudy& study, const Grid<float>& map, MapScore& score) {
  const GridFrame& frame = map.frame();
  const CompressionConfig how{.basis = combination.basis,
                              .compressor = combination.compressor,
                              .recovery = *recovery_named(combination.recovery),
                              .compressor_seed = study.seed};
  if (const auto trouble = trouble_of(how, combination.percent, frame.width, frame.height)) {
    score.not_valid = trouble->message;
    return;
  }
  Basis basis(how.basis, frame.width, frame.height);
  const std::size_t wanted = std::max<std::size_t>(kept_count(basis.cells(), combination.percent), 1);
  const std::vector<double> cells(map.values().begin(), map.values().end());
  std::vector<double> c(basis.size());
  std::optional<Compressor> random;
  if (how.compressor != CompressorKind::kTopM) {
    random = make_compressor(how.compressor, wanted, basis.size(), how.compressor_seed);
  }
  const Stopwatch compressing(Clock::kThreadCpu);
  basis.forward(cells, c);
  Compressor H = random ? *std::move(random) : make_top_m(c, wanted);
  std::vector<double> y(H.rows());
  H.apply(c, y);
  score.compress_ms = 1e3 * compressing.seconds();
  for (double& value : y) value = static_cast<double>(static_cast<float>(value));
  score.m = y.size();
  const Recovery recovery = recovery_for(how, frame.width, frame.height);
  const Stopwatch recovering(Clock::kThreadCpu);
  const Recovered recovered = recover(recovery, H, y);
  std::vector<double> back(cells.size());
  basis.inverse(recovered.x, back);
  score.recover_ms = 1e3 * recovering.seconds();
  score.converged = recovered.converged;
  Grid<float> estimate(frame);
  for (std::size_t i = 0; i < back.size(); ++i) estimate.values()[i] = static_cast<float>(back[i]);
  const MapMse mse = map_mse(map, estimate);
  score.mse_log_odds = mse.log_odds;
  score.mse_probability = mse.probability;
  count_bytes(combination, positions(basis, frame), score);
}

}  // namespace

MapMse map_mse(const Grid<float>& truth, const Grid<float>& estimate) {
  EXPECTS(truth.frame() == estimate.frame() && truth.frame().size() > 0);
  MapMse sum;
  for (std::size_t i = 0; i < truth.values().size(); ++i) {
    const auto a = static_cast<double>(truth.values()[i]), b = static_cast<double>(estimate.values()[i]);
    const double p = probability(a) - probability(b);
    sum.log_odds += (a - b) * (a - b);
    sum.probability += p * p;
  }
  const auto n = static_cast<double>(truth.values().size());
  return {sum.log_odds / n, sum.probability / n};
}

std::vector<MapScore> run_map_study(const MapStudy& study, const Grid<float>& map, Workers& workers,
                                    const LabProgress& progress) {
  const std::vector<std::string> known(kRecoveryNames.begin(), kRecoveryNames.end());
  for (const std::string& name : study.recoveries) index_of_name("recovery", name, known);
  const std::vector<Combination> all = combinations(study);
  std::vector<MapScore> scores(all.size());
  for_each_seed(all.size(), workers, progress, [&](std::size_t i) {
    scores[i].basis = name_of(all[i].basis);
    scores[i].compressor = name_of(all[i].compressor);
    scores[i].recovery = all[i].recovery;
    scores[i].percent = all[i].percent;
    measure(all[i], study, map, scores[i]);
  });
  return scores;
}

}  // namespace cogslam
