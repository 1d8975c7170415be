#include "eval/page/score_words.hpp"

#include <array>

namespace cogslam {
namespace {

constexpr std::array kWords{
    ScoreWords{
        "path_mse_m2", "Path error", "m²",
        "How far the position reported at each scan lay from the true one: the mean of the squared distances. Its "
        "root (RMSE) is in metres.",
        "Lower. Well below odometry alone; below the square of a cell's side is very good."},
    ScoreWords{"heading_mse_rad2", "Heading error", "rad²",
               "How far the reported heading was turned from the true one: the mean of the squared angles.",
               "Lower. A root of half a degree is good."},
    ScoreWords{"path_mse_final_m2", "Path error, final path", "m²",
               "The same for the path that the winning particle believes at the end, when it knows all scans.",
               "Lower; usually no worse than the path error."},
    ScoreWords{"heading_mse_final_rad2", "Heading error, final path", "rad²",
               "The heading error of the path that the winning particle believes at the end.", "Lower."},
    ScoreWords{"odometry_path_mse_m2", "Path error of odometry alone", "m²",
               "What the path error would be without any map: motion estimates added up from the start.",
               "It belongs to the readings, not to the filter: the error to beat."},
    ScoreWords{"odometry_heading_mse_rad2", "Heading error of odometry alone", "rad²",
               "The heading error of motion estimates added up from the start.", "The error to beat."},
    ScoreWords{
        "ate_rmse_m", "Path error after alignment", "m",
        "The path error (as a root) once the whole path may be shifted and turned to fit the true one best. Papers "
        "call it ATE.",
        "Lower. Much lower than the root of the path error means: right shape, wrong place."},
    ScoreWords{"rpe_trans_m", "Drift per metre", "m",
               "How wrong the motion over each metre travelled was, as a root mean square. Papers call it RPE.",
               "Lower. It does not punish old mistakes again, as the path error does."},
    ScoreWords{"rpe_rot_rad", "Turning drift per metre", "rad",
               "How wrong the turning over each metre travelled was, as a root mean square.", "Lower."},
    ScoreWords{"grid_mse", "Map error", "",
               "For each cell that can be seen: how far its probability of being occupied is from 0 (free) or 1 "
               "(occupied), squared, and the mean of that.",
               "Lower. An empty map scores 0.25; certain and right scores about 0.014. Compare equal cell sizes only."},
    ScoreWords{"grid_mse_all", "Map error, all cells", "",
               "The same over all cells of the room's rectangle; those that nobody can see should stay at one half.",
               "Lower."},
    ScoreWords{"grid_mse_logodds", "Map error in log-odds", "",
               "The map error measured on log-odds, within the bounds -2 and 3.2: sure mistakes weigh more.", "Lower."},
    ScoreWords{"grid_log_score", "Log score of the map", "nats",
               "The surprise of the map when told the truth of a cell, on average.",
               "Lower. An empty map scores 0.693; only honest probabilities score best."},
    ScoreWords{"grid_confusion", "Cells by truth and belief", "cells",
               "How many cells that are truly free or occupied the map calls free, unknown, or occupied.",
               "Free called occupied, and occupied called free, should be few."},
    ScoreWords{"path_mse_vs_baseline_m2", "Path differs from the baseline's", "m²",
               "The path error with the path of the uncompressed filter (same readings, same chance) in place of the "
               "truth: what compression alone changed.",
               "Lower; 0: compression changed nothing. Not measured for the baseline itself."},
    ScoreWords{"grid_mse_vs_baseline", "Map differs from the baseline's", "",
               "The mean squared difference of probability between this map and that of the uncompressed filter.",
               "Lower; 0: the same map."},
    ScoreWords{"registered", "Scans registered", "scans", "Scans that changed the map.",
               "Neither: it follows from the motion and the settings."},
    ScoreWords{"tracked", "Scans tracked", "scans", "Scans in between, which only refined the pose.", "Neither."},
    ScoreWords{"resamplings", "Resamplings", "", "How often unlikely particles were dropped and likely ones doubled.",
               "Neither. Very many mean that the particles forget quickly, and bytes look smaller than they are."},
    ScoreWords{"ancestors_100", "Ancestors 100 scans back", "particles",
               "From how many different particles all of today's descend, 100 registered scans before the end.",
               "Higher: more histories are kept. 1 means that all share one past."},
    ScoreWords{
        "payload_bytes", "Map bytes per particle", "bytes",
        "Memory of the map's content, per particle; what particles share is divided among them. Mean over the run.",
        "Lower, at equal path and map error."},
    ScoreWords{"payload_bytes_bitmap", "Map bytes with a bitmap", "bytes",
               "The same if a bit per position told which coefficients are kept, in place of 4 bytes each.",
               "Lower. Measured for stores of coefficients only."},
    ScoreWords{
        "bytes", "All bytes per particle", "bytes",
        "Memory all in: content, headers, directories, the allocator's rounding, pose and path. Mean over the run.",
        "Lower, at equal path and map error."},
    ScoreWords{"bytes_peak", "All bytes per particle, peak", "bytes", "The most there was at any registered scan.",
               "Lower: it is what must fit into memory."},
    ScoreWords{
        "degraded", "Reasons to doubt", "",
        "Why the figures mean less than usual: no_returns, no beam came back and the path is odometry's; "
        "empty_map, no scan changed a cell; the others name what readings and belief disagree about (docs/faults.md).",
        "None."},
    ScoreWords{"health", "Signs of trouble", "counts",
               "How often readings and belief did not go together: scans that were missing, empty or repeated; "
               "odometry, headings and scans that were doubted.",
               "Few. Beyond what sound runs show, the run warns that it is degraded."},
    ScoreWords{"state_hash", "Fingerprint of the filter", "",
               "Names the whole state of the filter at the end, bit for bit.", "Equal fingerprints: equal runs."},
    ScoreWords{"map_hash", "Fingerprint of the map", "", "Names the final map, bit for bit.",
               "Equal fingerprints: equal maps."},
    ScoreWords{"relations", "Errors of relations", "m, deg",
               "For logs of real robots: how far apart two moments of the path are, against relations checked by hand. "
               "Local ones span at most 5 m of travel, global ones more.",
               "Lower. Global errors show whether loops were closed."},
};

}  // namespace

std::span<const ScoreWords> score_words() { return kWords; }

}  // namespace cogslam
