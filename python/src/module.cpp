#include <fmt/format.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <memory>

#include "bind.h"
#include "nacre/core/parallel.h"
#include "nacre/core/version.h"

// The extension nacre._nacre: all but ray tracing.

NB_MODULE(_nacre, module) {
    using namespace nacre::python;
    using nacre::ThreadLimit;
    translate_errors();
    bind_paint(module);
    bind_look(module);
    bind_appearance_arrays(module);
    bind_optics(module);
    bind_measurement(module);
    bind_reference(module);
    bind_sparkle(module);
    bind_fit(module);
    bind_drawdown(module);
    bind_images(module);
    module.def("version", &nacre::version);
    module.def("threads", &ThreadLimit::threads);
    module.def(
        "set_threads",
        [](int threads) {
            if (threads > nacre::kThreadRange.hi) {
                throw nacre::DomainError(fmt::format("threads = {}: must be in {}", threads,
                                                     nacre::kThreadRange.text()));
            }
            static std::unique_ptr<ThreadLimit> limit;
            auto next = std::make_unique<ThreadLimit>(0);  // the smallest of nested limits counts
            if (threads < 0) next = std::make_unique<ThreadLimit>(threads);  // throws
            limit.reset();
            limit = std::make_unique<ThreadLimit>(threads);
        },
        nanobind::arg("threads"));
}
