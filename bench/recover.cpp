// Time of the recoveries, each beside its slow twin. Run from the root of the tree: bench_recover.
//
// CPU time on one core of a shared Xeon at 2.6 GHz, g++ 12.2 -O3 (wall time was about twice that, by the other load):
// - NESTA on a 64 x 64 room, 40 % Hadamard rows: relative gap 1e-4 in 10 ms (295 iterations) when the momentum
// restarts,
//   16 ms (476) without; the reference's eight widths end after 301 iterations at the optimum within 1e-5, but their
//   last widths are too narrow to prove it (gap 1.7e-2). With the rows as a dense matrix: 2.7 s, 260 times as long.
// - Alg. 5 by rank-one updates is 6 (n = 128) to 7 (n = 512) times as fast as by matrix products.
// - Fast l2 of 448 in 1120 values: 0.26 us; pseudo-inverse 67 ms by orthogonal decomposition, 190 ms by SVD.
// - Total variation of 154 x 249 cells to a gap of 1e-3: 0.06, 0.13, 0.10, 0.03 s for K = 600, 1500, 3000, 8000.
//   The steps for K = 3000 cell by cell: 0.43 s, 4 times as long, and without the gap.
// - Least l1 norm of the same at K = 8000 to 1e-3: Haar 0.09 s by Douglas-Rachford splitting, 1.3 s by NESTA; DCT 1.5 s
//   and 6.7 s. At K = 3000 Haar 0.14 s, DCT 1.7 s.
#include <benchmark/benchmark.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "slam/codec/basis.hpp"
#include "slam/codec/compressor.hpp"
#include "slam/recover/basis_pursuit.hpp"
#include "slam/recover/recovery.hpp"

namespace cogslam {
namespace {

/// A room of 64 x 64 cells as log-odds: free inside its walls, unknown behind them, two boxes.
std::vector<double> drawn_room() {
  std::vector<double> map(64 * 64, 0.0);
  for (std::size_t y = 4; y < 60; ++y) {
    for (std::size_t x = 4; x < 60; ++x) {
      const bool wall = x == 4 || x == 59 || y == 4 || y == 59;
      const bool box = (x > 14 && x < 22 && y > 30 && y < 36) || (x > 40 && x < 45 && y > 12 && y < 25);
      map[64 * y + x] = wall || box ? 3.0 : -2.0;
    }
  }
  return map;
}

/// 0.4 n random Hadamard rows of the room's Haar coefficients.
struct RoomProblem {
  Compressor H = make_compressor(CompressorKind::kHadamard, 1638, 4096, 1);
  std::vector<double> c = std::vector<double>(4096);
  std::vector<double> y = std::vector<double>(1638);

