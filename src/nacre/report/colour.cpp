#include "nacre/report/colour.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/report/plot.h"

namespace nacre::report {

void require_colour(std::string_view colour, const std::string& where) {
    const auto is_digit = [](unsigned char c) { return std::isxdigit(c) != 0; };
    if (colour.size() == 7 && colour[0] == '#' &&
        std::all_of(colour.begin() + 1, colour.end(), is_digit)) {
        return;
    }
    throw DomainError(fmt::format("{}: '{}' is no colour of the form \"#rrggbb\"", where, colour));
}

std::string css_colour(const std::array<double, 3>& srgb) {
    std::string text = "#";
    for (const double component : srgb) {
        // max(0, NaN) is 0.
        const double clipped = std::min(1.0, std::max(0.0, component));
        text += fmt::format("{:02x}", std::lround(255 * clipped));
    }
    return text;
}

}  // namespace nacre::report
