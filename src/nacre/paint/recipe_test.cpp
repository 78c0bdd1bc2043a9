#include "nacre/paint/recipe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "nacre/core/error.h"
#include "nacre/testing/errors.h"

namespace nacre::paint {
namespace {

using nacre::test::message_of;
using ::testing::HasSubstr;

FlakeSpecies mica_coated_with_titania() {
    optics::Platelet platelet;
    platelet.core = {optics::Material(1.58), 500, {60}};
    platelet.coats = {{optics::Material(2.5), 80, {5}}};
    FlakeSpecies species;
    species.amount = VolumeFraction{0.0396};
    species.body = platelet;
    return species;
}

Recipe pearl() {
    Recipe recipe;
    recipe.clearcoat = Clearcoat{45, 0.0, 0.0};
    recipe.layers = {
        Layer{15, {mica_coated_with_titania()}, {Pigment{PigmentCoefficients{200.0, 50.0, 0.0}}}}};
    recipe.substrate_reflectance = 0.05;
    return recipe;
}

TEST(PigmentMass, BecomesVolumeByTheDensities) {
    // 42 g of 4.2 g/cm^3 and 55 g of 1.1 g/cm^3: 10 and 50 cm^3.
    EXPECT_DOUBLE_EQ(volume_fraction(PigmentMass{42.0 / 97, 4.2, 1.1}), 10.0 / 60);
    EXPECT_EQ(volume_fraction(PigmentVolume{0.2}), 0.2);
}

TEST(FlakeSpecies, ThicknessIsCorePlusBothSidesOfEachCoat) {
    EXPECT_DOUBLE_EQ(mica_coated_with_titania().thickness_um(), 0.660);
}

// A uniform law of 100 nm and a deviation of 100 nm is cut at zero: it reaches up to 273 nm.
TEST(FlakeSpecies, ThicknessIsTheMeanOfWhatZeroLeavesOfALaw) {
    FlakeSpecies species = mica_coated_with_titania();
    optics::Platelet platelet;
    platelet.core = {
        optics::find_material("Al"), 100, {100, optics::ThicknessSpread::Law::uniform}};
    species.body = platelet;
    EXPECT_NEAR(species.thickness_um(), 0.5e-3 * (100 + 100 * std::sqrt(3)), 1e-12);
}

TEST(FlakeSpecies, AreaDensityIsVolumeFractionOverThickness) {
    EXPECT_DOUBLE_EQ(mica_coated_with_titania().area_density_per_um(), 0.0396 / 0.660);
    FlakeSpecies species = mica_coated_with_titania();
    species.amount = AreaDensity{0.1};
    EXPECT_DOUBLE_EQ(species.area_density_per_um(), 0.1);
}

TEST(Recipe, ThicknessIsThatOfClearcoatAndLayers) {
    Recipe recipe = pearl();
    recipe.layers.push_back(Layer{8, {}, {}});
    EXPECT_EQ(recipe.thickness_um(), 45 + 15 + 8);
    recipe.clearcoat.reset();
    EXPECT_EQ(recipe.thickness_um(), 15 + 8);
}

TEST(ValidateRecipe, AcceptsAPaintAtTheEdgesOfItsRanges) {
    EXPECT_NO_THROW(validate(pearl(), {400, 700}));
    Recipe recipe = pearl();
    recipe.binder = optics::Material(1.0);
    recipe.layers[0].flakes[0].body = PrescribedFlake{0.4, 0.6, 0.3};
    recipe.layers[0].flakes[0].amount = VolumeFraction{1.0};
    recipe.substrate_reflectance = 1.0;
    EXPECT_NO_THROW(validate(recipe, {}));
}

struct BrokenRecipe {
    std::function<void(Recipe&)> break_it;
    const char* key;
    const char* allowed;
};

TEST(ValidateRecipe, NamesKeyValueAndRangeOfWhateverIsWrong) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto flakes = [](Recipe& r) -> FlakeSpecies& { return r.layers[0].flakes[0]; };
    const std::vector<BrokenRecipe> cases = {
        {[](Recipe& r) { r.binder = optics::Material(0.9); }, "ior = 0.9", "[1, 3]"},
        {[](Recipe& r) { r.binder = optics::Material(optics::ComplexIndex(1.5, 0.1)); }, "ior",
         "real"},
        {[](Recipe& r) { r.layers.clear(); }, "layer", "at least one layer"},
        {[](Recipe& r) { r.layers.assign(65, r.layers[0]); }, "layer", "at most 64"},
        {[](Recipe& r) { r.layers[0].thickness_um = 0; }, "layer[0].thickness_um = 0",
         "(0, 1000000] um"},
        {[&](Recipe& r) { r.layers[0].thickness_um = nan; }, "layer[0].thickness_um = nan", "um"},
        {[](Recipe& r) { r.clearcoat->thickness_um = -1; }, "clearcoat.thickness_um = -1", "um"},
        {[](Recipe& r) { r.clearcoat->roughness = 2; }, "clearcoat.roughness = 2",
         "0, a smooth interface, or a number in [0.01, 1]"},
        {[](Recipe& r) { r.clearcoat->roughness = 1e-3; }, "clearcoat.roughness = 0.001",
         "[0.01, 1]"},
        {[](Recipe& r) { r.substrate_reflectance = 1.1; }, "substrate.reflectance = 1.1", "[0, 1]"},
        {[](Recipe& r) {
             std::get<PigmentCoefficients>(r.layers[0].pigments[0].body).anisotropy = 1;
         },
         "layer[0].pigment[0].anisotropy = 1", "(-1, 1)"},
        {[](Recipe& r) {
             std::get<paint::PigmentCoefficients>(r.layers[0].pigments[0].body).scattering_per_mm =
                 -1.0;
         },
         "layer[0].pigment[0].scattering_per_mm = -1", "1/mm"},
        {[](Recipe& r) {
             r.layers[0].pigments[0].body = PigmentParticles{PigmentVolume{0.6}, {}};
         },
         "layer[0].pigment[0].volume_fraction = 0.6", "(0, 0.5]"},
        {[](Recipe& r) {
             r.layers[0].pigments.assign(
                 2, Pigment{PigmentParticles{PigmentVolume{0.3}, optics::Spheres{2.75, 250}}});
         },
         "layer[0].pigment[1].volume_fraction = 0.3: with the pigments before it", "at most 0.5"},
        {[](Recipe& r) {
             r.layers[0].pigments[0].body =
                 PigmentParticles{PigmentMass{0.9, 4.2}, optics::Spheres{2.75, 250}};
         },
         "layer[0].pigment[0].mass_fraction = 0.9: with these densities", "at most 0.5"},
        {[](Recipe& r) {
             r.layers[0].pigments[0].body =
                 PigmentParticles{PigmentVolume{0.1}, optics::Spheres{2.75, 0.5}};
         },
         "layer[0].pigment[0].diameter_nm = 0.5", "[1, 10000] nm"},
        {[](Recipe& r) {
             r.layers[0].pigments[0].body = PigmentParticles{
                 PigmentVolume{0.1}, optics::Spheres{optics::find_material("ZnO"), 250}};
         },
         "layer[0].pigment[0].material = ZnO", "[450, 780] nm"},
        {[&](Recipe& r) { flakes(r).amount = VolumeFraction{1.5}; },
         "layer[0].flakes[0].volume_fraction = 1.5", "(0, 1]"},
        {[&](Recipe& r) { flakes(r).amount = AreaDensity{0}; },
         "layer[0].flakes[0].area_density_per_um = 0", "1/um"},
        {[&](Recipe& r) {
             flakes(r).amount = VolumeFraction{0.6};
             r.layers[0].flakes.push_back(flakes(r));
         },
         "layer[0].flakes[1].volume_fraction = 0.6", "at most 1"},
        {[&](Recipe& r) { flakes(r).orientation.beckmann_alpha = 0; },
         "layer[0].flakes[0].orientation.alpha = 0", "[0.005, 1]"},
        {[&](Recipe& r) {
             flakes(r).body = PrescribedFlake{0.7, 0.4, 0.3};
         },
         "layer[0].flakes[0].transmittance = 0.4", "at most 1"},
        {[&](Recipe& r) { std::get<optics::Platelet>(flakes(r).body).core.thickness_nm = 0; },
         "layer[0].flakes[0].core.thickness_nm = 0", "nm"},
        {[&](Recipe& r) {
             std::get<optics::Platelet>(flakes(r).body).coats[0].spread.standard_deviation_nm = -1;
         },
         "layer[0].flakes[0].coats[0].spread_nm = -1", "nm"},
        {[&](Recipe& r) { flakes(r).diameter_um = 0.0005; },
         "layer[0].flakes[0].diameter_um = 0.0005", "[0.001, 10000] um"},
        {[&](Recipe& r) {
             flakes(r).diameter_um = 18;
             flakes(r).diameter_spread_um = 19;
         },
         "layer[0].flakes[0].diameter_spread_um = 19", "at most diameter_um = 18"},
        {[&](Recipe& r) {
             flakes(r).quantiles = DiameterQuantiles{0.01, 1, 2};
         },
         "layer[0].flakes[0].d50_um = 1: with d10_um = 0.01 and d90_um = 2", "[0.001, 1000000] um"},
        {[](Recipe& r) { r.clearcoat = Clearcoat{.thickness_um = 45, .thickness_spread_um = 16}; },
         "clearcoat.thickness_spread_um = 16", "[0, 15] um, at most a third of thickness_um = 45"},
        {[](Recipe& r) { r.microfacet.emplace().alpha = 0; }, "microfacet.alpha = 0", "[0.001, 1]"},
        {[](Recipe& r) { r.microfacet.emplace().facets.emplace().count = 0; },
         "microfacet.facets.count = 0", "[1, 1000000000000000]"},
    };
    for (const BrokenRecipe& broken : cases) {
        Recipe recipe = pearl();
        broken.break_it(recipe);
        const std::string message = message_of<DomainError>([&] { validate(recipe, {400, 700}); });
        EXPECT_THAT(message, HasSubstr(broken.key));
        EXPECT_THAT(message, HasSubstr(broken.allowed));
    }
}

TEST(ValidateRecipe, FindsAnEnergyExcessBetweenTheSamplesOfTheOtherSpectrum) {
    // R peaks at 550 nm, where T has no sample of its own.
    const PrescribedFlake flake{spectra::Spectrum({400, 550, 700}, {0.1, 0.9, 0.1}),
                                spectra::Spectrum({400, 700}, {0.2, 0.2}), 0.3};
    EXPECT_EQ(limits::wavelength_of_excess(flake), 550);
}

TEST(ValidateRecipe, RefusesWavelengthsThatAMaterialDoesNotCover) {
    Recipe recipe = pearl();
    auto& platelet = std::get<optics::Platelet>(recipe.layers[0].flakes[0].body);
    platelet.core.material =
        optics::Material("glass", {500, 600}, std::vector<optics::ComplexIndex>{1.5, 1.5});
    EXPECT_NO_THROW(validate(recipe, {500, 600}));
    const std::string message = message_of<DomainError>([&] { validate(recipe, {500, 610}); });
    EXPECT_THAT(message, HasSubstr("layer[0].flakes[0].core.material = glass"));
    EXPECT_THAT(message, HasSubstr("[500, 600] nm, not at 610 nm"));
}

}  // namespace
}  // namespace nacre::paint
