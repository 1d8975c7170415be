#include "slam/path_tree.hpp"

#include <algorithm>
#include <limits>

#include "core/check.hpp"
#include "slam/map/memory_meter.hpp"

namespace cogslam {
namespace {

/// Makes room for one more; doubling, as vectors do, would leave half of it spare.
template <class T>
void make_room(std::vector<T>& values) {
  if (values.size() == values.capacity()) values.reserve(values.size() + values.size() / 8 + 16);
}

}  // namespace

void PathTree::append(std::size_t record, std::span<const StoredPose> T_map_base) {
  EXPECTS(record <= std::numeric_limits<std::uint32_t>::max() && T_map_base.size() == leaves_.size());
  Generation next{.record = static_cast<std::uint32_t>(record), .branches = {}};
  next.branches.reserve(leaves_.size());
  for (std::size_t slot = 0; slot < leaves_.size(); ++slot) {
    next.branches.push_back({T_map_base[slot], leaves_[slot]});
    leaves_[slot] = static_cast<std::uint32_t>(slot);
  }
  make_room(generations_);
  generations_.push_back(std::move(next));
  grow_trunk();
}

void PathTree::resample(std::span<const std::size_t> chosen) {
  EXPECTS(chosen.size() == leaves_.size());
  std::vector<std::uint32_t> next;
  for (const std::size_t slot : chosen) next.push_back(leaves_[slot]);
  leaves_ = std::move(next);
  drop_unused();
}

/// From the last generation back, until one loses nothing.
void PathTree::drop_unused() {
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t*> users;  // what points into the generation at hand
  for (std::uint32_t& leaf : leaves_) users.push_back(&leaf);
  for (auto generation = generations_.rbegin(); generation != generations_.rend(); ++generation) {
    std::vector<std::uint32_t> place(generation->branches.size(), kUnused);
    for (const std::uint32_t* user : users) place[*user] = 0;
    std::vector<Branch> kept;
    kept.reserve(static_cast<std::size_t>(std::count(place.begin(), place.end(), 0U)));
    if (kept.capacity() == place.size()) return;
    for (std::size_t i = 0; i < place.size(); ++i) {
      if (place[i] == kUnused) continue;
      place[i] = static_cast<std::uint32_t>(kept.size());
      kept.push_back(generation->branches[i]);
    }
    for (std::uint32_t* user : users) *user = place[*user];
    generation->branches = std::move(kept);
    users.clear();
    for (Branch& branch : generation->branches) users.push_back(&branch.parent);
  }
}

void PathTree::grow_trunk() {
  auto first = generations_.begin();
  for (; first != generations_.end() && first->branches.size() == 1; ++first) {
    make_room(trunk_);
    trunk_.push_back({first->branches[0].T_map_base, first->record});
  }
  if (first == generations_.begin()) return;
  generations_.erase(generations_.begin(), first);  // the parents of those that follow are all in place 0
  if (generations_.capacity() > 2 * generations_.size() + 16) generations_.shrink_to_fit();
}

std::vector<RegisteredPose> PathTree::path_of(std::size_t slot) const {
  std::vector<RegisteredPose> path;
  path.reserve(length());
  std::uint32_t place = leaves_[slot];
  for (auto generation = generations_.rbegin(); generation != generations_.rend(); ++generation) {
    const Branch& branch = generation->branches[place];
    path.push_back({generation->record, branch.T_map_base.pose()});
    place = branch.parent;
  }
  for (auto pose = trunk_.rbegin(); pose != trunk_.rend(); ++pose) {
    path.push_back({pose->record, pose->T_map_base.pose()});
  }
  std::reverse(path.begin(), path.end());
  return path;
}

std::size_t PathTree::ancestors(std::size_t steps) const {
  EXPECTS(steps < length());
  return steps < generations_.size() ? generations_[generations_.size() - 1 - steps].branches.size() : 1;
}

std::size_t PathTree::poses() const {
  std::size_t sum = trunk_.size();
  for (const Generation& generation : generations_) sum += generation.branches.size();
  return sum;
}

std::int64_t PathTree::bytes() const {
  std::int64_t sum = heap_bytes(trunk_.capacity() * sizeof(TrunkPose)) +
                     heap_bytes(generations_.capacity() * sizeof(Generation)) +
                     heap_bytes(leaves_.capacity() * sizeof(leaves_[0]));
  for (const Generation& generation : generations_) sum += heap_bytes(generation.branches.capacity() * sizeof(Branch));
  return sum;
}

}  // namespace cogslam
