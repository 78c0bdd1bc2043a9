#include "nacre/core/progress.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>

namespace nacre {
namespace {

std::atomic<bool> requested{false};
std::atomic<bool> installed{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may not take a lock");

struct sigaction previous_interrupt, previous_terminate;

extern "C" void on_signal(int signal_number) {
    if (requested.exchange(true)) {
        // So that the shell sees the signal as the cause of death: restore the default action, send
        // it again.
        signal(signal_number, SIG_DFL);
        raise(signal_number);
    }
}

}  // namespace

void SharedProgress::report() {
    last_report_ = Clock::now();
    if (!stopped_ && !progress_(std::min(1.0, done_ / total_))) stopped_ = true;
}

void SharedProgress::add(double done) {
    if (!progress_) return;
    const std::scoped_lock lock(mutex_);
    done_ += done;
    report();
}

bool SharedProgress::keep_going() {
    if (!progress_ || stopped_) return !stopped_;
    // Loops ask once a sample. The coarse clock, of a few milliseconds, costs a tenth of the fine
    // one, and a lock is taken only where the time has come for this thread.
    constexpr std::int64_t kInterval_ms = 5;
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC_COARSE, &now);
    const std::int64_t now_ms = 1000 * std::int64_t{now.tv_sec} + now.tv_nsec / 1'000'000;
    // Of the counter asked last: one may ask another, and must not keep it from asking.
    thread_local const SharedProgress* last = nullptr;
    thread_local std::int64_t last_ms = 0;
    if (last == this && now_ms - last_ms < kInterval_ms) return true;
    last = this;
    last_ms = now_ms;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (lock.owns_lock() &&
        Clock::now() - last_report_ >= std::chrono::milliseconds(kInterval_ms)) {
        report();
    }
    return !stopped_;
}

void SharedProgress::throw_if_stopped(const char* what) {
    if (!keep_going()) throw Stopped(fmt::format("{} was stopped", what));
}

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

namespace {

constexpr std::chrono::milliseconds kRedrawInterval{100};
constexpr int kUsualColumns = 80;
// Kept free for " 100 %  1:02:03 elapsed, 1:02:03 left", so that the bar keeps its length.
constexpr int kTailColumns = 37;

int terminal_columns() {
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
    return kUsualColumns;
}

}  // namespace

std::string duration_text(double seconds) {
    // Beyond a century, and for NaN, there is no useful number.
    if (!(seconds < 3.2e9)) return "very long";
    if (seconds < 59.95) return fmt::format("{:.1f} s", std::max(0.0, seconds));
    const auto whole = static_cast<long long>(std::lround(seconds));
    const long long h = whole / 3600, m = whole / 60 % 60, s = whole % 60;
    return h > 0 ? fmt::format("{}:{:02}:{:02}", h, m, s) : fmt::format("{}:{:02}", m, s);
}

std::string progress_line(const std::string& label, double fraction, double elapsed_s,
                          int columns) {
    fraction = fraction >= 0 ? std::min(fraction, 1.0) : 0.0;  // NaN counts as 0
    std::string times = duration_text(elapsed_s) + " elapsed";
    // Before 1 % is done the estimate is too uncertain to show.
    if (fraction >= 0.01 && fraction < 1) {
        times += ", " + duration_text(elapsed_s * (1 - fraction) / fraction) + " left";
    }
    const std::string tail =
        fmt::format(" {:3} %  {}", static_cast<int>(std::floor(100 * fraction)), times);
    const int room = columns - static_cast<int>(label.size()) - 4 - kTailColumns;
    std::string line = label + "  ";
    if (room >= 5) {
        const int width = std::min(room, 40);
        const int done = static_cast<int>(fraction * width);
        line += fmt::format("[{:#<{}}{:-<{}}]", "", done, "", width - done);
    }
    line += tail;
    return line.substr(0, static_cast<std::size_t>(std::max(columns, 0)));
}

ProgressBar::ProgressBar(std::string label, bool quiet)
    : label_(std::move(label)), visible_(!quiet && isatty(STDERR_FILENO)) {}

ProgressBar::~ProgressBar() {
    if (drawn_) std::fputc('\n', stderr);
}

Progress ProgressBar::callback() {
    return [this](double fraction) { return update(fraction); };
}

bool ProgressBar::update(double fraction) {
    const auto now = Clock::now();
    const bool just_finished = fraction >= 1 && drawn_fraction_ < 1;
    if (visible_ && (just_finished || !drawn_ || now - last_drawn_ >= kRedrawInterval)) {
        const double elapsed_s = std::chrono::duration<double>(now - start_).count();
        // One column stays free: a full line would wrap on some terminals. ESC [K clears the rest.
        const std::string line = progress_line(label_, fraction, elapsed_s, terminal_columns() - 1);
        std::fputs(("\r" + line + "\x1b[K").c_str(), stderr);
        std::fflush(stderr);
        last_drawn_ = now;
        drawn_ = true;
        drawn_fraction_ = fraction;
    }
    return !interrupt_requested();
}

}  // namespace nacre
