#include "nacre/montecarlo/medium.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/quadrature.h"
#include "nacre/montecarlo/events.h"
#include "nacre/testing/montecarlo.h"
#include "nacre/testing/statistics.h"

namespace nacre::montecarlo {
namespace {

constexpr std::array<double, 1> kWavelength{550};

Flakes flakes_of(double alpha, double reflectance, double transmittance) {
    const auto species = test::flakes(1, alpha, reflectance, transmittance);
    return {1, alpha, FlakeOptics(species, optics::Material(1.5), kWavelength)};
}

Vec3d at_cosine(double mu, double phi) {
    const double s = std::sqrt(1 - mu * mu);
    return {s * std::cos(phi), s * std::sin(phi), mu};
}

/// Over the whole sphere: Gauss-Legendre in the angle to `axis`, equal steps around it. About the
/// travel direction the kernels are smooth in these, the grazing reflections forwards included.
double integrate_sphere(const Vec3d& axis, const std::function<double(const Vec3d&)>& f) {
    constexpr int kSteps = 512, kNodes = 256;
    const Vec3d across = perpendicular(axis), third = cross(axis, across);
    const Quadrature rule = gauss_legendre(kNodes, 0, std::numbers::pi);
    double sum = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double sine = std::sin(rule.nodes[i]), cosine = std::cos(rule.nodes[i]);
        for (int k = 0; k < kSteps; ++k) {
            const double phi = 2 * std::numbers::pi * k / kSteps;
            sum += rule.weights[i] * sine *
                   f(cosine * axis + sine * (std::cos(phi) * across + std::sin(phi) * third));
        }
    }
    return sum * 2 * std::numbers::pi / kSteps;
}

struct ProjectedArea {
    double alpha, mu, value;
};
// Mean projected area of Beckmann flakes: SciPy 1.17.1, nested integrate.quad over the two slopes
// with a break at the kink, epsrel 1e-12; at mu = 1 that is sqrt(pi)/alpha erfcx(1/alpha).
constexpr ProjectedArea kProjectedAreas[] = {
    {.1, 1, .995073188}, {.1, .5, .497536594}, {.1, .2, .199090779}, {.1, .05, .069458091},
    {.3, 1, .960019857}, {.3, .5, .480303234}, {.3, .2, .225844008}, {.3, .05, .163769345},
};

TEST(Flakes, ExtinctionOfOpaqueFlakesIsTheirMeanProjectedArea) {
    for (const auto& [alpha, mu, value] : kProjectedAreas)
        EXPECT_NEAR(flakes_of(alpha, 0, 0).extinction(mu)[0] / value, 1, kExtinctionRelativeError)
            << "alpha " << alpha << ", mu " << mu;
}

TEST(Flakes, ExtinctionOfFlatFlakesIsTheCosine) {
    constexpr double kAlpha = 0.005;  // the smallest a recipe may ask for
    // E|w.m| = mu E(1 + s^2)^(-1/2) = mu (1 - alpha^2/2 + O(alpha^4)) far from grazing
    for (double mu : {0.2, 0.5, 1.0})
        EXPECT_NEAR(flakes_of(kAlpha, 0, 0).extinction(mu)[0], mu * (1 - kAlpha * kAlpha / 2),
                    1e-8);
}

TEST(Flakes, ExtinctionScalesWithOneMinusTheTransmittance) {
    const double opaque = flakes_of(.3, 0, 0).extinction(.4)[0];
    EXPECT_NEAR(flakes_of(.3, .2, .7).extinction(.4)[0], 0.3 * opaque, 1e-14);
}

TEST(Slab, TabulatedExtinctionKeepsToTheQuadrature) {
    for (double alpha : {0.02, 0.1, 0.5}) {
        Slab slab;
        slab.flakes.push_back(flakes_of(alpha, .5, .2));
        Slab tabulated = slab;
        tabulated.tabulate_extinction();
        const double along_normal = slab.extinction(1)[0];
        for (int i = 0; i < kExtinctionTableIntervals; i += i < 100 ? 1 : 20) {
            const double mu = (i + 0.5) / kExtinctionTableIntervals;
            EXPECT_NEAR(tabulated.extinction(mu)[0], slab.extinction(mu)[0],
                        kExtinctionTableError * along_normal)
                << "alpha " << alpha << ", mu " << mu;
        }
    }
}

TEST(Slab, TabulatedExtinctionOfLeaningFlakesIsAboutTheirMeanNormal) {
    Slab slab;
    slab.flakes.push_back(flakes_of(0.1, .5, .2));
    slab.flakes.back().lean = FlakeFrame({0.1, -0.14});
    slab.absorption_per_um = splat(0.01);
    Slab tabulated = slab;
    tabulated.tabulate_extinction();
    const double along_normal = slab.extinction(slab.flakes.back().lean->n)[0];
    double least = along_normal;
    for (double phi : {0.3, 2.1, 4.4}) {
        for (double mu : {0.05, 0.4, 0.98}) {
            const Vec3d w = at_cosine(mu, phi);
            EXPECT_NEAR(tabulated.extinction(w)[0], slab.extinction(w)[0],
                        kExtinctionTableError * along_normal)
                << mu << " " << phi;
            least = std::min(least, slab.extinction(w)[0]);
        }
    }
    EXPECT_LT(least, 0.3 * along_normal);
}

TEST(Slab, WithoutFlakesItsExtinctionIsTheSameInAllDirections) {
    Slab slab;
    slab.absorption_per_um = splat(0.01);
    slab.pigments.push_back({splat(0.02), 0.5});
    slab.sum_pigments();
    slab.tabulate_extinction();
    EXPECT_DOUBLE_EQ(slab.extinction(at_cosine(0.2, 1))[0], 0.03);
}

TEST(Flakes, ScatteringIntegratesToTheExtinctionOfPerfectMirrors) {
    for (double alpha : {0.1, 0.3, 0.5}) {
        const Flakes species = flakes_of(alpha, 1, 0);
        for (double mu : {0.05, 0.2, 0.5, 0.97}) {
            const Vec3d in = at_cosine(-mu, 0.3);
            const double integral = integrate_sphere(
                in, [&](const Vec3d& out) { return species.scattering(in, out)[0]; });
            const double extinction = species.extinction(mu)[0];
            EXPECT_NEAR(integral / extinction, 1, 10 * kExtinctionRelativeError)
                << "alpha " << alpha << ", mu " << mu;
        }
    }
}

TEST(Flakes, LeaningOnesScatterWhatTheyTakeFromTheLight) {
    for (const std::array<double, 2> lean : {std::array{0.1, 0.0}, std::array{-0.12, 0.2}}) {
        Flakes species = flakes_of(0.2, 1, 0);
        species.lean = FlakeFrame(lean);
        for (double mu : {0.2, 0.5, 0.97}) {
            const Vec3d in = at_cosine(-mu, 0.3);
            const double integral = integrate_sphere(
                in, [&](const Vec3d& out) { return species.scattering(in, out)[0]; });
            EXPECT_NEAR(integral / species.extinction(-1.0 * in)[0], 1,
                        10 * kExtinctionRelativeError)
                << "lean " << lean[0] << ", mu " << mu;
        }
    }
}

// Two ways to one number: the quadrature, and the normals that walks draw.
TEST(Flakes, ExtinctionOfLeaningOnesIsTheMeanOverTheNormalsThatAreDrawn) {
    Flakes species = flakes_of(0.25, 0.2, 0.4);
    species.lean = FlakeFrame({0.15, -0.1});
    RandomStream random(3, 1, 4);
    for (const Vec3d& w : {at_cosine(0.9, 0.2), at_cosine(0.4, 2.8), at_cosine(0.1, 3.6)}) {
        test::Sample area;
        for (int i = 0; i < 400'000; ++i) {
            const Vec3d m = sample_beckmann_normal(species.alpha, species.lean, random);
            area.add(0.6 * std::abs(dot(w, m)));
        }
        EXPECT_NEAR(species.extinction(w)[0], area.mean(), test::kWorstZ * area.error());
    }
    // Turned together nothing changes, and leaning along w is not leaning away.
    Flakes turned = species;
    turned.lean = FlakeFrame({0.1, 0.15});  // by 90 deg
    EXPECT_NEAR(turned.extinction(at_cosine(0.4, 2.8 + std::numbers::pi / 2))[0],
                species.extinction(at_cosine(0.4, 2.8))[0], 1e-9);
    EXPECT_GT(species.extinction(at_cosine(0.4, 0))[0],
              1.3 * species.extinction(at_cosine(0.4, std::numbers::pi))[0]);
}

TEST(Flakes, ScatteringIsReciprocal) {
    const Flakes species = flakes_of(.2, .8, .1);
    const Vec3d in = at_cosine(-.9, 0), out = at_cosine(.7, .3);
    const double forward = species.scattering(in, out)[0];
    EXPECT_GT(forward, 0.01);
    EXPECT_NEAR(species.scattering(-out, -in)[0], forward, 1e-15);
}

TEST(Flakes, ForwardDirectionIsNotScattered) {
    const Flakes species = flakes_of(.2, .8, .1);
    const Vec3d level(0.6, 0.8, 0);
    EXPECT_EQ(species.scattering(level, level)[0], 0);
    EXPECT_EQ(species.scattering(level, -level)[0], 0) << "its normal would lie in the plane";
}

TEST(Flakes, TableOfAPlateletKeepsToTheTransferMatrix) {
    paint::FlakeSpecies species;
    species.amount = paint::AreaDensity{1};
    optics::Platelet body;
    body.core = {optics::Material(1.58), 500, {}};
    body.coats = {{optics::Material(2.5), 150, {}}};
    species.body = body;
    const optics::Material binder(1.5);
    const std::array<double, 3> wavelengths{400, 550, 700};
    const FlakeOptics flake(species, binder, wavelengths);
    std::vector<double> cosines;  // between the nodes, where a linear table is worst
    for (int i = 0; i < kPlateletTableIntervals; i += 3)
        cosines.push_back((i + 0.5) / kPlateletTableIntervals);
    const auto exact = optics::platelet_table(body, binder, cosines, wavelengths);
    double worst = 0;
    for (std::size_t i = 0; i < cosines.size(); ++i) {
        for (std::size_t j = 0; j < wavelengths.size(); ++j) {
            worst = test::worse(worst, std::abs(flake.reflectance(cosines[i])[j] -
                                                exact.reflectance[i * wavelengths.size() + j]));
            worst = test::worse(worst, std::abs(flake.transmittance(cosines[i])[j] -
                                                exact.transmittance[i * wavelengths.size() + j]));
        }
    }
    EXPECT_LT(worst, kPlateletTableError);
    EXPECT_GT(worst, 0);
}

// Eight wavelengths of red iron oxide.
Pigment red_oxide() {
    paint::Recipe recipe = test::paint_of(1.5, {{10, {}, {}}});
    recipe.layers[0].pigments = {{paint::PigmentParticles{
        paint::PigmentVolume{0.05}, {optics::find_material("Fe2O3"), 400, 0.2}}}};
    const std::vector<double> wavelengths{400, 440, 480, 520, 560, 600, 650, 700};
    return Medium(recipe, wavelengths).slabs[0].pigments[0];
}

TEST(PhaseTable, IntegratesToOneInEveryLane) {
    const Pigment pigment = red_oxide();
    const auto& density = pigment.phase->density();
    for (int lane = 0; lane < kLanes; ++lane) {
        double sum = 0;
        for (std::size_t i = 1; i < density.size(); ++i) {
            const int node = static_cast<int>(i);
            sum += std::numbers::pi * (density[i - 1][lane] + density[i][lane]) *
                   (optics::PhaseFunction::node_cosine(node - 1) -
                    optics::PhaseFunction::node_cosine(node));
        }
        EXPECT_NEAR(sum, 1, 1e-12);
    }
}

TEST(PhaseTable, DrawsTheCosineOfEachFraction) {
    const Pigment pigment = red_oxide();
    for (const int lane : {0, 7}) {
        EXPECT_NEAR(pigment.phase->cosine(lane, 0), 1, 1e-12);
        EXPECT_NEAR(pigment.phase->cosine(lane, 1), -1, 1e-9);
        // d fraction = -2 pi p d cosine
        for (double f = 0.05; f < 1; f += 0.1) {
            constexpr double kStep = 1e-6;
            const double c = pigment.phase->cosine(lane, f);
            const double slope =
                (pigment.phase->cosine(lane, f - kStep) - pigment.phase->cosine(lane, f + kStep)) /
                (2 * kStep);
            EXPECT_NEAR(slope * 2 * std::numbers::pi * pigment.phase_value(c)[lane], 1, 1e-3);
        }
    }
}

// Weights, directions: the light of every wavelength goes where its own phase function says.
TEST(SamplePigment, TurnsEachWavelengthByItsOwnPhaseFunction) {
    const Pigment pigment = red_oxide();
    const Lanes start = make_lanes<Lanes>([](int i) { return i == 3 ? 0.0 : 0.5 + 0.1 * i; });
    const Vec3d in = at_cosine(0.4, 1);
    RandomStream random(5, 0, 0);
    constexpr int kCount = 200'000;
    std::array<double, kLanes> sum{}, square{}, light{};
    for (int k = 0; k < kCount; ++k) {
        Lanes weight = start;
        const double cosine = dot(in, sample_pigment(pigment, in, weight, random));
        ASSERT_NEAR(lane_sum(weight), lane_sum(start), 1e-12);
        for (int i = 0; i < kLanes; ++i) {
            sum[i] += weight[i] * cosine;
            square[i] += weight[i] * cosine * weight[i] * cosine;
            light[i] += weight[i];
        }
    }
    for (int i = 0; i < kLanes; ++i) {
        const double mean_cosine = integrate_sphere(in, [&](const Vec3d& out) {
            return dot(in, out) * pigment.phase_value(dot(in, out))[i];
        });
        const double mean = sum[i] / kCount;
        const double error = std::sqrt((square[i] / kCount - mean * mean) / kCount);
        // 16 means: one in 20000 beyond four standard errors.
        EXPECT_NEAR(mean, start[i] * mean_cosine, 4 * error + 1e-4);
        EXPECT_NEAR(light[i] / kCount, start[i], 4 * 2 / std::sqrt(1.0 * kCount));
    }
}

TEST(Pigment, ScatteringIntegratesToItsRateWithItsMeanCosine) {
    for (double g : {-0.5, 0.0, 0.7}) {
        Pigment pigment{Lanes{}, g};
        pigment.scattering_per_um[0] = 0.2;
        const Vec3d in = at_cosine(0.4, 1);
        const auto scattering = [&](const Vec3d& out) { return pigment.scattering(in, out)[0]; };
        EXPECT_NEAR(integrate_sphere(in, scattering), 0.2, 1e-12);
        EXPECT_NEAR(
            integrate_sphere(in, [&](const Vec3d& out) { return dot(in, out) * scattering(out); }),
            0.2 * g, 1e-12);
    }
}

}  // namespace

