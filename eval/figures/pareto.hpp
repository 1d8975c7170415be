#pragma once

#include <vector>

namespace cogslam {

/// A price and what is had for it; less of either is better.
struct Offer {
  double price = 0.0;
  double error = 0.0;
};

/// Those that no other beats: none is at most as dear with less error, or cheaper with at most as much. By price.
std::vector<Offer> pareto_front(std::vector<Offer> offers);

}  // namespace cogslam
