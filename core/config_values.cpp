#include <algorithm>
#include <cmath>

#include "core/angle.hpp"
#include "core/config.hpp"
#include "core/config_tree.hpp"
#include "core/number_text.hpp"

namespace cogslam {
namespace {

[[noreturn]] void fail_at(const ConfigTree& value, const std::string& key, const std::string& expected) {
  throw InputError(value.place, key + ": expected " + expected + ", found " + found_text(value));
}

/// Whole numbers without exponent.
std::string limit_text(double limit) {
  constexpr double kLongest = 1e10;
  const bool whole = limit == std::floor(limit) && std::abs(limit) < kLongest;
  return whole ? std::to_string(static_cast<std::int64_t>(limit)) : number_text(limit);
}

std::string within(const std::string& what, Range range, Range widest = {}) {
  const bool low = range.min > widest.min, high = range.max < widest.max;
  const bool positive = range.min == kPositive.min;
  if (positive && !high) return what + " above 0";
  if (positive) return what + " in (0, " + limit_text(range.max) + "]";
  if (low && high) return what + " in [" + limit_text(range.min) + ", " + limit_text(range.max) + "]";
  if (low) return what + " of at least " + limit_text(range.min);
  if (high) return what + " of at most " + limit_text(range.max);
  return what;
}

double number_of(const ConfigTree& value, const std::string& key, Range range) {
  const auto number = value.kind == ConfigTree::Kind::kText && !value.quoted ? parse_number(value.text) : std::nullopt;
  if (!number || *number < range.min || *number > range.max) fail_at(value, key, within("a number", range));
  return *number;
}

template <class Int>
Int whole_number_of(const ConfigTree& value, const std::string& key, Range range) {
  constexpr Range kWidest{static_cast<double>(std::numeric_limits<Int>::min()),
                          static_cast<double>(std::numeric_limits<Int>::max())};
  range = {std::ceil(std::max(range.min, kWidest.min)), std::floor(std::min(range.max, kWidest.max))};
  const auto number =
      value.kind == ConfigTree::Kind::kText && !value.quoted ? parse_whole_number(value.text) : std::nullopt;
  const auto in_range = [&](std::int64_t n) {
    return static_cast<double>(n) >= range.min && static_cast<double>(n) <= range.max;
  };
  if (number && in_range(*number)) return static_cast<Int>(*number);
  const bool too_wide =
      number && (static_cast<double>(*number) < kWidest.min || static_cast<double>(*number) > kWidest.max);
  fail_at(value, key, within("a whole number", range, too_wide ? Range{} : kWidest));
}

Eigen::Vector2d pair_of(const ConfigTree& value, const std::string& key, Range range) {
  if (value.kind != ConfigTree::Kind::kList || value.items.size() != 2) fail_at(value, key, "two numbers [x, y]");
  return {number_of(*value.items[0], key, range), number_of(*value.items[1], key, range)};
}

const ConfigTree& list_of(const ConfigTree& value, const std::string& key, const std::string& expected) {
  if (value.kind != ConfigTree::Kind::kList) fail_at(value, key, expected);
  return value;
}

std::string pair_text(const Eigen::Vector2d& v) { return "[" + number_text(v.x()) + ", " + number_text(v.y()) + "]"; }

template <class Values, class ToText>
std::string list_text(const Values& values, ToText to_text) {
  std::string out = "[";
  for (const auto& v : values) out += (out.size() > 1 ? ", " : "") + to_text(v);
  return out + "]";
}

/// Degrees that read back as `angle` [rad], a round figure if there is one.
double degrees_that_read_as(double angle) {
  const double exact = degrees(angle);
  const double round = std::round(exact * 1e9) / 1e9;
  const double below = std::nextafter(exact, -1e300), above = std::nextafter(exact, 1e300);
  for (const double candidate : {round, exact, below, above}) {
    if (radians(candidate) == angle) return candidate;
  }
  return exact;
}

}  // namespace

void ConfigSection::read(const std::string& key, double& value, Range range) {
  if (const auto* entry = tree_->find(key)) value = number_of(*entry->value, key, range);
  tree_->note(key, number_text(value));
}

void ConfigSection::read(const std::string& key, int& value, Range range) {
  if (const auto* entry = tree_->find(key)) value = whole_number_of<int>(*entry->value, key, range);
  tree_->note(key, std::to_string(value));
}

void ConfigSection::read(const std::string& key, std::uint32_t& value, Range range) {
  if (const auto* entry = tree_->find(key)) value = whole_number_of<std::uint32_t>(*entry->value, key, range);
  tree_->note(key, std::to_string(value));
}

void ConfigSection::read(const std::string& key, bool& value) {
  if (const auto* entry = tree_->find(key)) {
    const ConfigTree& given = *entry->value;
    const bool yes = given.text == "true", no = given.text == "false";
    if (given.kind != ConfigTree::Kind::kText || given.quoted || (!yes && !no)) fail_at(given, key, "true or false");
    value = yes;
  }
  tree_->note(key, value ? "true" : "false");
}

void ConfigSection::read(const std::string& key, std::string& value) {
  if (const auto* entry = tree_->find(key)) {
    if (entry->value->kind != ConfigTree::Kind::kText) fail_at(*entry->value, key, "a text");
    value = entry->value->text;
  }
  tree_->note(key, yaml_scalar(value));
}

void ConfigSection::read(const std::string& key, std::filesystem::path& value) {
  std::filesystem::path noted = value;
  if (const auto* entry = tree_->find(key)) {
    const ConfigTree& given = *entry->value;
    if (given.kind != ConfigTree::Kind::kText || given.text.empty()) fail_at(given, key, "the name of a file");
    noted = given.text;
    const bool by_option = given.place.file.starts_with("--set ");
    value = by_option ? noted : std::filesystem::path(given.place.file).parent_path() / noted;
    const bool goes_up = std::find(noted.begin(), noted.end(), "..") != noted.end();
    if (by_option || goes_up) noted = std::filesystem::absolute(value).lexically_normal();
  }
  tree_->note(key, yaml_scalar(noted.string()));
}

void ConfigSection::read(const std::string& key, Eigen::Vector2d& value, Range range) {
  if (const auto* entry = tree_->find(key)) value = pair_of(*entry->value, key, range);
  tree_->note(key, pair_text(value));
}

void ConfigSection::read(const std::string& key, std::vector<double>& value, Range range) {
  if (const auto* entry = tree_->find(key)) {
    std::vector<double> given;
    for (const auto& item : list_of(*entry->value, key, "a list of numbers [a, b, ...]").items) {
      given.push_back(number_of(*item, key, range));
    }
    value = std::move(given);
  }
  tree_->note(key, list_text(value, number_text));
}

void ConfigSection::read(const std::string& key, std::vector<Eigen::Vector2d>& value, Range range) {
  if (const auto* entry = tree_->find(key)) {
    std::vector<Eigen::Vector2d> given;
    for (const auto& item : list_of(*entry->value, key, "a list of points [[x, y], ...]").items) {
      given.push_back(pair_of(*item, key, range));
    }
    value = std::move(given);
  }
  tree_->note(key, list_text(value, pair_text));
}

void ConfigSection::read_degrees(const std::string& key, double& value, Range range) {
  const auto* entry = tree_->find(key);
  const double in_degrees = entry ? number_of(*entry->value, key, range) : degrees_that_read_as(value);
  // Also for a default: not every angle in radians has degrees that lead back to it, and a run must equal the run
  // of its resolved file.
  value = radians(in_degrees);
  tree_->note(key, number_text(in_degrees));
}

}  // namespace cogslam
