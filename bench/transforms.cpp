// Time of the steps that bring a map to its kept coefficients and back, each beside its slow twin.
// GB/s are of the map (Haar) or the coefficients (selection), 4 bytes each.
//
// 2 virtual cores Intel Xeon 2.6 GHz (shared), g++ 12.2 -O3, SSE2 only; one core:
//   Haar, GB/s         40x46  64x64  256x256  320x320  1024x1024
//   forward, fused      13     21      24       11        9.3
//   inverse, fused      14     19      21       20        9.1
//   rows then columns   1.4    3.1     1.0      0.33      0.25
//   10^6 coefficients, ms   selection  stable sort  fast l2
//   40 % kept                  4.6         145         0.40
//   10 % kept                  5.0         120         0.30
//   80 % are zero              0.85         48         0.34
//   one magnitude alone        3.1          15   (two in turn: 5.5 and 19)
//   CPU us, double          128   4096   64x64  250x154  512x512  249x154  1009  2^18
//   Walsh-Hadamard         0.20    7.1                                            730
//     by its matrix         2.1  11600
//   DCT-II (FFT)            1.05    46      36      867     3920     1700    63
//     OpenCV               0.84     28      21      382     3370   refuses   refuses
//     by its matrix         2.4  11300      71     2100    40900     2095   302
// Conclusion: one pass over each level, both directions at once, is 6 to 36 times as fast as rows, then columns, which
// walk down columns through the cache. Selection costs more than the transform; zeros, which it drops first, are cheap.
// OpenCV's DCT is 1.2 to 1.7 times as fast as ours on powers of two and 2.3 times on 250 x 154 (factors 7 and 11),
// where it works: on even sides alone. Ours takes any, the primes by way of a longer FFT. OpenCV has no Walsh-Hadamard
// transform; ours is 5 to 6 times as fast as our DCT of the same data.
#include <benchmark/benchmark.h>

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>

#include "core/rng.hpp"
#include "slam/codec/basis.hpp"
#include "slam/codec/haar.hpp"
#include "slam/codec/hadamard.hpp"
#include "slam/codec/top_m.hpp"
#include "tests/support/slow_haar.hpp"
#include "tests/support/slow_top_m.hpp"
#include "tests/support/slow_transforms.hpp"

namespace cogslam {
namespace {

std::vector<float> random_floats(std::size_t count) {
  Rng rng({.seed = 1, .purpose = Purpose::kWorld});
  std::vector<float> values(count);
  for (float& value : values) {
    value = static_cast<float>(rng.normal());
  }
  return values;
}

void report_input(benchmark::State& state, std::size_t bytes) {
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes));
}

