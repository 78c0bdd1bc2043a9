#include "nacre/paint/parameter_deviation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/paint/recipe_parameter.h"

namespace nacre::paint {

ParameterDeviation parse_deviation(const std::string& key, std::string_view text) {
    std::string_view number = trimmed(text);
    const bool relative = number.ends_with('%');
    if (relative) number.remove_suffix(1);
    const auto amount = parse_number(number);
    if (!amount) {
        throw DomainError(fmt::format(
            "{} = {}: must be a standard deviation, a number in the unit of what it is about or a "
            "percentage as in 5 %",
            key, excerpt(text)));
    }
    return {key, relative ? *amount / 100 : *amount, relative};
}

std::string deviation_text(const ParameterDeviation& deviation) {
    if (!deviation.relative) return fmt::format("{}", deviation.amount);
    // 0.07 * 100 is 7.000000000000001: the shortest text that reads back to the same fraction.
    for (int digits = 1; digits <= 17; ++digits) {
        const double percent =
            *parse_number(fmt::format("{:.{}g}", 100 * deviation.amount, digits));
        if (percent / 100 == deviation.amount) return fmt::format("{} %", percent);
    }
    return fmt::format("{} %", 100 * deviation.amount);
}

double standard_deviation(const Recipe& recipe, const ParameterDeviation& deviation) {
    check_deviation(recipe, deviation);
    if (!deviation.relative) return deviation.amount;
    return deviation.amount * std::abs(find_parameter(recipe, deviation.key).value);
}

void check_deviation(const Recipe& recipe, const ParameterDeviation& deviation) {
    const RecipeParameter parameter = find_parameter(recipe, deviation.key);
    const std::string what = deviation.key + " = " + deviation_text(deviation);
    if (!deviation.relative) {
        const Range allowed{0, parameter.range.hi - parameter.range.lo, parameter.range.unit};
        if (!allowed.contains(deviation.amount)) {
            throw DomainError(
                fmt::format("{}: a standard deviation must be in {}, or a percentage "
                            "as in \"5 %\"",
                            what, allowed.text()));
        }
        return;
    }
    if (!Range{0, 1}.contains(deviation.amount)) {
        throw DomainError(
            fmt::format("{}: a relative standard deviation must be in [0 %, 100 %]", what));
    }
    if (parameter.value == 0) {
        throw DomainError(fmt::format(
            "{}: the recipe's own number is 0, of which there is no percentage; give the standard "
            "deviation as a number in {}",
            what, Range{0, parameter.range.hi - parameter.range.lo, parameter.range.unit}.text()));
    }
}

std::vector<ParameterDeviation> with_deviations(std::vector<ParameterDeviation> deviations,
                                                const std::vector<ParameterDeviation>& changes) {
    for (const ParameterDeviation& change : changes) {
        const auto found = std::find_if(deviations.begin(), deviations.end(),
                                        [&](const auto& d) { return d.key == change.key; });
        if (found == deviations.end()) {
            deviations.push_back(change);
        } else {
            *found = change;
        }
    }
    return deviations;
}

}  // namespace nacre::paint
