#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/exit_codes.hpp"
#include "core/angle.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cogslam {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// 16 x 12 cells, a wall down the middle.
std::string small_field() {
  std::string text;
  for (int y = 0; y < 12; ++y) {
    for (int x = 0; x < 16; ++x) text += std::string(x == 7 ? "1" : "0") + (x < 15 ? "," : "\n");
  }
  return text;
}

TEST(Sense, RecoverPrintsATableCsvOrJson) {
  const TemporaryFolder folder;
  const std::string map = folder.file("room.csv", small_field());
  const std::vector<std::string> common{"sense", "recover", map, "--samples", "30", "60", "--seeds", "2", "--quiet"};
  const auto with = [&](const std::vector<std::string>& flags) {
    std::vector<std::string> arguments = common;
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    return run_program(arguments);
  };
  const Outcome table = with({}), csv = with({"--csv"}), json = with({"--json"});
  EXPECT_EQ(table.code, kOk) << table.err;
  EXPECT_THAT(table.out, StartsWith("1 maps, seeds 1 to 2"));
  EXPECT_THAT(table.out, HasSubstr("2/2"));
  EXPECT_THAT(csv.out, StartsWith("map,n,choice,prior,k,seeds,relative_error_mean"));
  EXPECT_THAT(csv.out, HasSubstr("\nroom,192,random,haar,30,2,"));
  EXPECT_EQ(nlohmann::json::parse(json.out)["scores"].size(), 6U);
  EXPECT_EQ(with({"--json", "--csv"}).code, kUsageError);
}

TEST(Sense, RecoverSaysWhatIsWrong) {
  const TemporaryFolder folder;
  const std::string map = folder.file("room.csv", small_field());
  const auto error = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"sense", "recover"});
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, kUsageError);
    EXPECT_EQ(outcome.out, "");
    return outcome.err;
  };
  EXPECT_EQ(error({map, "--samples", "193"}), "cogslam: K = 193 is more than the 192 cells of map 'room'\n");
  EXPECT_EQ(error({map, "--samples", "0"}), "cogslam: K = 0: expected at least one cell to sense\n");
  EXPECT_EQ(error({map, "--prior", "har"}), "cogslam: unknown prior 'har'; did you mean 'haar'?\n");
  EXPECT_EQ(error({map, "--cells", "ray"}), "cogslam: unknown choice of cells 'ray'; did you mean 'rays'?\n");
  EXPECT_EQ(error({map, "--prior", "fourier"}), "cogslam: unknown prior 'fourier', expected one of haar, dct, tv\n");
  EXPECT_THAT(error({"nowhere.csv"}), StartsWith("cogslam: nowhere.csv: "));
  const std::string empty = folder.file("empty.csv", "\n");
  EXPECT_EQ(error({empty}), "cogslam: " + empty + ": no values, expected a row of numbers per line\n");
  EXPECT_THAT(error({}), HasSubstr("MAP is required"));
}

TEST(Sense, RecoverReadsMapsOfRosAndTheirPictures) {
  const TemporaryFolder folder;
  std::string csv, plain = "P2\n# as map_server writes it\n16 12\n255\n";
  for (int y = 0; y < 12; ++y) {
    for (int x = 0; x < 16; ++x) {
      const bool wall = x == 7 || (y == 2 && x < 4), unknown = y > 8;
      csv += std::string(wall ? "1" : unknown ? "0.5" : "0") + (x < 15 ? "," : "\n");
      plain += wall ? "0 " : unknown ? "205 " : "254 ";
    }
  }
  const std::string pgm = folder.file("room.pgm", plain);
  const std::string yaml = folder.file("room.yaml", "image: room.pgm\nresolution: 0.1\norigin: [-1, -2, 0]\n");
  const auto recovered = [](const std::string& map) {
    const Outcome outcome =
        run_program({"sense", "recover", map, "--samples", "40", "--prior", "tv", "--seeds", "2", "--json"});
    EXPECT_EQ(outcome.code, kOk) << outcome.err;
    nlohmann::json scores = nlohmann::json::parse(outcome.out)["scores"];
    return scores[0]["relative_error"].dump();
  };
  const std::string expected = recovered(folder.file("room.csv", csv));
  EXPECT_EQ(recovered(pgm), expected);
  EXPECT_EQ(recovered(yaml), expected);
  EXPECT_THAT(run_program({"sense", "recover", folder.file("cut.pgm", "P5 4 4 255\nabc"), "--samples", "2"}).err,
              HasSubstr("cut.pgm: cut off after 3 pixels, expected 4 x 4"));
  EXPECT_THAT(run_program({"sense", "recover", folder.file("odd.pgm", "0,1\n"), "--samples", "2"}).err,
              HasSubstr("odd.pgm: neither PGM (P2, P5) nor PNG, expected one of them"));
}

