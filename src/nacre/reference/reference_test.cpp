#include "nacre/reference/reference.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "nacre/core/quadrature.h"
#include "nacre/optics/dielectric.h"
#include "nacre/reference/test_support.h"

namespace nacre::reference {
namespace {

using test::brdf;
using test::kGreen;
using test::kWorstZ;
using test::worked_paint;
using test::z_score;

const std::vector<Direction> kWorkedOutgoing{{15, 180}, {30, 180}, {45, 180}, {60, 180},
                                             {75, 180}, {0, 0},    {30, 90},  {45, 0}};
// By two independent methods that agree within their error (DESIGN section 2.4).
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
            << "theta_o " << kWorkedOutgoing[i].theta_deg << ": " << found[i].mean << " +- "
            << found[i].standard_error;
        if (i < 5) {
            EXPECT_LT(found[i].standard_error, 5e-3 * found[i].mean);
        }
    }
}

TEST(Reference, MatchesTheWorkedValuesOfSingleScattering) {
    const auto found =
        brdf(worked_paint(), {45, 0}, kWorkedOutgoing, {.samples = 200'000, .part = Part::single});
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_LT(std::abs(z_score(found[i], kWorkedSingle[i], 2e-3 * kWorkedSingle[i])), kWorstZ)
            << "theta_o " << kWorkedOutgoing[i].theta_deg << ": " << found[i].mean << " +- "
            << found[i].standard_error;
    }
}

TEST(Reference, PartsAddUpToTheTotal) {
    auto recipe = test::paint(1.5, {test::flake_layer(1, .3, .6, .2)}, 0.5);
    recipe.layers[0].pigments.push_back({20.0, 5.0, 0.3});
    const std::vector<Direction> outgoing{{30, 180}, {60, 70}};
    const auto part = [&](Part p, std::uint64_t seed) {
        return brdf(recipe, {40, 0}, outgoing, {.samples = 60'000, .seed = seed, .part = p});
    };
    const auto total = part(Part::total, 1), single = part(Part::single, 2),
               multiple = part(Part::multiple, 3);
    for (std::size_t i = 0; i < outgoing.size(); ++i) {
        const Estimate sum{single[i].mean + multiple[i].mean,
                           std::hypot(single[i].standard_error, multiple[i].standard_error)};
        EXPECT_LT(std::abs(z_score(sum, total[i])), kWorstZ);
        EXPECT_GT(single[i].mean, 0);
        EXPECT_GT(multiple[i].mean, 0);
    }
}

/// Chandrasekhar's H for isotropic scattering, by iteration of its integral equation in the form
/// that converges fast:  1/H = sqrt(1 - a) + a/2 Int x H(x)/(mu + x) dx.
///                                                        [chandrasekhar-1960, chapter V]
class ChandrasekharH {
 public:
    explicit ChandrasekharH(double albedo)
        : albedo_(albedo), rule_(gauss_legendre(64, 0, 1)), h_(rule_.nodes.size(), 1.0) {
        for (int iteration = 0; iteration < 400; ++iteration) {
            std::vector<double> next;
            for (double mu : rule_.nodes) next.push_back((h_[next.size()] + (*this)(mu)) / 2);
            h_ = next;
        }
    }
    double operator()(double mu) const {
        double integral = 0;
        for (std::size_t i = 0; i < h_.size(); ++i)
            integral += rule_.weights[i] * rule_.nodes[i] * h_[i] / (mu + rule_.nodes[i]);
        return 1 / (std::sqrt(1 - albedo_) + albedo_ / 2 * integral);
    }
    /// BRDF of the half space.
    double brdf(double mu_i, double mu_o) const {
        return albedo_ / (4 * std::numbers::pi) * (*this)(mu_i) * (*this)(mu_o) / (mu_i + mu_o);
    }

 private:
    double albedo_;
    Quadrature rule_;
    std::vector<double> h_;
};

TEST(Reference, MatchesChandrasekharsHalfSpace) {
    const ChandrasekharH h(.9);
    EXPECT_NEAR(h.brdf(1, 1), 0.122572, 1e-6) << "the oracle against its published value";
    EXPECT_NEAR(h.brdf(1, .5), 0.137453, 1e-6);
    const auto recipe = test::paint(1, {test::pigment_layer(.9, 100, 0)});
    const std::vector<Direction> outgoing{{0, 0}, {60, 0}, {60, 123}, {85, 0}, {30, 180}};
    for (double theta_i : {0.0, 70.0}) {
        const auto found = brdf(recipe, {theta_i, 0}, outgoing, {.samples = 60'000});
        const auto cosine = [](double deg) { return std::cos(deg * std::numbers::pi / 180); };
        for (std::size_t i = 0; i < outgoing.size(); ++i) {
            const double expected = h.brdf(cosine(theta_i), cosine(outgoing[i].theta_deg));
            EXPECT_LT(std::abs(z_score(found[i], expected)), kWorstZ)
                << found[i].mean << " for " << expected;
        }
    }
}

TEST(Reference, HelmholtzReciprocityHolds) {
    auto recipe =
        test::paint(1.5, {test::flake_layer(1, .3, .6, .2), test::pigment_layer(.8, 1, .4)}, 0.7);
    recipe.clearcoat = layers::Clearcoat{40, 2.0, 0};
    const Direction a{20, 0}, b{65, 150};
    const auto there = brdf(recipe, a, {b}, {.samples = 80'000, .seed = 5});
    const auto back = brdf(recipe, b, {a}, {.samples = 80'000, .seed = 6});
    EXPECT_LT(std::abs(z_score(there[0], back[0])), kWorstZ)
        << there[0].mean << ' ' << back[0].mean;
    EXPECT_LT(there[0].standard_error, 0.01 * there[0].mean);
}

TEST(Reference, BrdfIntegratesToTheAlbedo) {
    // Two estimators of the same walks: next-event estimation and escapes through the interface.
    const auto recipe =
        test::paint(1.5, {test::flake_layer(1, .5, .6, .2), test::pigment_layer(.9, 2, .2)}, 0.3);
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
        integral.mean += weight * found[i].mean;
        integral.standard_error += weight * found[i].standard_error;  // a bound: as if in step
    }
    const Albedo albedo =
        reference_albedo(recipe, std::vector{incident}, kGreen, {.samples = 200'000, .seed = 9})
            .at(0);
    const double mirror = optics::dielectric_reflectance(
        1.0, 1.5, std::cos(incident.theta_deg * std::numbers::pi / 180));
    EXPECT_LT(
        std::abs(z_score(albedo.reflectance, integral.mean + mirror, integral.standard_error)),
        kWorstZ);
    EXPECT_LT(integral.standard_error, 0.03 * integral.mean);
}

TEST(Reference, WavelengthsWalkTogetherAsTheyWouldAlone) {
    // Eight wavelengths from black to white, for which the same walk has very different odds.
    const std::vector<double> wavelengths{400, 440, 480, 520, 560, 600, 640, 680};
    const spectra::Spectrum rising({400, 680}, {0.02, 0.9});
    const spectra::Spectrum falling({400, 680}, {0.5, 0.05});
    layers::Layer layer;
    layer.thickness_um = 20;
    layer.flakes.push_back(test::flakes(.1, .3, rising, 0.05));
    layer.pigments.push_back(
        {spectra::Spectrum({400, 680}, {200, 2}), spectra::Spectrum({400, 680}, {1, 100}), 0.2});
    auto recipe = test::paint(1.5, {layer});
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
            << wavelengths[i] << " nm: " << together[i].mean << ' ' << alone[0].mean;
        EXPECT_LT(together[i].standard_error, 0.02 * together[i].mean);
    }
}

TEST(Reference, DispersiveBinderRefractsEachWavelengthByItself) {
    auto recipe = test::paint(1, {test::flake_layer(1, .2, .6, .1)});
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
}  // namespace nacre::reference
