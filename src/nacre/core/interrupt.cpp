#include "nacre/core/interrupt.h"

#include <signal.h>

#include <atomic>

namespace nacre {
namespace {

std::atomic<bool> requested{false};
std::atomic<bool> installed{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may not take a lock");

struct sigaction previous_interrupt, previous_terminate;

extern "C" void on_signal(int signal_number) {
    if (requested.exchange(true)) {
        // The shell shall see that the signal ended us: restore the default and send it again.
        signal(signal_number, SIG_DFL);
        raise(signal_number);
    }
}

}  // namespace

InterruptHandler::InterruptHandler() : active_(!installed.exchange(true)) {
    if (!active_) return;
    requested = false;
    struct sigaction action = {};
    action.sa_handler = on_signal;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;  // a write in progress goes on
    sigaction(SIGINT, &action, &previous_interrupt);
    sigaction(SIGTERM, &action, &previous_terminate);
}

InterruptHandler::~InterruptHandler() {
    if (!active_) return;
    sigaction(SIGINT, &previous_interrupt, nullptr);
    sigaction(SIGTERM, &previous_terminate, nullptr);
    requested = false;
    installed = false;
}

bool interrupt_requested() { return requested.load(std::memory_order_relaxed); }

}  // namespace nacre
