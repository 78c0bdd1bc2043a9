#include "nacre/fit/effect.h"

#include <vector>

#include "nacre/core/error.h"

namespace nacre::fit {

namespace {

const std::vector<double> kProbe_nm = {450, 550, 650};

/// Diameters and their spreads, which the hot spot depends on.
std::vector<double> flake_sizes(const paint::Recipe& recipe) {
    std::vector<double> sizes;
    for (const paint::Layer& layer : recipe.layers) {
        for (const paint::FlakeSpecies& flake : layer.flakes) {
            sizes.push_back(flake.diameter_um);
            sizes.push_back(flake.diameter_spread_um);
            if (flake.quantiles) {
                const auto& [d10, d50, d90] = paint::quantiles_of(*flake.quantiles);
                sizes.insert(sizes.end(), {d10, d50, d90});
            }
        }
    }
    return sizes;
}

}  // namespace

EffectOnColours::EffectOnColours(const paint::Recipe& recipe, bool hot_spot, SharedProgress& work)
    : recipe_(recipe),
      hot_spot_(hot_spot),
      work_(work),
      medium_(solver::make_medium(recipe, kProbe_nm, nullptr, &work)) {}

bool EffectOnColours::of(const FreeNumber& number) const {
    const double here = number.to_unit(number.start);
    try {
        paint::Recipe recipe = recipe_;
        paint::set_parameter(recipe, number.bounds.key,
                             number.from_unit(here > 0.5 ? here - 0.25 : here + 0.25));
        if (!(solver::make_medium(recipe, kProbe_nm, nullptr, &work_) == medium_)) return true;
        return hot_spot_ && flake_sizes(recipe) != flake_sizes(recipe_);
    } catch (const DomainError&) {
        return true;  // invalid with the other numbers as they are: it may have an effect
    }
}

}  // namespace nacre::fit
