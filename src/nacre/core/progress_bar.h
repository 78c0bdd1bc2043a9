#pragma once

#include <chrono>
#include <string>

#include "nacre/core/progress.h"

namespace nacre {

/// A line on stderr that is redrawn in place: label, bar, percentage, time elapsed and estimate of
/// the time left. Draws nothing when quiet or when stderr is not a terminal.
class ProgressBar {
 public:
    explicit ProgressBar(std::string label, bool quiet = false);
    /// Ends the line, so that what follows starts on a fresh one.
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// For the library; must not outlive the bar. Asks the work to stop once
    /// interrupt_requested() (core/interrupt.h).
    Progress callback();

 private:
    using Clock = std::chrono::steady_clock;

    bool update(double fraction);

    std::string label_;
    bool visible_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_drawn_{};
    bool drawn_ = false;
    double drawn_fraction_ = 0;
};

/// The line itself, at most `columns` characters wide, as in
/// "render  [#####-----]  50 %  1:05 elapsed, 1:05 left".
std::string progress_line(const std::string& label, double fraction, double elapsed_s, int columns);

/// 3.2 s, 1:05, 2:03:04.
std::string duration_text(double seconds);

}  // namespace nacre
