#include "nacre/fit/free_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "nacre/core/error.h"
#include "nacre/fit/effect.h"

namespace nacre::fit {

namespace {

/// Why a number cannot be free; empty if it can.
std::string obstacle(const paint::Recipe& start, const std::string& key,
                     const std::vector<paint::ParameterBounds>& bounds,
                     const EffectOnColours& effect) {
    try {
        const FreeNumbers alone(start, {key}, bounds);
        return effect.of(alone[0]) ? "" : kNoEffect;
    } catch (const DomainError& error) {  // "key = value: reason"
        const std::string message = error.what();
        const std::size_t reason = message.find(": ");
        return reason == std::string::npos ? message : message.substr(reason + 2);
    }
}

}  // namespace

FreeKeys free_keys(const paint::Recipe& start, const std::vector<std::string>& patterns,
                   const std::vector<paint::ParameterBounds>& bounds, bool hot_spot,
                   const Progress& progress) {
    FreeKeys free;
    SharedProgress work(progress, 1);
    std::optional<EffectOnColours> effect;
    for (const std::string& pattern : patterns) {
        const bool many = pattern.find('*') != std::string::npos;
        for (const std::string& key : paint::matching_parameters(start, pattern)) {
            const auto is_key = [&](const SkippedNumber& skipped) { return skipped.key == key; };
            if (std::ranges::find(free.keys, key) != free.keys.end()) continue;
            if (many) {
                if (std::ranges::any_of(free.skipped, is_key)) continue;
                if (!effect) effect.emplace(start, hot_spot, work);
                if (std::string why = obstacle(start, key, bounds, *effect); !why.empty()) {
                    free.skipped.push_back({key, std::move(why)});
                    continue;
                }
            } else {
                std::erase_if(free.skipped, is_key);
            }
            free.keys.push_back(key);
        }
    }
    if (free.keys.empty() && !free.skipped.empty()) {
        throw DomainError(fmt::format("none of the {} numbers that match can be free; {}: {}",
                                      free.skipped.size(), free.skipped[0].key,
                                      free.skipped[0].why));
    }
    return free;
}

}  // namespace nacre::fit
