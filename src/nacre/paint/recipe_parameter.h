#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/paint/recipe.h"

// The numbers of a recipe by key, for fits, sweeps and sliders.
//
// A number is named by its path in a recipe file, entries of lists counted from 0, as error
// messages spell it: "layer[0].flakes[0].coats[0].thickness_nm". A spectrum that varies with the
// wavelength is one number too, its largest sample: "clearcoat.absorption_per_mm.max". Setting it
// scales all samples, so that the amount of a dye varies and the shape of its spectrum stays. What
// a recipe states as a material (of a film, or of the binder if it is not a plain number) is not a
// number; nor is the roughness of a smooth interface, a spectrum that is zero everywhere although
// it has samples, and what a recipe does not have.

namespace nacre::paint {

struct RecipeParameter {
    std::string key;
    double value = 0;
    Range range;  ///< what the key may be, other keys apart
};

/// All numbers of a recipe in the order of docs/recipe.md.
std::vector<RecipeParameter> recipe_parameters(const Recipe& recipe);

/// @throws DomainError if the recipe has no such number; the message suggests one that it has
RecipeParameter find_parameter(const Recipe& recipe, std::string_view key);

/// Changes one number. What concerns several numbers at once, as R + T <= 1, is left to
/// validate().
/// @throws DomainError as find_parameter(), or naming key, value and range
void set_parameter(Recipe& recipe, std::string_view key, double value);

/// The keys that match a pattern, in the order of recipe_parameters(): a whole key, or its end from
/// a dot or the beginning on ("coats[0].thickness_nm", "alpha"), in which `*` stands for any text,
/// even none.
/// @throws DomainError if there is none, or if the pattern is without `*` and several keys end so
std::vector<std::string> matching_parameters(const Recipe& recipe, std::string_view pattern);

/// The same among any keys; none where none matches.
/// @throws DomainError if the pattern is without `*` and several keys end so
std::vector<std::string> matching_keys(const std::vector<std::string>& keys,
                                       std::string_view pattern);

/// The shortest pattern that means this number of the recipe alone.
std::string shortest_pattern(const Recipe& recipe, const std::string& key);

/// The interval in which a fit varies a number.
struct ParameterBounds {
    std::string key;
    double lo = 0, hi = 0;

    friend bool operator==(const ParameterBounds&, const ParameterBounds&) = default;
};

/// @throws DomainError if the recipe has no such number, lo < hi does not hold, an end is outside
///         the number's own range, or the recipe's number is not between them; the message starts
///         with the key
void check_bounds(const Recipe& recipe, const ParameterBounds& bounds);

}  // namespace nacre::paint
