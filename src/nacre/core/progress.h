#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <string>

#include "nacre/core/error.h"

// The library is silent: long work reports through a callback and asks it whether to go on. The
// command line turns the callback into a bar with an estimate of the time left, and Ctrl-C into a
// request to stop at the next safe point, where the work writes what it has.

namespace nacre {

/// Called now and then, from one thread at a time, with the fraction done in [0, 1].
/// Returning false asks the work to stop at the next safe point.
using Progress = std::function<bool(double fraction)>;

/// Thrown where work is stopped in its middle and has nothing to hand over.
class Stopped : public Error {
 public:
    using Error::Error;
};

/// Progress of work that several threads do in pieces: counts the pieces and asks the caller, from
/// one thread at a time, whether to go on.
class SharedProgress {
 public:
    /// @param progress  may be empty; outlives the counter
    /// @param total     of what add() counts, > 0
    SharedProgress(const Progress& progress, double total) : progress_(progress), total_(total) {}

    /// Counts what is done and reports it; add(0) asks at once.
    void add(double done = 1);
    /// Asks without counting, for loops inside of long pieces: at most every 5 ms, and never
    /// waiting for another thread that asks. @return false if the caller asked to stop
    bool keep_going();
    /// Whether the caller asked to stop; threads begin no further piece.
    bool stopped() const { return stopped_; }
    /// Asks, as above, and ends a loop of threads if it must stop.
    /// @throws Stopped "`what` was stopped"
    void throw_if_stopped(const char* what);

 private:
    using Clock = std::chrono::steady_clock;

    void report();

    const Progress& progress_;
    double total_, done_ = 0;
    Clock::time_point last_report_{};
    std::mutex mutex_;
    std::atomic<bool> stopped_ = false;
};

/// While it lives, the first SIGINT or SIGTERM only sets a flag; the second ends the program at
/// once, by that signal. The destructor puts back what was there before and clears the flag.
/// One at a time: a second one while the first lives changes nothing.
class InterruptHandler {
 public:
    InterruptHandler();
    ~InterruptHandler();
    InterruptHandler(const InterruptHandler&) = delete;
    InterruptHandler& operator=(const InterruptHandler&) = delete;

 private:
    bool active_;
};

/// True once a signal has come since the InterruptHandler was made. Cheap; from any thread.
bool interrupt_requested();

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
    /// interrupt_requested().
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
