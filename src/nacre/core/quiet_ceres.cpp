#include "nacre/core/quiet_ceres.h"

#include <glog/logging.h>

#include <mutex>

namespace nacre {

namespace {

struct Quiet {
    std::mutex mutex;
    int alive = 0;
    int level_before = 0;
};

Quiet& quiet() {
    static Quiet state;
    return state;
}

}  // namespace

QuietCeres::QuietCeres() {
    Quiet& state = quiet();
    const std::lock_guard lock(state.mutex);
    if (state.alive++ > 0) return;
    state.level_before = FLAGS_minloglevel;
    FLAGS_minloglevel = google::GLOG_FATAL;
}

QuietCeres::~QuietCeres() {
    Quiet& state = quiet();
    const std::lock_guard lock(state.mutex);
    if (--state.alive == 0) FLAGS_minloglevel = state.level_before;
}

}  // namespace nacre
