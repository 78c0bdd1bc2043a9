#include "nacre/bsdf/models/microflake.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nacre/core/math.h"
#include "nacre/core/random.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"
#include "nacre/testing/bsdf.h"
#include "nacre/testing/paints.h"
#include "nacre/testing/statistics.h"

namespace nacre::bsdf {
namespace {

using test::metallic;

constexpr double kAngles[] = {0.1, 20, 45, 60, 75, 85, 89};

// Two layers, two species, a pigment, an absorbing clearcoat and a bright substrate: every term.
paint::Recipe everything() {
    paint::Recipe recipe = metallic(0.1, 0.6);
    optics::Platelet platelet;
    platelet.core = {optics::find_material("mica"), 500, {60}};
    platelet.coats = {{optics::find_material("TiO2_anatase"), 80, {5}}};
    paint::FlakeSpecies pearl = test::flakes(0.05, 0.2, 0.0);
    pearl.body = platelet;
    const paint::PigmentParticles red{paint::PigmentVolume{0.001},
                                      {optics::find_material("Fe2O3"), 250, 0.2}};
    recipe.layers.insert(
        recipe.layers.begin(),
        paint::Layer{10, {pearl}, {{paint::PigmentCoefficients{20.0, 5.0, 0.5}}, {red}}});
    recipe.clearcoat = paint::Clearcoat{40, spectra::Spectrum({400.0, 700.0}, {8.0, 1.0}), 0.0};
    recipe.substrate_reflectance = spectra::Spectrum({400.0, 700.0}, {0.3, 0.8});
    return recipe;
}

struct Model {
    std::shared_ptr<const solver::SolvedPaint> paint;
    std::unique_ptr<const Microflake> bsdf;

