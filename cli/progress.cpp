#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "cli/interrupt.hpp"
#include "eval/metrics/timing.hpp"

namespace cogslam {
namespace {

constexpr double kRedrawSeconds = 0.2;
constexpr double kLeastDone = 0.02;  // before that the time left is a guess of nothing

/// Who cannot be told is not told; fmt::print would throw.
void tell(const std::string& text) { std::fputs(text.c_str(), stderr); }

}  // namespace

struct ProgressLine::Stage {
  std::string title;
  Stopwatch watch{Clock::kWall};
  double drawn_at = -kRedrawSeconds;  ///< on `watch` [s]
};

ProgressLine::ProgressLine(int stages, bool quiet)
    : stages_(stages), quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() { clear(); }

StageBegin ProgressLine::begin() {
  return [this](const std::string& name) {
    start(name);
    return Progress([this](double done) { report(done); });
  };
}

void ProgressLine::start(const std::string& name) {
  end_stage();
  stop_if_interrupted();
  ++number_;
  stage_ = std::make_unique<Stage>(Stage{fmt::format("[{}/{}] {}", number_, stages_, name)});
  if (!quiet_ && !terminal_) tell(stage_->title + "\n");
}

void ProgressLine::report(double done) {
  stop_if_interrupted();
  if (quiet_ || !terminal_ || !stage_) return;
  const double passed = stage_->watch.seconds();
  if (passed - stage_->drawn_at < kRedrawSeconds) return;
  stage_->drawn_at = passed;
  const std::string left = done < kLeastDone ? "" : ", " + clock_text(passed * (1.0 - done) / done) + " left";
  redraw(fmt::format("{}: {:.0f} %{}", stage_->title, 100.0 * done, left));
}

void ProgressLine::end_stage() {
  if (!stage_) return;
  const std::string text = fmt::format("{}: done in {:.1f} s", stage_->title, stage_->watch.seconds());
  stage_.reset();
  if (quiet_) return;
  if (terminal_) {
    redraw(text);
  } else {
    tell(text + "\n");
  }
}

void ProgressLine::say(const std::string& message) {
  end_stage();
  clear();
  if (!quiet_) tell(message + "\n");
}

void ProgressLine::warn(const std::string& message) {
  end_stage();
  warn_amid(message);
}

void ProgressLine::warn_amid(const std::string& message) {
  clear();
  tell("cogslam: " + message + "\n");
}

void ProgressLine::clear() {
  if (terminal_) redraw("");
}

void ProgressLine::redraw(const std::string& text) {
  if (quiet_) return;
  tell("\r\033[K" + text);
  std::fflush(stderr);
}

std::string clock_text(double seconds) {
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace cogslam
