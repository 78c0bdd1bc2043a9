#pragma once

#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

// Errors carry their context: the library throws, the command line prints what() and picks the
// exit status from the type (docs/conventions.md, "Errors"). A std::logic_error is a bug in Nacre.

namespace nacre {

/// Base of every other exception that Nacre throws. Failures while running exit with status 3.
class Error : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// An argument of a public function is outside its valid range. Exit status 2.
class DomainError : public Error {
 public:
    using Error::Error;
};

/// A file, or a text that a user wrote, is wrong: the message names file, line, key, value and
/// the allowed range as far as they exist. Exit status 2.
class InputError : public Error {
 public:
    using Error::Error;
};

/// Throws the DomainError of require_in_range().
[[noreturn]] void throw_out_of_range(double value, double lo, double hi, const char* what);

/// Throws DomainError unless lo <= value <= hi; NaN is refused too.
/// `what` names the quantity and its unit, as in "cos_i" or "wavelength in nm".
inline void require_in_range(double value, double lo, double hi, const char* what) {
    if (!(value >= lo && value <= hi)) throw_out_of_range(value, lo, hi, what);
}

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
    std::string text() const;
};

/// The same of a range with closed ends. `what` names the unit as well.
inline void require_in_range(double value, const Range& range, const char* what) {
    require_in_range(value, range.lo, range.hi, what);
}

/// "; 3 % is 0.03", to append to the message about a value that is out of its range, where a
/// fraction seems to have been written in per cent; else nothing.
/// @param key  of the value: fractions, reflectance and transmittance are called so
std::string percent_hint(std::string_view key, double value, const Range& range);

}  // namespace nacre