namespace {

/// Every quantity different at every wavelength.
paint::Recipe coloured_paint() {
    paint::Layer layer = test::flake_layer(1, 0.1, 0, 0);
    optics::Platelet platelet;
    platelet.core = {optics::find_material("mica"), 400, {50}};
    platelet.coats = {{optics::find_material("TiO2_anatase"), 80, {}}};
    layer.flakes[0].body = platelet;
    const spectra::Spectrum rising({400, 700}, {1, 4});
    layer.pigments = {{paint::PigmentCoefficients{rising, 0.5, 0.2}},
                      {paint::PigmentCoefficients{3.0, rising, 0.0}},
                      {paint::PigmentParticles{paint::PigmentVolume{0.01},
                                               {optics::find_material("Fe2O3"), 200, 0.2}}}};
    paint::Recipe recipe = test::paint_of(1.5, {layer});
    recipe.substrate_reflectance = spectra::Spectrum({400, 700}, {0.1, 0.7});
    recipe.clearcoat = paint::Clearcoat{20, rising, 0};
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
        for (std::size_t k = 0; k < p.pigments.size(); ++k) {
            near(p.pigments[k].scattering_per_um, q.pigments[k].scattering_per_um);
            ASSERT_EQ(!p.pigments[k].phase, !q.pigments[k].phase);
            if (!p.pigments[k].phase) continue;
            for (double c : {-0.9, 0.1, 0.99}) {
                near(p.pigments[k].phase_value(c), q.pigments[k].phase_value(c));
            }
        }
    }
}

TEST(MediumGrid, OnItsWavelengthsItIsTheMediumItself) {
    const paint::Recipe recipe = coloured_paint();
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
    const paint::Recipe recipe = coloured_paint();
    EXPECT_THROW(MediumGrid(recipe, {}), DomainError);
    EXPECT_THROW(MediumGrid(recipe, {500, 490}), DomainError);
    EXPECT_THROW(MediumGrid(recipe, {500, NAN}), DomainError);
}

}  // namespace
}  // namespace nacre::montecarlo
