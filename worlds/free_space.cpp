#include "worlds/free_space.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include "core/error.hpp"
#include "worlds/polygon.hpp"

namespace cogslam {
namespace {

constexpr double kSame = 1e-9;                   // [m]
constexpr std::size_t kMostPieces = 10'000'000;  // of surfaces, cut at every corner and crossing: 0.5 GB
constexpr const char* kTooCrowded = "too many surfaces lie above each other or cross, expected fewer or shorter ones";
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Interval {
  double low;
  double high;
};

bool is_upright(const Segment& s) { return s.b.x() - s.a.x() <= kSame; }

double height_at(const Segment& s, double x) {
  if (x <= s.a.x()) return s.a.y();
  if (x >= s.b.x()) return s.b.y();
  return s.a.y() + (x - s.a.x()) * ((s.b.y() - s.a.y()) / (s.b.x() - s.a.x()));
}

std::optional<double> crossing_x(const Segment& s, const Segment& t) {
  if (std::max(s.a.x(), t.a.x()) > std::min(s.b.x(), t.b.x())) return std::nullopt;
  const double start = turn(t.a, t.b, s.a), end = turn(t.a, t.b, s.b);
  if (start * end >= 0.0 || turn(s.a, s.b, t.a) * turn(s.a, s.b, t.b) >= 0.0) return std::nullopt;
  return s.a.x() + (s.b.x() - s.a.x()) * (start / (start - end));
}

/// Numbers of the surfaces, by their left ends.
std::vector<std::size_t> from_left_to_right(const std::vector<Segment>& surfaces) {
  std::vector<std::size_t> order(surfaces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&surfaces](std::size_t i, std::size_t j) {
    const double x_i = surfaces[i].a.x(), x_j = surfaces[j].a.x();
    return x_i != x_j ? x_i < x_j : i < j;
  });
  return order;
}

/// x of every corner and crossing, ascending, those less than kSame apart taken once.
std::vector<double> slab_borders(const std::vector<Segment>& surfaces) {
  std::vector<double> all;
  const std::vector<std::size_t> order = from_left_to_right(surfaces);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Segment& s = surfaces[order[i]];
    all.push_back(s.a.x());
    all.push_back(s.b.x());
    for (std::size_t j = i + 1; j < order.size() && surfaces[order[j]].a.x() <= s.b.x(); ++j) {
      // Rounding depends on which of the two comes first: their own order, whatever lies further left.
      const auto [first, second] = std::minmax(order[i], order[j]);
      if (const auto x = crossing_x(surfaces[first], surfaces[second])) all.push_back(*x);
    }
    if (all.size() > kMostPieces) throw InputError(kTooCrowded);
  }
  std::sort(all.begin(), all.end());
  std::vector<double> out;
  for (const double x : all) {
    if (out.empty() || x - out.back() > kSame) out.push_back(x);
  }
  return out;
}

/// What the upright surfaces at one border cover of it, by lower end; pieces may overlap.
std::vector<Interval> covered(const std::vector<Segment>& upright) {
  std::vector<Interval> out;
  for (const Segment& s : upright) out.push_back({std::min(s.a.y(), s.b.y()), std::max(s.a.y(), s.b.y())});
  std::sort(out.begin(), out.end(), [](const Interval& a, const Interval& b) { return a.low < b.low; });
  return out;
}

bool leaves_gap(Interval opening, const std::vector<Interval>& cover) {
  for (const Interval& c : cover) {
    if (c.low - opening.low > kSame) break;
    opening.low = std::max(opening.low, c.high);
  }
  return opening.high - opening.low > kSame;
}

/// The piece of border x that bounds face number `i` of a slab.
Interval opening_at(const std::vector<Segment>& stack, std::size_t i, double x) {
  return {i == 0 ? -kInfinity : height_at(stack[i - 1], x), i == stack.size() ? kInfinity : height_at(stack[i], x)};
}

}  // namespace

