#include "core/line_fields.hpp"

#include <string>

#include "core/number_text.hpp"
#include "core/printable.hpp"

namespace cogslam {
namespace {

constexpr std::string_view kBlanks = " \t\r\v\f";

std::string expectation(std::int64_t min, std::int64_t max) {
  using Limits = std::numeric_limits<std::int64_t>;
  if (min == Limits::min() && max == Limits::max()) return "a whole number";
  if (max == Limits::max()) return "a whole number of at least " + std::to_string(min);
  return "a whole number in [" + std::to_string(min) + ", " + std::to_string(max) + "]";
}

}  // namespace

std::size_t LineFields::next_start() const {
  const std::size_t start = line_.find_first_not_of(kBlanks, next_);
  return start == std::string_view::npos ? line_.size() : start;
}

SourcePlace LineFields::at(std::size_t index) const { return {place_.file, place_.line, static_cast<int>(index) + 1}; }

SourcePlace LineFields::place() const { return at(next_start()); }

bool LineFields::done() const { return next_start() == line_.size(); }

std::string_view LineFields::word(std::string_view name) {
  if (done()) throw InputError(place(), "line ends where " + std::string(name) + " was expected");
  last_ = next_start();
  next_ = std::min(line_.find_first_of(kBlanks, last_), line_.size());
  return line_.substr(last_, next_ - last_);
}

double LineFields::number(std::string_view name) {
  const std::string_view text = word(name);
  const auto value = parse_number(text);
  if (!value) fail(std::string(name) + ": expected a number, found " + in_quotes(text));
  return *value;
}

std::int64_t LineFields::whole_number(std::string_view name, std::int64_t min, std::int64_t max) {
  const std::string_view text = word(name);
  const auto value = parse_whole_number(text);
  if (!value || *value < min || *value > max) {
    fail(std::string(name) + ": expected " + expectation(min, max) + ", found " + in_quotes(text));
  }
  return *value;
}

void LineFields::finish() const {
  if (!done()) {
    const std::size_t start = next_start();
    const std::size_t end = std::min(line_.find_first_of(kBlanks, start), line_.size());
    throw InputError(place(), "expected the end of the line, found " + in_quotes(line_.substr(start, end - start)));
  }
}

void LineFields::fail(std::string_view message) const { throw InputError(at(last_), std::string(message)); }

}  // namespace cogslam
