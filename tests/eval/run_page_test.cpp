#include "eval/page/run_page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "core/check.hpp"
#include "eval/page/player_data.hpp"
#include "eval/page/score_tables.hpp"
#include "eval/page/score_words.hpp"
#include "eval/report/markup.hpp"
#include "tests/support/short_scenario.hpp"

namespace cogslam {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;
using testing::Not;

constexpr PageParts kParts{.style = "p { margin: 0; }\n", .script = "start();\n", .notices = "Notice of a part"};

/// A drive of two seconds through a filter and a mapper, both traced.
struct TracedRun {
  explicit TracedRun(int threads = 1)
      : scenario(short_scenario()),
        drive(record_drive(scenario)),
        workers(threads),
        episode(replay_variants(scenario.name, drive.recording, {.truth = &drive.truth}, scenario.variants,
                                scenario.seed, workers, {}, TraceLimits{})) {}

  Scenario scenario;
  Drive drive;
  Workers workers;
  Episode episode;

  [[nodiscard]] RunFiles files() const {
    return {.episode = episode,
            .recording = drive.recording,
            .truth = &drive.truth,
            .config_name = "scenario.yaml",
            .config = scenario.resolved};
  }
};

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// The content of <script id="...">.
std::string script_of(const std::string& page, const std::string& id) {
  const std::size_t begin = page.find('>', page.find("id=\"" + id + "\"")) + 1;
  return page.substr(begin, page.find("</script>", begin) - begin);
}

TEST(HtmlText, EscapesAllThatHtmlReadsOtherwise) {
  EXPECT_EQ(markup_text("a<b>&\"c\"'d' \xC3\xA9"), "a&lt;b&gt;&amp;&quot;c&quot;&#39;d&#39; \xC3\xA9");
}

TEST(HtmlDocument, ForbidsToFetchAnything) {
  const std::string page = html_document("t", "<p>x</p>\n", kParts);
  EXPECT_THAT(page, HasSubstr("default-src 'none'; img-src data:;"));
  EXPECT_THAT(page, HasSubstr("<!--\nNotice of a part\n-->"));
  EXPECT_THAT(page, HasSubstr("<script>\nstart();\n</script>"));
  EXPECT_THAT(html_document("t", "", {.style = "p{}"}), Not(HasSubstr("<script")));
}

TEST(HtmlDocument, RefusesPartsThatWouldEndTheirElement) {
  EXPECT_THROW(html_document("t", "", {.script = "x = '</script>'"}), ContractViolation);
  EXPECT_THROW(html_document("t", "", {.script = "x = '<!--'"}), ContractViolation);
  EXPECT_THROW(html_document("t", "", {.style = "</style>"}), ContractViolation);
  EXPECT_THROW(html_document("t", "", {.notices = "a --> b"}), ContractViolation);
}

TEST(ScoreWords, ExplainEveryScoreInTheOrderOfTheRecord) {
  const ordered_json scores = ordered_json::parse(scores_json({.variants = {VariantRecord{}}}))[0];
  std::vector<std::string> keys, explained;
  for (const auto& [key, value] : scores.items()) keys.push_back(key);
  for (const ScoreWords& words : score_words()) {
    explained.emplace_back(words.key);
    EXPECT_FALSE(words.name.empty() || words.meaning.empty() || words.good.empty()) << words.key;
  }
  EXPECT_EQ(explained, keys);
}

TEST(ScoreTables, SayWhatWasNotMeasuredAndNeverNan) {
  RunRecord record{.scenario = "s"};
  VariantRecord v{.name = "og", .store = "dense", .cell_size_m = 0.1, .particles = 3};
  v.scores.path_mse_m2 = std::numeric_limits<double>::quiet_NaN();
  v.scores.grid_mse = 0.25;
  record.variants.push_back(v);
  const std::string html = headline_table(record) + explained_table(record, 0) + all_scores_table(record);
  EXPECT_THAT(html,
              HasSubstr(R"(data-key="path_mse_m2" data-variant="0" data-value="null"><span title="not measured">)"));
  EXPECT_THAT(html, HasSubstr(R"(data-key="grid_mse" data-variant="0" data-value="0.25">0.25</td>)"));
  EXPECT_THAT(html, Not(testing::ContainsRegex(">-?nan")));
  EXPECT_THAT(html, Not(testing::ContainsRegex(">-?inf")));
}

TEST(ScoreTables, ShowRootsBesideMeansOfSquares) {
  RunRecord record{.scenario = "s", .variants = {VariantRecord{.name = "og"}}};
  record.variants[0].scores.path_mse_m2 = 0.0004;
  EXPECT_THAT(explained_table(record, 0),
              HasSubstr(R"(data-value="0.0004">0.0004<span class="part"><i>root</i> 0.02 m)"));
  EXPECT_THAT(headline_table(record), HasSubstr(R"(data-derived="root" data-sort="0.02">0.0200</td>)"));
}

TEST(RunPage, HoldsTheRecordWithoutCosts) {
  const TracedRun run;
  const std::string page = run_page(run.files(), {}, kParts);
  const ordered_json record = ordered_json::parse(script_of(page, "record"));
  ordered_json expected = ordered_json::parse(to_json(run.episode.record));
  for (auto& variant : expected["variants"]) variant.erase("costs");
  EXPECT_EQ(record, expected);
  EXPECT_THAT(page, Not(HasSubstr("cpu_s")));
}

TEST(RunPage, IsTheSameForTheSameRunWithAnyNumberOfThreads) {
  const std::string one = run_page(TracedRun(1).files(), {}, kParts);
  EXPECT_EQ(run_page(TracedRun(3).files(), {}, kParts), one);
  EXPECT_EQ(run_page(TracedRun(1).files(), {}, kParts), one);
}

TEST(RunPage, WithoutScriptIsStaticAndHasItsCurvesAsAPicture) {
  const TracedRun run;
  const std::string page = run_page(run.files(), {{0, true, "png"}, {1, false, "png"}}, {.style = kParts.style});
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, HasSubstr("<img src=\"data:image/svg+xml;base64,"));
  EXPECT_EQ(count_of(page, "<img src=\"data:image/png;base64,cG5n\""), 2U);
  EXPECT_THAT(page, HasSubstr("This is the static page"));
  EXPECT_THAT(page, HasSubstr("id=\"headlines\""));
}

