#pragma once

#include <nanobind/nanobind.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"

// Work that takes long, called from Python.

namespace nacre::python {

namespace nb = nanobind;

/// Runs `work` on a thread of its own. This one, which must hold the GIL, lets it go, and every
/// 50 ms takes it to let Python act on signals and to call `progress`, if that is not None, with the
/// fraction done. Where Ctrl-C has been pressed, `progress` raises, or it returns False, the work is
/// asked to stop; what was raised is raised again once it has.
/// @throws what the work throws
void run_beside(const nb::object& progress, const std::function<void(const Progress&)>& work);

/// The same for work that has a result.
template <class Work>
auto run(const nb::object& progress, const Work& work) {
    using Result = std::invoke_result_t<const Work&, const Progress&>;
    std::optional<Result> result;
    run_beside(progress, [&](const Progress& callback) { result.emplace(work(callback)); });
    return std::move(*result);
}

/// Calls body(i) for i in [0, n), without the GIL: a few in place, many in parallel so that Ctrl-C
/// works.
template <class Body>
void for_each(std::size_t n, const Body& body) {
    constexpr std::size_t kFew = 64;
    if (n <= kFew) {
        const nb::gil_scoped_release release;
        for (std::size_t i = 0; i < n; ++i) body(i);
        return;
    }
    run_beside(nb::none(), [&](const Progress& callback) {
        SharedProgress work(callback, static_cast<double>(n));
        parallel_for(0, n, [&](std::size_t i) {
            if (work.stopped()) return;
            if (i % kFew == 0) work.keep_going();
            body(i);
        });
    });
}

}  // namespace nacre::python
