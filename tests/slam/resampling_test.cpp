#include "slam/resampling.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <numeric>

#include "core/check.hpp"
#include "core/rng.hpp"

namespace cogslam {
namespace {

using testing::Each;
using testing::ElementsAre;

/// Slow twin: for every slot the first particle whose cumulative weight, summed anew, reaches the slot's point.
std::vector<std::size_t> resample_slowly(const std::vector<double>& weights, double offset) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double point = (static_cast<double>(i) + offset) / static_cast<double>(weights.size());
    std::size_t j = 0;
    while (j + 1 < weights.size() &&
           std::accumulate(weights.begin(), weights.begin() + static_cast<std::ptrdiff_t>(j) + 1, 0.0) < point) {
      ++j;
    }
    chosen.push_back(j);
  }
  return chosen;
}

std::vector<double> random_weights(Rng& rng) {
  std::vector<double> log_weights(1 + rng.below(60));
  const double spread = rng.uniform(0.0, 6.0);
  for (double& l : log_weights) l = spread * rng.normal();
  return normalised_weights(log_weights);
}

std::vector<double> counts_of(const std::vector<std::size_t>& chosen) {
  std::vector<double> counts(chosen.size(), 0.0);
  for (const std::size_t j : chosen) counts[j] += 1.0;
  return counts;
}

Rng test_rng(std::uint32_t entity) { return Rng({.seed = 43, .purpose = Purpose::kResample, .entity = entity}); }

TEST(SystematicResample, EqualsItsSlowTwin) {
  for (std::uint32_t round = 0; round < 300; ++round) {
    Rng rng = test_rng(round);
    const std::vector<double> weights = random_weights(rng);
    const double offset = rng.uniform();
    EXPECT_EQ(systematic_resample(weights, offset), resample_slowly(weights, offset));
  }
}

TEST(SystematicResample, TakesEachParticleFloorOrCeilTimesInAscendingOrder) {
  for (std::uint32_t round = 0; round < 300; ++round) {
    Rng rng = test_rng(1000 + round);
    const std::vector<double> weights = random_weights(rng);
    const std::vector<std::size_t> chosen = systematic_resample(weights, rng.uniform());
    ASSERT_EQ(chosen.size(), weights.size());
    EXPECT_TRUE(std::is_sorted(chosen.begin(), chosen.end()));
    const std::vector<double> counts = counts_of(chosen);
    for (std::size_t j = 0; j < weights.size(); ++j) {
      const double share = static_cast<double>(weights.size()) * weights[j];
      EXPECT_GE(counts[j], std::floor(share - 1e-9));
      EXPECT_LE(counts[j], std::ceil(share + 1e-9));
    }
  }
}

TEST(SystematicResample, IsWithoutBiasOverTheOffset) {
  Rng rng = test_rng(2000);
  const std::vector<double> weights = random_weights(rng);
  constexpr int kOffsets = 2000;
  std::vector<double> mean(weights.size(), 0.0);
  for (int k = 0; k < kOffsets; ++k) {
    const std::vector<double> counts = counts_of(systematic_resample(weights, (k + 0.5) / kOffsets));
    for (std::size_t j = 0; j < mean.size(); ++j) mean[j] += counts[j] / kOffsets;
  }
  // A count is a step function of the offset with two steps at most, each found to half an offset.
  for (std::size_t j = 0; j < mean.size(); ++j) {
    EXPECT_NEAR(mean[j], static_cast<double>(weights.size()) * weights[j], 1.01 / kOffsets);
  }
}

TEST(SystematicResample, KeepsEqualParticlesAndLeavesOutTheImpossible) {
  EXPECT_THAT(systematic_resample({0.25, 0.25, 0.25, 0.25}, 0.5), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(systematic_resample({0.0, 1.0, 0.0}, 1e-12), Each(1));
  EXPECT_THAT(systematic_resample({0.0, 1.0, 0.0}, 1.0 - 1e-12), Each(1));
  EXPECT_THAT(systematic_resample({1.0}, 0.5), ElementsAre(0));
}

TEST(SystematicResample, RefusesAnOffsetOutsideTheOpenInterval) {
  EXPECT_THROW(systematic_resample({1.0}, 0.0), ContractViolation);
  EXPECT_THROW(systematic_resample({1.0}, 1.0), ContractViolation);
  EXPECT_THROW(systematic_resample({}, 0.5), ContractViolation);
}

TEST(EffectiveSampleSize, IsOneForOneAndNForEqualWeights) {
  EXPECT_DOUBLE_EQ(effective_sample_size({0.0, 1.0, 0.0}), 1.0);
  EXPECT_NEAR(effective_sample_size(std::vector<double>(100, 0.01)), 100.0, 1e-9);
  EXPECT_DOUBLE_EQ(effective_sample_size({0.5, 0.25, 0.25}), 1.0 / 0.375);
}

TEST(EffectiveSampleSize, LiesBetweenOneAndN) {
  for (std::uint32_t round = 0; round < 200; ++round) {
    Rng rng = test_rng(3000 + round);
    const std::vector<double> weights = random_weights(rng);
    EXPECT_GE(effective_sample_size(weights), 1.0 - 1e-12);
    EXPECT_LE(effective_sample_size(weights), static_cast<double>(weights.size()) * (1.0 + 1e-12));
  }
}

TEST(NormalisedWeights, DoNotMindTheScaleOfTheLogWeights) {
  for (const double scale : {0.0, -1e6, 1e6, -1e12}) {
    const std::vector<double> weights = normalised_weights({scale + std::log(3.0), scale});
    const double tolerance = 1e-15 + 1e-15 * std::abs(scale);  // the rounding of the sum above
    EXPECT_NEAR(weights[0], 0.75, tolerance);
    EXPECT_NEAR(weights[1], 0.25, tolerance);
  }
  EXPECT_THAT(normalised_weights({-1e300, 0.0, 1e300}), ElementsAre(0.0, 0.0, 1.0));
  EXPECT_THAT(normalised_weights({-7.0}), ElementsAre(1.0));
}

TEST(NormalisedWeights, RefuseWhatIsNotFinite) {
  EXPECT_THROW(normalised_weights({}), ContractViolation);
  EXPECT_THROW(normalised_weights({0.0, std::numeric_limits<double>::infinity()}), ContractViolation);
  EXPECT_THROW(normalised_weights({0.0, -std::numeric_limits<double>::infinity()}), ContractViolation);
  EXPECT_THROW(normalised_weights({0.0, std::numeric_limits<double>::quiet_NaN()}), ContractViolation);
  EXPECT_THROW(normalised_weights({std::numeric_limits<double>::quiet_NaN(), 0.0}), ContractViolation);
}

}  // namespace
}  // namespace cogslam
