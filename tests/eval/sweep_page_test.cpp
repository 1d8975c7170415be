#include "eval/page/sweep_page.hpp"

#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>

#include "eval/page/sweep_curves.hpp"
#include "eval/page/sweep_tables.hpp"
#include "eval/sweep/columns.hpp"

namespace cogslam {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

constexpr PageParts kParts{.style = "p { margin: 0; }\n", .script = "start();\n", .notices = "Notice of a part"};
constexpr PageParts kStatic{.style = kParts.style, .script = {}, .notices = {}};

using Row = std::map<std::string, TableValue, std::less<>>;

void add_row(const Row& row, EpisodeTable& table) {
  std::vector<TableValue>& values = table.rows.emplace_back();
  for (const std::string& column : table.columns) {
    values.push_back(row.contains(column) ? row.at(column) : TableValue{});
  }
}

/// Two seeds of a baseline and of two levels of compression in one world.
EpisodeTable small_table() {
  EpisodeTable table;
  for (const EpisodeColumn& column : episode_columns()) table.columns.emplace_back(column.name);
  for (const int percent : {0, 10, 40}) {
    for (const std::int64_t seed : {1, 2}) {
      const std::string level = std::to_string(percent);
      Row row{{"key", "k" + level + std::to_string(seed)},
              {"world", "room <1>"},
              {"cell_size_m", 0.1},
              {"variant", "og"},
              {"seed", seed},
              {"true_poses", std::int64_t{0}},
              {"store", "dense"},
              {"particles", std::int64_t{100}},
              {"readings_key", "r" + std::to_string(seed)},
              {"path_mse_m2", 0.5},
              {"grid_mse", static_cast<double>(percent + seed)},
              {"bytes", 200.0 + percent}};
      if (percent > 0) {
        row["variant"] = "cog_" + level;
        row["baseline"] = "og";
        row["store"] = "coefficients";
        row["percent_kept"] = static_cast<double>(percent);
        row["basis"] = "haar", row["compressor"] = "top_m", row["recovery"] = "fast_l2";
      }
      add_row(row, table);
    }
  }
  return table;
}

std::string page_of(const EpisodeTable& table, const PageParts& parts, std::set<std::string> pages = {}) {
  return sweep_page(
      {.name = "a < b", .planned = 7, .table = table, .summary = summarize(table), .pages = std::move(pages)}, parts);
}

TEST(SweepPage, HoldsCurvesTablesAndScript) {
  const std::string page = page_of(small_table(), kParts);
  EXPECT_THAT(page, HasSubstr("<h1>a &lt; b</h1>"));
  EXPECT_THAT(page, HasSubstr("6 of 7 planned episodes: 3 variants, 1 worlds, 2 seeds"));
  EXPECT_THAT(page, HasSubstr("The sweep is not complete"));
  EXPECT_THAT(page, HasSubstr("start();"));
  EXPECT_THAT(page, HasSubstr("id=\"sweep-data\""));
  EXPECT_THAT(page, Not(HasSubstr("image/svg+xml")));
  EXPECT_THAT(page, Not(HasSubstr("room <1>")));
}

TEST(SweepPage, IsStaticWithoutScript) {
  const std::string page = page_of(small_table(), kStatic);
  EXPECT_THAT(page, HasSubstr("data:image/svg+xml;base64,"));
  EXPECT_THAT(page, HasSubstr("This is the static page"));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
}

TEST(SweepPage, SaysThatNothingIsThere) {
  EpisodeTable table = small_table();
  table.rows.clear();
  const std::string page = page_of(table, kParts);
  EXPECT_THAT(page, HasSubstr("0 of 7 planned episodes"));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, Not(HasSubstr("<table")));
}

TEST(SweepPage, StatesMeansIntervalsAndDifferences) {
  const EpisodeTable table = small_table();
  const std::string html = variants_table({.name = "", .planned = 6, .table = table, .summary = summarize(table)});
  // Mean of 11 and 12; half width t(1) * s / sqrt(2) = 12.706 * 0.5.
  EXPECT_THAT(html,
              HasSubstr("data-key=\"grid_mse\" data-value=\"11.5\">11.5<span class=\"part\"><i>±</i> 6.4</span>"));
  EXPECT_THAT(html, HasSubstr("data-key=\"grid_mse - baseline\" data-value=\"10\">10<span class=\"part\"><i>±</i> 0<"));
  EXPECT_THAT(html, HasSubstr("not measured"));  // heading
}

TEST(SweepPage, LinksEpisodesToTheirFiles) {
  const EpisodeTable table = small_table();
  const std::string html = page_of(table, kStatic, {"k402"});
  EXPECT_THAT(html, HasSubstr("cogslam replay readings/r2.bin --truth readings/r2.truth.bin --scenario "
                              "episodes/k402.yaml</code>"));
  EXPECT_THAT(html, HasSubstr("<a href=\"episodes/k402.html\">page</a>"));
  EXPECT_THAT(html, Not(HasSubstr("episodes/k401.html")));
  EXPECT_THAT(html, HasSubstr("<a href=\"episodes/k401.log\">log</a>"));
}

TEST(SweepPage, ListsOnlyTheFirstOfVeryManyEpisodes) {
  EpisodeTable table = small_table();
  const std::vector<TableValue> row = table.rows.front();
  while (table.rows.size() <= kEpisodesListed) table.rows.push_back(row);
  const std::string html = episodes_table({.name = "", .planned = 0, .table = table, .summary = {}});
  EXPECT_THAT(html, HasSubstr("3000 of 3001 episodes"));
}

TEST(SweepCurves, TellTheFamilyAndValuesOfEachVariant) {
  const EpisodeTable table = small_table();
  const json data =
      json::parse(sweep_curves_json({.name = "", .planned = 6, .table = table, .summary = summarize(table)}));
  ASSERT_EQ(data["points"].size(), 3);
  EXPECT_EQ(data["points"][0]["family"], "dense x100");
  EXPECT_EQ(data["points"][0]["percent_kept"], nullptr);
  const json& cog = data["points"][2];
  EXPECT_EQ(cog["family"], "coefficients haar top_m fast_l2 x100");
  EXPECT_EQ(cog["percent_kept"], 40.0);
  EXPECT_EQ(cog["values"]["grid_mse"][0], 41.5);
  EXPECT_EQ(cog["values"]["grid_mse"][2], 2);
  EXPECT_FALSE(cog["values"].contains("heading_mse_rad2"));
}

}  // namespace
}  // namespace cogslam
