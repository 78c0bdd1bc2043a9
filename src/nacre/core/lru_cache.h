#pragma once

#include <algorithm>
#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <utility>

namespace nacre {

/// Keeps what a costly function gave for the keys that were asked for last. May be used from several
/// threads at once; drops the least recently used.
///
/// @tparam Key  compared by ==
template <class Key, class Value>
class LruCache {
 public:
    using Size = std::size_t (*)(const Value&);

    /// @param capacity  of the sizes of all values together; one larger than that is not kept
    /// @param size      of a value; none: 1
    explicit LruCache(std::size_t capacity, Size size = nullptr)
        : capacity_(capacity), size_(size) {}

    /// The value kept for this key, else make().
    /// @param make  () -> Value, the same for equal keys. It is not locked meanwhile, so that two
    ///              threads may make the same, of which one is kept. What it throws is passed on,
    ///              and nothing is kept.
    template <class Make>
    std::shared_ptr<const Value> get(const Key& key, const Make& make) {
        {
            const std::scoped_lock lock(mutex_);
            if (auto found = find(key)) return found;
        }
        auto value = std::make_shared<const Value>(make());
        const std::size_t size = size_ ? size_(*value) : 1;
        const std::scoped_lock lock(mutex_);
        ++made_;
        if (auto found = find(key)) return found;  // made by another thread meanwhile
        if (size > capacity_) return value;
        entries_.push_front({key, value, size});
        for (used_ += size; used_ > capacity_; entries_.pop_back()) used_ -= entries_.back().size;
        return value;
    }

    /// How often make() was called.
    std::size_t made() const {
        const std::scoped_lock lock(mutex_);
        return made_;
    }

 private:
    struct Entry {
        Key key;
        std::shared_ptr<const Value> value;
        std::size_t size;
    };

    // The value kept for a key, which is the last used one then; null if there is none.
    std::shared_ptr<const Value> find(const Key& key) {
        const auto found = std::find_if(entries_.begin(), entries_.end(),
                                        [&](const Entry& entry) { return entry.key == key; });
        if (found == entries_.end()) return nullptr;
        entries_.splice(entries_.begin(), entries_, found);
        return found->value;
    }

    std::size_t capacity_;
    Size size_;
    mutable std::mutex mutex_;
    std::list<Entry> entries_;  // the last used one first
    std::size_t used_ = 0, made_ = 0;
};

}  // namespace nacre
