#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/pose2.hpp"
#include "slam/registered_pose.hpp"

namespace cogslam {

/// A pose for every record out of those of the registered ones. Between registered records k and k' the odometry is
/// followed from k, and what is missing at k' is shared out by record index, never by time (stamps of real logs jump):
///
///   T_i = T_k (inv(O_k) O_i) (w r),  r = inv(T_k inv(O_k) O_k') T_k',  w = (i - k) / (k' - k),
///
/// where w r scales x, y and the wrapped angle of r. Before the first and after the last registered record the
/// odometry alone is followed. `odometry` holds O_i of every record; `registered` must be strictly increasing in
/// `record`, and not empty unless there are no records.
std::vector<Pose2> complete_path(std::span<const Pose2> odometry, std::span<const RegisteredPose> registered);

}  // namespace cogslam
