#include "eval/sweep/columns.hpp"

#include <array>

namespace cogslam {
namespace {

using enum ColumnType;
using enum ColumnKind;

#define VARIANT "/run/variants/0/"
#define SCORES VARIANT "scores/"
#define COSTS VARIANT "costs/"

constexpr std::array kColumns{
    EpisodeColumn{"key", kText, kIdentity, "/key"},
    EpisodeColumn{"world", kText, kIdentity, "/run/scenario"},
    EpisodeColumn{"cell_size_m", kReal, kIdentity, VARIANT "cell_size_m"},
    EpisodeColumn{"variant", kText, kIdentity, VARIANT "name"},
    EpisodeColumn{"seed", kInteger, kIdentity, "/run/seed"},
    EpisodeColumn{"baseline", kText, kIdentity, "/baseline"},
    EpisodeColumn{"true_poses", kInteger, kIdentity, "/true_poses"},
    EpisodeColumn{"store", kText, kIdentity, VARIANT "store"},
    EpisodeColumn{"percent_kept", kReal, kIdentity, VARIANT "percent_kept"},
    EpisodeColumn{"basis", kText, kIdentity, VARIANT "basis"},
    EpisodeColumn{"compressor", kText, kIdentity, VARIANT "compressor"},
    EpisodeColumn{"recovery", kText, kIdentity, VARIANT "recovery"},
    EpisodeColumn{"particles", kInteger, kIdentity, VARIANT "particles"},
    EpisodeColumn{"readings_key", kText, kIdentity, "/readings_key"},
    EpisodeColumn{"readings_hash", kText, kIdentity, "/run/readings_hash"},
    EpisodeColumn{"simulated_s", kReal, kIdentity, "/run/simulated_s"},
    EpisodeColumn{"path_mse_m2", kReal, kScore, SCORES "path_mse_m2"},
    EpisodeColumn{"heading_mse_rad2", kReal, kScore, SCORES "heading_mse_rad2"},
    EpisodeColumn{"path_mse_final_m2", kReal, kScore, SCORES "path_mse_final_m2"},
    EpisodeColumn{"heading_mse_final_rad2", kReal, kScore, SCORES "heading_mse_final_rad2"},
    EpisodeColumn{"odometry_path_mse_m2", kReal, kScore, SCORES "odometry_path_mse_m2"},
    EpisodeColumn{"odometry_heading_mse_rad2", kReal, kScore, SCORES "odometry_heading_mse_rad2"},
    EpisodeColumn{"ate_rmse_m", kReal, kScore, SCORES "ate_rmse_m"},
    EpisodeColumn{"rpe_trans_m", kReal, kScore, SCORES "rpe_trans_m"},
    EpisodeColumn{"rpe_rot_rad", kReal, kScore, SCORES "rpe_rot_rad"},
    EpisodeColumn{"grid_mse", kReal, kScore, SCORES "grid_mse"},
    EpisodeColumn{"grid_mse_all", kReal, kScore, SCORES "grid_mse_all"},
    EpisodeColumn{"grid_mse_logodds", kReal, kScore, SCORES "grid_mse_logodds"},
    EpisodeColumn{"grid_log_score", kReal, kScore, SCORES "grid_log_score"},
    EpisodeColumn{"truth_free_belief_free", kInteger, kScore, SCORES "grid_confusion/truth_free/free"},
    EpisodeColumn{"truth_free_belief_unknown", kInteger, kScore, SCORES "grid_confusion/truth_free/unknown"},
    EpisodeColumn{"truth_free_belief_occupied", kInteger, kScore, SCORES "grid_confusion/truth_free/occupied"},
    EpisodeColumn{"truth_occupied_belief_free", kInteger, kScore, SCORES "grid_confusion/truth_occupied/free"},
    EpisodeColumn{"truth_occupied_belief_unknown", kInteger, kScore, SCORES "grid_confusion/truth_occupied/unknown"},
    EpisodeColumn{"truth_occupied_belief_occupied", kInteger, kScore, SCORES "grid_confusion/truth_occupied/occupied"},
    EpisodeColumn{"path_mse_vs_baseline_m2", kReal, kScore, SCORES "path_mse_vs_baseline_m2"},
    EpisodeColumn{"grid_mse_vs_baseline", kReal, kScore, SCORES "grid_mse_vs_baseline"},
    EpisodeColumn{"registered", kInteger, kScore, SCORES "registered"},
    EpisodeColumn{"tracked", kInteger, kScore, SCORES "tracked"},
    EpisodeColumn{"resamplings", kInteger, kScore, SCORES "resamplings"},
    EpisodeColumn{"ancestors_100", kInteger, kScore, SCORES "ancestors_100"},
    EpisodeColumn{"payload_bytes", kReal, kScore, SCORES "payload_bytes"},
    EpisodeColumn{"payload_bytes_bitmap", kReal, kScore, SCORES "payload_bytes_bitmap"},
    EpisodeColumn{"bytes", kReal, kScore, SCORES "bytes"},
    EpisodeColumn{"bytes_peak", kInteger, kScore, SCORES "bytes_peak"},
    EpisodeColumn{"state_hash", kText, kScore, SCORES "state_hash"},
    EpisodeColumn{"map_hash", kText, kScore, SCORES "map_hash"},
    EpisodeColumn{"cpu_s", kReal, kCost, COSTS "cpu_s"},
    EpisodeColumn{"cpu_ms_per_registered", kReal, kCost, COSTS "cpu_ms_per_registered"},
    EpisodeColumn{"wall_s", kReal, kCost, COSTS "wall_s"},
    EpisodeColumn{"rss_bytes_above_start", kInteger, kCost, COSTS "rss_bytes_above_start"},
    EpisodeColumn{"program", kText, kCost, "/program"},
};

#undef VARIANT
#undef SCORES
#undef COSTS

}  // namespace

std::span<const EpisodeColumn> episode_columns() { return kColumns; }

}  // namespace cogslam
