#include "eval/figures/pareto.hpp"

#include <algorithm>

namespace cogslam {

std::vector<Offer> pareto_front(std::vector<Offer> offers) {
  std::sort(offers.begin(), offers.end(),
            [](const Offer& a, const Offer& b) { return a.price != b.price ? a.price < b.price : a.error < b.error; });
  std::vector<Offer> front;
  for (const Offer& offer : offers) {
    if (front.empty() || offer.error < front.back().error) front.push_back(offer);
  }
  return front;
}

}  // namespace cogslam
