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
//   80 % are zero              0.87         49         0.34
// Conclusion: one pass over each level, both directions at once, is 6 to 36 times as fast as rows, then columns, which
// walk down columns through the cache. Selection costs more than the transform; zeros, which it drops first, are cheap.
#include <benchmark/benchmark.h>

#include <vector>

#include "core/rng.hpp"
#include "slam/codec/haar.hpp"
#include "slam/codec/top_m.hpp"
#include "tests/support/slow_haar.hpp"
#include "tests/support/slow_top_m.hpp"

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
BENCHMARK(fast_l2)->Apply(selections);

}  // namespace
}  // namespace cogslam

BENCHMARK_MAIN();
