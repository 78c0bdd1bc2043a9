#include "nacre/paint/recipe_parameter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "nacre/core/error.h"
#include "nacre/paint/recipe.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/paints.h"

namespace nacre::paint {
namespace {

using nacre::test::message_of;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

using nacre::test::full_recipe;

std::vector<std::string> keys(const Recipe& recipe) {
    std::vector<std::string> keys;
    for (const RecipeParameter& parameter : recipe_parameters(recipe))
        keys.push_back(parameter.key);
    return keys;
}

TEST(RecipeParameter, EveryNumberOfARecipeIsListedInItsOrder) {
    EXPECT_THAT(
        keys(full_recipe()),
        ElementsAre(
            "ior", "lean.tilt_deg", "lean.azimuth_deg", "clearcoat.thickness_um",
            "clearcoat.thickness_spread_um", "clearcoat.absorption_per_mm.max",
            "clearcoat.roughness", "clearcoat.orange_peel.wa", "clearcoat.orange_peel.wb",
            "clearcoat.orange_peel.wc", "clearcoat.orange_peel.wd", "clearcoat.orange_peel.we",
            "layer[0].thickness_um", "layer[0].flakes[0].volume_fraction",
            "layer[0].flakes[0].diameter_um", "layer[0].flakes[0].diameter_spread_um",
            "layer[0].flakes[0].orientation.alpha", "layer[0].flakes[0].core.thickness_nm",
            "layer[0].flakes[0].core.spread_nm", "layer[0].flakes[0].coats[0].thickness_nm",
            "layer[0].flakes[0].coats[0].spread_nm", "layer[0].flakes[1].area_density_per_um",
            "layer[0].flakes[1].diameter_um", "layer[0].flakes[1].diameter_spread_um",
            "layer[0].flakes[1].edge_um", "layer[0].flakes[1].waviness",
            "layer[0].flakes[1].orientation.alpha", "layer[0].flakes[1].orientation.alpha_bottom",
            "layer[0].flakes[1].reflectance", "layer[0].flakes[1].transmittance",
            "layer[0].flakes[1].thickness_um", "layer[0].pigment[0].scattering_per_mm",
            "layer[0].pigment[0].absorption_per_mm", "layer[0].pigment[0].anisotropy",
            "layer[0].pigment[1].volume_fraction", "layer[0].pigment[1].diameter_nm",
            "layer[0].pigment[1].spread", "layer[0].pigment[2].mass_fraction",
            "layer[0].pigment[2].density_g_per_cm3", "layer[0].pigment[2].binder_density_g_per_cm3",
            "layer[0].pigment[2].diameter_nm", "layer[0].pigment[2].spread",
            "layer[0].pigment[3].scattering_per_mm", "layer[0].pigment[3].absorption_per_mm",
            "layer[0].pigment[3].anisotropy", "layer[0].pigment[3].volume_fraction",
            "layer[0].pigment[4].kubelka_munk.K", "layer[0].pigment[4].kubelka_munk.S",
            "layer[0].pigment[4].anisotropy", "layer[0].pigment[4].mass_fraction",
            "layer[0].pigment[4].density_g_per_cm3", "layer[0].pigment[4].binder_density_g_per_cm3",
            "layer[1].thickness_um", "substrate.reflectance", "microfacet.alpha",
            "microfacet.film_ior", "microfacet.film_thickness_nm", "microfacet.base_ior",
            "microfacet.base_extinction", "microfacet.facets.count", "microfacet.facets.cone_deg",
            "microfacet.facets.thickness_spread_nm"));
}

// A number that was set is read back, no other number changes, and a value out of range is refused
// under the same key: keys, values and ranges are those of validate().
TEST(RecipeParameter, SettingOneNumberChangesThatNumberAlone) {
    const Recipe recipe = full_recipe();
    const std::vector<RecipeParameter> before = recipe_parameters(recipe);
    ASSERT_THAT(before, Not(SizeIs(0)));
    for (const RecipeParameter& parameter : before) {
        Recipe changed = recipe;
        // Less by a tenth, or where that is too little (an index of 1 cannot fall) more.
        double value = parameter.value > 0 ? 0.9 * parameter.value : 0.125;
        if (!parameter.range.contains(value)) value = 1.1 * parameter.value;
        ASSERT_TRUE(parameter.range.contains(value)) << parameter.key;
        set_parameter(changed, parameter.key, value);
        EXPECT_EQ(find_parameter(changed, parameter.key).value, value) << parameter.key;
        set_parameter(changed, parameter.key, parameter.value);
        for (const RecipeParameter& other : before) {
            EXPECT_EQ(find_parameter(changed, other.key).value, other.value)
                << parameter.key << " moved " << other.key;
        }
        const auto refused = [&, key = parameter.key] {
            Recipe copy = recipe;
            set_parameter(copy, key, parameter.range.lo - 1);
        };
        EXPECT_THAT(message_of<DomainError>(refused), HasSubstr(parameter.key + " = "))
            << parameter.key;
    }
}

TEST(RecipeParameter, TheLargestSampleOfASpectrumScalesAllOfIt) {
    Recipe recipe = full_recipe();
    set_parameter(recipe, "clearcoat.absorption_per_mm.max", 2.0);
    EXPECT_THAT(recipe.clearcoat->absorption_per_mm.values(), ElementsAre(0.5, 2.0));
    // At zero the shape of the spectrum would be lost; a spectrum that is zero has none.
    EXPECT_THROW(set_parameter(recipe, "clearcoat.absorption_per_mm.max", 0.0), DomainError);
    recipe.clearcoat->absorption_per_mm = spectra::Spectrum({400, 700}, {0.0, 0.0});
    EXPECT_THAT(keys(recipe), Not(Contains("clearcoat.absorption_per_mm.max")));
}

TEST(RecipeParameter, WhatARecipeLacksIsNotListed) {
    Recipe recipe = full_recipe();
    recipe.clearcoat->roughness = 0;  // smooth: 0 is outside the range of roughness
    recipe.binder = optics::Material("resin", std::vector<double>{400, 700},
                                     std::vector<optics::ComplexIndex>{1.52, 1.49});
    EXPECT_THAT(keys(recipe), Not(Contains("clearcoat.roughness")));
    EXPECT_THAT(keys(recipe), Not(Contains("ior")));
    recipe.clearcoat.reset();
    EXPECT_THAT(keys(recipe), Not(Contains(HasSubstr("clearcoat"))));
}

TEST(RecipeParameter, AnUnknownKeyIsRefusedWithTheNearestOne) {
    EXPECT_EQ(
        message_of<DomainError>([] { find_parameter(full_recipe(), "layer[0].thickness_nm"); }),
        "layer[0].thickness_nm: is not a number of this recipe (did you mean "
        "'layer[0].thickness_um'?)");
    EXPECT_THAT(message_of<DomainError>([] { find_parameter(full_recipe(), "x"); }),
                HasSubstr("its numbers are ior, lean.tilt_deg, lean.azimuth_deg, "));
}

TEST(RecipeParameter, APatternMeansEndsOfKeysAndStarsAnyText) {
    const Recipe recipe = full_recipe();
    EXPECT_THAT(matching_parameters(recipe, "coats[0].thickness_nm"),
                ElementsAre("layer[0].flakes[0].coats[0].thickness_nm"));
    EXPECT_THAT(matching_parameters(recipe, "microfacet.alpha"), ElementsAre("microfacet.alpha"));
    EXPECT_THAT(
        matching_parameters(recipe, "orientation.*"),
        ElementsAre("layer[0].flakes[0].orientation.alpha", "layer[0].flakes[1].orientation.alpha",
                    "layer[0].flakes[1].orientation.alpha_bottom"));
    EXPECT_THAT(
        matching_parameters(recipe, "flakes[0]*spread_nm"),
        ElementsAre("layer[0].flakes[0].core.spread_nm", "layer[0].flakes[0].coats[0].spread_nm"));
    EXPECT_EQ(matching_parameters(recipe, "*"), keys(recipe));
    EXPECT_THAT(message_of<DomainError>([&] { matching_parameters(recipe, "orientation.alpha"); }),
                HasSubstr("may mean layer[0].flakes[0].orientation.alpha, "
                          "layer[0].flakes[1].orientation.alpha; write more"));
    // The end of a word is not the end of a key.
    EXPECT_THAT(message_of<DomainError>([&] { matching_parameters(recipe, "ness_nm"); }),
                HasSubstr("is not a number"));
    EXPECT_THAT(message_of<DomainError>([&] { matching_parameters(recipe, ""); }),
                HasSubstr("is not a number"));
    // Backtracking at every star would take time exponential in their number.
    EXPECT_THAT(message_of<DomainError>(
                    [&] { matching_parameters(recipe, "*e*e*e*e*e*e*e*e*e*e*e*e*e*e*?"); }),
                HasSubstr("is not a number"));
}

TEST(RecipeParameter, BoundsAreCheckedAgainstTheNumber) {
    const Recipe recipe = full_recipe();
    const std::string key = "layer[0].flakes[0].volume_fraction";
    EXPECT_NO_THROW(check_bounds(recipe, {key, 0.01, 0.2}));
    EXPECT_EQ(message_of<DomainError>([&] {
                  check_bounds(recipe, {key, 0, 0.2});
              }),
              key + " = [0, 0.2]: both ends must be in (0, 1]");
    EXPECT_EQ(message_of<DomainError>([&] {
                  check_bounds(recipe, {key, 0.2, 0.1});
              }),
              key + " = [0.2, 0.1]: the first end must be below the second");
    EXPECT_EQ(message_of<DomainError>([&] {
                  check_bounds(recipe, {key, 0.1, 0.2});
              }),
              key + " = [0.1, 0.2]: the recipe's own 0.05 is not between them");
    EXPECT_THAT(message_of<DomainError>([&] {
                    check_bounds(recipe, {key, 0.01, 0.0 / 0.0});
                }),
                HasSubstr("both ends must be in"));
    EXPECT_THAT(message_of<DomainError>([&] {
                    check_bounds(recipe, {"layer[9].thickness_um", 1, 2});
                }),
                HasSubstr("is not a number of this recipe"));
}

}  // namespace
}  // namespace nacre::paint
