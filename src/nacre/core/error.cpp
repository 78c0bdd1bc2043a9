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

}  // namespace nacre