TEST(Sense, OffsetsPrintsBothKindsOfMapsOrCsv) {
  const Outcome both = run_program({"sense", "offsets", "--draws", "4", "-j", "1"});
  EXPECT_EQ(both.code, kOk) << both.err;
  EXPECT_THAT(both.out, StartsWith("drawn: 4 pairs, seed 1, up to 3 cells and 10 deg, 2048 of 2048 cells sampled\n"));
  EXPECT_THAT(both.out, HasSubstr("\nscanned: 4 pairs, seed 1, "));
  const Outcome csv = run_program({"sense", "offsets", "--draws", "3", "--source", "scanned", "--csv"});
  EXPECT_THAT(csv.out, StartsWith("x_m,y_m,heading_deg,dx_m,"));
  EXPECT_EQ(std::count(csv.out.begin(), csv.out.end(), '\n'), 4);
}

TEST(Sense, HallwayPrintsARowForEachDrive) {
  const Outcome table = run_program({"sense", "hallway", "--seeds", "1", "--samples", "2048", "--step", "4"});
  EXPECT_EQ(table.code, kOk) << table.err;
  EXPECT_THAT(table.out, StartsWith("hallway, looks at most 4 m and 30 deg apart, partial maps of 64 x 32 cells, "));
  EXPECT_THAT(table.out, HasSubstr("\nworst ratio: heading 0."));
}

TEST(Sense, MotionSaysWhatIsWrong) {
  const auto error = [](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "sense");
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, kUsageError);
    EXPECT_EQ(outcome.out, "");
    return outcome.err;
  };
  EXPECT_EQ(error({"offsets", "--samples", "2049"}),
            "cogslam: samples: expected 0 (all) to 2048, the cells of a partial map, found 2049\n");
  EXPECT_EQ(error({"offsets", "--source", "scaned"}), "cogslam: unknown source 'scaned'; did you mean 'scanned'?\n");
  EXPECT_EQ(error({"hallway", "--samples", "0"}),
            "cogslam: samples: expected 1 to 2048, the cells of a partial map, found 0\n");
  EXPECT_EQ(error({"hallway", "--samples", "2049"}),
            "cogslam: samples: expected 1 to 2048, the cells of a partial map, found 2049\n");
  EXPECT_EQ(error({"hallway", "--seeds", "1", "--across", "4", "--ahead", "4", "--samples", "16"}),
            "cogslam: none of 111 links between partial maps has 40 cells in common, expected a smaller step or larger "
            "maps\n");
  EXPECT_EQ(error({"hallway", "--step", "0"}), "cogslam: step_m: expected more than 0\n");
}

TEST(Sense, LogSaysWhatIsWrong) {
  const TemporaryFolder folder;
  const std::string log = folder.file("odometry.clf", "ODOM 0 0 0 0 0 0 1.0 host 1.0\nODOM 1 0 0 0 0 0 2.0 host 2.0\n");
  const std::string relations = folder.file("log.relations", "1.0 2.0 1 0 0 0 0 0\n");
  const auto error = [](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"sense", "log"});
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, kUsageError);
    return outcome.err;
  };
  EXPECT_EQ(error({log, "--relations", relations}),
            "cogslam: " + log + ": no laser scan in the log, expected FLASER or ROBOTLASER1 lines\n");
  EXPECT_THAT(error({"nowhere.clf", "--relations", relations}), StartsWith("cogslam: nowhere.clf: "));
  EXPECT_EQ(error({log, "--relations", relations, "--samples", "0"}),
            "cogslam: samples: expected 1 to 2048, the cells of a partial map, found 0\n");
  EXPECT_THAT(error({log}), HasSubstr("--relations is required"));
}

