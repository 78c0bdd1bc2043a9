#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "nacre/paint/recipe_parameter.h"

// What a fit may vary: numbers of a recipe between bounds, as coordinates of the unit cube.

namespace nacre::fit {

/// Bounds for a number whose recipe states none: the plausible error of a colourist's recipe, cut
/// to the range of the key. Reflectances and transmittances, if constant over wavelength: all of
/// [0, 1]. Anisotropy: what the solver resolves. A spread of thickness: from 0 to three times
/// itself or 15 % of the thickness, whichever is more. The binder's index: 10 % either way.
/// Everything else: a third to three times itself.
/// @throws DomainError if the recipe has no such number, or if it is 0 where it must have a size
paint::ParameterBounds default_bounds(const paint::Recipe& recipe, const std::string& key);

/// One number of a recipe that is sought.
struct FreeNumber {
    paint::ParameterBounds bounds;
    double start = 0;
    bool bounds_given = false;  ///< by the recipe's table [fit], not by default_bounds()

    /// The coordinate of a value between the bounds, 0 to 1: in its logarithm if the lower bound is
    /// above 0, since amounts and thicknesses act by their ratios, else in the value. From 0 to far
    /// above the start: in log(1 + value / size), which is linear near 0 and a logarithm beyond, the
    /// size being the start, or where that is 0 a hundredth of the upper bound.
    double to_unit(double value) const;
    double from_unit(double x) const;
    double slope(double x) const;  ///< derivative of from_unit()

 private:
    /// Where log(1 + value / size) is the coordinate; else 0.
    double size() const;
};

/// The fitted value of a free number.
struct FittedParameter {
    FreeNumber number;
    double value = 0;
    std::optional<double> standard_error;  ///< none: not determined (Certainty::standard_error)
    bool at_lower_bound = false, at_upper_bound = false;
};

class FreeNumbers {
 public:
    static constexpr std::size_t kMax = 24;

    /// @param keys    of numbers of the recipe, without repetition
    /// @param bounds  of any numbers, as the recipe's file states them
    /// @throws DomainError if there are no keys, more than kMax, or one twice, and as
    ///         paint::check_bounds() and default_bounds()
    FreeNumbers(const paint::Recipe& start, const std::vector<std::string>& keys,
                const std::vector<paint::ParameterBounds>& bounds);

    std::size_t size() const { return numbers_.size(); }
    const FreeNumber& operator[](std::size_t i) const { return numbers_[i]; }
    const paint::Recipe& start() const { return start_; }

    std::vector<double> start_point() const;
    /// Recipe at a point of the unit cube. Numbers that only make sense together, as R + T <= 1,
    /// may make it invalid.
    paint::Recipe at(std::span<const double> x) const;

 private:
    paint::Recipe start_;
    std::vector<FreeNumber> numbers_;
};

}  // namespace nacre::fit