  RoomProblem() {
    Basis(BasisKind::kHaar, 64, 64).forward(drawn_room(), c);
    H.apply(c, y);
  }
};

/// All numbers of a comma-separated file; none where there is no such file.
std::vector<double> csv_values(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<double> all;
  for (std::string line; std::getline(file, line);) {
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) all.push_back(std::stod(field));
  }
  return all;
}

/// The reference problem, where its files stand beside the repository: coefficients and a row order.
bool load_reference(const std::filesystem::path& folder, RoomProblem& problem) {
  const std::vector<double> c = csv_values(folder / "haar2d_ideal.csv");
  const std::vector<double> order = csv_values(folder / "hadamard_rowperm_lcg4096.csv");
  if (c.size() != 4096 || order.size() != 4096) return false;
  problem.c = c;
  problem.H = Compressor::transform_rows(CompressorKind::kHadamard, {order.begin(), order.begin() + 1638}, 4096);
  problem.H.apply(problem.c, problem.y);
  return true;
}

void report(benchmark::State& state, const Recovered& result) {
  state.counters["iterations"] = result.iterations;
  state.counters["gap"] = result.duality_gap.value_or(std::nan(""));
  state.counters["converged"] = result.converged ? 1.0 : 0.0;
}

void nesta_on_room(benchmark::State& state, const Nesta& nesta) {
  RoomProblem problem;
  state.SetLabel(load_reference("../shared/oracle/golden", problem) ? "room64_ideal" : "drawn room");
  Recovered result;
  for (auto _ : state) result = recover(nesta, problem.H, problem.y);
  report(state, result);
}
const Nesta kByWidths{.mu_final = 3e-6, .continuation = 3, .tolerance = 1e-12, .stop_at_gap = 1e-4};
BENCHMARK_CAPTURE(nesta_on_room, restarted_to_gap_1e4, Nesta::to_gap(1e-4))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(nesta_on_room, three_widths_to_gap_1e4, kByWidths)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(nesta_on_room, default_eight_widths, Nesta{})->Unit(benchmark::kMillisecond);

/// The slow twin of one product: the same rows as a dense matrix.
void nesta_on_room_with_dense_rows(benchmark::State& state) {
  RoomProblem problem;
  state.SetLabel(load_reference("../shared/oracle/golden", problem) ? "room64_ideal" : "drawn room");
  Compressor dense = Compressor::matrix(explicit_matrix(problem.H), true);
  Recovered result;
  for (auto _ : state) result = recover(Nesta::to_gap(1e-4), dense, problem.y);
  report(state, result);
}
BENCHMARK(nesta_on_room_with_dense_rows)->Unit(benchmark::kMillisecond)->Iterations(1);

/// Ten passes of Alg. 5 on n coefficients, half of them measured.
void csekf_ten_passes(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  Compressor H = make_compressor(CompressorKind::kGaussian, n / 2, n, 1);
  const std::vector<double> y(n / 2, 1.0);
  for (auto _ : state) benchmark::DoNotOptimize(recover(KalmanCs{.tau = 11}, H, y));
}
BENCHMARK(csekf_ten_passes)->Arg(128)->Arg(512)->Unit(benchmark::kMillisecond);

/// Slow twin: (I - K H) Sigma as a product of matrices, as eq. 51 is printed.
void csekf_ten_passes_by_matrix_products(benchmark::State& state) {
  const auto n = static_cast<Eigen::Index>(state.range(0));
  const auto size = static_cast<std::size_t>(n);
  Compressor map = make_compressor(CompressorKind::kGaussian, size / 2, size, 1);
  const Eigen::MatrixXd H = explicit_matrix(map);
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(n, n);
  const Eigen::VectorXd y = Eigen::VectorXd::Constant(n / 2, 1.0);
  for (auto _ : state) {
    Eigen::MatrixXd sigma = identity - H.transpose() * H / 1.0001;
    Eigen::VectorXd c = H.transpose() * y / 1.0001;
    for (int pass = 0; pass < 10; ++pass) {
      const Eigen::VectorXd h = c.unaryExpr([](double v) { return v >= 0.0 ? 1.0 : -1.0; });
      const Eigen::VectorXd gain = sigma * h / (h.dot(sigma * h) + 1e4);
      const Eigen::MatrixXd factor = identity - gain * h.transpose();
      c = factor * c;
      sigma = factor * sigma;
    }
    benchmark::DoNotOptimize(c.data());
  }
}
BENCHMARK(csekf_ten_passes_by_matrix_products)->Arg(128)->Arg(512)->Unit(benchmark::kMillisecond);

/// l2 of n = 1120 coefficients of which 40 % are selected, as in figure 11.
void l2_of_selection(benchmark::State& state, const Recovery& recovery) {
  Compressor H = make_compressor(CompressorKind::kSelection, 448, 1120, 1);
  const std::vector<double> y(448, 1.0);
  for (auto _ : state) benchmark::DoNotOptimize(recover(recovery, H, y));
}
BENCHMARK_CAPTURE(l2_of_selection, fast_l2, FastL2{})->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(l2_of_selection, pinv_orthogonal, PseudoInverse{})->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(l2_of_selection, pinv_svd, PseudoInverse{PseudoInverse::Decomposition::kSvd})
    ->Unit(benchmark::kMicrosecond)
    ->Iterations(1);

/// A building of 249 x 154 cells: corridors of 0 between rooms of 0.5 (unknown) with walls of 1.
std::vector<double> drawn_hallway() {
  std::vector<double> map(154 * 249);
  for (std::size_t y = 0; y < 154; ++y) {
    for (std::size_t x = 0; x < 249; ++x) {
      const std::size_t u = x % 60, v = y % 50;
      map[249 * y + x] = u < 12 || v < 12 ? 0.0 : (u == 12 || u == 59 || v == 12 || v == 49 ? 1.0 : 0.5);
    }
  }
  return map;
}

/// 154 x 249 cells of which some are known; the map "tri" of the reference where it stands beside the repository.
struct HallwayProblem {
  std::vector<double> map = drawn_hallway();
  bool is_reference = false;
  Compressor phi;
  std::vector<double> y;

