#pragma once

// Ctrl-C asks long work to stop at the next safe point, where it writes what it has.

namespace nacre {

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

}  // namespace nacre
