#include "eval/figures/episode_score.hpp"

namespace cogslam {

std::optional<std::size_t> episode_row(const EpisodeTable& table, const EpisodeName& name) {
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (table.text(row, "world") == name.world && table.number(row, "cell_size_m") == name.cell_size &&
        table.text(row, "variant") == name.variant && table.number(row, "seed") == static_cast<double>(name.seed)) {
      return row;
    }
  }
  return std::nullopt;
}

std::optional<double> episode_score(const EpisodeTable& table, const EpisodeName& name, const std::string& column) {
  const auto row = episode_row(table, name);
  if (!row) return std::nullopt;
  return table.number(*row, column);
}

}  // namespace cogslam
