#include "nacre/core/error.h"

#include <fmt/format.h>

namespace nacre {

void throw_out_of_range(double value, double lo, double hi, const char* what) {
    throw DomainError(fmt::format("{} = {} is outside [{}, {}]", what, value, lo, hi));
}

std::string Range::text() const {
    return fmt::format("{}{}, {}{}{}{}", lo_open ? '(' : '[', lo, hi, hi_open ? ')' : ']',
                       *unit ? " " : "", unit);
}

std::string percent_hint(std::string_view key, double value, const Range& range) {
    bool fraction = false;
    for (const std::string_view word : {"fraction", "reflectance", "transmittance"}) {
        fraction = fraction || key.find(word) != std::string_view::npos;
    }
    if (!fraction || !(range.lo >= 0 && range.hi <= 1 && value > 1 && value <= 100)) return {};
    return fmt::format("; {} % is {:.6g}", value, value / 100);
}

}  // namespace nacre
