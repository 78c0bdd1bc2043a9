#pragma once

#include <cstddef>
#include <memory>

#include "nacre/core/error.h"

// Loops over indices on all cores, by oneTBB. An exception thrown by a body ends the loop and is
// rethrown to the caller; a loop inside of a body goes on to its end all the same.

namespace nacre {

/// What parallel_for() and parallel_for_ranges() call: a loop body with its type erased, so that
/// oneTBB's templates are compiled once (parallel.cpp).
struct LoopBody {
    const void* body;
    void (*call)(const void* body, std::size_t first, std::size_t last);
};
void run_in_parallel(std::size_t begin, std::size_t end, const LoopBody& body);
void run_in_parallel(std::size_t begin, std::size_t end, std::size_t grain, const LoopBody& body);

/// Calls body(first, last) for consecutive pieces [first, last) of [begin, end), each of at most
/// `grain` indices, on as many threads as there are. Which thread gets which piece varies from
/// run to run: a result must not depend on it.
template <class Body>
void parallel_for_ranges(std::size_t begin, std::size_t end, std::size_t grain, const Body& body) {
    run_in_parallel(begin, end, grain,
                    {&body, [](const void* b, std::size_t first, std::size_t last) {
                         (*static_cast<const Body*>(b))(first, last);
                     }});
}

/// Calls body(i) once for each i in [begin, end); pieces are cut to balance the load.
template <class Body>
void parallel_for(std::size_t begin, std::size_t end, const Body& body) {
    run_in_parallel(begin, end, {&body, [](const void* b, std::size_t first, std::size_t last) {
                                     const Body& call = *static_cast<const Body*>(b);
                                     for (std::size_t i = first; i != last; ++i) call(i);
                                 }});
}

/// Threads that may be asked for, by the command line as by Python; 0: all the machine has.
inline constexpr Range kThreadRange{0, 4096};

/// While it lives, at most `threads` threads run parallel loops; 0 means all the machine has.
/// Limits may nest: the smallest counts.
class ThreadLimit {
 public:
    /// @throws DomainError if threads is negative
    explicit ThreadLimit(int threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

    /// How many threads a parallel loop may use now.
    static int threads();

 private:
    struct Control;  // oneTBB's
    std::unique_ptr<Control> control_;
};

}  // namespace nacre
