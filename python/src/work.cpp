#include "work.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace nacre::python {

namespace {

constexpr std::chrono::milliseconds kBetweenQuestions{50};

/// What the waiting thread and the working one tell each other.
struct Work {
    std::mutex mutex;
    std::condition_variable changed;
    bool done = false;
    std::exception_ptr thrown;
    std::atomic<double> fraction{0};
    std::atomic<bool> stop{false};
};

/// Lets Python act on signals and hear of the progress. @throws nb::python_error
bool goes_on(const nb::object& progress, double fraction) {
    if (PyErr_CheckSignals() != 0) nb::raise_python_error();
    return progress.is_none() || !progress(fraction).is(nb::bool_(false));
}

}  // namespace

void run_beside(const nb::object& progress, const std::function<void(const Progress&)>& work) {
    Work shared;
    std::thread worker([&] {
        try {
            work([&shared](double fraction) {
                shared.fraction = fraction;
                return !shared.stop;
            });
        } catch (...) {
            shared.thrown = std::current_exception();
        }
        const std::lock_guard lock(shared.mutex);
        shared.done = true;
        shared.changed.notify_one();
    });
    std::exception_ptr raised;  // in Python
    for (bool done = false; !done;) {
        {
            const nb::gil_scoped_release release;
            std::unique_lock lock(shared.mutex);
            done = shared.changed.wait_for(lock, kBetweenQuestions, [&] { return shared.done; });
        }
        if (raised) continue;
        try {
            if (done && shared.thrown) break;
            if (!goes_on(progress, done ? 1 : shared.fraction.load())) shared.stop = true;
        } catch (...) {
            raised = std::current_exception();
            shared.stop = true;
        }
    }
    worker.join();
    if (raised) std::rethrow_exception(raised);
    if (shared.thrown) std::rethrow_exception(shared.thrown);
}

}  // namespace nacre::python
