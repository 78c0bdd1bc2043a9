#include "nacre/montecarlo/reference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <tbb/task_arena.h>

#include <array>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

#include "nacre/core/error.h"
#include "nacre/core/quadrature.h"
#include "nacre/optics/fresnel.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/h_function.h"
#include "nacre/testing/montecarlo.h"

namespace nacre::montecarlo {
namespace {

using nacre::test::message_of;
using test::brdf;
using test::kGreen;
using test::kWorstZ;
using test::worked_paint;

const std::vector<Direction> kWorkedOutgoing{{15, 180}, {30, 180}, {45, 180}, {60, 180},
                                             {75, 180}, {0, 0},    {30, 90},  {45, 0}};
// The worked example of docs/microflake.md, by two independent methods that agree within their
// error.
constexpr double kWorkedTotal[] = {0.0986750, 0.660157,   1.21809,    0.879130,
                                   0.403080,  0.00615526, 0.00147852, 2.5171e-5};
constexpr double kWorkedSingle[] = {0.0850942, 0.630615,   1.17416, 0.828999,
                                    0.361052,  0.00215988, 5.74e-5, 6.68e-13};
constexpr double kWorkedRelativeError = 2e-4;  // of the table; its last value has fewer digits

TEST(Reference, MatchesTheWorkedValuesOfTheTotal) {
    const auto found = brdf(worked_paint(), {45, 0}, kWorkedOutgoing, {.samples = 400'000});
    ASSERT_EQ(found.size(), kWorkedOutgoing.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_LT(
            std::abs(z_score(found[i], kWorkedTotal[i], kWorkedRelativeError * kWorkedTotal[i])),
            kWorstZ)
            << "theta_o " << kWorkedOutgoing[i].theta_deg << ": " << found[i].value << " +- "
            << found[i].standard_error;
        if (i < 5) {
            EXPECT_LT(found[i].standard_error, 5e-3 * found[i].value);
        }
    }
}

TEST(Reference, MatchesTheWorkedValuesOfSingleScattering) {
    const auto found =
        brdf(worked_paint(), {45, 0}, kWorkedOutgoing, {.samples = 200'000, .part = Part::single});
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_LT(std::abs(z_score(found[i], kWorkedSingle[i], 2e-3 * kWorkedSingle[i])), kWorstZ)
            << "theta_o " << kWorkedOutgoing[i].theta_deg << ": " << found[i].value << " +- "
            << found[i].standard_error;
    }
}

TEST(Reference, PartsAddUpToTheTotal) {
    auto recipe = test::paint_of(1.5, {test::flake_layer(1, .3, .6, .2)}, 0.5);
    recipe.layers[0].pigments.push_back({paint::PigmentCoefficients{20.0, 5.0, 0.3}});
    const std::vector<Direction> outgoing{{30, 180}, {60, 70}};
    const auto part = [&](Part p, std::uint64_t seed) {
        return brdf(recipe, {40, 0}, outgoing, {.samples = 60'000, .seed = seed, .part = p});
    };
    const auto total = part(Part::total, 1), single = part(Part::single, 2),
               multiple = part(Part::multiple, 3);
    for (std::size_t i = 0; i < outgoing.size(); ++i) {
        const Estimate sum{single[i].value + multiple[i].value,
                           std::hypot(single[i].standard_error, multiple[i].standard_error)};
        EXPECT_LT(std::abs(z_score(sum, total[i])), kWorstZ);
        EXPECT_GT(single[i].value, 0);
        EXPECT_GT(multiple[i].value, 0);
    }
}

/// BRDF of an isotropically scattering half space.           [chandrasekhar-1960, chapter V]
class IsotropicHalfSpace {
 public:
    explicit IsotropicHalfSpace(double albedo)
        : albedo_(albedo), h_([albedo](double) { return albedo / 2; }) {}
    double brdf(double mu_i, double mu_o) const {
        return albedo_ / (4 * std::numbers::pi) * h_(mu_i) * h_(mu_o) / (mu_i + mu_o);
    }

 private:
    double albedo_;
    test::HFunction h_;
};

TEST(Reference, MatchesChandrasekharsHalfSpace) {
    const IsotropicHalfSpace h(.9);
    EXPECT_NEAR(h.brdf(1, 1), 0.122572, 1e-6) << "the oracle against its published value";
    EXPECT_NEAR(h.brdf(1, .5), 0.137453, 1e-6);
    const auto recipe = test::paint_of(1, {test::pigment_layer(.9, 100, 0)});
    const std::vector<Direction> outgoing{{0, 0}, {60, 0}, {60, 123}, {85, 0}, {30, 180}};
    for (double theta_i : {0.0, 70.0}) {
        const auto found = brdf(recipe, {theta_i, 0}, outgoing, {.samples = 60'000});
        const auto cosine = [](double deg) { return std::cos(deg * std::numbers::pi / 180); };
        for (std::size_t i = 0; i < outgoing.size(); ++i) {
            const double expected = h.brdf(cosine(theta_i), cosine(outgoing[i].theta_deg));
            EXPECT_LT(std::abs(z_score(found[i], expected)), kWorstZ)
                << found[i].value << " for " << expected;
        }
    }
}

TEST(Reference, HelmholtzReciprocityHolds) {
    auto recipe = test::paint_of(
        1.5, {test::flake_layer(1, .3, .6, .2), test::pigment_layer(.8, 1, .4)}, 0.7);
    recipe.clearcoat = paint::Clearcoat{40, 2.0, 0};
    const Direction a{20, 0}, b{65, 150};
    const auto there = brdf(recipe, a, {b}, {.samples = 80'000, .seed = 5});
    const auto back = brdf(recipe, b, {a}, {.samples = 80'000, .seed = 6});
    EXPECT_LT(std::abs(z_score(there[0], back[0])), kWorstZ)
        << there[0].value << ' ' << back[0].value;
    EXPECT_LT(there[0].standard_error, 0.01 * there[0].value);
}

TEST(Reference, BrdfIntegratesToTheAlbedo) {
    // Two estimators of the same walks: next-event estimation and escapes through the interface.
    const auto recipe = test::paint_of(
        1.5, {test::flake_layer(1, .5, .6, .2), test::pigment_layer(.9, 2, .2)}, 0.3);
    const Direction incident{50, 0};
    const Quadrature mu = gauss_legendre(12, 0, 1);
    constexpr int kPhiSteps = 24;
    std::vector<Direction> outgoing;
    for (double m : mu.nodes)
        for (int k = 0; k < kPhiSteps; ++k)
            outgoing.push_back({test::degrees_of_cosine(m), 360.0 * (k + 0.5) / kPhiSteps});
    const auto found = brdf(recipe, incident, outgoing, {.samples = 2'000});
    Estimate integral;
    for (std::size_t i = 0; i < outgoing.size(); ++i) {
        const std::size_t j = i / kPhiSteps;
        const double weight = mu.weights[j] * mu.nodes[j] * 2 * std::numbers::pi / kPhiSteps;
        integral.value += weight * found[i].value;
        integral.standard_error += weight * found[i].standard_error;  // a bound
    }
    const Albedo albedo =
        reference_albedo(recipe, std::vector{incident}, kGreen, {.samples = 200'000, .seed = 9})
            .at(0);
    const double specular = optics::dielectric_reflectance(
        1.0, 1.5, std::cos(incident.theta_deg * std::numbers::pi / 180));
    EXPECT_LT(
        std::abs(z_score(albedo.reflectance, integral.value + specular, integral.standard_error)),
        kWorstZ);
    EXPECT_LT(integral.standard_error, 0.03 * integral.value);
}

TEST(Reference, WavelengthsWalkTogetherAsTheyWouldAlone) {
    // Eight wavelengths from black to white, for which the same walk has very different
    // probability.
    const std::vector<double> wavelengths{400, 440, 480, 520, 560, 600, 640, 680};
    const spectra::Spectrum rising({400, 680}, {0.02, 0.9});
    const spectra::Spectrum falling({400, 680}, {0.5, 0.05});
    paint::Layer layer;
    layer.thickness_um = 20;
    layer.flakes.push_back(test::flakes(.1, .3, rising, 0.05));
    layer.pigments.push_back({paint::PigmentCoefficients{
        spectra::Spectrum({400, 680}, {200, 2}), spectra::Spectrum({400, 680}, {1, 100}), 0.2}});
    auto recipe = test::paint_of(1.5, {layer});
    recipe.substrate_reflectance = falling;
    const std::vector<Direction> incident{{45, 0}}, outgoing{{30, 180}};
    const auto together =
        reference_brdf(recipe, incident, outgoing, wavelengths, {.samples = 80'000, .seed = 1});
    ASSERT_EQ(together.size(), wavelengths.size());
    for (std::size_t i = 0; i < wavelengths.size(); ++i) {
        const auto alone =
            reference_brdf(recipe, incident, outgoing, std::vector<double>{wavelengths[i]},
                           {.samples = 20'000, .seed = 2 + i});
        EXPECT_LT(std::abs(z_score(together[i], alone[0])), kWorstZ)
            << wavelengths[i] << " nm: " << together[i].value << ' ' << alone[0].value;
        EXPECT_LT(together[i].standard_error, 0.02 * together[i].value);
    }
}

TEST(Reference, DispersiveBinderRefractsEachWavelengthByItself) {
    auto recipe = test::paint_of(1, {test::flake_layer(1, .2, .6, .1)});
    recipe.binder = optics::Material("resin", std::vector<double>{400, 700},
                                     std::vector<optics::ComplexIndex>{1.6, 1.4});
    const std::vector<Direction> incident{{45, 0}}, outgoing{{60, 180}};
    const std::vector<double> wavelengths{400, 700};
    const ReferenceSettings settings{.samples = 50'000};
    const auto found = reference_brdf(recipe, incident, outgoing, wavelengths, settings);
    for (std::size_t i = 0; i < wavelengths.size(); ++i) {
        auto plain = recipe;
        plain.binder = recipe.binder.index(wavelengths[i]);
        const auto alone =
            reference_brdf(plain, incident, outgoing, kGreen, {.samples = 50'000, .seed = 7});
        EXPECT_LT(std::abs(z_score(found[i], alone[0])), kWorstZ);
    }
}

}  // namespace

// The contract of the functions: order, determinism, errors, progress.

namespace {

using test::brdf;
using test::kGreen;
using test::kWorstZ;
using test::worked_paint;

TEST(Reference, ManyOutgoingDirectionsKeepTheirOrder) {
    // More than one walk serves: two directions in turns, so that a slip shows.
    std::vector<Direction> outgoing;
    for (int i = 0; i < 700; ++i) {
        outgoing.push_back({45, 180});
        outgoing.push_back({60, 180});
    }
    const auto found = brdf(worked_paint(), {45, 0}, outgoing, {.samples = 3000});
    ASSERT_EQ(found.size(), outgoing.size());
    EXPECT_EQ(found[0].value, found[2].value) << "the same walks";
    EXPECT_NE(found[0].value, found[1398].value) << "other walks";
    EXPECT_LT(std::abs(z_score(found[0], found[1398])), kWorstZ);
    EXPECT_LT(std::abs(z_score(found[1], found[1399])), kWorstZ);
    EXPECT_GT(found[0].value, 1.2 * found[1].value);
}

TEST(Reference, ThreadsDoNotChangeTheResult) {
    const auto run = [](int threads) {
        tbb::task_arena arena(threads);
        return arena.execute([] {
            return brdf(worked_paint(), {45, 0}, {{30, 180}, {45, 180}, {30, 90}},
                        {.samples = 20'001, .seed = 42});
        });
    };
    const auto one = run(1), two = run(2);
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].value, two[i].value);
        EXPECT_EQ(one[i].standard_error, two[i].standard_error);
    }
}

TEST(Reference, SeedsAreIndependentAndTheirScatterIsTheStandardError) {
    // Sum of z^2 over 64 seeds against their common mean: chi-square with 63 degrees of freedom,
    // within four of its standard deviations, sqrt(126).
    constexpr int kSeeds = 64;
    std::vector<Estimate> found;
    double mean = 0;
    for (int seed = 0; seed < kSeeds; ++seed) {
        found.push_back(brdf(worked_paint(), {45, 0}, {{45, 180}},
                             {.samples = 2000, .seed = static_cast<std::uint64_t>(seed)})[0]);
        mean += found.back().value / kSeeds;
    }
    double chi_square = 0;
    for (const Estimate& e : found) chi_square += std::pow(z_score(e, mean), 2);
    EXPECT_NEAR(chi_square, kSeeds - 1, 4 * std::sqrt(2.0 * (kSeeds - 1)));
}

TEST(Reference, ReportsProgressAndStopsWhenAsked) {
    double last = 0;
    reference_brdf(worked_paint(), std::vector<Direction>{{45, 0}, {10, 0}},
                   std::vector<Direction>{{45, 180}}, kGreen, {.samples = 1000},
                   [&](double fraction) {
                       EXPECT_GE(fraction, last);
                       last = fraction;
                       return true;
                   });
    EXPECT_DOUBLE_EQ(last, 1);
    int calls = 0;
    EXPECT_THROW(reference_brdf(worked_paint(), std::vector<Direction>{{45, 0}},
                                std::vector<Direction>{{45, 180}}, kGreen, {.samples = 100'000},
                                [&](double) { return ++calls < 3; }),
                 Error);
    EXPECT_EQ(calls, 3);
}

// One block of long walks: the callback is asked within it.
TEST(Reference, AsksWithinABlockOfLongWalks) {
    const auto recipe = test::paint_of(1, {test::flake_layer(300, .5, 1, 0)});
    int calls = 0;
    EXPECT_THROW(reference_albedo(recipe, std::vector<Direction>{{45, 0}}, kGreen,
                                  {.samples = 1'000'000'000}, [&](double) { return ++calls < 2; }),
                 Error);
    EXPECT_EQ(calls, 2);
}

TEST(Reference, StopsWhileFilmsAreComputed) {
    int calls = 0;
    const Progress never = [&](double) { return ++calls < 1; };
    EXPECT_EQ(message_of<Stopped>([&] {
                  reference_albedo(test::pearl(), std::vector<Direction>{{45, 0}}, kGreen,
                                   {.samples = 1000}, never);
              }),
              "computing the films of a flake was stopped");
    EXPECT_EQ(calls, 1);
}

TEST(Reference, AnInterruptEndsAWalk) {
    const InterruptHandler handler;
    raise(SIGINT);
    EXPECT_THROW(brdf(worked_paint(), {45, 0}, {{45, 180}}, {.samples = 10}), Stopped);
}

TEST(Reference, RefusesArgumentsOutOfRangeByName) {
    using testing::HasSubstr;
    const auto ask = [](Direction in, Direction out, std::uint64_t samples) {
        return message_of<DomainError>(
            [&] { brdf(worked_paint(), in, {out}, {.samples = samples}); });
    };
    EXPECT_THAT(ask({90, 0}, {0, 0}, 10), HasSubstr("incident direction = 90"));
    EXPECT_THAT(ask({0, 0}, {-1, 0}, 10), HasSubstr("outgoing direction = -1"));
    EXPECT_THAT(ask({0, std::numeric_limits<double>::infinity()}, {0, 0}, 10), HasSubstr("phi"));
    EXPECT_THAT(ask({0, 0}, {0, 0}, 1), HasSubstr("samples = 1"));
    paint::Recipe no_layers = worked_paint();
    no_layers.layers.clear();
    no_layers.microfacet.emplace();
    EXPECT_THAT(message_of<DomainError>([&] {
                    brdf(no_layers, {0, 0}, {{0, 0}}, {.samples = 10});
                }),
                HasSubstr("layer: is missing"));
}

TEST(Reference, EmptyRequestsGiveEmptyAnswers) {
    EXPECT_TRUE(reference_brdf(worked_paint(), {}, {}, kGreen, {}).empty());
}

}  // namespace

// Plane albedos against published slabs and closed forms.

namespace {

using test::kWorstZ;

Albedo albedo_of(const paint::Recipe& recipe, double mu, std::uint64_t samples,
                 std::uint64_t seed = 1) {
    const std::vector<Direction> incident{{test::degrees_of_cosine(mu), 0}};
    return reference_albedo(recipe, incident, std::vector<double>{550},
                            {.samples = samples, .seed = seed})
        .at(0);
}

// Printed with five or six digits: half of the last one is below a hundredth of a standard error.

TEST(PigmentSlab, MatchesTablesOfReflectanceAndTransmittance) {
    struct Case {
        double albedo, depth, anisotropy, mu, reflectance, transmittance;
    };
    // Without an interface [van-de-hulst-1980; prahl-1993].
    constexpr Case kCases[] = {
        {.9, 2, .75, 1, .097395, .660958},  {.99, 1, 0, .5, .486518, .491628},
        {.99, 4, .5, .5, .619959, .306051}, {1, 1, 0, 1, .341329, .658671},
        {.9, 1, 0, 1, .267410, .591625},
    };
    for (const Case& c : kCases) {
        const auto recipe =
            test::paint_of(1, {test::pigment_layer(c.albedo, c.depth, c.anisotropy)});
        const Albedo albedo = albedo_of(recipe, c.mu, 140'000);
        EXPECT_LT(std::abs(z_score(albedo.reflectance, c.reflectance)), kWorstZ)
            << c.albedo << ' ' << c.depth << ' ' << albedo.reflectance.value;
        EXPECT_LT(std::abs(z_score(albedo.absorbed_by_substrate, c.transmittance)), kWorstZ)
            << c.albedo << ' ' << c.depth << ' ' << albedo.absorbed_by_substrate.value;
    }
}

TEST(PigmentSlab, SemiInfiniteUnderAnInterfaceMatchesTheTable) {
    const auto recipe = test::paint_of(1.5, {test::pigment_layer(.9, 100, 0)});
    const Albedo albedo = albedo_of(recipe, 1, 140'000);
    EXPECT_LT(std::abs(z_score(albedo.reflectance, .25992)), kWorstZ) << albedo.reflectance.value;
}

TEST(FlakeSlab, MatchesAddingDoubling) {
    struct Case {
        double index, alpha, beta, reflectance, transmittance, mu, total_reflected, transmitted;
    };
    // By adding-doubling and Monte Carlo (docs/solver.md); transmitted < 0: not known. At index 1.5
    // the total includes specular reflection.
    constexpr Case kCases[] = {
        {1, .1, 2, 1, 0, .8, .66557, .33443},
        {1, .1, 2, .6, 0, .8, .32101, .18172},
        {1.5, .2, 2, 1, 0, .9, .58769, -1},
        {1.5, .3, 4, .6, 0, .95, .27608, -1},
    };
    for (const Case& c : kCases) {
        const auto recipe = test::paint_of(
            c.index, {test::flake_layer(c.beta, c.alpha, c.reflectance, c.transmittance)});
        const Albedo albedo = albedo_of(recipe, c.mu, 140'000);
        EXPECT_LT(std::abs(z_score(albedo.reflectance, c.total_reflected)), kWorstZ)
            << c.index << ' ' << c.alpha << ' ' << albedo.reflectance.value;
        if (c.transmitted >= 0) {
            EXPECT_LT(std::abs(z_score(albedo.absorbed_by_substrate, c.transmitted)), kWorstZ)
                << c.index << ' ' << c.alpha << ' ' << albedo.absorbed_by_substrate.value;
        }
    }
}

TEST(FlakeSlab, NearlyFlatFlakesObeyKubelkaAndMunk) {
    // S = R, K = 1 - R - T, depth beta, light and flakes along one line.  [kubelka-1948]
    constexpr double kAlpha = 0.005;  // deviates from the line by some alpha^2, far below the noise
    struct Case {
        double beta, reflectance, transmittance;
    };
    for (const Case& c : {Case{2, .7, .3}, Case{.5, .2, .8}, Case{3, .6, .1}}) {
        const double k_over_s = (1 - c.reflectance - c.transmittance) / c.reflectance;
        const double a = 1 + k_over_s, b = std::sqrt(a * a - 1);
        const double depth = c.beta * c.reflectance;
        const double expected = b < 1e-6 ? depth / (1 + depth) : 1 / (a + b / std::tanh(b * depth));
        const auto recipe =
            test::paint_of(1, {test::flake_layer(c.beta, kAlpha, c.reflectance, c.transmittance)});
        const Albedo albedo = albedo_of(recipe, 1, 140'000);
        EXPECT_LT(std::abs(z_score(albedo.reflectance, expected)), kWorstZ)
            << albedo.reflectance.value << ' ' << expected;
    }
}

TEST(FlakeSlab, LosslessFlakesLoseNoLight) {
    for (double index : {1.0, 1.5}) {
        const auto recipe = test::paint_of(index, {test::flake_layer(1.5, .3, .7, .3)});
        const Albedo albedo = albedo_of(recipe, .6, 35'000);
        const double sum = albedo.reflectance.value + albedo.absorbed_by_substrate.value;
        // Roulette alone makes the sum fluctuate, so the two errors bound its own.
        const double error =
            albedo.reflectance.standard_error + albedo.absorbed_by_substrate.standard_error;
        EXPECT_NEAR(sum, 1, kWorstZ * error) << "index " << index;
    }
}

TEST(FlakeSlab, ThickLosslessFlakesReflectEverything) {
    const auto recipe = test::paint_of(1, {test::flake_layer(300, .5, 1, 0)});
    const Albedo albedo = albedo_of(recipe, .8, 5'000);
    EXPECT_GT(albedo.reflectance.value, 0.985);  // some 1/300 is transmitted
    EXPECT_NEAR(albedo.reflectance.value + albedo.absorbed_by_substrate.value, 1, 1e-9);
}

TEST(FlakeSlab, LosslessPaintOverWhiteReflectsEverything) {
    const auto recipe = test::paint_of(1.5, {test::flake_layer(1, .2, .4, .6)}, 1.0);
    const Albedo albedo = albedo_of(recipe, .7, 20'000);
    EXPECT_LT(std::abs(z_score(albedo.reflectance, 1)), kWorstZ) << albedo.reflectance.value;
    EXPECT_EQ(albedo.absorbed_by_substrate.value, 0);
}

TEST(Clearcoat, AbsorbsByBeerAndLambert) {
    // Black below: what reaches the substrate went once through the coat at the refracted angle.
    paint::Recipe recipe = test::paint_of(1, {test::flake_layer(1e-6, .1, 0, 1)});
    recipe.clearcoat = paint::Clearcoat{45, 20.0, 0};
    const Albedo albedo = albedo_of(recipe, .5, 1000);
    EXPECT_NEAR(albedo.absorbed_by_substrate.value, std::exp(-0.045 * 20 / .5), 1e-12);
    EXPECT_EQ(albedo.reflectance.value, 0);
}

TEST(PigmentSlab, DeepAbsorptionOverAWhiteSubstrateFollowsBeerAndLambert) {
    // Nothing scatters but the substrate: exp(-depth) down, and the mean of exp(-depth / mu) over
    // Lambert's law up. Most walks end by Russian roulette on their way, and must contribute
    // nothing.
    constexpr double kDepth = 1.5;
    const auto recipe = test::paint_of(1, {test::pigment_layer(0, kDepth, 0)}, 1);
    const Albedo albedo = albedo_of(recipe, 1, 140'000);
    const Quadrature mu = gauss_legendre(64, 0, 1);
    double up = 0;
    for (std::size_t i = 0; i < mu.nodes.size(); ++i)
        up += 2 * mu.weights[i] * mu.nodes[i] * std::exp(-kDepth / mu.nodes[i]);
    const double expected = std::exp(-kDepth) * up;
    EXPECT_LT(std::abs(z_score(albedo.reflectance, expected)), kWorstZ)
        << albedo.reflectance.value << " against " << expected;
    EXPECT_LT(albedo.reflectance.standard_error, 0.01 * expected);
}

}  // namespace
}  // namespace nacre::montecarlo
