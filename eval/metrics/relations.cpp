#include "eval/metrics/relations.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>

#include "core/check.hpp"
#include "core/line_fields.hpp"
#include "core/text_file.hpp"
#include "eval/metrics/path_error.hpp"
#include "sensors/log/plausible.hpp"

namespace cogslam {
namespace {

constexpr double kLocalTravel = 5.0;             // [m]
constexpr Duration kStampTolerance{20'000'000};  // 0.02 s
constexpr Duration kSameStamp{500};              // seconds as double tell apart 0.1 us in our days

/// Finds records by stamp although the stamps of real logs jump backwards.
class StampIndex {
 public:
  explicit StampIndex(std::span<const Time> stamps) : stamps_(stamps), order_(stamps.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(), [&](auto a, auto b) { return stamps_[a] < stamps_[b]; });
  }

  [[nodiscard]] std::optional<std::size_t> find(Time stamp) const {
    auto at = std::partition_point(order_.begin(), order_.end(), [&](auto i) { return stamps_[i] < stamp; });
    if (at == order_.end() || (at != order_.begin() && distance(at - 1, stamp) <= distance(at, stamp))) --at;
    if (distance(at, stamp) > kStampTolerance) return std::nullopt;
    std::size_t first = *at;
    const Time nearest = stamps_[first];
    while (at != order_.begin() && distance(at - 1, nearest) < kSameStamp) first = std::min(first, *--at);
    return first;
  }

 private:
  [[nodiscard]] Duration distance(std::vector<std::size_t>::const_iterator at, Time stamp) const {
    return {std::abs((stamps_[*at] - stamp).ns)};
  }

  std::span<const Time> stamps_;
  std::vector<std::size_t> order_;
};

struct Sizes {
  std::vector<double> trans, rot;

  void add(const Pose2& error) {
    trans.push_back(error.position().norm());
    rot.push_back(std::abs(error.theta));
  }
};

struct Moments {
  double mean = 0.0, std = 0.0;
};

Moments moments(std::span<const double> values) {
  if (values.empty()) return {};
  const auto n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double sum = 0.0;
  for (const double v : values) sum += (v - mean) * (v - mean);
  return {mean, std::sqrt(sum / n)};
}

RelationStats stats(const Sizes& sizes) {
  const Moments trans = moments(sizes.trans), rot = moments(sizes.rot);
  return {sizes.trans.size(), trans.mean, trans.std, rot.mean, rot.std};
}

Time read_stamp(LineFields& fields, std::string_view name) {
  const double seconds = fields.number(name);
  if (std::abs(seconds) > kLatestStamp)
    fields.fail(std::string(name) + ": expected seconds, found more than 140 years");
  return Time::from_seconds(seconds);
}

double read_position(LineFields& fields, std::string_view name) {
  const double position = fields.number(name);
  if (std::abs(position) > kFarthest) fields.fail(std::string(name) + ": expected at most 1e6 m");
  return position;
}

void read_zero(LineFields& fields, std::string_view name) {
  if (fields.number(name) != 0.0) fields.fail(std::string(name) + ": expected 0, since relations lie in the plane");
}

Relation read_relation(LineFields fields) {
  Relation relation;
  relation.from = read_stamp(fields, "t1");
  relation.to = read_stamp(fields, "t2");
  relation.T_from_to.x = read_position(fields, "x");
  relation.T_from_to.y = read_position(fields, "y");
  for (const char* name : {"z", "roll", "pitch"}) read_zero(fields, name);
  relation.T_from_to.theta = wrap_angle(fields.number("yaw"));
  fields.finish();
  return relation;
}

}  // namespace

std::vector<Relation> read_relations(const std::filesystem::path& file) {
  std::vector<Relation> relations;
  for (LineReader reader(file); reader.next();) {
    const LineFields fields(reader.line(), reader.place());
    if (!fields.done() && reader.line().front() != '#') relations.push_back(read_relation(fields));
  }
  return relations;
}

RelationErrors relation_errors(std::span<const Relation> relations, std::span<const Time> stamps,
                               std::span<const Pose2> odometry, std::span<const Pose2> path) {
  EXPECTS(!stamps.empty() && stamps.size() == odometry.size() && stamps.size() == path.size());
  const StampIndex index(stamps);
  const std::vector<double> travel = travelled(odometry);
  Sizes local, global, all;
  RelationErrors errors;
  for (const Relation& relation : relations) {
    const auto from = index.find(relation.from), to = index.find(relation.to);
    if (!from || !to) {
      ++errors.unmatched;
      continue;
    }
    const Pose2 error = relation.T_from_to.inverse() * (path[*from].inverse() * path[*to]);
    (std::abs(travel[*to] - travel[*from]) <= kLocalTravel ? local : global).add(error);
    all.add(error);
  }
  errors.local = stats(local);
  errors.global = stats(global);
  errors.all = stats(all);
  return errors;
}

}  // namespace cogslam
