#include "nacre/montecarlo/plane_walk.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/core/quadrature.h"
#include "nacre/testing/montecarlo.h"
#include "nacre/testing/reference_albedos.h"

namespace nacre::montecarlo {
namespace {

using test::direction;
using test::kOnGrid;
using test::kWorstZ;
using test::walked_albedo;

constexpr int kWalks = 200'000;

std::array<Estimate, kLanes> walked_by_plane(const paint::Recipe& recipe, double theta_deg) {
    return walked_albedo(*PlaneWalk(recipe).bind(kOnGrid), direction(theta_deg, 30), kWalks);
}

TEST(PlaneWalk, AlbedoIsThatOfTheReferenceAtEveryWavelength) {
    // One by walks of today, which the frozen ones are held against too.
    const paint::Recipe recipe = test::pearl();
    const auto found = walked_by_plane(recipe, 0);
    const auto expected =
        reference_albedo(recipe, std::vector<Direction>{{0, 0}}, kOnGrid, {.samples = kWalks});
    std::array<Estimate, kLanes> reflected;
    for (int lane = 0; lane < kLanes; ++lane) {
        reflected[lane] = expected[lane].reflectance;
        EXPECT_LT(std::abs(z_score(found[lane], reflected[lane])), kWorstZ) << kOnGrid[lane];
    }
    test::expect_frozen_albedo(reflected, recipe, 0);
    test::expect_frozen_albedo(found, recipe, 0);
    test::expect_frozen_albedo(walked_by_plane(recipe, 60), recipe, 60);
}

TEST(PlaneWalk, AlbedoIsThatOfTheReferenceUnderARoughClearcoat) {
    paint::Recipe recipe = test::pearl();
    recipe.name = "rough pearl";
    recipe.clearcoat->roughness = 0.3;
    test::expect_frozen_albedo(walked_by_plane(recipe, 40), recipe, 40);
}

TEST(PlaneWalk, AlbedoIsThatOfTheReferenceInADispersiveBinder) {
    paint::Recipe recipe = test::pearl();
    recipe.name = "pearl in flint";
    recipe.binder = optics::Material("flint", std::vector<double>{400, 700},
                                     std::vector<optics::ComplexIndex>{1.9, 1.5});
    test::expect_frozen_albedo(walked_by_plane(recipe, 60), recipe, 60);
}

TEST(PlaneWalk, PowerIntoASolidAngleIsTheIntegralOfTheReferencesBrdf) {
    // Around the mirror direction, inside the lobe, and away from both.
    struct Bin {
        double theta_from, theta_to, phi_from, phi_to;
    };
    const std::array bins{Bin{35, 55, 160, 200}, Bin{10, 30, 140, 180}, Bin{50, 70, 80, 120}};
    const paint::Recipe recipe = test::pearl();
    const double theta_i = 45;

    const auto surface = PlaneWalk(recipe).bind(kOnGrid);
    const Vec3f wi = direction(theta_i, 0);
    const auto found =
        test::estimate(*surface, wi, 2 * kWalks, bins.size(), 5,
                       [&](const bsdf::BsdfSample& s, std::vector<FloatLanes>& values) {
                           if (s.kind == bsdf::SampleKind::specular) return;
                           const double theta = std::acos(s.wo.z) * 180 / std::numbers::pi;
                           double phi = std::atan2(s.wo.y, s.wo.x) * 180 / std::numbers::pi;
                           if (phi < 0) phi += 360;
                           for (std::size_t b = 0; b < bins.size(); ++b) {
                               if (theta > bins[b].theta_from && theta < bins[b].theta_to &&
                                   phi > bins[b].phi_from && phi < bins[b].phi_to)
                                   values[b] = s.weight;
                           }
                       });

    // By the quadrature below with 400000 walks of the reference of Nacre 0.1.0: NACRE_WRITE_TRUTH=1
    // prints it. Eyes share walks: their errors add up, if fully correlated.
    const double frozen[3][kLanes][2] = {{{0.02339371, 1.1e-05},
                                          {0.01596903, 7.94e-06},
                                          {0.008237869, 4.7e-06},
                                          {0.005454734, 3.85e-06},
                                          {0.008923865, 5.13e-06},
                                          {0.01717499, 8.93e-06},
                                          {0.02569456, 1.28e-05},
                                          {0.02874566, 1.41e-05}},
                                         {{0.007859708, 4.31e-06},
                                          {0.005797019, 2.78e-06},
                                          {0.003782536, 2.16e-06},
                                          {0.002818253, 2.02e-06},
                                          {0.003559324, 2.21e-06},
                                          {0.005440804, 2.72e-06},
                                          {0.00822504, 3.8e-06},
                                          {0.009908397, 4.64e-06}},
                                         {{0.001185514, 2.28e-06},
                                          {0.001485381, 1.47e-06},
                                          {0.001856797, 1.78e-06},
                                          {0.002118794, 2.11e-06},
                                          {0.002246833, 2.27e-06},
                                          {0.002327745, 2.43e-06},
                                          {0.00248758, 2.72e-06},
                                          {0.00270037, 3.11e-06}}};
    const bool anew = std::getenv("NACRE_WRITE_TRUTH");
    constexpr int kNodes = 6;
    for (std::size_t b = 0; b < bins.size() && anew; ++b) {
        const Quadrature theta = gauss_legendre(kNodes, bins[b].theta_from, bins[b].theta_to);
        const Quadrature phi = gauss_legendre(kNodes, bins[b].phi_from, bins[b].phi_to);
        std::vector<Direction> detectors;
        std::vector<double> weights;
        for (int i = 0; i < kNodes; ++i) {
            for (int j = 0; j < kNodes; ++j) {
                detectors.push_back({theta.nodes[i], phi.nodes[j]});
                const double t = theta.nodes[i] * kDegree;
                weights.push_back(theta.weights[i] * phi.weights[j] * kDegree * kDegree *
                                  std::sin(t) * std::cos(t));
            }
        }
        const auto brdf = reference_brdf(recipe, std::vector<Direction>{{theta_i, 0}}, detectors,
                                         kOnGrid, {.samples = 400'000, .seed = 7});
        for (int lane = 0; lane < kLanes; ++lane) {
            Estimate sum;
            for (std::size_t j = 0; j < detectors.size(); ++j) {
                sum.value += weights[j] * brdf[j * kLanes + lane].value;
                sum.standard_error += weights[j] * brdf[j * kLanes + lane].standard_error;
            }
            std::printf("{%.7g, %.3g}, ", sum.value, sum.standard_error);
        }
        std::printf("\n");
    }
    for (std::size_t b = 0; b < bins.size(); ++b) {
        for (int lane = 0; lane < kLanes; ++lane) {
            const double value = frozen[b][lane][0], error = frozen[b][lane][1];
            EXPECT_GT(value, 10 * error);
            EXPECT_LT(std::abs(z_score(found[b][lane], value, error)), 3)
                << "bin " << b << ", " << kOnGrid[lane] << " nm: " << found[b][lane].value << " +- "
                << found[b][lane].standard_error << " against " << value << " +- " << error;
        }
    }
}

TEST(PlaneWalk, SpecularReflectanceIsFresnels) {
    const auto surface = PlaneWalk(test::worked_paint()).bind(kOnGrid);
    // n = 1.5 at normal incidence: 0.04.
    const Vec3f wi{0, 0, 1};
    const auto specular =
        test::estimate(*surface, wi, 100'000, 1, 3,
                       [&](const bsdf::BsdfSample& s, std::vector<FloatLanes>& values) {
                           if (s.kind == bsdf::SampleKind::specular) values[0] = s.weight;
                       })[0];
    EXPECT_LT(std::abs(z_score(specular[0], 0.04)), kWorstZ);
    EXPECT_LT(specular[0].standard_error, 0.04 * std::sqrt(1 / 0.04) / std::sqrt(1e5))
        << "drawn more often than by Fresnel's reflectance alone";
}

TEST(PlaneWalk, EstimatedAlbedoIsThatOfItsSamples) {
    const auto surface = PlaneWalk(test::pearl()).bind(kOnGrid);
    for (const double theta : {0., 37., 70.}) {
        const Vec3f wi = direction(theta, 0);
        const FloatLanes tabulated = surface->albedo(wi);
        const auto found = walked_albedo(*surface, wi, 50'000);
        for (int lane = 0; lane < kLanes; ++lane) {
            // The standard deviation of a weight is about 0.5 at most, over the root of 512 walks.
            EXPECT_NEAR(tabulated[lane], found[lane].value, 4 * 0.5 / std::sqrt(512.)) << theta;
        }
    }
}

TEST(PlaneWalk, WavelengthsBetweenTheGridsAreInterpolatedAndThoseBeyondAreItsEnds) {
    // Albedo is not linear in the films' reflectance: only bounds are known between neighbours.
    const PlaneWalk model(test::pearl());
    const bsdf::Wavelengths wavelengths{380, 400, 550, 555, 560, 700, 720, 780};
    const auto a = walked_albedo(*model.bind(wavelengths), {0, 0, 1}, kWalks);
    EXPECT_EQ(a[0].value, a[1].value);
    EXPECT_EQ(a[5].value, a[6].value);
    EXPECT_EQ(a[5].value, a[7].value);
    EXPECT_LT(std::abs(z_score(a[3], (a[2].value + a[4].value) / 2)), kWorstZ);
}

TEST(PlaneWalk, EvalAndPdfAreZeroAndSamplesHaveNoDensity) {
    const auto surface = PlaneWalk(test::worked_paint()).bind(kOnGrid);
    const Vec3f wi = direction(30, 0), wo = direction(30, 180);
    EXPECT_EQ(lane_max(surface->eval(wi, wo)), 0);
    EXPECT_EQ(surface->pdf(wi, wo), 0);
    int left = 0;
    for (int i = 0; i < 100; ++i) {
        const auto sample = surface->sample(wi, 0.01f * static_cast<float>(i), {0.25f, 0.5f});
        if (!sample) continue;  // absorbed
        EXPECT_EQ(length(sample->wo - wo) < 1e-6f, sample->kind == bsdf::SampleKind::specular);
        EXPECT_NE(sample->kind, bsdf::SampleKind::density);
        EXPECT_EQ(sample->exit_mm, Vec3f{});
        EXPECT_GT(sample->wo.z, 0);
        EXPECT_NEAR(length(sample->wo), 1, 1e-6);
        ++left;
    }
    EXPECT_GT(left, 30);
    EXPECT_FALSE(surface->sample(direction(91, 0), 0.5f, {0.5f, 0.5f}));
    EXPECT_EQ(lane_max(surface->albedo(direction(91, 0))), 0);
}

TEST(PlaneWalk, RefusesWhatIsNoPaint) {
    paint::Recipe recipe = test::worked_paint();
    recipe.layers[0].thickness_um = -1;
    EXPECT_THROW(PlaneWalk{recipe}, DomainError);
    recipe = test::worked_paint();
    EXPECT_THROW(PlaneWalk(recipe, std::vector<double>{}), DomainError);
    EXPECT_THROW(PlaneWalk(recipe, std::vector<double>{500, 500}), DomainError);
    recipe.clearcoat.emplace();
    recipe.clearcoat->thickness_um = 10;
    recipe.clearcoat->roughness = 1e-4;
    EXPECT_THROW(PlaneWalk{recipe}, DomainError);
}

TEST(PlaneWalk, StopsWhileFilmsAreComputed) {
    const std::vector<double> nm = spectra::default_wavelengths_nm();
    const Progress never = [](double) { return false; };
    EXPECT_THROW(PlaneWalk(test::pearl(), nm, never), Stopped);
}

}  // namespace
}  // namespace nacre::montecarlo
