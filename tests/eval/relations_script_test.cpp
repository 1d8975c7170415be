// Our relations error against the benchmark's reference script, on real logs and the same path.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>

#include "core/number_text.hpp"
#include "eval/metrics/path_completion.hpp"
#include "eval/metrics/relations.hpp"
#include "sensors/log/carmen_log.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cogslam {
namespace {

namespace fs = std::filesystem;

const fs::path kShared = fs::path(COGSLAM_SOURCE_DIR) / ".." / "shared";

struct Records {
  std::vector<Time> stamps;
  std::vector<Pose2> odometry;
};

Records read_records(const fs::path& file) {
  const CarmenLog log = read_carmen_log(file);
  Records records{{}, log.odometry};
  for (const Reading& reading : log.readings) records.stamps.push_back(reading.stamp);
  return records;
}

/// Every fifth record whose stamp is its own, its odometry bent by some smooth error.
std::vector<RegisteredPose> bent_path(const Records& records) {
  std::map<Time, int> uses;
  for (const Time stamp : records.stamps) ++uses[stamp];
  std::vector<RegisteredPose> path;
  for (std::size_t i = 3; i < records.stamps.size(); i += 5) {
    if (uses[records.stamps[i]] > 1) continue;
    const double t = 0.01 * static_cast<double>(i);
    path.push_back({i, records.odometry[i] * Pose2{0.2 * std::sin(t), 0.1 * std::cos(3 * t), 0.3 * std::sin(2 * t)}});
  }
  return path;
}

struct Expected {
  std::size_t count;
  double trans_mean, trans_std, rot_mean_deg, rot_std_deg;
};
using ExpectedErrors = std::array<Expected, 3>;  // local, global, all

void expect_equal(const RelationErrors& errors, const ExpectedErrors& expected) {
  const RelationStats* ours[] = {&errors.local, &errors.global, &errors.all};
  for (std::size_t i = 0; i < 3; ++i) {  // as far as the script prints digits
    EXPECT_EQ(ours[i]->count, expected[i].count);
    EXPECT_NEAR(ours[i]->trans_mean, expected[i].trans_mean, 0.51e-4);
    EXPECT_NEAR(ours[i]->trans_std, expected[i].trans_std, 0.51e-4);
    EXPECT_NEAR(degrees(ours[i]->rot_mean), expected[i].rot_mean_deg, 0.51e-2);
    EXPECT_NEAR(degrees(ours[i]->rot_std), expected[i].rot_std_deg, 0.51e-2);
  }
  EXPECT_EQ(errors.unmatched, 0U);
}

std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  for (int c = 0; pipe && (c = std::fgetc(pipe.get())) != EOF;) text += static_cast<char>(c);
  return text;
}

/// Python with NumPy, or an empty string.
std::string python() {
  for (const char* name : {"python3", "/usr/bin/python3"}) {
    if (std::system((std::string(name) + " -c 'import numpy' >/dev/null 2>&1").c_str()) == 0) return name;
  }
  return "";
}

/// What the script prints: "local: n=1139 trans 0.0238+-0.0245 (median 0.0161) rot 1.46+-1.19; ...".
ExpectedErrors parse_script(const std::string& text) {
  ExpectedErrors expected{};
  const char* names[] = {"local: ", "global: ", "all: "};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t start = text.find(names[i]);
    if (start == std::string::npos) ADD_FAILURE() << "no " << names[i] << "in: " << text;
    Expected& e = expected[i];
    double median = 0.0;
    const int read = std::sscanf(text.c_str() + start + std::string(names[i]).size(),
                                 "n=%zu trans %lf+-%lf (median %lf) rot %lf+-%lf", &e.count, &e.trans_mean,
                                 &e.trans_std, &median, &e.rot_mean_deg, &e.rot_std_deg);
    EXPECT_EQ(read, 6) << text;
  }
  return expected;
}

struct RealLog {
  const char* name;
  ExpectedErrors odometry;  ///< what the script prints for odometry alone
  ExpectedErrors bent;      ///< and for bent_path
};

void PrintTo(const RealLog& log, std::ostream* out) { *out << log.name; }

const RealLog kIntel{"intel",
                     {{{1139, 0.0238, 0.0245, 1.46, 1.19},
                       {881, 14.6954, 14.4700, 97.62, 43.03},
                       {2020, 6.4226, 12.0106, 43.40, 55.52}}},
                     {{{1139, 0.0775, 0.0466, 2.14, 2.13},
                       {881, 14.6792, 14.4643, 98.05, 42.35},
                       {2020, 6.4459, 11.9867, 43.97, 55.20}}}};
const RealLog kCsail{
    "mit-csail",
    {{{1050, 0.0454, 0.0712, 2.50, 4.16}, {139, 15.1427, 7.5133, 25.37, 13.63}, {1189, 1.8104, 5.4895, 5.17, 9.54}}},
    {{{1050, 0.0956, 0.0788, 2.53, 4.15}, {139, 15.0775, 7.5963, 28.99, 19.78}, {1189, 1.8471, 5.4703, 5.62, 11.54}}}};

class RelationsScript : public testing::TestWithParam<RealLog> {
 protected:
  void SetUp() override {
    if (!fs::exists(log_file())) GTEST_SKIP() << "needs the real log " << log_file();
    records_ = read_records(log_file());
    relations_ = read_relations(relations_file());
  }
  [[nodiscard]] static fs::path log_file() { return kShared / "data" / (std::string(GetParam().name) + ".clf.gz"); }
  [[nodiscard]] static fs::path relations_file() {
    return kShared / "data" / (std::string(GetParam().name) + ".relations");
  }
  [[nodiscard]] RelationErrors errors_of(const std::vector<Pose2>& path) const {
    return relation_errors(relations_, records_.stamps, records_.odometry, path);
  }
  /// What the script prints for these poses, to the last bit of each number.
  [[nodiscard]] ExpectedErrors run_script(const std::string& interpreter,
                                          const std::vector<RegisteredPose>& poses) const {
    std::string text;
    for (const RegisteredPose& p : poses) {
      const Pose2& T = p.T_map_base;
      for (const double value : {records_.stamps[p.record].seconds(), T.x, T.y, T.theta})
        text += number_text(value) + ' ';
      text += '\n';
    }
    const TemporaryFolder folder;
    const fs::path file = folder.file("path.txt", text);
    const fs::path script = kShared / "tools" / "relations_metric.py";
    const auto quoted = [](const fs::path& p) { return " '" + p.string() + "'"; };
    return parse_script(
        output_of(interpreter + quoted(script) + quoted(log_file()) + quoted(relations_file()) + quoted(file)));
  }

  Records records_;
  std::vector<Relation> relations_;
};

TEST_P(RelationsScript, EqualsWhatTheScriptPrinted) {
  expect_equal(errors_of(records_.odometry), GetParam().odometry);
  expect_equal(errors_of(complete_path(records_.odometry, bent_path(records_))), GetParam().bent);
}

TEST_P(RelationsScript, EqualsTheScriptRunNow) {
  const std::string interpreter = python();
  if (interpreter.empty()) GTEST_SKIP() << "needs Python 3 with NumPy to run the script itself";
  const auto poses = bent_path(records_);
  expect_equal(errors_of(complete_path(records_.odometry, poses)), run_script(interpreter, poses));
}

INSTANTIATE_TEST_SUITE_P(RealLogs, RelationsScript, testing::Values(kIntel, kCsail), [](const auto& instance) {
  return std::string(instance.param.name) == "intel" ? "Intel" : "Csail";
});

}  // namespace
}  // namespace cogslam
