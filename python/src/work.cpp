#include "work.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <string_view>
#include <thread>

namespace nacre::python {

namespace {

constexpr std::chrono::milliseconds kPollInterval{50};

/// What the waiting thread and the working one tell each other.
struct Work {
    std::mutex mutex;
    std::condition_variable changed;
    bool done = false;
    std::exception_ptr thrown;
    std::atomic<double> fraction{0};
    std::atomic<bool> stop{false};
};

/// Whether a function returned False, Python's or one of numpy's; what is no truth value is none.
/// @throws nb::python_error
bool is_false(const nb::object& returned) {
    if (returned.is(nb::bool_(false))) return true;
    if (!nb::hasattr(returned, "dtype")) return false;
    const nb::object kind = nb::getattr(returned.attr("dtype"), "kind", nb::none());
    if (!nb::isinstance<nb::str>(kind) ||
        std::string_view(nb::cast<nb::str>(kind).c_str()) != "b") {
        return false;
    }
    const int truth = PyObject_IsTrue(returned.ptr());
    if (truth < 0) PyErr_Clear();  // of several
    return truth == 0;
}

/// Lets Python act on signals and hear of the progress. @throws nb::python_error
bool goes_on(const nb::object& progress, double fraction) {
    if (PyErr_CheckSignals() != 0) nb::raise_python_error();
    return progress.is_none() || !is_false(progress(fraction));
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
            done = shared.changed.wait_for(lock, kPollInterval, [&] { return shared.done; });
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
