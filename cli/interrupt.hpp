#pragma once

namespace cogslam {

/// The user or the system asked the program to stop.
struct Interrupted {};

/// From now on the first SIGINT or SIGTERM is noted, and a second one ends the program at once.
void watch_for_interrupts();

/// Throws Interrupted once a signal was noted. Cheap: call it from every progress report.
void stop_if_interrupted();

}  // namespace cogslam
