#include "slam/map/measured_map.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>

#include "core/rng.hpp"
#include "slam/map/coefficient_map.hpp"
#include "slam/map/store.hpp"

namespace cogslam {
namespace {

GridFrame area_of(int width, int height) {
  return {.cell_size = 0.1, .lattice_min = {-4, 2}, .width = width, .height = height};
}

MeasuredMap map_of(const GridFrame& area, double percent, const CompressionConfig& compression,
                   std::shared_ptr<MemoryMeter> meter = std::make_shared<MemoryMeter>()) {
  return {std::make_shared<const MeasuringPlan>(MeasuringPlan{area, percent, compression}), std::move(meter)};
}

/// A room in log-odds: walls around, free inside, a corner never seen.
Grid<float> room(const GridFrame& area) {
  Grid<float> grid;
  grid.reset(area, -2.0F);
  for (int y = 0; y < area.height; ++y) {
    for (int x = 0; x < area.width; ++x) {
      if (x == 0 || y == 0 || x == area.width - 1 || y == area.height - 1) grid[Cell{x, y}] = 3.2F;
      if (x > area.width - 4 && y > area.height - 4) grid[Cell{x, y}] = 0.0F;
    }
  }
  return grid;
}

std::vector<float> through(MeasuredMap map, const Grid<float>& grid) {
  MeasuredMap::Scratch scratch;
  map.commit(grid, scratch);
  Grid<float> back;
  map.load(back, scratch);
  return back.values();
}

double mse(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::pow(static_cast<double>(a[i]) - static_cast<double>(b[i]), 2);
  return sum / static_cast<double>(a.size());
}

double greatest_difference(const std::vector<float>& a, const std::vector<float>& b) {
  double greatest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) greatest = std::max(greatest, std::abs(static_cast<double>(a[i] - b[i])));
  return greatest;
}

constexpr std::array kBases{BasisKind::kHaar,  BasisKind::kHaarStandard, BasisKind::kHaar1d,  BasisKind::kDct,
                            BasisKind::kDct1d, BasisKind::kHadamard,     BasisKind::kIdentity};
constexpr std::array kCompressors{CompressorKind::kTopM,     CompressorKind::kSelection, CompressorKind::kGaussian,
                                  CompressorKind::kHadamard, CompressorKind::kDct,       CompressorKind::kNoiselet};

TEST(MeasuredMap, EqualsTheFastPathForThePapersChoice) {
  for (const auto& [width, height] : {std::pair{16, 8}, {13, 10}}) {
    const GridFrame area = area_of(width, height);
    MeasuredMap measured = map_of(area, 40.0, {});
    CoefficientMap fast(area, 40.0, std::make_shared<MemoryMeter>());
    MeasuredMap::Scratch a;
    CoefficientScratch b;
    Grid<float> grid_a, grid_b;
    Rng rng({.seed = 31, .purpose = Purpose::kWorld});
    for (int step = 0; step < 10; ++step) {
      measured.load(grid_a, a);
      fast.load(grid_b, b);
      ASSERT_LT(greatest_difference(grid_a.values(), grid_b.values()), 1e-4) << "step " << step;
      for (std::size_t i = 0; i < area.size(); ++i) {
        // Numbers that do not repeat: blocks of equal coefficients would leave the choice to rounding.
        const auto change = static_cast<float>(rng.uniform(-0.4, 0.8) * (1.0 + 0.01 * static_cast<double>(i)));
        grid_a.values()[i] += change;
        grid_b.values()[i] += change;
      }
      if (width == 13) grid_a = grid_b;  // at a cut edge coefficients come in equal pairs
      measured.commit(grid_a, a);
      fast.commit(grid_b, b);
      ASSERT_EQ(measured.measurements(), fast.coefficients());
    }
  }
}

TEST(MeasuredMap, IsExactWithEveryCoefficientOfAMapThatFillsItsCanvas) {
  const Grid<float> grid = room(area_of(16, 16));
  for (const BasisKind basis : kBases) {
    for (const CompressorKind compressor : kCompressors) {
      const CompressionConfig config{.basis = basis, .compressor = compressor};
      ASSERT_FALSE(trouble_of(config, 100.0, 16, 16));
      EXPECT_LT(greatest_difference(through(map_of(area_of(16, 16), 100.0, config), grid), grid.values()), 1e-5)
          << name_of(basis) << " " << name_of(compressor);
    }
  }
}

/// With H picking coefficients nothing constrains the others, so the least l1 and the least l2 norm leave them at 0.
TEST(MeasuredMap, RecoversTheSameFromPickedCoefficientsByCompressedSensingAsByL2) {
  const GridFrame area = area_of(10, 10);
  const Grid<float> grid = room(area);
  for (const CompressorKind compressor : {CompressorKind::kTopM, CompressorKind::kSelection}) {
    for (const BasisKind basis : kBases) {
      const auto with = [&](const Recovery& recovery) {
        return through(map_of(area, 40.0, {.basis = basis, .compressor = compressor, .recovery = recovery}), grid);
      };
      const std::vector<float> l2 = with(FastL2{});
      EXPECT_GT(mse(l2, grid.values()), 1e-3);
      EXPECT_LT(greatest_difference(with(Nesta{}), l2), 1e-6) << name_of(basis);
      EXPECT_LT(greatest_difference(with(PseudoInverse{}), l2), 1e-5) << name_of(basis);
    }
  }
}

/// Law: the error of the l2 recovery is what was not measured, sum c^2 - sum y^2, on a map that fills its canvas.
TEST(MeasuredMap, LosesByL2ExactlyWhatWasNotMeasured) {
  const GridFrame area = area_of(16, 8);
  const Grid<float> grid = room(area);
  double energy = 0.0;
  for (const float value : grid.values()) energy += static_cast<double>(value) * static_cast<double>(value);
  for (const CompressorKind compressor : kCompressors) {
    const CompressionConfig config{.compressor = compressor};
    MapMeasurer measurer(std::make_shared<const MeasuringPlan>(MeasuringPlan{area, 40.0, config}));
    CoefficientCode code;
    measurer.measure(grid.values(), code);
    double measured = 0.0;
    for (const float y : code.values) measured += static_cast<double>(y) * static_cast<double>(y);
    std::vector<float> back(area.size());
    measurer.recover(code, back);
    EXPECT_NEAR(mse(back, grid.values()) * static_cast<double>(area.size()), energy - measured, 1e-4 * energy)
        << name_of(compressor);
  }
}

TEST(MeasuredMap, RecoversMoreByCompressedSensingThanByL2FromMixedCoefficients) {
  const GridFrame area = area_of(32, 32);
  const Grid<float> grid = room(area);
  for (const CompressorKind compressor :
       {CompressorKind::kGaussian, CompressorKind::kHadamard, CompressorKind::kDct, CompressorKind::kNoiselet}) {
    const auto with = [&](const Recovery& recovery) {
      return mse(through(map_of(area, 60.0, {.compressor = compressor, .recovery = recovery}), grid), grid.values());
    };
    EXPECT_LT(with(Nesta{}), 0.1 * with(FastL2{})) << name_of(compressor);
  }
}

TEST(MeasuredMap, FillsInBetweenCellsByTotalVariation) {
  const GridFrame area = area_of(24, 24);
  Grid<float> grid;
  grid.reset(area, -2.0F);
  for (int y = 0; y < 24; ++y) {
    for (int x = 12; x < 24; ++x) grid[Cell{x, y}] = 3.0F;
  }
  const auto with = [&](const Recovery& recovery) {
    const CompressionConfig config{BasisKind::kIdentity, CompressorKind::kSelection, recovery};
    return mse(through(map_of(area, 50.0, config), grid), grid.values());
  };
  EXPECT_LT(with(TotalVariation{}), 0.1 * with(FastL2{}));
}

TEST(MeasuredMap, CountsAnIndexOnlyWhereRowsDependOnTheMap) {
  const Grid<float> grid = room(area_of(10, 10));
  for (const CompressorKind compressor : kCompressors) {
    const auto meter = std::make_shared<MemoryMeter>();
    MeasuredMap map = map_of(area_of(10, 10), 40.0, {.compressor = compressor}, meter);
    MeasuredMap::Scratch scratch;
    map.commit(grid, scratch);
    EXPECT_EQ(map.measurements(), 40U);
    EXPECT_EQ(meter->payload(), compressor == CompressorKind::kTopM ? 40 * 8 : 40 * 4);
    const MeasuredMap copy = map;
    EXPECT_EQ(meter->payload(), compressor == CompressorKind::kTopM ? 40 * 8 : 40 * 4);
  }
}

// One coefficient carries a flat map. What rounding leaves of the others is not map, and must not be paid for.
TEST(MeasuredMap, DoesNotKeepRounding) {
  Grid<float> flat;
  flat.reset(area_of(7, 5), 0.3F);
  for (const BasisKind basis : {BasisKind::kDct, BasisKind::kDct1d}) {
    MeasuredMap map = map_of(flat.frame(), 100.0, {.basis = basis});
    MeasuredMap::Scratch scratch;
    map.commit(flat, scratch);
    EXPECT_EQ(map.measurements(), 1U);
  }
}

TEST(MeasuredMap, MakesItsMatrixAnewInAScratchOfAnotherPlan) {
  const Grid<float> grid = room(area_of(10, 10));
  MeasuredMap first = map_of(area_of(10, 10), 40.0, {.compressor = CompressorKind::kDct});
  MeasuredMap second = map_of(area_of(10, 10), 40.0, {.compressor = CompressorKind::kDct, .compressor_seed = 2});
  MeasuredMap::Scratch scratch;
  first.commit(grid, scratch);
  second.commit(grid, scratch);
  Grid<float> shared, own;
  first.load(shared, scratch);
  MeasuredMap::Scratch fresh;
  first.load(own, fresh);
  EXPECT_EQ(shared.values(), own.values());
  second.load(own, fresh);
  EXPECT_NE(shared.values(), own.values());
}

}  // namespace
}  // namespace cogslam
