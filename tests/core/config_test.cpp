#include "core/config.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/angle.hpp"
#include "core/rng.hpp"

namespace cogslam {
namespace {

using testing::ElementsAre;

enum class Kind { kSimple, kCluttered };

/// One value of every type; a stage's config in small.
struct Sample {
  double rate_hz = 40.0;
  int particles = 100;
  std::uint32_t seed = 1;
  bool fast = false;
  std::string name = "room";
  Eigen::Vector2d size_m{3.0, 4.0};
  std::vector<double> cells_m{1.0, 0.1};
  std::vector<Eigen::Vector2d> way_m{};
  double noise = radians(2.0);
  Kind kind = Kind::kSimple;
  std::vector<double> boxes{};

  bool operator==(const Sample&) const = default;
};

Sample read_sample(ConfigSection& section) {
  Sample s;
  section.read("name", s.name);
  ConfigSection slam = section.section("slam");
  slam.read("rate_hz", s.rate_hz);
  slam.read("particles", s.particles);
  slam.read("seed", s.seed);
  slam.read("fast", s.fast);
  slam.read("size_m", s.size_m);
  slam.read("cells_m", s.cells_m);
  slam.read("way_m", s.way_m);
  slam.read_degrees("noise_deg", s.noise);
  slam.read_choice("kind", s.kind, {{"simple", Kind::kSimple}, {"cluttered", Kind::kCluttered}});
  for (ConfigSection& box : section.sections("boxes")) box.read("width_m", s.boxes.emplace_back(0.5));
  section.finish();
  return s;
}

TEST(Config, EmptyTextLeavesEveryDefault) {
  for (const char* text : {"", "# nothing\n", "---\n", "{}", "slam:\n", "slam: {}\nboxes: []", "boxes:\n"}) {
    auto config = ConfigSection::parse(text, "a.yaml");
    EXPECT_EQ(read_sample(config), Sample{}) << text;
  }
}

TEST(Config, ReadsEveryType) {
  auto config = ConfigSection::parse(
      "name: \"a b\"  # a comment\n"
      "slam:\n"
      "  rate_hz: 2.5e1\n"
      "  particles: 7\n"
      "  seed: 4294967295\n"
      "  fast: true\n"
      "  size_m: [1, -2.5]\n"
      "  cells_m: [0.5]\n"
      "  way_m: [[0, 1], [2, 3]]\n"
      "  noise_deg: 90\n"
      "  kind: cluttered\n"
      "boxes:\n"
      "  - width_m: 0.2\n"
      "  - {}\n",
      "a.yaml");
  EXPECT_TRUE(config.has("name"));
  EXPECT_FALSE(config.has("world"));
  const Sample expected{.rate_hz = 25.0,
                        .particles = 7,
                        .seed = 4294967295,
                        .fast = true,
                        .name = "a b",
                        .size_m = {1.0, -2.5},
                        .cells_m = {0.5},
                        .way_m = {{0.0, 1.0}, {2.0, 3.0}},
                        .noise = radians(90.0),
                        .kind = Kind::kCluttered,
                        .boxes = {0.2, 0.5}};
  EXPECT_EQ(read_sample(config), expected);
}

TEST(Config, ResolvedListsWhatWasReadWithDefaults) {
  auto config = ConfigSection::parse("slam: {particles: 7, noise_deg: 2.5}\nboxes: [{width_m: 0.2}, {}]", "a.yaml");
  read_sample(config);
  EXPECT_EQ(config.resolved(),
            "name: room\n"
            "slam:\n"
            "  rate_hz: 40\n"
            "  particles: 7\n"
            "  seed: 1\n"
            "  fast: false\n"
            "  size_m: [3, 4]\n"
            "  cells_m: [1, 0.1]\n"
            "  way_m: []\n"
            "  noise_deg: 2.5\n"
            "  kind: simple\n"
            "boxes:\n"
            "  - width_m: 0.2\n"
            "  - width_m: 0.5\n");
}

TEST(Config, ResolvedTextLoadsAsItself) {
  Rng rng({.seed = 40, .purpose = Purpose::kWorld});
  const auto number = [&] { return rng.normal() * std::exp(rng.uniform(-40, 40)); };
  for (int i = 0; i < 300; ++i) {
    const Sample sample{.rate_hz = number(),
                        .particles = static_cast<int>(rng.bits()),
                        .seed = rng.bits(),
                        .fast = rng.below(2) == 1,
                        .name = std::string("null \"\\\n\t") + static_cast<char>(32 + rng.below(95)),
                        .size_m = {number(), number()},
                        .cells_m = {number(), number()},
                        .way_m = {{number(), number()}},
                        .noise = rng.uniform(-3.5, 3.5)};  // a quarter of such angles have no exact degrees
    auto empty = ConfigSection::parse("", "a.yaml");
    Sample s = sample;
    const auto read = [](ConfigSection& c, Sample& v) {
      c.read("name", v.name);
      c.read("rate_hz", v.rate_hz);
      c.read("particles", v.particles);
      c.read("seed", v.seed);
      c.read("fast", v.fast);
      c.read("size_m", v.size_m);
      c.read("cells_m", v.cells_m);
      c.read("way_m", v.way_m);
      c.read_degrees("noise_deg", v.noise);
      c.finish();
    };
    read(empty, s);
    EXPECT_NEAR(s.noise, sample.noise, 1e-15);
    auto again = ConfigSection::parse(empty.resolved(), "resolved.yaml");
    Sample back;
    read(again, back);
    ASSERT_EQ(back, s) << empty.resolved();
    ASSERT_EQ(again.resolved(), empty.resolved());
  }
}

TEST(Config, KeepsARoundFigureOfDegrees) {
  for (int tenths = -3600; tenths <= 3600; ++tenths) {
    auto config = ConfigSection::parse("", "a.yaml");
    double angle = radians(tenths / 10.0);
    config.read_degrees("a_deg", angle);
    EXPECT_EQ(angle, radians(tenths / 10.0));
    auto again = ConfigSection::parse(config.resolved(), "b.yaml");
    double figure = 0.0;
    again.read("a_deg", figure);
    ASSERT_EQ(figure, tenths / 10.0);
  }
}

TEST(Config, QuotesTextsThatYamlWouldTakeForSomethingElse) {
  for (const std::string text : {"null", "~", "", "true", "5", "- a", "a: b", "# a", "&a", "\"", "\x7f", "\xc3\xa9"}) {
    auto config = ConfigSection::parse("", "a.yaml");
    std::string value = text;
    config.read("name", value);
    auto again = ConfigSection::parse(config.resolved(), "b.yaml");
    std::string back;
    again.read("name", back);
    EXPECT_EQ(back, text);
  }
}

TEST(Config, OverridesReplaceAndAddValues) {
  auto config = ConfigSection::parse("slam: {particles: 7}\nboxes: [{width_m: 0.2}, {}]", "a.yaml");
  config.override_value("slam.particles", "50");
  config.override_value("slam.size_m", "[5, 6]");
  config.override_value("name", "hall");
  config.override_value("boxes.1.width_m", "0.3");
  const Sample s = read_sample(config);
  EXPECT_EQ(s.particles, 50);
  EXPECT_EQ(s.size_m, Eigen::Vector2d(5, 6));
  EXPECT_EQ(s.name, "hall");
  EXPECT_THAT(s.boxes, ElementsAre(0.2, 0.3));

  auto empty = ConfigSection::parse("", "a.yaml");
  empty.override_value("slam.fast", "true");
  EXPECT_TRUE(read_sample(empty).fast);
}

TEST(Config, SectionsAreSharedBetweenReaders) {
  auto config = ConfigSection::parse("slam: {a: 1, b: 2}", "a.yaml");
  int a = 0, b = 0;
  config.section("slam").read("a", a);
  config.section("slam").read("b", b);
  config.finish();
  EXPECT_EQ(config.resolved(), "slam:\n  a: 1\n  b: 2\n");
}

TEST(Config, FindsFilesFromWhereTheyAreNamed) {
  const auto read = [](const std::string& text, const std::string& file, const std::string& set = {}) {
    ConfigSection config = ConfigSection::parse(text, file);
    if (!set.empty()) config.override_value("map", set);
    std::filesystem::path value = "none";
    config.read("map", value);
    return std::pair(value.string(), config.resolved());
  };
  EXPECT_EQ(read("", "/a/s.yaml"), std::pair(std::string("none"), std::string("map: none\n")));
  EXPECT_EQ(read("map: m/x.yaml", "/a/s.yaml"), std::pair(std::string("/a/m/x.yaml"), std::string("map: m/x.yaml\n")));
  EXPECT_EQ(read("map: /b/x.yaml", "/a/s.yaml"),
            std::pair(std::string("/b/x.yaml"), std::string("map: \"/b/x.yaml\"\n")));
  EXPECT_EQ(read("map: ../x.yaml", "/a/b/s.yaml"),
            std::pair(std::string("/a/b/../x.yaml"), std::string("map: \"/a/x.yaml\"\n")));
  const std::string here = std::filesystem::current_path().string();
  EXPECT_EQ(read("map: y.yaml", "/a/s.yaml", "x.yaml"),
            std::pair(std::string("x.yaml"), "map: \"" + here + "/x.yaml\"\n"));
}

}  // namespace
}  // namespace cogslam