void haar_forward_fused(benchmark::State& state) {
  const HaarCanvas canvas = HaarCanvas::covering(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const std::vector<float> map = random_floats(canvas.cells());
  std::vector<float> coefficients(canvas.size());
  std::vector<float> scratch(canvas.scratch_size());
  for (auto _ : state) {
    haar_forward(canvas, map, coefficients, scratch);
    benchmark::DoNotOptimize(coefficients.data());
    benchmark::ClobberMemory();
  }
  report_input(state, map.size() * sizeof(float));
}

void haar_inverse_fused(benchmark::State& state) {
  const HaarCanvas canvas = HaarCanvas::covering(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const std::vector<float> coefficients = random_floats(canvas.size());
  std::vector<float> map(canvas.cells());
  std::vector<float> scratch(canvas.scratch_size());
  for (auto _ : state) {
    haar_inverse(canvas, coefficients, map, scratch);
    benchmark::DoNotOptimize(map.data());
    benchmark::ClobberMemory();
  }
  report_input(state, map.size() * sizeof(float));
}

void haar_rows_then_columns(benchmark::State& state) {
  const HaarCanvas canvas = HaarCanvas::covering(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const std::vector<float> map = random_floats(canvas.cells());
  for (auto _ : state) {
    std::vector<float> image = slow::padded(map, canvas.map_width, canvas.map_height, canvas.width, canvas.height);
    slow::haar_rows_then_columns(canvas.width, canvas.height, image);
    benchmark::DoNotOptimize(image.data());
  }
  report_input(state, map.size() * sizeof(float));
}

// Arguments: number of coefficients, percent kept, percent that are not zero.
std::vector<float> sparse_floats(std::size_t count, std::int64_t percent_nonzero) {
  std::vector<float> values = random_floats(count);
  Rng rng({.seed = 2, .purpose = Purpose::kWorld});
  for (float& value : values) {
    value = rng.below(100) < percent_nonzero ? value : 0.0F;
  }
  return values;
}

void top_m_selection(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const std::vector<float> coefficients = sparse_floats(count, state.range(2));
  CoefficientCode code;
  TopMScratch scratch;
  for (auto _ : state) {
    select_top_m(coefficients, kept_count(count, static_cast<double>(state.range(1))), code, scratch);
    benchmark::DoNotOptimize(code.values.data());
  }
  report_input(state, count * sizeof(float));
}

void top_m_sort(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const std::vector<float> coefficients = sparse_floats(count, state.range(2));
  for (auto _ : state) {
    const CoefficientCode code =
        slow::sort_and_keep(coefficients, kept_count(count, static_cast<double>(state.range(1))));
    benchmark::DoNotOptimize(code.values.data());
  }
  report_input(state, count * sizeof(float));
}

/// The worst for counting: one magnitude, or two in turn.
std::vector<float> equal_floats(std::int64_t magnitudes) {
  std::vector<float> values(1'000'000);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const float sign = i % 3 == 0 ? -1.0F : 1.0F;
    values[i] = sign * (magnitudes == 2 && i % 2 == 0 ? 0.5F : 0.25F);
  }
  return values;
}

void top_m_selection_of_equals(benchmark::State& state) {
  const std::vector<float> coefficients = equal_floats(state.range(0));
  CoefficientCode code;
  TopMScratch scratch;
  for (auto _ : state) {
    select_top_m(coefficients, 400'000, code, scratch);
    benchmark::DoNotOptimize(code.values.data());
  }
}

void top_m_sort_of_equals(benchmark::State& state) {
  const std::vector<float> coefficients = equal_floats(state.range(0));
  for (auto _ : state) {
    const CoefficientCode code = slow::sort_and_keep(coefficients, 400'000);
    benchmark::DoNotOptimize(code.values.data());
  }
}

void fast_l2(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const std::vector<float> coefficients = sparse_floats(count, state.range(2));
  CoefficientCode code;
  TopMScratch scratch;
  select_top_m(coefficients, kept_count(count, static_cast<double>(state.range(1))), code, scratch);
  std::vector<float> rebuilt(count);
  for (auto _ : state) {
    reconstruct_fast_l2(code, rebuilt);
    benchmark::DoNotOptimize(rebuilt.data());
    benchmark::ClobberMemory();
  }
  report_input(state, count * sizeof(float));
}

std::vector<double> random_doubles(std::size_t count) {
  const std::vector<float> values = random_floats(count);
  return {values.begin(), values.end()};
}

void walsh_hadamard_fast(benchmark::State& state) {
  std::vector<double> values = random_doubles(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) {
    walsh_hadamard(values);
    benchmark::DoNotOptimize(values.data());
    benchmark::ClobberMemory();
  }
}

void hadamard_by_matrix(benchmark::State& state) {
  const Eigen::MatrixXd matrix = slow::hadamard_matrix(static_cast<int>(state.range(0)));
  const std::vector<double> values = random_doubles(static_cast<std::size_t>(state.range(0)));
  Eigen::VectorXd out(matrix.rows());
  for (auto _ : state) {
    out.noalias() = matrix * Eigen::Map<const Eigen::VectorXd>(values.data(), matrix.cols());
    benchmark::DoNotOptimize(out.data());
  }
}

// 1: a line; else a square.
void dct_ours(benchmark::State& state) {
  Basis basis(BasisKind::kDct, static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const std::vector<double> values = random_doubles(basis.cells());
  std::vector<double> out(basis.size());
  for (auto _ : state) {
    basis.forward(values, out);
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
}

void dct_opencv(benchmark::State& state) {
  cv::setNumThreads(1);
  cv::Mat values(static_cast<int>(state.range(1)), static_cast<int>(state.range(0)), CV_64F), out;
  const std::vector<double> drawn = random_doubles(values.total());
  std::copy(drawn.begin(), drawn.end(), values.ptr<double>());
  for (auto _ : state) {
    cv::dct(values, out);
    benchmark::DoNotOptimize(out.data);
    benchmark::ClobberMemory();
  }
}

void dct_by_matrix(benchmark::State& state) {
  const Eigen::MatrixXd along_x = slow::dct_matrix(static_cast<int>(state.range(0)));
  const Eigen::MatrixXd along_y = slow::dct_matrix(static_cast<int>(state.range(1)));
  const Eigen::MatrixXd values = Eigen::MatrixXd::Constant(along_y.rows(), along_x.rows(), 0.5);
  Eigen::MatrixXd out(along_y.rows(), along_x.rows());
  for (auto _ : state) {
    out.noalias() = along_y * values * along_x.transpose();
    benchmark::DoNotOptimize(out.data());
  }
}

void even_sides(benchmark::internal::Benchmark* bench) {
  bench->Args({128, 1})->Args({4096, 1})->Args({64, 64})->Args({250, 154})->Args({512, 512});
  bench->Unit(benchmark::kMicrosecond);
}

void any_sides(benchmark::internal::Benchmark* bench) {
  even_sides(bench);
  bench->Args({249, 154})->Args({1009, 1});
}

void map_sides(benchmark::internal::Benchmark* bench) {
  for (const int side : {64, 256, 1024}) {
    bench->Args({side, side});
  }
  bench->Args({40, 46})->Args({320, 320})->Unit(benchmark::kMicrosecond);
}

void selections(benchmark::internal::Benchmark* bench) {
  bench->Args({1'000'000, 40, 100})->Args({1'000'000, 10, 100})->Args({1'000'000, 40, 20})->Args({4096, 18, 60});
  bench->Unit(benchmark::kMicrosecond);
}

BENCHMARK(haar_forward_fused)->Apply(map_sides);
BENCHMARK(haar_inverse_fused)->Apply(map_sides);
BENCHMARK(haar_rows_then_columns)->Apply(map_sides);
BENCHMARK(top_m_selection)->Apply(selections);
BENCHMARK(top_m_sort)->Apply(selections);
BENCHMARK(top_m_selection_of_equals)->Arg(1)->Arg(2)->Unit(benchmark::kMicrosecond);
BENCHMARK(top_m_sort_of_equals)->Arg(1)->Arg(2)->Unit(benchmark::kMicrosecond);
BENCHMARK(fast_l2)->Apply(selections);
BENCHMARK(walsh_hadamard_fast)->Arg(128)->Arg(4096)->Arg(1 << 18)->Unit(benchmark::kMicrosecond);
BENCHMARK(hadamard_by_matrix)->Arg(128)->Arg(4096)->Unit(benchmark::kMicrosecond);
BENCHMARK(dct_ours)->Apply(any_sides);
BENCHMARK(dct_opencv)->Apply(even_sides);  // refuses odd sides
BENCHMARK(dct_by_matrix)->Apply(any_sides);

}  // namespace
}  // namespace cogslam

BENCHMARK_MAIN();
