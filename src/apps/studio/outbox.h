#pragma once

#include <deque>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "apps/studio/messages/frames.h"

namespace nacre::studio {

/// Frames that belong together. Of those of one kind only the newest is of interest.
struct Answer {
    std::string kind;
    Frames frames;
};

/// What waits to be sent to a page: of each kind of answer the newest, so that a page that does not
/// read makes nothing grow.
class Outbox {
 public:
    void add(Answer answer) {
        std::erase_if(waiting_, [&](const Answer& a) { return a.kind == answer.kind; });
        waiting_.push_back(std::move(answer));
    }
    /// The oldest; none waits: none.
    std::optional<Answer> take() {
        if (waiting_.empty()) return std::nullopt;
        Answer answer = std::move(waiting_.front());
        waiting_.pop_front();
        for (Frame& frame : answer.frames) {
            if (known_.size() >= kMaxKnown) known_.clear();
            const bool is_new = !frame.program.empty() && known_.insert(frame.program).second;
            if (is_new) frame.text = std::move(frame.text_when_new);
        }
        return answer;
    }
    std::size_t size() const { return waiting_.size(); }

 private:
    static constexpr std::size_t kMaxKnown = 1000;

    std::deque<Answer> waiting_;
    std::set<std::string> known_;  // programs that were taken
};

}  // namespace nacre::studio
