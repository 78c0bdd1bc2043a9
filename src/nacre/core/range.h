#pragma once

#include <fmt/format.h>

#include <limits>
#include <string>

namespace nacre {

/// The numbers a quantity may take: an interval with open or closed ends, and its unit for
/// messages. A bound stands once, and readers, validators and error messages share it.
struct Range {
    double lo = -std::numeric_limits<double>::infinity();
    double hi = std::numeric_limits<double>::infinity();
    const char* unit = "";
    bool lo_open = false, hi_open = false;

    /// False for NaN.
    constexpr bool contains(double x) const {
        return (lo_open ? x > lo : x >= lo) && (hi_open ? x < hi : x <= hi);
    }
    /// As in "(0, 1000] um".
    std::string text() const {
        return fmt::format("{}{}, {}{}{}{}", lo_open ? '(' : '[', lo, hi, hi_open ? ')' : ']',
                           *unit ? " " : "", unit);
    }
};

}  // namespace nacre
