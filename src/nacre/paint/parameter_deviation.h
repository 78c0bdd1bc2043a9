#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nacre/paint/recipe.h"

// How well the numbers of a recipe are known: the table [uncertainty] of its file.

namespace nacre::paint {

/// How well one number of a recipe (paint/recipe_parameter.h) is known: the standard deviation of a
/// normal law about the recipe's own value, as somebody stated it.
struct ParameterDeviation {
    std::string key;
    double amount = 0;      ///< in the number's own unit, or a fraction of the number
    bool relative = false;  ///< which of these: 0.05 is then 5 %

    friend bool operator==(const ParameterDeviation&, const ParameterDeviation&) = default;
};

/// "0.002", in the number's own unit, or "5 %" of the number.
/// @throws DomainError naming key and text if it is neither; check_deviation() checks the rest
ParameterDeviation parse_deviation(const std::string& key, std::string_view text);

/// The same as text that parse_deviation() reads back.
std::string deviation_text(const ParameterDeviation& deviation);

/// The standard deviation in the number's own unit.
/// @throws DomainError as check_deviation()
double standard_deviation(const Recipe& recipe, const ParameterDeviation& deviation);

/// @throws DomainError if the recipe has no such number, the deviation is negative, above 100 % or
///         above the width of the number's range, or relative where the number is 0; the message
///         starts with the key
void check_deviation(const Recipe& recipe, const ParameterDeviation& deviation);

/// Each of `changes` in the place of the one with its key, or else at the end.
std::vector<ParameterDeviation> with_deviations(std::vector<ParameterDeviation> deviations,
                                                const std::vector<ParameterDeviation>& changes);

}  // namespace nacre::paint
