#pragma once

#include <atomic>
#include <mutex>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"

namespace nacre::measure {

/// What readers take, and more than anybody should want to make.
inline constexpr double kMostTableBytes = 2147483648.0;

/// @throws DomainError if a table would have more bytes than that
inline void require_table_size(double bytes) {
    require_in_range(bytes, 0, kMostTableBytes, "bytes of the table to be measured");
}

/// Calls body(row) for each row on all threads and reports after each.
/// @throws Error if `progress` asks to stop
template <class Body>
void for_each_row(int rows, const Progress& progress, const Body& body) {
    std::atomic<bool> stop = false;
    int done = 0;
    std::mutex report;
    parallel_for(0, static_cast<std::size_t>(rows), [&](std::size_t row) {
        if (stop) return;
        body(static_cast<int>(row));
        const std::lock_guard lock(report);
        if (progress && !progress(static_cast<double>(++done) / rows)) stop = true;
    });
    if (stop) throw Error("measuring the BRDF was stopped");
}

}  // namespace nacre::measure