  explicit HallwayProblem(std::size_t samples)
      : phi(make_compressor(CompressorKind::kSelection, samples, map.size(), 1)), y(samples) {
    const std::vector<double> given = csv_values("../shared/oracle/maps/hallway154x249_tri.csv");
    is_reference = given.size() == map.size();
    if (is_reference) map = given;
    phi.apply(map, y);
  }
};

/// Total variation to a relative gap of 1e-3.
void tv_of_hallway(benchmark::State& state) {
  HallwayProblem problem(static_cast<std::size_t>(state.range(0)));
  state.SetLabel(problem.is_reference ? "hallway tri" : "drawn hallway");
  Recovered result;
  for (auto _ : state) result = recover(TotalVariation{249, 154}, problem.phi, problem.y);
  report(state, result);
  state.counters["tv"] = total_variation(result.x, 249);
}
BENCHMARK(tv_of_hallway)->Arg(600)->Arg(1500)->Arg(3000)->Arg(8000)->Unit(benchmark::kMillisecond);

/// The same cells by least l1 norm in a basis: Douglas-Rachford splitting beside NESTA, both to a gap of 1e-3.
template <class Solver>
void sparsity_of_hallway(benchmark::State& state, BasisKind kind, const Solver& solver) {
  HallwayProblem problem(static_cast<std::size_t>(state.range(0)));
  state.SetLabel(problem.is_reference ? "hallway tri" : "drawn hallway");
  InverseThenCompress theta(Basis(kind, 249, 154), problem.phi);
  Recovered result;
  for (auto _ : state) result = recover(solver, theta, problem.y);
  report(state, result);
}
BENCHMARK_CAPTURE(sparsity_of_hallway, haar, BasisKind::kHaar, BasisPursuit{})
    ->Arg(3000)
    ->Arg(8000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sparsity_of_hallway, haar_by_nesta, BasisKind::kHaar, Nesta::to_gap(1e-3))
    ->Arg(8000)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK_CAPTURE(sparsity_of_hallway, dct, BasisKind::kDct, BasisPursuit{})
    ->Arg(3000)
    ->Arg(8000)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK_CAPTURE(sparsity_of_hallway, dct_by_nesta, BasisKind::kDct, Nesta::to_gap(1e-3))
    ->Arg(8000)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

/// Slow twin: the same 660 steps as for K = 3000, cell by cell and without measuring the gap.
void tv_of_hallway_cell_by_cell(benchmark::State& state) {
  const HallwayProblem problem(3000);
  const int W = 249, H = 154;
  std::vector<double> known(problem.map.size(), std::nan(""));
  for (const std::uint32_t i : problem.phi.indices()) known[i] = problem.map[i];
  const double primal = 0.3 / std::sqrt(8.0), dual = 1.0 / (0.3 * std::sqrt(8.0));
  for (auto _ : state) {
    std::vector<double> m(known.size(), 0.5), lead(m), q(m.size(), 0.0), r(m.size(), 0.0);
    for (int step = 0; step < 660; ++step) {
      for (int i = 0; i < H; ++i) {
        for (int j = 0; j < W; ++j) {
          const auto c = static_cast<std::size_t>(W * i + j);
          double slope = q[c] + r[c];
          if (i + 1 < H) slope -= q[c + W];
          if (j + 1 < W) slope -= r[c + 1];
          const double next = std::isnan(known[c]) ? std::clamp(m[c] - primal * slope, 0.0, 1.0) : known[c];
          lead[c] = 2.0 * next - m[c];
          m[c] = next;
        }
      }
      for (int i = 0; i < H; ++i) {
        for (int j = 0; j < W; ++j) {
          const auto c = static_cast<std::size_t>(W * i + j);
          if (i > 0) q[c] += dual * (lead[c] - lead[c - W]);
          if (j > 0) r[c] += dual * (lead[c] - lead[c - 1]);
          const double length = std::max(1.0, std::hypot(q[c], r[c]));
          q[c] /= length;
          r[c] /= length;
        }
      }
    }
    benchmark::DoNotOptimize(m.data());
    state.counters["tv"] = total_variation(m, W);
  }
}
BENCHMARK(tv_of_hallway_cell_by_cell)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cogslam

BENCHMARK_MAIN();
