#include "nacre/fit/free_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"

namespace nacre::fit {

namespace {

constexpr double kFactor = 3;            // of a number with a size, either way
constexpr double kIndexFactor = 1.1;     // of a refractive index
constexpr double kSpreadOfFilm = 0.15;   // of its thickness
constexpr double kMaxAnisotropy = 0.95;  // within what the solver takes (solver/resolution.cpp)
constexpr double kFarAbove = 10;         // of an upper bound over the start, the lower one being 0
constexpr double kSizeOfNothing = 0.01;  // of a start of 0, over the upper bound

bool ends_with(const std::string& key, std::string_view end) { return key.ends_with(end); }

paint::ParameterBounds spread_bounds(const paint::Recipe& recipe,
                                     const paint::RecipeParameter& spread) {
    double upper = kFactor * spread.value;
    const std::string film = spread.key.substr(0, spread.key.rfind('.') + 1);
    for (const paint::RecipeParameter& other : paint::recipe_parameters(recipe)) {
        if (other.key == film + "thickness_nm")
            upper = std::max(upper, kSpreadOfFilm * other.value);
    }
    return {spread.key, 0, std::min(upper, spread.range.hi)};
}

}  // namespace

paint::ParameterBounds default_bounds(const paint::Recipe& recipe, const std::string& key) {
    const paint::RecipeParameter parameter = paint::find_parameter(recipe, key);
    const Range& range = parameter.range;
    if (ends_with(key, ".spread_nm")) return spread_bounds(recipe, parameter);
    if (ends_with(key, ".anisotropy")) return {key, -kMaxAnisotropy, kMaxAnisotropy};
    if (range.lo == 0 && range.hi == 1 && !range.lo_open) return {key, 0, 1};
    if (parameter.value == 0) {
        throw DomainError(fmt::format(
            "{} = 0: has no size from which to guess where to seek it; bound it in the recipe's "
            "table [fit], as in \"{}\" = [0, 1]",
            key, key));
    }
    const double factor = key == "ior" ? kIndexFactor : kFactor;
    double lo = std::max(range.lo, parameter.value / factor);
    if (key == "clearcoat.thickness_um") {
        // Below, the stated spread over the panel would be more than a coat can have.
        const double spread_um = recipe.clearcoat->thickness_spread_um;
        lo = std::max(lo, std::min(spread_um / paint::limits::kMaxCoatSpread, parameter.value));
    }
    return {key, lo, std::min(range.hi, parameter.value * factor)};
}

double FreeNumber::size() const {
    const auto [key, lo, hi] = bounds;
    const double size = start > 0 ? start : kSizeOfNothing * hi;
    return lo == 0 && hi > kFarAbove * size ? size : 0;
}

double FreeNumber::to_unit(double value) const {
    const auto [key, lo, hi] = bounds;
    const double s = size();
    const double x = lo > 0  ? std::log(value / lo) / std::log(hi / lo)
                     : s > 0 ? std::log1p(value / s) / std::log1p(hi / s)
                             : (value - lo) / (hi - lo);
    return std::clamp(x, 0.0, 1.0);
}

double FreeNumber::from_unit(double x) const {
    const auto [key, lo, hi] = bounds;
    // The ends to the last bit, so that a number at its bound is not beyond it.
    if (x <= 0) return lo;
    if (x >= 1) return hi;
    const double s = size();
    const double value = lo > 0  ? lo * std::pow(hi / lo, x)
                         : s > 0 ? s * std::expm1(x * std::log1p(hi / s))
                                 : lo + x * (hi - lo);
    return std::clamp(value, lo, hi);
}

double FreeNumber::slope(double x) const {
    const auto [key, lo, hi] = bounds;
    if (lo > 0) return from_unit(x) * std::log(hi / lo);
    const double s = size();
    return s > 0 ? (from_unit(x) + s) * std::log1p(hi / s) : hi - lo;
}

FreeNumbers::FreeNumbers(const paint::Recipe& start, const std::vector<std::string>& keys,
                         const std::vector<paint::ParameterBounds>& bounds)
    : start_(start) {
    if (keys.empty()) throw DomainError("no number of the recipe is free: there is nothing to fit");
    if (keys.size() > kMax) {
        throw DomainError(
            fmt::format("{} numbers are free; at most {} can be fitted", keys.size(), kMax));
    }
    for (const std::string& key : keys) {
        const auto given =
            std::find_if(bounds.begin(), bounds.end(), [&](const auto& b) { return b.key == key; });
        FreeNumber number;
        number.bounds_given = given != bounds.end();
        number.bounds = number.bounds_given ? *given : default_bounds(start, key);
        paint::check_bounds(start, number.bounds);
        number.start = paint::find_parameter(start, key).value;
        for (const FreeNumber& other : numbers_) {
            if (other.bounds.key == key) {
                throw DomainError(fmt::format("{}: is named twice among the free numbers", key));
            }
        }
        numbers_.push_back(number);
    }
}

std::vector<double> FreeNumbers::start_point() const {
    std::vector<double> x;
    for (const FreeNumber& number : numbers_) x.push_back(number.to_unit(number.start));
    return x;
}

paint::Recipe FreeNumbers::at(std::span<const double> x) const {
    paint::Recipe recipe = start_;
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
        paint::set_parameter(recipe, numbers_[i].bounds.key, numbers_[i].from_unit(x[i]));
    }
    return recipe;
}

}  // namespace nacre::fit
