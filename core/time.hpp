#pragma once

#include <cmath>
#include <compare>
#include <cstdint>

namespace cogslam {

/// A span of time, integer nanoseconds. Seconds are for formulas and text only.
struct Duration {
  std::int64_t ns = 0;

  static Duration from_seconds(double s) { return {static_cast<std::int64_t>(std::llround(s * 1e9))}; }
  [[nodiscard]] constexpr double seconds() const { return static_cast<double>(ns) * 1e-9; }
  constexpr auto operator<=>(const Duration&) const = default;
};

/// A moment, integer nanoseconds since an epoch that the source of the data chooses (a simulation
/// starts at 0). Nothing here reads a clock: time arrives as an argument.
struct Time {
  std::int64_t ns = 0;

  static Time from_seconds(double s) { return {Duration::from_seconds(s).ns}; }
  [[nodiscard]] constexpr double seconds() const { return static_cast<double>(ns) * 1e-9; }
  constexpr auto operator<=>(const Time&) const = default;
};

constexpr Duration operator+(Duration a, Duration b) { return {a.ns + b.ns}; }
constexpr Duration operator-(Duration a, Duration b) { return {a.ns - b.ns}; }
constexpr Duration operator*(std::int64_t n, Duration d) { return {n * d.ns}; }
constexpr Duration operator-(Time a, Time b) { return {a.ns - b.ns}; }
constexpr Time operator+(Time t, Duration d) { return {t.ns + d.ns}; }
constexpr Time operator-(Time t, Duration d) { return {t.ns - d.ns}; }

}  // namespace cogslam
