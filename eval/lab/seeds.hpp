#pragma once

#include <cstddef>
#include <functional>

#include "core/parallel.hpp"

namespace cogslam {

/// Told the share in [0, 1] that is done, on the calling thread only; what it throws ends the work.
using LabProgress = std::function<void(double done)>;

/// Calls body(index) for every index in [0, count) on all workers and reports progress. What `body` writes must depend
/// on its index alone.
void for_each_seed(std::size_t count, Workers& workers, const LabProgress& progress,
                   const std::function<void(std::size_t)>& body);

}  // namespace cogslam
