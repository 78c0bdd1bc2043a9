#include "apps/studio/lanes.h"

#include <sys/resource.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

namespace nacre::studio {

namespace {

constexpr int kNice = 15;  // a thirtieth of the processor beside a thread of nice 0

}  // namespace

Lane::Lane(const Patience& patience, bool background)
    : patience_(patience), background_(background), thread_([this] { work(); }) {}

void Lane::end() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
        clients_.clear();
        turns_.clear();
        if (running_) running_->stopped = true;
    }
    posted_.notify_all();
    if (thread_.joinable()) thread_.join();
}

void Lane::post(ClientId id, Job job) {
    {
        const std::lock_guard lock(mutex_);
        if (ending_) return;
        const auto [place, is_new] = clients_.try_emplace(id);
        Client& client = place->second;
        if (is_new) client.answered = Clock::now();
        if (running_ && running_->client == id && running_->kind == job.kind) {
            running_->newer_waits = true;
        }
        const auto same = std::ranges::find(client.waiting, job.kind, &Job::kind);
        if (same != client.waiting.end()) {
            *same = std::move(job);
        } else {
            client.waiting.push_back(std::move(job));
        }
        if (std::ranges::find(turns_, id) == turns_.end()) turns_.push_back(id);
    }
    posted_.notify_one();
}

std::size_t Lane::stop(ClientId id, const std::optional<std::string>& kind) {
    const std::lock_guard lock(mutex_);
    std::size_t stopped = 0;
    if (running_ && running_->client == id && !running_->stopped &&
        (!kind || running_->kind == *kind)) {
        running_->stopped = true;
        ++stopped;
    }
    const auto found = clients_.find(id);
    if (found == clients_.end()) return stopped;
    stopped += std::erase_if(found->second.waiting,
                             [&](const Job& job) { return !kind || job.kind == *kind; });
    if (!kind) {
        clients_.erase(found);
        std::erase(turns_, id);
    }
    return stopped;
}

bool Lane::may_go_on() {
    const std::lock_guard lock(mutex_);
    if (running_->stopped) return false;
    if (!running_->newer_waits) return true;
    const auto now = Clock::now();
    if (now - running_->since < patience_.at_least) return true;
    if (now - clients_.at(running_->client).answered > patience_.longest_silence) return true;
    running_->stopped = true;
    return false;
}

void Lane::work() {
    // Of this thread alone, as Linux has it. Where that is refused, it works all the same.
    if (background_) (void)::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice);
    // oneTBB gives its workers to arenas of higher priority first.
    tbb::task_arena arena(
        tbb::task_arena::automatic, 1,
        background_ ? tbb::task_arena::priority::low : tbb::task_arena::priority::normal);
    std::unique_lock lock(mutex_);
    for (;;) {
        posted_.wait(lock, [&] { return ending_ || !turns_.empty(); });
        if (ending_) return;
        const ClientId id = turns_.front();
        turns_.pop_front();
        auto client = clients_.find(id);
        if (client == clients_.end() || client->second.waiting.empty()) continue;
        std::vector<Job>& waiting = client->second.waiting;
        Job job = std::move(waiting.front());
        waiting.erase(waiting.begin());
        if (!waiting.empty()) turns_.push_back(id);
        running_ = Running{id, job.kind, Clock::now()};
        lock.unlock();
        arena.execute([&] { job.run([this](double) { return may_go_on(); }); });
        job = {};  // what it holds may take long to destroy
        lock.lock();
        client = clients_.find(id);
        if (client != clients_.end() && !running_->stopped) client->second.answered = Clock::now();
        running_.reset();
    }
}

}  // namespace nacre::studio
