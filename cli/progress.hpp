#pragma once

#include <memory>
#include <optional>
#include <string>

#include "eval/episode.hpp"

namespace cogslam {

/// Tells on standard error how far the program has come: on a terminal one line, redrawn, with per cent and time left;
/// elsewhere a line where a stage begins and where it ends; nothing with --quiet. Every report is also the place where
/// the program stops when it is interrupted.
class ProgressLine {
 public:
  /// `stages`: how many there will be, for people; `expect` changes it.
  ProgressLine(int stages, bool quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void expect(int stages) { stages_ = stages; }
  /// For those who report stages; good as long as this object lives.
  StageBegin begin();
  /// Ends the stage that is running.
  void end_stage();
  /// A note on a line of its own, left out with --quiet.
  void say(const std::string& message);
  /// A warning: said in any case.
  void warn(const std::string& message);
  /// A warning that does not end the stage that is running.
  void warn_amid(const std::string& message);
  /// Takes the line off the terminal, so that standard output can come.
  void clear();

 private:
  struct Stage;

  void start(const std::string& name);
  void report(double done);
  void redraw(const std::string& text);

  int stages_;
  bool quiet_;
  bool terminal_;
  int number_ = 0;
  std::unique_ptr<Stage> stage_;
};

/// "1:05" or "2:03:04": minutes and seconds, hours where there are any.
std::string clock_text(double seconds);

}  // namespace cogslam
