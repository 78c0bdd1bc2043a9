#include "nacre/optics/mie.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/quadrature.h"
#include "nacre/testing/errors.h"

namespace nacre::optics {
namespace {

struct KnownSphere {
    double size_parameter;
    ComplexIndex index;
    double extinction, scattering, asymmetry;
};

// miepython 3.3.0 (numpy 2.4.6): qext, qsca, qback, g = miepython.efficiencies_mx(n - 1j * k, x)
const KnownSphere kSpheres[] = {
    {1, {1.8, 0}, 0.528869955806378, 0.528869955806378, 0.237370598399499},
    {3.5, {1.8, 0}, 3.17323747087439, 3.17323747087439, 0.424516131214897},
    {12, {1.8, 0}, 2.25728530230521, 2.25728530230521, 0.655096263726478},
    {5, {0.75, 0}, 1.53849410818036, 1.53849410818036, 0.875259636378781},
    {2.5, {1.5, 0.1}, 2.57286999342239, 1.77027847056088, 0.740054940054544},
    {0.17, {1.158, 0.4}, 0.173167657024658, 0.000179472237172918, 0.00475317727816188},
    {3, {1.158, 0.4}, 1.95754283667133, 0.69328139430241, 0.805288503809947},
    {2, {1.9, 0.6}, 3.03912051070353, 1.41789247229775, 0.659816865927658},
    {60, {1.33, 1e-05}, 1.99812258111468, 1.99592597707128, 0.859059942035509},
    {200, {2.5, 1.5}, 2.06691380213045, 1.37122231005795, 0.768929884159469},
    {30, {1.05, 0}, 2.81916140183123, 2.81916140183123, 0.99224472728507},
    {0.02, {1.6, 0}, 4.99383074743521e-08, 4.99383074743521e-08, 8.32599493143443e-05},
};

TEST(Mie, ASphereOfTheMediumsIndexScattersNothing) {
    for (const double x : {1e-6, 1e-3, 0.1, 1.0, 3.7, 100.0, 1e4}) {
        const MieEfficiencies e = MieSeries(x, 1).efficiencies();
        EXPECT_EQ(e.scattering, 0) << x;
        EXPECT_EQ(e.extinction, 0) << x;
        EXPECT_EQ(e.asymmetry, 0) << x;
    }
}

TEST(Mie, EfficienciesMatchMiepython) {
    constexpr double kAgreement = 1e-8;
    for (const KnownSphere& known : kSpheres) {
        SCOPED_TRACE(testing::Message() << "x = " << known.size_parameter << ", " << known.index);
        const MieEfficiencies e = MieSeries(known.size_parameter, known.index).efficiencies();
        EXPECT_NEAR(e.extinction / known.extinction, 1, kAgreement);
        EXPECT_NEAR(e.scattering / known.scattering, 1, kAgreement);
        EXPECT_NEAR(e.asymmetry, known.asymmetry, kAgreement);
    }
}

TEST(Mie, MatchesArithmeticOfFortyDigits) {
    // [bohren-huffman-1983, eq. 4.53] in mpmath 1.4.1 with mp.dps = 40, from its Bessel functions.
    // The first is among narrow resonances, the second small.
    const KnownSphere spheres[] = {
        {100, {1.8, 0}, 2.0646418883495615, 2.0646418883495615, 0.73643374026910222},
        {1e-3, {1.5, 0.1}, 1.9925181166793593e-4, 2.4022376993425426e-13, 1.9797507439922449e-7},
        {2, {1.9, 0.6}, 3.0391205107040401, 1.4178924722977481, 0.65981686592765796},
    };
    for (const KnownSphere& known : spheres) {
        const MieEfficiencies e = MieSeries(known.size_parameter, known.index).efficiencies();
        EXPECT_NEAR(e.extinction / known.extinction, 1, kMieRelativeError);
        EXPECT_NEAR(e.scattering / known.scattering, 1, kMieRelativeError);
        EXPECT_NEAR(e.asymmetry / known.asymmetry, 1, kMieRelativeError);
    }
}

struct KnownDirection {
    double size_parameter;
    ComplexIndex index;
    double cosine, phase_per_sr;
};

// miepython 3.3.0: miepython.i_unpolarized(n - 1j * k, x, [cosine], norm="one")
const KnownDirection kDirections[] = {
    {3.5, {1.8, 0}, -1, 0.11367125074554},       {3.5, {1.8, 0}, -0.4, 0.0156496344263518},
    {3.5, {1.8, 0}, 0.3, 0.057157425562253},     {3.5, {1.8, 0}, 1, 0.814378623137132},
    {3, {1.158, 0.4}, -1, 0.00300100993922554},  {3, {1.158, 0.4}, -0.4, 0.00691418700593275},
    {3, {1.158, 0.4}, 0.3, 0.00663620959848771}, {3, {1.158, 0.4}, 1, 0.990581325715152},
};

TEST(Mie, PhaseFunctionMatchesMiepython) {
    for (const KnownDirection& known : kDirections) {
        const double x = known.size_parameter;
        const MieSeries series(x, known.index);
        const double whole = std::numbers::pi * x * x * series.efficiencies().scattering;
        EXPECT_NEAR(series.intensity(known.cosine) / whole / known.phase_per_sr, 1, 1e-8)
            << "x = " << x << ", cosine " << known.cosine;
    }
}

TEST(Mie, IntensityIntegratesToScatteringAndItsMeanCosineIsG) {
    for (const KnownSphere& known : kSpheres) {
        const MieSeries series(known.size_parameter, known.index);
        const MieEfficiencies e = series.efficiencies();
        const Quadrature rule = gauss_legendre(2 * series.terms() + 2, -1, 1);
        double sum = 0, turned = 0;
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double power =
                2 * std::numbers::pi * rule.weights[i] * series.intensity(rule.nodes[i]);
            sum += power;
            turned += power * rule.nodes[i];
        }
        const double whole =
            std::numbers::pi * known.size_parameter * known.size_parameter * e.scattering;
        EXPECT_NEAR(sum / whole, 1, 1e-10) << known.size_parameter;
        EXPECT_NEAR(turned / sum, e.asymmetry, 1e-10) << known.size_parameter;
    }
}

TEST(Mie, WithoutAbsorptionAllExtinctionIsScattering) {
    for (double x : {0.01, 0.3, 0.7, std::numbers::pi, 20.0, 300.0}) {
        for (double n : {0.7, 1.2, 2.8}) {
            const MieEfficiencies e = MieSeries(x, n).efficiencies();
            EXPECT_NEAR(e.scattering / e.extinction, 1, kMieRelativeError) << x << ' ' << n;
        }
    }
}

TEST(Mie, SmallSpheresScatterAsRayleighSays) {
    // Q_sca = 8/3 x^4 |K|^2, Q_abs = 4 x Im K, K = (m^2 - 1)/(m^2 + 2); corrections go like x^2.
    //                                                       [bohren-huffman-1983, eq. 5.8]
    const double x = 1e-3;
    for (const ComplexIndex m : {ComplexIndex(1.8), ComplexIndex(1.2, 0.4)}) {
        const MieSeries series(x, m);
        const MieEfficiencies e = series.efficiencies();
        const ComplexIndex k = (m * m - 1.0) / (m * m + 2.0);
        EXPECT_NEAR(e.scattering / (8.0 / 3 * std::pow(x, 4) * std::norm(k)), 1, 10 * x * x);
        if (m.imag() > 0) {
            EXPECT_NEAR(e.absorption() / (4 * x * k.imag()), 1, 10 * x * x);
        }
        EXPECT_NEAR(series.intensity(0) / series.intensity(1), 0.5, 10 * x * x);
        EXPECT_NEAR(series.intensity(-1) / series.intensity(1), 1, 10 * x * x);
    }
}

TEST(Mie, LargeOpaqueSpheresTakeTwiceTheirShadow) {
    // Q_ext -> 2; the edge adds 1.99 x^(-2/3).                     [nussenzveig-wiscombe-1980]
    for (double x : {100.0, 1000.0, 5000.0}) {
        const double edge = 1.9924 * std::pow(x, -2.0 / 3);
        EXPECT_NEAR(MieSeries(x, {1.5, 0.5}).efficiencies().extinction, 2 + edge, 0.1 * edge) << x;
    }
}

TEST(Mie, ASphereOfTheMediumDoesNothing) {
    EXPECT_LT(MieSeries(5, 1.0).efficiencies().extinction, 1e-14);
}

std::string domain_error(void (*make)()) { return test::message_of<DomainError>(make); }

TEST(Mie, RefusesSizesAndIndicesOutOfRange) {
    EXPECT_THAT(domain_error([] { MieSeries(0, 1.5); }), testing::HasSubstr("size_parameter"));
    EXPECT_THAT(domain_error([] { MieSeries(1e5, 1.5); }), testing::HasSubstr("10000"));
    EXPECT_THAT(domain_error([] { MieSeries(1, {1.5, -0.1}); }), testing::HasSubstr("-0.1"));
    EXPECT_THAT(domain_error([] { MieSeries(1, {0, 1}); }), testing::HasSubstr("above 0"));
    EXPECT_THAT(domain_error([] { MieSeries(1e4, {500, 0}); }), testing::HasSubstr("1000000"));
}

}  // namespace
}  // namespace nacre::optics
