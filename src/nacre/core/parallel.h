#pragma once

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <cstddef>
#include <optional>

#include "nacre/core/error.h"

// Loops over indices on all cores, by oneTBB. An exception thrown by a body ends the loop and is
// rethrown to the caller.

namespace nacre {

/// Calls body(first, last) for consecutive pieces [first, last) of [begin, end), each of at most
/// `grain` indices, on as many threads as there are. Which thread gets which piece varies from
/// run to run: a result must not depend on it.
template <class Body>
void parallel_for_ranges(std::size_t begin, std::size_t end, std::size_t grain, const Body& body) {
    if (begin >= end) return;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(begin, end, grain > 0 ? grain : 1),
        [&](const tbb::blocked_range<std::size_t>& r) { body(r.begin(), r.end()); },
        tbb::simple_partitioner{});
}

/// Calls body(i) once for each i in [begin, end); pieces are cut to balance the load.
template <class Body>
void parallel_for(std::size_t begin, std::size_t end, const Body& body) {
    if (begin >= end) return;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(begin, end),
                      [&](const tbb::blocked_range<std::size_t>& r) {
                          for (std::size_t i = r.begin(); i != r.end(); ++i) body(i);
                      });
}

/// While it lives, at most `threads` threads run parallel loops; 0 means all the machine has.
/// Limits may nest: the smallest counts.
class ThreadLimit {
 public:
    /// @throws DomainError if threads is negative
    explicit ThreadLimit(int threads) {
        if (threads < 0) throw DomainError(fmt::format("threads = {} is negative", threads));
        if (threads > 0) {
            control_.emplace(tbb::global_control::max_allowed_parallelism,
                             static_cast<std::size_t>(threads));
        }
    }

    /// How many threads a parallel loop may use now.
    static int threads() {
        return static_cast<int>(
            tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
    }

 private:
    std::optional<tbb::global_control> control_;
};

}  // namespace nacre
