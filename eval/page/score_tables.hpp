#pragma once

#include <string>

#include "eval/run_record.hpp"

// Scores as HTML. A cell that shows a score has the attributes data-key (of scores.json), data-variant (place in the
// record) and data-value: the JSON of the exact value, of which the text is a rounding. Scores at hand in other units
// (roots, degrees) have data-derived instead of data-value.

namespace cogslam {

/// A row per variant, with the scores that people ask for first.
std::string headline_table(const RunRecord& record);

/// A row per variant, with every score.
std::string all_scores_table(const RunRecord& record);

/// A row per score: its name, the value of variant `shown`, what it means and which way is good.
std::string explained_table(const RunRecord& record, std::size_t shown);

/// One sentence or two on what came out for a variant.
std::string score_summary(const VariantRecord& variant);

}  // namespace cogslam
