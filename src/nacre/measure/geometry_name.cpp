#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "nacre/core/error.h"
#include "nacre/measure/geometry.h"
#include "nacre/optics/number_text.h"

// Names of geometries, as instruments and their exporters write them.

namespace nacre::measure {

namespace {

/// Takes words and numbers off the front of a text.
class Words {
 public:
    explicit Words(std::string_view text) : rest_(text) {}

    bool take(std::string_view word) {
        if (rest_.size() < word.size()) return false;
        for (std::size_t i = 0; i < word.size(); ++i) {
            const char c = rest_[i] >= 'A' && rest_[i] <= 'Z' ? rest_[i] - 'A' + 'a' : rest_[i];
            if (c != word[i]) return false;
        }
        rest_.remove_prefix(word.size());
        return true;
    }
    std::optional<double> take_number() {
        const double sign = take("minus") ? -1 : 1;
        double value = 0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return sign * value;
    }
    bool at_end() const { return rest_.empty(); }

 private:
    std::string_view rest_;
};

std::optional<Geometry> parsed(Words words) {
    words.take("r");
    const auto lamp = words.take_number();
    if (!lamp) return std::nullopt;
    if (words.take("as")) {
        const auto aspecular = words.take_number();
        if (!aspecular) return std::nullopt;
        if (words.at_end()) return in_plane(*lamp, *aspecular);
        if (!words.take("az")) return std::nullopt;
        const auto azimuth = words.take_number();
        if (!azimuth || !words.at_end()) return std::nullopt;
        return off_plane(*lamp, *aspecular, *azimuth);
    }
    if (!words.take("to")) return std::nullopt;
    const auto theta = words.take_number();
    if (!theta || !words.take(",")) return std::nullopt;
    const auto phi = words.take_number();
    if (!phi || !words.at_end()) return std::nullopt;
    return towards(*lamp, *theta, *phi);
}

}  // namespace

Geometry parse_geometry(std::string_view name) {
    if (const auto geometry = parsed(Words(name))) return *geometry;
    throw DomainError(fmt::format(
        "'{}' is no geometry; one is written 45as15 or 45as-15 (lamp and aspecular angle), "
        "45as25az90 (turned about the mirror direction) or 45to30,90 (theta and phi of the view)",
        optics::excerpt(name)));
}

}  // namespace nacre::measure
