#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

// "did you mean": the nearest of a list of known names, for error messages.

namespace nacre {

/// Fewest insertions, deletions, substitutions and swaps of neighbours that turn a into b, no
/// letter being changed twice: the optimal string alignment distance. Bytes are compared, capital
/// letters count as their small ones.                                            [damerau-1964]
int edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to `name` if it is near enough to be a slip of the hand (at most a third
/// of the letters differ, and at least one edit is allowed); the first of several equally near.
std::optional<std::string> closest_match(std::string_view name,
                                         std::span<const std::string> candidates);

/// " (did you mean 'x'?)", or nothing: to append to a message.
std::string did_you_mean(std::string_view name, std::span<const std::string> candidates);

}  // namespace nacre