/// FLASER lines of a robot that drives along a corridor 4 m wide, whose end wall stands at x = 8 m; odometry tells
/// every way a fifth too long.
std::string drawn_log() {
  std::string text;
  for (int k = 0; k < 6; ++k) {
    const double x = 0.5 * k;
    text += "FLASER 181";
    for (int i = 0; i <= 180; ++i) {
      const double angle = radians(i - 90.0), side = std::abs(std::sin(angle));
      const double wall = side > 1e-9 ? 2.0 / side : 100.0;
      text += fmt::format(" {:.3f}", std::min(wall, std::cos(angle) > 1e-9 ? (8.0 - x) / std::cos(angle) : 100.0));
    }
    const std::string odometry = fmt::format(" {0:.3f} 0 0", 1.2 * x);
    text += fmt::format("{0}{0} {1}.0 host {1}.0\n", odometry, k + 1);
  }
  return text;
}

/// Two scans of the same walls, `metres` apart by odometry.
std::string leap_log(double metres) {
  std::string ranges;
  for (int i = 0; i <= 180; ++i) ranges += i % 60 < 30 ? " 4.0" : " 6.0";
  const auto line = [&](double x, int stamp) {
    return fmt::format("FLASER 181{0} {1} 0 0 {1} 0 0 {2}.0 host {2}.0\n", ranges, x, stamp);
  };
  return line(0.0, 1) + line(metres, 2);
}

TEST(Sense, LogWithoutOverlapSaysSo) {
  const TemporaryFolder folder;
  const std::string relations = folder.file("log.relations", "1.0 2.0 1 0 0 0 0 0\n");
  const auto run = [&](const std::string& text) {
    return run_program({"sense", "log", folder.file("leap.clf", text), "--relations", relations});
  };
  const Outcome apart = run(leap_log(50.0)), near = run(leap_log(0.6));
  EXPECT_EQ(apart.code, kUsageError);
  EXPECT_EQ(apart.out, "");
  EXPECT_EQ(
      apart.err,
      "cogslam: " + (folder.path() / "leap.clf").string() +
          ": none of 1 links between partial maps has 40 cells in common, expected a smaller step or larger maps\n");
  EXPECT_EQ(near.code, kOk) << near.err;
  EXPECT_THAT(near.out, HasSubstr("(0 without overlap)"));
  const Outcome once = run(leap_log(0.6) + leap_log(50.6).substr(leap_log(50.6).find('\n') + 1));
  EXPECT_THAT(once.out, HasSubstr("3 partial maps, 1 links not estimated (1 without overlap)")) << once.err;
}

TEST(Sense, LogCorrectsTheWayOfADrawnOne) {
  const TemporaryFolder folder;
  const std::string log = folder.file("drawn.clf", drawn_log());
  const std::string relations = folder.file("drawn.relations", "1.0 6.0 2.5 0 0 0 0 0\n");
  const Outcome outcome = run_program({"sense", "log", log, "--relations", relations});
  EXPECT_EQ(outcome.code, kOk) << outcome.err;
  EXPECT_THAT(outcome.out,
              StartsWith("drawn.clf: 6 records, 6 scans\n6 partial maps, 0 links not estimated (0 without overlap), "));
  const auto translation = [&](const std::string& path) {
    std::istringstream row(outcome.out.substr(outcome.out.find(path)));
    std::string name, split;
    double count = 0.0, metres = 0.0;
    row >> name >> split >> count >> metres;
    return metres;
  };
  EXPECT_NEAR(translation("odometry   all"), 0.5, 1e-3) << outcome.out;
  // From the first look the end wall is out of reach: of five links one keeps its 0.1 m.
  EXPECT_THAT(outcome.out, HasSubstr(", 1 with a direction not observed"));
  EXPECT_LT(translation("corrected  all"), 0.11) << outcome.out;
}

TEST(Sense, FiguresWritesFilesAndNamesThoseThereAre) {
  const TemporaryFolder folder;
  const std::string map = folder.file("room.csv", small_field()), out = (folder.path() / "figures").string();
  const Outcome outcome = run_program({"sense", "figures", "5", "--map", map, "--seeds", "2", "--out", out, "--quiet"});
  EXPECT_EQ(outcome.code, kOk) << outcome.err;
  EXPECT_EQ(outcome.out, out + "\n");
  for (const char* name : {"figure_05.csv", "figure_05.svg", "figure_05.png"}) {
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "figures" / name)) << name;
  }
  const Outcome unknown = run_program({"sense", "figures", "1"});
  EXPECT_EQ(unknown.code, kUsageError);
  EXPECT_THAT(unknown.err, StartsWith("cogslam: no figure 1, expected one of "));
}

}  // namespace
}  // namespace cogslam
