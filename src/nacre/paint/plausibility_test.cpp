#include "nacre/paint/plausibility.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "nacre/testing/paints.h"

namespace nacre::paint {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Titania on mica in 15 um, as sold and sprayed.
Recipe sold_pearl() {
    FlakeSpecies flakes;
    flakes.amount = VolumeFraction{0.03};
    flakes.diameter_um = 18;
    flakes.orientation.beckmann_alpha = 0.15;
    flakes.body = optics::Platelet{.core = {optics::Material(1.58), 450, {}},
                                   .coats = {{optics::Material(2.5), 80, {}}}};
    Recipe recipe = test::paint_of(1.5, {{15, {flakes}, {}}});
    recipe.clearcoat = Clearcoat{.thickness_um = 40};
    return recipe;
}

optics::Platelet& platelet(Recipe& recipe) {
    return std::get<optics::Platelet>(recipe.layers[0].flakes[0].body);
}

TEST(Plausibility, APaintThatIsSoldIsPlausible) {
    EXPECT_THAT(implausible_numbers(sold_pearl()), IsEmpty());
    EXPECT_THAT(implausible_numbers(test::violet()), IsEmpty());
}

TEST(Plausibility, FindsSlipsOfTheUnitAndOfTheDecimalPoint) {
    struct Slip {
        std::function<void(Recipe&)> make;
        const char* finding;
    };
    const Slip slips[] = {
        {[](Recipe& r) { platelet(r).coats[0].thickness_nm = 0.08; },
         "layer[0].flakes[0].coats[0].thickness_nm = 0.08 nm: thinner than 1 nm"},
        {[](Recipe& r) { platelet(r).core.thickness_nm = 0.45; },
         "layer[0].flakes[0].core.thickness_nm = 0.45 nm: thinner than 1 nm"},
        {[](Recipe& r) {
             platelet(r).coats.clear();
             platelet(r).coated_sides = optics::Platelet::CoatedSides::one;
         },
         "layer[0].flakes[0].coated_sides = \"one\": there are no coats"},
        {[](Recipe& r) { r.layers[0].thickness_um = 0.5; },
         "layer[0].flakes[0]: flakes 0.61 um thick do not fit into a layer of 0.5 um"},
        {[](Recipe& r) { r.layers[0].thickness_um = 2; },
         "layer[0].flakes[0]: flakes of 18 um that are tilted as these reach over 2.84 um of "
         "depth"},
        {[](Recipe& r) { r.layers[0].thickness_um = 15000; },
         "layer[0].thickness_um = 15000 um: thicker than 1000 um"},
        {[](Recipe& r) { r.clearcoat->thickness_um = 40000; },
         "clearcoat.thickness_um = 40000 um: thicker than 1000 um"},
        {[](Recipe& r) { r.layers[0].flakes[0].amount = VolumeFraction{0.5}; },
         "layer[0]: 50 % of its volume is flakes and pigments"},
        {[](Recipe& r) { r.layers[0].flakes[0].diameter_um = 1.5; },
         "layer[0].flakes[0].diameter_um = 1.5 um: flakes 0.61 um thick are hardly flat"},
        {[](Recipe& r) { r.layers[0].flakes[0].orientation.beckmann_alpha = 0.01; },
         "layer[0].flakes[0].orientation.alpha = 0.01: half of the flakes' area lies within 0.48 "
         "deg"},
        {[](Recipe& r) { r.layers[0].flakes[0].orientation.beckmann_alpha = 0.5; },
         "layer[0].flakes[0].orientation.alpha = 0.5: half of the flakes' area is tilted by more "
         "than "
         "22.6 deg"}};
    for (const Slip& slip : slips) {
        Recipe recipe = sold_pearl();
        slip.make(recipe);
        EXPECT_THAT(implausible_numbers(recipe), ElementsAre(HasSubstr(slip.finding)));
    }
}

TEST(Plausibility, ASpreadOfACoatWithoutColourIsNotSeen) {
    Recipe recipe = sold_pearl();
    recipe.clearcoat->thickness_spread_um = 5;
    EXPECT_EQ(recipe.coat_spread(), 0);
    EXPECT_THAT(implausible_numbers(recipe),
                ElementsAre(HasSubstr("clearcoat.thickness_spread_um = 5 um: nothing is seen")));
    recipe.clearcoat->absorption_per_mm = spectra::Spectrum({400, 700}, {0.0, 10.0});
    EXPECT_EQ(recipe.coat_spread(), 5 / 40.0);
    EXPECT_THAT(implausible_numbers(recipe), IsEmpty());
}

TEST(Plausibility, PigmentsCountAmongTheSolids) {
    Recipe recipe = sold_pearl();
    recipe.layers[0].pigments = {{PigmentCoefficients{.amount = PigmentVolume{0.38}}, "white"}};
    EXPECT_THAT(implausible_numbers(recipe), ElementsAre(HasSubstr("41 % of its volume")));
}

TEST(Plausibility, FilmsOfFacetsHaveTheSameBound) {
    Recipe recipe;
    recipe.microfacet = Microfacet{.film_ior = 1.8, .film_thickness_nm = 0.158};
    EXPECT_THAT(implausible_numbers(recipe),
                ElementsAre(HasSubstr("microfacet.film_thickness_nm = 0.158 nm")));
    recipe.microfacet->film_thickness_nm = 0;  // no film
    EXPECT_THAT(implausible_numbers(recipe), IsEmpty());
}

}  // namespace
}  // namespace nacre::paint