/// Names of variants and scenarios are checked, but those of logs come from files.
TEST(RunPage, LeavesNoNameAWayIntoItsMarkup) {
  TracedRun run;
  const std::string name = "</script><img src=x onerror=alert(1)>";
  run.episode.record.scenario = "<b>\"a\" & 'b'</script>";
  run.drive.recording.source = name;
  run.episode.record.variants[0].name = run.episode.runs[0].record.name = name;
  for (const PageParts& parts : {kParts, PageParts{.style = kParts.style}}) {
    const std::string page = run_page(run.files(), {{0, true, "png"}}, parts);
    EXPECT_THAT(page, Not(HasSubstr("<img src=x")));
    EXPECT_THAT(page, Not(HasSubstr("<b>\"a\"")));
    EXPECT_EQ(count_of(page, "<script"), count_of(page, "</script>"));
    EXPECT_THAT(page, HasSubstr("<title>&lt;b&gt;&quot;a&quot; &amp; &#39;b&#39;&lt;/script&gt; - cogslam</title>"));
  }
  const std::string page = run_page(run.files(), {}, kParts);
  EXPECT_EQ(ordered_json::parse(script_of(page, "record"))["variants"][0]["name"], name);
}

TEST(RunPage, SaysThatNothingWasMeasured) {
  Recording recording;
  recording.readings.resize(3);
  Workers workers(1);
  const Episode episode = replay_variants("empty", recording, {}, {VariantConfig{.name = "og"}}, 1, workers);
  const std::string page =
      run_page({.episode = episode, .recording = recording, .config_name = "replay.yaml"}, {}, kParts);
  EXPECT_THAT(page, HasSubstr("Nothing was measured"));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
}

TEST(RunPage, HasNoPlayerWithoutATrace) {
  TracedRun run;
  for (VariantRun& variant : run.episode.runs) variant.trace.reset();
  EXPECT_THAT(run_page(run.files(), {}, kParts), Not(HasSubstr("id=\"pack-0\"")));
  EXPECT_THAT(run_page(run.files(), {}, {.style = kParts.style}), Not(HasSubstr("image/svg")));
}

TEST(RunPage, ShowsPosesThatAreNotFiniteAsMissing) {
  TracedRun run;
  run.episode.runs[0].online[5].x = std::numeric_limits<double>::quiet_NaN();
  run.episode.runs[0].online[6].theta = std::numeric_limits<double>::infinity();
  EXPECT_THAT(run_page(run.files(), {}, kParts), HasSubstr("id=\"pack-1\""));
  EXPECT_THAT(run_page(run.files(), {}, {.style = kParts.style}), HasSubstr("image/svg"));
}

TEST(PlayerData, GetsCoarserUntilItFits) {
  const TracedRun run;
  const PlayerData all = player_data_within(run.files(), 1'000'000'000);
  EXPECT_EQ(ordered_json::parse(all.json)["variants"].size(), 4U);
  EXPECT_EQ(all.packs.size(), 5U);
  const std::size_t least = player_data(run.files(), 6, 1).bytes();
  EXPECT_LT(least, all.bytes());
  for (std::size_t most = all.bytes() - 1; most > least; most = most * 3 / 4) {
    const PlayerData fitted = player_data_within(run.files(), most);
    EXPECT_LE(fitted.bytes(), most);
    EXPECT_FALSE(fitted.packs.empty());
  }
  EXPECT_EQ(ordered_json::parse(player_data_within(run.files(), least).json)["variants"].size(), 1U);
  EXPECT_TRUE(player_data_within(run.files(), least - 1).packs.empty()) << "then there is no player";
  EXPECT_THAT(run_page(run.files(), {}, kParts, 10), Not(HasSubstr("id=\"player-data\"")));
}

}  // namespace
}  // namespace cogslam
