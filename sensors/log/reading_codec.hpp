#pragma once

#include "sensors/log/bytes.hpp"
#include "sensors/readings.hpp"

namespace cogslam {

void put_pose(ByteWriter& out, const Pose2& pose);
Pose2 take_pose(ByteReader& in, const char* what);

/// The bytes of one reading, every field and bit of it.
void put_reading(ByteWriter& out, const Reading& reading);
Reading take_reading(ByteReader& in);

}  // namespace cogslam
