#include <gtest/gtest.h>

#include <filesystem>

#include "core/config.hpp"
#include "tests/support/error_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cogslam {
namespace {

enum class Kind { kSimple, kCluttered };

/// Reads `text` as a scenario with one key of every type would.
void read_all(ConfigSection section) {
  ConfigSection slam = section.section("slam");
  double rate = 1.0, angle = 0.0;
  int particles = 1;
  std::uint32_t seed = 0;
  bool fast = false;
  std::string name;
  Eigen::Vector2d size(0, 0);
  std::vector<double> sizes;
  std::vector<Eigen::Vector2d> points;
  Kind kind = Kind::kSimple;
  slam.read("particles", particles, {1, 1000});
  slam.read("rate_hz", rate, kPositive);
  slam.read("free", rate);
  slam.read("share", rate, {0, 1});
  slam.read("count", particles);
  slam.read("seed", seed);
  slam.read("fast", fast);
  slam.read("name", name);
  slam.read("size_m", size, kNotNegative);
  slam.read("sizes_m", sizes);
  slam.read("points_m", points);
  slam.read_degrees("angle_deg", angle, {-90, 90});
  slam.read_choice("kind", kind, {{"simple", Kind::kSimple}, {"cluttered", Kind::kCluttered}});
  for (ConfigSection& box : slam.sections("boxes")) box.read("width_m", rate, {.min = 0.1});
  section.finish();
}

std::string error_of(const std::string& text) {
  return error_text([&] { read_all(ConfigSection::parse(text, "a.yaml")); });
}

struct Bad {
  std::string text;
  std::string message;
};

void PrintTo(const Bad& bad, std::ostream* out) { *out << bad.text; }

class ConfigError : public testing::TestWithParam<Bad> {};

TEST_P(ConfigError, HasItsMessage) { EXPECT_EQ(error_of(GetParam().text), GetParam().message); }

std::string deep(int levels) {
  return "slam: " + std::string(static_cast<std::size_t>(levels), '[') +
         std::string(static_cast<std::size_t>(levels), ']');
}

INSTANTIATE_TEST_SUITE_P(
    Values, ConfigError,
    testing::Values(
        Bad{"slam:\n  particles: x", "a.yaml:2:14: particles: expected a whole number in [1, 1000], found 'x'"},
        Bad{"slam: {particles: 0}", "a.yaml:1:19: particles: expected a whole number in [1, 1000], found '0'"},
        Bad{"slam: {particles: 3.5}", "a.yaml:1:19: particles: expected a whole number in [1, 1000], found '3.5'"},
        Bad{"slam: {particles: 1e2}", "a.yaml:1:19: particles: expected a whole number in [1, 1000], found '1e2'"},
        Bad{"slam: {particles: \"5\"}",
            "a.yaml:1:19: particles: expected a whole number in [1, 1000], found the text \"5\""},
        Bad{"slam: {particles: }", "a.yaml:1:19: particles: expected a whole number in [1, 1000], found nothing"},
        Bad{"slam: {particles: [1, 2]}",
            "a.yaml:1:19: particles: expected a whole number in [1, 1000], found a list of 2"},
        Bad{"slam: {particles: {a: 1}}",
            "a.yaml:1:8: particles: expected a whole number in [1, 1000], found a section"},
        Bad{"slam: {count: 3000000000}",
            "a.yaml:1:15: count: expected a whole number in [-2147483648, 2147483647], found '3000000000'"},
        Bad{"slam: {count: one}", "a.yaml:1:15: count: expected a whole number, found 'one'"},
        Bad{"slam: {seed: -1}", "a.yaml:1:14: seed: expected a whole number in [0, 4294967295], found '-1'"},
        Bad{"slam: {rate_hz: 0}", "a.yaml:1:17: rate_hz: expected a number above 0, found '0'"},
        Bad{"slam: {rate_hz: 4 Hz}", "a.yaml:1:17: rate_hz: expected a number above 0, found '4 Hz'"},
        Bad{"slam: {free: .nan}", "a.yaml:1:14: free: expected a number, found '.nan'"},
        Bad{"slam: {free: inf}", "a.yaml:1:14: free: expected a number, found 'inf'"},
        Bad{"slam: {free: 1e999}", "a.yaml:1:14: free: expected a number, found '1e999'"},
        Bad{"slam: {free: 0x10}", "a.yaml:1:14: free: expected a number, found '0x10'"},
        Bad{"slam: {share: 1.5}", "a.yaml:1:15: share: expected a number in [0, 1], found '1.5'"},
        Bad{"slam: {fast: yes}", "a.yaml:1:14: fast: expected true or false, found 'yes'"},
        Bad{"slam: {fast: 1}", "a.yaml:1:14: fast: expected true or false, found '1'"},
        Bad{"slam: {fast: \"true\"}", "a.yaml:1:14: fast: expected true or false, found the text \"true\""},
        Bad{"slam: {name: [a]}", "a.yaml:1:14: name: expected a text, found a list of 1"},
        Bad{"slam: {size_m: 3}", "a.yaml:1:16: size_m: expected two numbers [x, y], found '3'"},
        Bad{"slam: {size_m: [1, 2, 3]}", "a.yaml:1:16: size_m: expected two numbers [x, y], found a list of 3"},
        Bad{"slam: {size_m: [1, -2]}", "a.yaml:1:20: size_m: expected a number of at least 0, found '-2'"},
        Bad{"slam: {sizes_m: 3}", "a.yaml:1:17: sizes_m: expected a list of numbers [a, b, ...], found '3'"},
        Bad{"slam: {sizes_m: [1, x]}", "a.yaml:1:21: sizes_m: expected a number, found 'x'"},
        Bad{"slam: {points_m: [[1, 2], 3]}", "a.yaml:1:27: points_m: expected two numbers [x, y], found '3'"},
        Bad{"slam: {angle_deg: 91}", "a.yaml:1:19: angle_deg: expected a number in [-90, 90], found '91'"},
        Bad{"slam: {kind: clutterd}",
            "a.yaml:1:14: kind: expected one of simple, cluttered, found 'clutterd'; did you mean 'cluttered'?"},
        Bad{"slam: {kind: round}", "a.yaml:1:14: kind: expected one of simple, cluttered, found 'round'"},
        Bad{"slam: {boxes: 1}", "a.yaml:1:15: boxes: expected a list of sections, found '1'"},
        Bad{"slam: {boxes: [1]}", "a.yaml:1:16: boxes: expected a section of `key: value` lines, found '1'"},
        Bad{"slam: {boxes: [{width_m: 0}]}", "a.yaml:1:26: width_m: expected a number of at least 0.1, found '0'"},
        Bad{"slam: 5", "a.yaml:1:7: slam: expected a section of `key: value` lines, found '5'"}));

INSTANTIATE_TEST_SUITE_P(Keys, ConfigError,
                         testing::Values(Bad{"slam:\n  particels: 5",
                                             "a.yaml:2:3: unknown key 'particels'; did you mean 'particles'?"},
                                         Bad{"slma: {}", "a.yaml:1:1: unknown key 'slma'; did you mean 'slam'?"},
                                         Bad{"camera: {}", "a.yaml:1:1: unknown key 'camera'; known here: slam"},
                                         Bad{"slam: {boxes: [{width_m: 1}, {width: 1}]}",
                                             "a.yaml:1:31: unknown key 'width'; did you mean 'width_m'?"},
                                         Bad{"slam: {}\nslam: {}", "a.yaml:2:1: duplicate key 'slam', first on line 1"},
                                         Bad{"slam: {fast: true, seed: 1, fast: true}",
                                             "a.yaml:1:29: duplicate key 'fast', first on line 1"},
                                         Bad{"5: 1", "a.yaml:1:1: expected a name as key, found '5'"},
                                         Bad{"true: 1", "a.yaml:1:1: expected a name as key, found 'true'"},
                                         Bad{"~: 1", "a.yaml:1:1: expected a name as key, found nothing"},
                                         Bad{"? [a, b]\n: 1", "a.yaml:1:3: expected a name as key, found a list"},
                                         Bad{"? {a: b}\n: 1", "a.yaml:1:3: expected a name as key, found a section"},
                                         Bad{"<<: {a: 1}", "a.yaml:1:1: expected a name as key, found '<<'"}));

INSTANTIATE_TEST_SUITE_P(
    Text, ConfigError,
    testing::Values(Bad{"- 1\n- 2", "a.yaml:1:1: expected `key: value` lines, found a list of 2"},
                    Bad{"hello", "a.yaml:1:1: expected `key: value` lines, found 'hello'"},
                    Bad{"slam: &x {}", "a.yaml:1:7: anchor '&x'; expected a value without an anchor"},
                    Bad{"slam: {name: &x a, kind: *x}", "a.yaml:1:14: anchor '&x'; expected a value without an anchor"},
                    Bad{"slam: *x", "a.yaml:1:7: not valid YAML: the referenced anchor is not defined"},
                    Bad{"slam: !!map {}", "a.yaml:1:7: tag 'tag:yaml.org,2002:map'; expected a value without a tag"},
                    Bad{"slam: {}\n---\nslam: {}", "a.yaml:2:1: a second document begins; expected one document"},
                    Bad{deep(32), "a.yaml:1:38: nested too deep, expected at most 32 levels"},
                    Bad{deep(5000), "a.yaml:1:10007: nested too deep, expected at most 32 levels"},
                    Bad{"slam: {a: 1", "a.yaml:2:1: not valid YAML: end of map flow not found"},
                    Bad{"slam: [1, 2", "a.yaml:2:1: not valid YAML: end of sequence flow not found"},
                    Bad{"slam:\n  name: \"x\n", "a.yaml:2:9: quote is never closed"},
                    Bad{"slam: 1\n  fast: true", "a.yaml:2:7: not valid YAML: illegal map value"},
                    Bad{"slam:\n\tfast: true", "a.yaml:2:1: tab in the indent, expected spaces"},
                    Bad{std::string("slam: \0", 7), "a.yaml:1:7: expected a text file in UTF-8, found binary content"},
                    Bad{"slam:\n  \xff", "a.yaml:2:3: expected a text file in UTF-8, found binary content"}));

TEST(ConfigOverride, ErrorsNameTheOption) {
  const auto error_with = [](const std::string& path, const std::string& text) {
    return error_text([&] {
      auto config = ConfigSection::parse("slam: {particles: 3, boxes: [{width_m: 1}]}", "a.yaml");
      config.override_value(path, text);
      read_all(config);
    });
  };
  EXPECT_EQ(error_with("slam.particles", "50"), "no error");
  EXPECT_EQ(error_with("slam.particles", "x"),
            "--set slam.particles=x: particles: expected a whole number in [1, 1000], found 'x'");
  EXPECT_EQ(error_with("slam.particels", "50"),
            "--set slam.particels=50: unknown key 'particels'; did you mean 'particles'?");
  EXPECT_EQ(error_with("slam.particles.x", "1"), "--set slam.particles.x=1: 'x' lies under '3', expected a section");
  EXPECT_EQ(error_with("slam..x", "1"), "--set slam..x=1: expected names joined by dots, found an empty name");
  EXPECT_EQ(error_with("", "1"), "--set =1: expected names joined by dots, found an empty name");
  EXPECT_EQ(error_with("slam.boxes.1.width_m", "1"),
            "--set slam.boxes.1.width_m=1: expected an index below 1, found '1'");
  EXPECT_EQ(error_with("slam", "[1"), "--set slam=[1: not valid YAML: end of sequence flow not found");
  EXPECT_EQ(error_with("slam", "{a: 1, a: 2}"), "--set slam={a: 1, a: 2}: duplicate key 'a'");
}

TEST(ConfigFile, NamesAFileThatCannotBeRead) {
  const TemporaryFolder folder;
  const auto error_loading = [](const std::filesystem::path& file) {
    return error_text([&] { ConfigSection::load(file); });
  };
  const std::string name = folder.path().string();
  EXPECT_EQ(error_loading(folder.path()), name + ": is a folder, expected a file");
  EXPECT_EQ(error_loading(folder.path() / "no.yaml"), name + "/no.yaml: cannot be opened: No such file or directory");
  EXPECT_EQ(error_loading(folder.file("big.yaml", std::string(1'000'001, '#'))),
            name + "/big.yaml: file is too large, expected at most 1000000 bytes");
  EXPECT_EQ(error_loading(folder.file("a.yaml", "a: 1\na: 2")),
            name + "/a.yaml:2:1: duplicate key 'a', first on line 1");
}

TEST(ConfigSection, FailsAtTheKeyOrAtTheSection) {
  auto config = ConfigSection::parse("slam:\n  fast: true\n", "a.yaml");
  auto slam = config.section("slam");
  EXPECT_EQ(error_text([&] { slam.fail("fast", "bad"); }), "a.yaml:2:3: bad");
  EXPECT_EQ(error_text([&] { slam.fail("slow", "bad"); }), "a.yaml:1:1: bad");
  EXPECT_EQ(error_text([&] { config.section("eval").fail("x", "bad"); }), "a.yaml:1:1: bad");
  EXPECT_EQ(error_text([&] { ConfigSection::parse("", "a.yaml").fail("x", "bad"); }), "a.yaml: bad");
}

TEST(NearestName, AcceptsAThirdOfTheLetters) {
  EXPECT_EQ(nearest_name("particels", {"particles", "rate"}), "particles");
  EXPECT_EQ(nearest_name("rte", {"particles", "rate"}), "rate");
  EXPECT_EQ(nearest_name("re", {"particles", "rate"}), "");
  EXPECT_EQ(nearest_name("abcdef", {"abcxyz"}), "");
  EXPECT_EQ(nearest_name("abcdef", {"abcxyf", "abcdxf"}), "abcdxf");
  EXPECT_EQ(nearest_name("", {"a"}), "");
  EXPECT_EQ(nearest_name(std::string(1'000'000, 'a'), {"a"}), "");
}

}  // namespace
}  // namespace cogslam
