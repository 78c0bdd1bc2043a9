#include "nacre/paint/expansion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "nacre/paint/orientation.h"
#include "nacre/paint/recipe_parameter.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/paints.h"

namespace nacre::paint {
namespace {

using nacre::test::flakes;
using nacre::test::message_of;
using nacre::test::paint_of;
using ::testing::AllOf;
using ::testing::HasSubstr;

double area_density(const Layer& layer) {
    double sum = 0;
    for (const FlakeSpecies& species : layer.flakes) sum += species.area_density_per_um();
    return sum;
}

Recipe with(const FlakeSpecies& species) { return paint_of(1.5, {{20, {species}, {}}}); }

/// One species with all that there is.
FlakeSpecies rich_flakes() {
    FlakeSpecies species = flakes(0.1, 0.1, 0.6);
    species.orientation.law = Orientation::Law::ggx;
    species.orientation.alpha_bottom = 0.2;
    species.quantiles = DiameterQuantiles{9, 20, 40};
    species.edge_um = 0.2;
    species.body = optics::Platelet{{optics::Material(1.58), 500, {30}},
                                    {{optics::Material(2.5), 80, {5}}},
                                    optics::Platelet::CoatedSides::one};
    return species;
}

TEST(Expansion, LeavesPlainPaintsAsTheyAre) {
    Recipe plain = nacre::test::full_recipe();
    EXPECT_FALSE(is_plain(plain));
    for (FlakeSpecies& species : plain.layers[0].flakes) {
        species.orientation = {};
        species.edge_um = 0;
    }
    EXPECT_TRUE(is_plain(plain));
    EXPECT_EQ(expanded(plain), plain);
}

TEST(Expansion, IsDoneOnce) {
    const Recipe once = expanded(with(rich_flakes()));
    EXPECT_TRUE(is_plain(once));
    EXPECT_EQ(expanded(once), once);
}

TEST(Expansion, KeepsTheAreaOfTheFlakesAndTheThickness) {
    FlakeSpecies species = rich_flakes();
    species.edge_um = 0;
    const Recipe paint = with(species);
    validate(paint, {});
    const Recipe whole = expanded(paint);
    EXPECT_GT(whole.layers.size(), 4u);
    EXPECT_NEAR(whole.thickness_um(), paint.thickness_um(), 1e-9);
    for (const Layer& layer : whole.layers) EXPECT_NEAR(area_density(layer), 0.1, 1e-12);
}

TEST(Expansion, OfEqualAlphasIsOneLayer) {
    FlakeSpecies species = flakes(0.1, 0.1, 0.6);
    species.orientation.alpha_bottom = 0.1;
    const Recipe whole = expanded(with(species));
    ASSERT_EQ(whole.layers.size(), 1u);
    ASSERT_EQ(whole.layers[0].flakes.size(), 1u);
    EXPECT_DOUBLE_EQ(whole.layers[0].flakes[0].orientation.beckmann_alpha, 0.1);
}

// Int dz / alpha(z)^2 over the layer is H / (alpha_top alpha_bottom).
TEST(Expansion, OfDepthKeepsTheMeanPeak) {
    for (const double bottom : {0.05, 0.3}) {
        FlakeSpecies species = flakes(0.1, 0.1, 0.6);
        species.orientation.alpha_bottom = bottom;
        double peak = 0, before = 0.1;
        for (const Layer& layer : expanded(with(species)).layers) {
            const double alpha = layer.flakes[0].orientation.beckmann_alpha;
            peak += layer.thickness_um / (alpha * alpha);
            EXPECT_LT(std::abs(std::log(alpha / before)), 1.001 * std::log1p(kSublayerError));
            before = alpha;
        }
        EXPECT_NEAR(peak, 20 / (0.1 * bottom), 1e-9 * peak);
    }
}

TEST(Expansion, OfOneCoatedSideIsHalfOfEach) {
    FlakeSpecies species = flakes(0.1, 0.1, 0.6);
    species.body = optics::Platelet{{optics::Material(1.58), 500, {}},
                                    {{optics::Material(2.5), 80, {}}},
                                    optics::Platelet::CoatedSides::one};
    EXPECT_DOUBLE_EQ(species.thickness_um(), 0.58);
    const Recipe whole = expanded(with(species));
    ASSERT_EQ(whole.layers[0].flakes.size(), 2u);
    for (const FlakeSpecies& face : whole.layers[0].flakes) {
        EXPECT_DOUBLE_EQ(face.area_density_per_um(), 0.05);
    }
    EXPECT_FALSE(whole.layers[0].flakes[0].body == whole.layers[0].flakes[1].body);
}

// All that a flake blocks stays the same: what its rim takes from the mirror it scatters.
TEST(Expansion, OfEdgesKeepsTheCrossSection) {
    for (const bool sheet : {false, true}) {
        FlakeSpecies species = flakes(0.1, 0.1, 0.6);
        species.edge_um = 0.5;
        if (sheet) species.quantiles = DiameterQuantiles{4, 10, 22};
        const Layer layer = expanded(with(species)).layers.at(0);
        ASSERT_EQ(layer.pigments.size(), 1u);
        const auto& rim = std::get<PigmentCoefficients>(layer.pigments[0].body);
        const double scattered = rim.scattering_per_mm(550) / 1000;
        EXPECT_NEAR(area_density(layer) + scattered, 0.1, 1e-9);
        EXPECT_EQ(rim.absorption_per_mm(550), 0);
        if (!sheet) {
            EXPECT_NEAR(scattered / 0.1, 4 * 0.5 / 20 - 4 * std::pow(0.5 / 20, 2), 1e-9);
        }
    }
}

// The grey share grows as flakes shrink, and ends with them.
TEST(Expansion, OfEdgesGrowsAsFlakesShrink) {
    double before = 0;
    for (const double d : {100.0, 50.0, 20.0, 8.0, 3.0}) {
        FlakeSpecies species = flakes(0.1, 0.1, 0.6);
        species.edge_um = 0.5;
        species.diameter_um = d;
        const Layer layer = expanded(with(species)).layers.at(0);
        const double rim = 0.1 - area_density(layer);
        EXPECT_GT(rim, before);
        before = rim;
    }
}

TEST(Expansion, RefusesWhatCannotBe) {
    const auto refusal = [](auto&& change) {
        FlakeSpecies species = flakes(0.1, 0.1, 0.6);
        change(species);
        return message_of<DomainError>([&] { validate(with(species), {}); });
    };
    EXPECT_EQ(refusal([](FlakeSpecies&) {}), "accepted");
    EXPECT_THAT(refusal([](FlakeSpecies& f) {
                    f.quantiles = DiameterQuantiles{9, 8, 40};
                }),
                AllOf(HasSubstr("layer[0].flakes[0].d50_um = 8"), HasSubstr("d10_um = 9")));
    EXPECT_THAT(refusal([](FlakeSpecies& f) { f.quantiles = MedianDiameter{0}; }),
                HasSubstr("layer[0].flakes[0].d50_um = 0: must be in [0.001, 10000]"));
    EXPECT_THAT(refusal([](FlakeSpecies& f) {
                    f.quantiles = MedianDiameter{18};
                    f.edge_um = 9;
                }),
                HasSubstr("layer[0].flakes[0].edge_um = 9: must be below half of d50_um = 18"));
    EXPECT_THAT(refusal([](FlakeSpecies& f) { f.edge_um = 10; }),
                HasSubstr("layer[0].flakes[0].edge_um = 10: must be below half of diameter_um"));
    EXPECT_THAT(refusal([](FlakeSpecies& f) { f.waviness = 0.25; }),
                HasSubstr("layer[0].flakes[0].waviness = 0.25: must be at most 0.2"));
    EXPECT_THAT(refusal([](FlakeSpecies& f) {
                    f.orientation.law = Orientation::Law::ggx;
                    f.orientation.beckmann_alpha = 0.7;
                }),
                HasSubstr("layer[0].flakes[0].orientation.alpha = 0.7: with ggx must be in"));
    EXPECT_THAT(refusal([](FlakeSpecies& f) { f.orientation.law = Orientation::Law::tabulated; }),
                HasSubstr("needs tilts"));
    const auto tabulated = [&](std::vector<TiltDensity> tilts) {
        return refusal([&](FlakeSpecies& f) {
            f.orientation.law = Orientation::Law::tabulated;
            f.orientation.table = TabulatedTilts{std::move(tilts)};
        });
    };
    EXPECT_THAT(tabulated({{0, 1}}), HasSubstr("at least 2"));
    EXPECT_THAT(tabulated({{2, 1}, {1, 1}}), HasSubstr("tilts[1].tilt_deg = 1: must be above"));
    EXPECT_THAT(tabulated({{0, 0}, {10, 0}}), HasSubstr("density above 0"));
    EXPECT_THAT(tabulated({{20, 0}, {21, 1}, {22, 0}}), HasSubstr("mixture"));
}

// Fits, sweeps and sliders reach the numbers by their keys.
TEST(Expansion, HasNumbersByKey) {
    Recipe paint = with(rich_flakes());
    paint.layers[0].flakes[0].waviness = 0.02;
    for (const auto& [key, value] :
         {std::pair("orientation.alpha", 0.1), std::pair("alpha_bottom", 0.2),
          std::pair("d50_um", 20.0), std::pair("edge_um", 0.2), std::pair("waviness", 0.02)}) {
        const std::vector<std::string> keys = matching_parameters(paint, key);
        ASSERT_EQ(keys.size(), 1u) << key;
        EXPECT_EQ(find_parameter(paint, keys[0]).value, value) << key;
        Recipe changed = paint;
        set_parameter(changed, keys[0], 1.25 * value);
        EXPECT_FALSE(expanded(changed) == expanded(paint)) << key;
    }
    // What a recipe does not have is no number of it.
    const Recipe plain = with(flakes(0.1, 0.1, 0.6));
    EXPECT_THROW(find_parameter(plain, "layer[0].flakes[0].edge_um"), DomainError);
    EXPECT_THROW(find_parameter(plain, "layer[0].flakes[0].d50_um"), DomainError);
}

}  // namespace
}  // namespace nacre::paint