FreeSpace::FreeSpace(const World& world) {
  std::vector<Segment> surfaces = world.segments();
  for (Segment& s : surfaces) {
    if (s.b.x() < s.a.x()) std::swap(s.a, s.b);
  }
  borders_ = slab_borders(surfaces);
  const std::vector<std::vector<Segment>> upright = fill_slabs(surfaces);
  for (std::size_t i = 0; i < borders_.size(); ++i) join(slabs_[i], slabs_[i + 1], borders_[i], upright[i]);
  for (int& parent : parents_) parent = root(parent);
  outside_ = parents_.front();
  start_face_ = face_of(world.start.position());
}

std::vector<std::vector<Segment>> FreeSpace::fill_slabs(const std::vector<Segment>& surfaces) {
  slabs_.resize(borders_.size() + 1);
  std::vector<std::vector<Segment>> upright(borders_.size());
  const auto border_of = [this](double x) {
    return static_cast<std::size_t>(std::lower_bound(borders_.begin(), borders_.end(), x - kSame) - borders_.begin());
  };
  std::size_t pieces = 0;
  for (const Segment& s : surfaces) {
    const std::size_t first = border_of(s.a.x()), last = border_of(s.b.x());
    pieces += last - first;
    if (pieces > kMostPieces) throw InputError(kTooCrowded);
    if (is_upright(s)) upright[first].push_back(s);
    for (std::size_t i = first; i < last; ++i) slabs_[i + 1].surfaces.push_back(s);
  }
  for (std::size_t i = 0; i < slabs_.size(); ++i) {
    std::vector<Segment>& stack = slabs_[i].surfaces;
    const double middle = stack.empty() ? 0.0 : 0.5 * (borders_[i - 1] + borders_[i]);
    std::sort(stack.begin(), stack.end(),
              [middle](const Segment& a, const Segment& b) { return height_at(a, middle) < height_at(b, middle); });
    slabs_[i].faces.resize(stack.size() + 1);
    std::iota(slabs_[i].faces.begin(), slabs_[i].faces.end(), static_cast<int>(parents_.size()));
    parents_.insert(parents_.end(), slabs_[i].faces.begin(), slabs_[i].faces.end());
  }
  return upright;
}

void FreeSpace::join(const Slab& left, const Slab& right, double x, const std::vector<Segment>& upright) {
  const std::vector<Interval> cover = covered(upright);
  std::size_t l = 0, r = 0;
  while (l < left.faces.size() && r < right.faces.size()) {
    const Interval on_left = opening_at(left.surfaces, l, x), on_right = opening_at(right.surfaces, r, x);
    const Interval both{std::max(on_left.low, on_right.low), std::min(on_left.high, on_right.high)};
    if (leaves_gap(both, cover)) {
      const int a = root(left.faces[l]), b = root(right.faces[r]);
      parents_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
    // Past the last face of one side, the faces left on the other one still have to meet it.
    if (r + 1 == right.faces.size() || (l + 1 < left.faces.size() && on_left.high < on_right.high)) {
      ++l;
    } else {
      ++r;
    }
  }
}

int FreeSpace::root(int face) const {
  while (parents_[static_cast<std::size_t>(face)] != face) face = parents_[static_cast<std::size_t>(face)];
  return face;
}

int FreeSpace::face_of(const Eigen::Vector2d& p) const {
  const auto slab_number = std::upper_bound(borders_.begin(), borders_.end(), p.x()) - borders_.begin();
  const Slab& slab = slabs_[static_cast<std::size_t>(slab_number)];
  const auto above = std::partition_point(slab.surfaces.begin(), slab.surfaces.end(),
                                          [&p](const Segment& s) { return height_at(s, p.x()) <= p.y(); });
  const int face = slab.faces[static_cast<std::size_t>(above - slab.surfaces.begin())];
  return parents_[static_cast<std::size_t>(face)];
}

}  // namespace cogslam
