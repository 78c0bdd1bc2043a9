#include "nacre/core/text.h"

#include <algorithm>
#include <vector>

namespace nacre {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// Longer texts are not compared: no key is so long, and the distance takes time in proportion to
// the product of the lengths.
constexpr std::size_t kMaxNameLength = 100;

}  // namespace

std::string lowercase(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = lower(c);
    return result;
}

std::string excerpt(std::string_view text, std::size_t longest, char stand_in) {
    std::size_t end = std::min(text.size(), longest);
    // Not before a continuation byte, which would leave half a character.
    while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) {
        --end;
    }
    std::string result(text.substr(0, end));
    for (char& c : result) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = stand_in;
    }
    return end < text.size() ? result + "..." : result;
}

int edit_distance(std::string_view a, std::string_view b) {
    // Three rows of the table d[i][j] = distance of the first i letters of a to the first j of b.
    std::vector<int> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before.swap(last);
        last.swap(row);
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const char x = lower(a[i - 1]), y = lower(b[j - 1]);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (x != y)});
            if (i > 1 && j > 1 && x == lower(b[j - 2]) && lower(a[i - 2]) == y) {
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
        }
    }
    return row[b.size()];
}

std::optional<std::string> closest_match(std::string_view name,
                                         std::span<const std::string> candidates) {
    if (name.empty() || name.size() > kMaxNameLength) return std::nullopt;
    std::optional<std::string> best;
    int best_distance = 0;
    for (const std::string& candidate : candidates) {
        if (candidate.size() > kMaxNameLength) continue;
        const int longest = static_cast<int>(std::max(name.size(), candidate.size()));
        const int distance = edit_distance(name, candidate);
        if (distance < longest && distance <= std::max(1, longest / 3) &&
            (!best || distance < best_distance)) {
            best = candidate;
            best_distance = distance;
        }
    }
    return best;
}

std::string did_you_mean(std::string_view name, std::span<const std::string> candidates) {
    const auto match = closest_match(name, candidates);
    return match ? " (did you mean '" + *match + "'?)" : "";
}

}  // namespace nacre
