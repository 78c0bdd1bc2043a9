#pragma once

#include <functional>
#include <memory>
#include <string>

#include "apps/studio/answers.h"
#include "apps/studio/lanes.h"
#include "apps/studio/outbox.h"

// One page that is connected: its messages become jobs, its answers wait in an outbox. Knows no
// sockets.

namespace nacre::studio {

/// The threads that answer all pages.
class Workshop {
 public:
    Lane& lane_of(const std::string& type);
    void forget(ClientId client);
    std::size_t stop(ClientId client, const std::optional<std::string>& type);
    /// Stops all work and waits for its end; nothing is answered any more.
    void end();
    SolvedPaints& solved() { return solved_; }

 private:
    SolvedPaints solved_;
    /// An answer takes some 20 ms; it may take so much longer before it is given up for a newer one.
    Lane paint_{
        {.at_least = std::chrono::milliseconds(100), .longest_silence = std::chrono::seconds(1)}};
    Lane look_{{}, true}, fit_{{}, true}, picture_{{}, true};
    Lane atlas_{{}};  // somebody waits for it; pages stop it when a slider moves
};

class Session {
 public:
    /// @param post  hands an answer over to the thread of the socket; from any thread
    Session(ClientId id, Workshop& workshop, std::function<void(Answer)> post)
        : id_(id), workshop_(workshop), post_(std::move(post)) {}
    ~Session() { workshop_.forget(id_); }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// A text frame that came. Takes no time: the work is a job's.
    void receive(std::string_view text);

 private:
    ClientId id_;
    Workshop& workshop_;
    std::function<void(Answer)> post_;
    std::shared_ptr<Memory> memory_ = std::make_shared<Memory>();
};

}  // namespace nacre::studio
