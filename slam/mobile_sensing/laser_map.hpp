#pragma once

#include <string>

#include "core/angle.hpp"
#include "core/grid.hpp"
#include "core/pose2.hpp"
#include "sensors/readings.hpp"

// Compressive mobile sensing, section III.B: what a sweep of a laser scanner says of the cells around it.

namespace cogslam {

/// The laser measurement model.
///
/// Between two beams the paper says nothing. Here p(m | z) is known for each point of the plane, so that the mean over
/// a cell (eq. 8) is an integral over its area: between two beams that end on one surface, the surface is the straight
/// piece between their ends; elsewhere a beam speaks for the points that are nearest to it in angle.
struct LaserModel {
  double p_free = 0.2;      ///< of a point between the scanner and the end of the beam, in (0, 0.5)
  double p_occupied = 0.9;  ///< of the end point itself, in (0.5, 1)
  double sigma_m = 0.1;     ///< of the Gaussian about the end point; sigma^2 is the paper's epsilon
  /// Two neighbouring beams end on one surface if the piece between their ends makes at least this angle with them
  /// [rad], up to pi/2. pi/2 keeps the ends apart, as the paper prints it: a wall seen from afar is a row of dots.
  double least_incidence = radians(7.0);
  int points_per_side = 4;    ///< of a cell: eq. 8 is a mean over this many points squared
  double range_max_m = 81.0;  ///< a longer reading is none; a scan's own limit holds where it is shorter

  /// What is inconsistent and what was expected; empty if nothing is.
  [[nodiscard]] std::string check() const;
};

inline constexpr double kUnchanged = 0.5;  ///< p(m | z) where a sweep says nothing; also the prior p(m)

/// p(m | z, pose) by eq. 6 and the rules below it, as the mean over each cell of `frame` (eq. 8), for a base at
/// `T_frame_base`: p_free along the beams, unchanged beyond their ends and outside the field of view, and a Gaussian of
/// height p_occupied about the nearest end point or surface. A beam without return is free up to the limit. A beam's
/// time is ignored: the sweep is taken as seen from one place.
Grid<double> scan_occupancy(const LaserModel& model, const Scan& scan, const Pose2& T_frame_base,
                            const GridFrame& frame);

/// Eq. 7: adds the log-odds of what one sweep says to those so far; the prior is 0.5, so that its term is 0.
void add_evidence(Grid<double>& log_odds, const Grid<double>& occupancy);

/// The probability that has these log-odds.
Grid<double> probability(const Grid<double>& log_odds);

}  // namespace cogslam
