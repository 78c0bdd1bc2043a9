#include "nacre/reference/medium_grid.h"

#include <gtest/gtest.h>

#include "nacre/core/error.h"
#include "nacre/reference/test_support.h"

namespace nacre::reference {
namespace {

/// Every quantity different at every wavelength.
layers::Recipe coloured_paint() {
    layers::Layer layer = test::flake_layer(1, 0.1, 0, 0);
    optics::Platelet platelet;
    platelet.core = {optics::find_material("mica"), 400, {50}};
    platelet.coats = {{optics::find_material("TiO2_anatase"), 80, {}}};
    layer.flakes[0].body = platelet;
    const spectra::Spectrum rising({400, 700}, {1, 4});
    layer.pigments = {{rising, 0.5, 0.2}, {3.0, rising, 0.0}};
    layers::Recipe recipe = test::paint(1.5, {layer});
    recipe.substrate_reflectance = spectra::Spectrum({400, 700}, {0.1, 0.7});
    recipe.clearcoat = layers::Clearcoat{20, rising, 0};
    return recipe;
}

std::vector<double> by_ten() {
    std::vector<double> grid;
    for (int i = 0; i <= 30; ++i) grid.push_back(400 + 10 * i);
    return grid;
}

void expect_equal(const Medium& a, const Medium& b, int lanes) {
    const auto near = [&](const Lanes& x, const Lanes& y) {
        for (int i = 0; i < lanes; ++i) EXPECT_NEAR(x[i], y[i], 1e-14);
    };
    EXPECT_EQ(a.lane_count, b.lane_count);
    EXPECT_EQ(a.index, b.index);
    near(a.substrate_reflectance, b.substrate_reflectance);
    ASSERT_EQ(a.slabs.size(), b.slabs.size());
    for (std::size_t s = 0; s < a.slabs.size(); ++s) {
        const Slab &p = a.slabs[s], &q = b.slabs[s];
        EXPECT_EQ(p.thickness_um, q.thickness_um);
        EXPECT_EQ(p.flake_rate_per_um, q.flake_rate_per_um);
        EXPECT_NEAR(p.pigment_rate_per_um, q.pigment_rate_per_um, 1e-14);
        near(p.absorption_per_um, q.absorption_per_um);
        near(p.pigment_scattering_per_um, q.pigment_scattering_per_um);
        ASSERT_EQ(p.flakes.size(), q.flakes.size());
        for (std::size_t f = 0; f < p.flakes.size(); ++f) {
            for (const double cosine : {0.0, 0.33, 0.9, 1.0}) {
                near(p.flakes[f].optics.reflectance(cosine),
                     q.flakes[f].optics.reflectance(cosine));
                near(p.flakes[f].optics.transmittance(cosine),
                     q.flakes[f].optics.transmittance(cosine));
            }
        }
        for (std::size_t k = 0; k < p.pigments.size(); ++k)
            near(p.pigments[k].scattering_per_um, q.pigments[k].scattering_per_um);
    }
}

TEST(MediumGrid, OnItsWavelengthsItIsTheMediumItself) {
    const layers::Recipe recipe = coloured_paint();
    // Unsorted, and across the groups of eight in which the grid is kept.
    const std::vector<double> wavelengths{690, 400, 470, 480, 550, 560, 610, 700};
    expect_equal(MediumGrid(recipe, by_ten()).at(wavelengths), Medium(recipe, wavelengths), kLanes);
    const std::vector<double> two{430, 650};
    expect_equal(MediumGrid(recipe, by_ten()).at(two), Medium(recipe, two), 2);
}

TEST(MediumGrid, IsLinearBetweenWavelengthsAndConstantBeyond) {
    const MediumGrid grid(coloured_paint(), by_ten());
    const std::vector<double> wavelengths{470, 473, 480, 380, 400, 700, 800};
    const Medium medium = grid.at(wavelengths);
    const auto expect_linear = [&](const Lanes& x) {
        EXPECT_NEAR(x[1], 0.7 * x[0] + 0.3 * x[2], 1e-14);
        EXPECT_EQ(x[3], x[4]);
        EXPECT_EQ(x[5], x[6]);
        EXPECT_NE(x[0], x[2]);
    };
    expect_linear(medium.substrate_reflectance);
    expect_linear(medium.slabs[1].absorption_per_um);
    expect_linear(medium.slabs[1].flakes[0].optics.reflectance(0.7));
    expect_linear(medium.slabs[1].flakes[0].optics.transmittance(0.7));
}

TEST(MediumGrid, RefusesWavelengthsOutOfOrder) {
    const layers::Recipe recipe = coloured_paint();
    EXPECT_THROW(MediumGrid(recipe, {}), DomainError);
    EXPECT_THROW(MediumGrid(recipe, {500, 490}), DomainError);
    EXPECT_THROW(MediumGrid(recipe, {500, NAN}), DomainError);
}

}  // namespace
}  // namespace nacre::reference
