#include "nacre/core/parallel.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include "nacre/core/error.h"

namespace nacre {
namespace {
using Indices = tbb::blocked_range<std::size_t>;

// Of its own: a loop inside of another's body would end early, and without a word, when the outer
// one is given up for an exception, and what follows it would go on with half of its results.
struct OwnContext : tbb::task_group_context {
    OwnContext() : task_group_context(isolated) {}
};
}  // namespace

void run_in_parallel(std::size_t begin, std::size_t end, const LoopBody& body) {
    if (begin >= end) return;
    OwnContext context;
    tbb::parallel_for(
        Indices(begin, end), [&](const Indices& r) { body.call(body.body, r.begin(), r.end()); },
        context);
}

void run_in_parallel(std::size_t begin, std::size_t end, std::size_t grain, const LoopBody& body) {
    if (begin >= end) return;
    OwnContext context;
    tbb::parallel_for(
        Indices(begin, end, grain > 0 ? grain : 1),
        [&](const Indices& r) { body.call(body.body, r.begin(), r.end()); },
        tbb::simple_partitioner{}, context);
}

struct ThreadLimit::Control {
    explicit Control(int threads)
        : control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)) {
    }
    tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads) {
    if (threads < 0) throw DomainError(fmt::format("threads = {} is negative", threads));
    if (threads > 0) control_ = std::make_unique<Control>(threads);
}

ThreadLimit::~ThreadLimit() = default;

int ThreadLimit::threads() {
    return static_cast<int>(
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

}  // namespace nacre