    explicit Model(const paint::Recipe& recipe)
        : paint(std::make_shared<const solver::SolvedPaint>(
              solver::solve(recipe, spectra::default_wavelengths_nm()))),
          bsdf(std::make_unique<const Microflake>(paint)) {}
};

const Model& everything_model() {
    static const Model model(everything());
    return model;
}

// Largest difference to the solved paint over the peak of each incident direction.
double worst_error(const Model& model) {
    const auto bound = model.bsdf->bind(kOnGrid);
    double worst = 0;
    for (const double theta_i : kAngles) {
        double peak = 0, error = 0;
        for (const double phi : {180.0, 178.0, 174.0, 165.0, 150.0, 120.0, 60.0, 1.0}) {
            for (double theta_o = 0.5; theta_o < 90; theta_o += 4) {
                const auto expected =
                    model.paint->brdf(theta_i * kDegree, theta_o * kDegree, phi * kDegree);
                const FloatLanes found =
                    bound->eval(direction(theta_i, 0), direction(theta_o, phi));
                for (int lane = 0; lane < kLanes; ++lane) {
                    const double f = expected[static_cast<int>((kOnGrid[lane] - 400) / 10)];
                    peak = std::max(peak, f);
                    error = test::worse(error, std::abs(found[lane] - f));
                }
            }
        }
        worst = test::worse(worst, error / peak);
    }
    return worst;
}

TEST(Microflake, AgreesWithTheSolvedPaintWhateverItsRoughness) {
    for (const double alpha : {0.03, 0.09, 0.3, 0.5}) {
        SCOPED_TRACE(alpha);
        EXPECT_LT(worst_error(Model(metallic(alpha, 1.0))), kMicroflakeError);
    }
}

TEST(Microflake, AgreesWithTheSolvedPaintForEveryIngredient) {
    EXPECT_LT(worst_error(everything_model()), kMicroflakeError);
}

TEST(Microflake, RefractsEachWavelengthItsOwnWay) {
    paint::Recipe recipe = metallic(0.2, 0.8);
    recipe.binder = optics::Material("crown", {400, 700}, {{1.56, 0}, {1.48, 0}});
    EXPECT_LT(worst_error(Model(recipe)), kMicroflakeError);
}

// What a smooth interface lets through changes the faster towards grazing incidence the nearer its index
// is to 1, where it is all. What is left is the table's: of the multiple scattering of light that grazes
// on both ways.
TEST(Microflake, AgreesWithTheSolvedPaintAtGrazingIncidenceWhateverTheIndex) {
    struct Case {
        double index, most;
    };
    for (const auto& [index, most] :
         {Case{1.0, 0.3}, {1.001, 0.2}, {1.02, 0.05}, {1.1, 0.02}, {1.5, 0.004}, {2.5, 0.001}}) {
        paint::Recipe recipe = metallic(0.2, 0.8);
        recipe.binder = optics::Material(index);
        const Model model(recipe);
        const auto bound = model.bsdf->bind(kOnGrid);
        constexpr double kPhi = 160;
        for (const double theta_i : {1.0, 45.0, 89.0, 89.6, 89.9}) {
            for (const double theta_o : {89.0, 89.4, 89.6, 89.8, 89.95}) {
                constexpr auto kIndex = static_cast<std::size_t>((kOnGrid[0] - 400) / 10);
                const double expected =
                    model.paint->brdf(theta_i * kDegree, theta_o * kDegree, kPhi * kDegree)[kIndex];
                const FloatLanes f = bound->eval(direction(theta_i, 0), direction(theta_o, kPhi));
                EXPECT_NEAR(f[0], expected, most * expected)
                    << "index " << index << ", " << theta_i << " to " << theta_o << " deg";
            }
        }
    }
}

paint::Recipe rough_pearl(double roughness) {
    paint::Recipe recipe = everything();
    recipe.clearcoat->roughness = roughness;
    return recipe;
}

TEST(Microflake, AgreesWithTheSolvedPaintUnderARoughClearcoat) {
    for (const double roughness : {0.1, 0.4}) {
        SCOPED_TRACE(roughness);
        EXPECT_LT(worst_error(Model(rough_pearl(roughness))), kMicroflakeRoughError);
    }
}

TEST(Microflake, SamplesFollowTheDensityUnderARoughClearcoat) {
    const Model model(rough_pearl(0.2));
    const auto bound = model.bsdf->bind(kOnGrid);
    for (const double theta_i : {10.0, 70.0}) {
        EXPECT_LT(chi_square_z_score(*bound, direction(theta_i, 0), 21, 200000), 3.5) << theta_i;
    }
}

TEST(Microflake, InterpolatesBetweenWavelengthsAndKeepsTheEnds) {
    const auto bound = everything_model().bsdf->bind({380, 400, 405, 410, 690, 697.5, 700, 730});
    const FloatLanes f = bound->eval(direction(45, 0), direction(30, 170));
    EXPECT_FLOAT_EQ(f[0], f[1]);
    // Single scattering is linear in the reflectances up to its attenuation: half way within 1 %.
    EXPECT_NEAR(f[2], 0.5 * (f[1] + f[3]), 0.01 * f[2]);
    EXPECT_FLOAT_EQ(f[6], f[7]);
}

TEST(Microflake, IsReciprocalAndNeverNegative) {
    expect_reciprocal(*everything_model().bsdf->bind(kOnGrid), 2000);
}

TEST(Microflake, IsBlackBelowTheHorizon) {
    expect_black_below_the_horizon(*everything_model().bsdf->bind(kOnGrid));
}

TEST(Microflake, SampleReportsItsOwnDensityAndWeight) {
    const auto bound = everything_model().bsdf->bind(kOnGrid);
    const Drawn drawn = expect_own_density_and_weight(*bound, 4000, 1e-3f);
    EXPECT_GT(drawn.specular, 100);
    EXPECT_GT(drawn.others, 2000);
}

TEST(Microflake, DensitiesOfEightDirectionsAreThoseOfEach) {
    expect_densities_of_eight(*everything_model().bsdf->bind(kOnGrid), 1e-3f);
    expect_densities_of_eight(*Model(rough_pearl(0.2)).bsdf->bind(kOnGrid), 1e-3f);
}

TEST(Microflake, SamplesFollowTheDensity) {
    int tests = 0;
    for (const double alpha : {0.1, 0.4}) {
        const Model model(metallic(alpha, 0.7));
        const auto bound = model.bsdf->bind(kOnGrid);
        for (const double theta_i : {0.5, 35.0, 65.0, 85.0}) {
            SCOPED_TRACE(testing::Message() << "alpha " << alpha << ", theta_i " << theta_i);
            // One-sided, eight tests with fixed seeds: 3.5 deviations are one false alarm in 500.
            EXPECT_LT(chi_square_z_score(*bound, direction(theta_i, 0), 11 + tests, 200000), 3.5);
            ++tests;
        }
    }
    EXPECT_EQ(tests, 8);
}

// Directions are drawn in proportion to what is reflected: single samples of a grey paint scatter by
// some 15 %, and few are lost to total reflection inside the coat.
TEST(Microflake, WeightsVaryLittle) {
    for (const double alpha : {0.05, 0.16, 0.4}) {
        const Model model(metallic(alpha, 0.7));
        const auto bound = model.bsdf->bind(kOnGrid);
        Rng rng(6, 1);
        for (const double theta_i : {0.5, 30.0, 60.0, 75.0}) {
            constexpr int kSamples = 20000;
            double sum = 0, squares = 0;
            for (int i = 0; i < kSamples; ++i) {
                const auto s = bound->sample(direction(theta_i, 10), rng.uniform_float(),
                                             {rng.uniform_float(), rng.uniform_float()});
                const double weight = s ? s->weight[4] : 0.0;
                sum += weight;
                squares += weight * weight;
            }
            EXPECT_LT(squares * kSamples / (sum * sum) - 1, 0.05)
                << "alpha " << alpha << ", theta_i " << theta_i;
        }
    }
}

TEST(Microflake, WeightsStayBoundedUpToGrazing) {
    for (const double alpha : {0.03, 0.1, 0.5}) {
        const Model model(metallic(alpha, 1.0));
        const auto bound = model.bsdf->bind(kOnGrid);
        Rng rng(5, 1);
        for (const double theta_i : {0.5, 30.0, 60.0, 80.0, 88.0, 89.9}) {
            double largest = 0;
            for (int i = 0; i < 20000; ++i) {
                const auto s = bound->sample(direction(theta_i, 10), rng.uniform_float(),
                                             {rng.uniform_float(), rng.uniform_float()});
                if (s) largest = test::worse(largest, static_cast<double>(lane_max(s->weight)));
            }
            EXPECT_GT(largest, 0.3);
            // The cosine lobe, which a thirtieth samples, bounds the weight.
            EXPECT_LT(largest, 10) << "alpha " << alpha << ", theta_i " << theta_i;
        }
    }
}

TEST(Microflake, AlbedoIsTheMeanWeight) {
    const auto bound = everything_model().bsdf->bind(kOnGrid);
    for (const double theta_i : {0.5, 40.0, 70.0, 86.0}) {
        const auto [mean, error] = mean_weight(*bound, direction(theta_i, 0), 4, 40000, 9);
        // The table's own quadrature adds up to 5e-3.
        EXPECT_NEAR(bound->albedo(direction(theta_i, 0))[4], mean, 4 * error + 5e-3);
    }
}

TEST(Microflake, LosesNoLightWhereNothingAbsorbs) {
    paint::Recipe recipe = metallic(0.2, 1.0);
    recipe.substrate_reflectance = 1.0;
    const Model model(recipe);
    const auto bound = model.bsdf->bind(kOnGrid);
    for (const double theta_i : {0.5, 45.0, 80.0}) {
        const auto [mean, error] = mean_weight(*bound, direction(theta_i, 0), 0, 100000, 13);
        EXPECT_NEAR(mean, 1.0, 4 * error + kMicroflakeError);
    }
}

}  // namespace
}  // namespace nacre::bsdf
