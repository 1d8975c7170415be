#include "eval/sweep/plan.hpp"

#include <optional>

#include "core/hash.hpp"
#include "core/number_text.hpp"
#include "eval/sweep/resolved_text.hpp"
#include "eval/sweep/sweep_file.hpp"

namespace cogslam {
namespace {

// Counts up when the same configuration comes to mean something else: old results are then not taken for new ones.
constexpr int kEpisodeFormat = 1;

Hash new_key(const char* of) {
  return Hash().add(std::string(of)).add(std::string(COGSLAM_VERSION)).add(kEpisodeFormat);
}

/// Of the surfaces themselves: the file of a map can change under its name.
std::uint64_t geometry_hash(const World& world) {
  Hash hash;
  for (const Segment& s : world.segments()) hash.add(s.a.x()).add(s.a.y()).add(s.b.x()).add(s.b.y());
  return hash.value();
}

/// The shared filter section, at one cell size.
std::string slam_lines(const ResolvedText& resolved, double cell_size) {
  std::string lines = resolved.lines("slam");
  const std::string key = "  cell_sizes_m:";
  const std::size_t at = lines.find(key);
  return lines.replace(at, lines.find('\n', at) - at, key + " [" + number_text(cell_size) + "]");
}

/// What all episodes of a world at one cell size share.
struct WorldText {
  std::string readings;  ///< all that the readings depend on, but the seed
  std::string rest;      ///< map and filter
  std::uint64_t geometry = 0;
};

WorldText world_text(const SweepWorld& world, double cell_size) {
  const ResolvedText resolved(world.scenario.resolved);
  return {.readings = resolved.without({"name", "seed", "map", "slam", "variants"}),
          .rest = resolved.lines("map") + slam_lines(resolved, cell_size),
          .geometry = geometry_hash(world.scenario.world)};
}

bool is_dense(const SweepVariant& variant) { return variant.config.slam.store.kind == StoreKind::kDense; }

/// The first dense variant with the same poses and particles; else the first with the same poses; never one after it
/// that is dense like itself.
std::optional<std::size_t> baseline_of(const std::vector<SweepVariant>& variants, std::size_t v) {
  const VariantConfig& of = variants[v].config;
  std::optional<std::size_t> any;
  for (std::size_t b = 0; b < variants.size(); ++b) {
    const VariantConfig& candidate = variants[b].config;
    if (!is_dense(variants[b]) || candidate.true_poses != of.true_poses) continue;
    if (is_dense(variants[v]) && b >= v) break;
    if (candidate.true_poses || candidate.slam.particles == of.slam.particles) return b;
    if (!any) any = b;
  }
  return any;
}

std::string scenario_text(const std::string& world, std::uint32_t seed, const WorldText& text,
                          const std::string& variants) {
  return "name: \"" + world + "\"\nseed: " + std::to_string(seed) + "\n" + text.readings + text.rest + "variants:\n" +
         variants;
}

std::string key_of(const char* of, const WorldText& text, const std::string& scenario) {
  return new_key(of).add(text.geometry).add(scenario).hex();
}

PlannedEpisode plan_episode(const SweepWorld& world, const WorldText& text, const SweepVariant& variant,
                            const SweepVariant* baseline, std::uint32_t seed) {
  PlannedEpisode episode{.world = world.name, .variant = variant.config.name, .seed = seed};
  episode.true_poses = variant.config.true_poses;
  episode.particles = variant.config.slam.particles;
  episode.readings_key = new_key("readings").add(text.geometry).add(seed).add(text.readings).hex();
  episode.scenario = scenario_text(world.name, seed, text, variant.resolved);
  episode.own_key = episode.key = key_of("episode", text, episode.scenario);
  if (baseline == nullptr) return episode;
  episode.baseline = baseline->config.name;
  episode.baseline_key = key_of("episode", text, scenario_text(world.name, seed, text, baseline->resolved));
  episode.scenario = scenario_text(world.name, seed, text, baseline->resolved + variant.resolved);
  episode.key = key_of("episode", text, episode.scenario);
  return episode;
}

/// The text must say what it was made from, and some contradictions show only at a cell size.
void check_episode(const PlannedEpisode& episode) {
  const std::string name = "world " + episode.world + ", variant " + episode.variant + ", resolved";
  read_scenario(ConfigSection::parse(episode.scenario, name), episode.world);
}

void plan_world(const SweepFile& config, const SweepWorld& world, std::vector<PlannedEpisode>& episodes) {
  const std::vector<SweepVariant> variants = config.variants(world.scenario.slam);
  for (const double cell_size : config.cell_sizes) {
    const WorldText text = world_text(world, cell_size);
    for (std::size_t v = 0; v < variants.size(); ++v) {
      const auto baseline = baseline_of(variants, v);
      for (const std::uint32_t seed : config.seeds) {
        episodes.push_back(plan_episode(world, text, variants[v], baseline ? &variants[*baseline] : nullptr, seed));
        episodes.back().cell_size = cell_size;
        if (seed == config.seeds.front()) check_episode(episodes.back());
      }
    }
  }
}

}  // namespace

SweepPlan load_sweep(const std::filesystem::path& file) {
  const SweepFile config = SweepFile::load(file);
  SweepPlan plan{.name = config.name};
  for (const SweepWorld& world : config.worlds()) plan_world(config, world, plan.episodes);
  return plan;
}

}  // namespace cogslam
