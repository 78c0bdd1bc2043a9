#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "nacre/core/progress.h"

// Threads that work for the pages, so that no work ever keeps a socket waiting. A lane is one thread
// and the jobs that wait for it. Nothing queues up: of a page's jobs of one kind the newest alone
// waits, and pages take turns.

namespace nacre::studio {

using ClientId = std::uint64_t;

class Lane {
 public:
    using Clock = std::chrono::steady_clock;

    struct Job {
        std::string kind;
        /// Must not throw. What it is given says whether to go on.
        std::function<void(const Progress&)> run;
    };

    /// When a running job is stopped because a newer one of its kind waits.
    struct Patience {
        /// Not before it has run for so long: it may be about to answer.
        Clock::duration at_least{};
        /// Not while the page's last answer from this lane is older: a slider that never rests must
        /// see something move.
        Clock::duration longest_silence = Clock::duration::max();
    };

    /// @param background  whether other lanes come first: its loops get the processors that are left
    explicit Lane(const Patience& patience, bool background = false);
    ~Lane() { end(); }
    Lane(const Lane&) = delete;
    Lane& operator=(const Lane&) = delete;

    /// Takes the place of a waiting job of the same kind.
    void post(ClientId client, Job job);
    /// Stops and forgets a page's jobs of a kind, or all. @return how many there were
    std::size_t stop(ClientId client, const std::optional<std::string>& kind = {});
    /// Stops what runs, forgets what waits, and waits for the thread.
    void end();

 private:
    struct Client {
        std::vector<Job> waiting;  // in the order in which their kinds came
        Clock::time_point answered;
    };
    struct Running {
        ClientId client;
        std::string kind;
        Clock::time_point since;
        bool newer_waits = false, stopped = false;
    };

    void work();
    bool may_go_on();

    const Patience patience_;
    const bool background_;
    std::mutex mutex_;
    std::condition_variable posted_;
    std::map<ClientId, Client> clients_;
    std::deque<ClientId> turns_;  // of the clients with waiting jobs, each once
    std::optional<Running> running_;
    bool ending_ = false;
    std::thread thread_;  // last: it uses all of the above
};

}  // namespace nacre::studio
