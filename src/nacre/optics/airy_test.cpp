#include "nacre/optics/airy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/quadrature.h"
#include "nacre/core/random.h"
#include "nacre/optics/fresnel.h"
#include "nacre/optics/thin_film.h"
#include "nacre/testing/statistics.h"

namespace nacre::optics {
namespace {

struct Indices {
    double outside, film, base, extinction;

    AiryFilm film_object() const { return {outside, film, base, extinction}; }
    double exact(double cosine, double thickness_nm, double wavelength_nm,
                 Polarization polarization = Polarization::unpolarized) const {
        const ThinFilm layer{film, thickness_nm};
        return stack_reflectance(outside, {&layer, 1}, {base, extinction}, cosine, wavelength_nm,
                                 polarization)
            .reflectance;
    }
};

// Dielectric and metal bases, a film that reflects totally, a base that does.
constexpr Indices kCases[] = {{1, 1.8, 1.08, 0.51}, {1, 1.33, 1.5, 0},  {1.5, 2.5, 1.58, 0},
                              {1.5, 1.8, 0.2, 3.6}, {1, 2.5, 0.5, 0},   {1.5, 1.3, 1.7, 0.2},
                              {1.5, 1.3, 1.0, 0},   {1, 1.5, 3.2, 3.3}, {1.5, 1.5, 1.5, 0}};
constexpr double kAiryCosines[] = {1, 0.99, 0.8, 0.5, 0.2, 0.05, 0.001};

template <class V>
double worst_error(double max_wavelengths) {
    using Real = LaneScalar<V>;
    Rng rng(1, 1);
    double worst = 0;
    for (const Indices& c : kCases) {
        const AiryFilm film = c.film_object();
        for (int n = 0; n < 400; ++n) {
            const Real cosine = n < 7 ? static_cast<Real>(kAiryCosines[n])
                                      : static_cast<Real>(1 - 0.999 * rng.uniform_double());
            const double nm = 550 * max_wavelengths / c.film * rng.uniform_double();
            const V wavelengths = make_lanes<V>([](int i) { return 400 + 40 * i; });
            const V found = film.reflectance(cosine, static_cast<Real>(nm), 1 / wavelengths);
            for (int i = 0; i < kLanes; ++i) {
                const double exact = c.exact(cosine, nm, 400 + 40 * i);
                worst = test::worse(worst, std::abs(found[i] - exact));
            }
        }
    }
    return worst;
}

TEST(AiryFilm, AgreesWithTheTransferMatrix) {
    EXPECT_LT(worst_error<DoubleLanes>(10), kAiryError);
    EXPECT_LT(worst_error<FloatLanes>(10), kAiryFloatError);
}

TEST(AiryFilm, KeepsThePolarisationsApart) {
    const Indices c = kCases[0];
    const auto pair = c.film_object().at(0.4).polarised_reflectance(splat(210.0 / 480));
    EXPECT_NEAR(pair.s[0], c.exact(0.4, 210, 480, Polarization::s), kAiryError);
    EXPECT_NEAR(pair.p[0], c.exact(0.4, 210, 480, Polarization::p), kAiryError);
}

TEST(AiryFilm, VanishesSmoothlyIntoTheBareBase) {
    for (const Indices& c : kCases) {
        for (const double cosine : kAiryCosines) {
            const auto bare = fresnel(c.outside, {c.base, c.extinction}, cosine);
            const double expected = 0.5 * (std::norm(bare.r_s) + std::norm(bare.r_p));
            double previous = INFINITY;
            for (const double nm : {1.0, 0.1, 0.01, 0.0}) {
                const double found = c.film_object().reflectance(cosine, nm, splat(1 / 550.0))[0];
                const double away = std::abs(found - expected);
                // Of first order in d / lambda, faster the nearer to grazing incidence.
                EXPECT_LE(away, std::min(1.0, 0.02 * nm / cosine) * 5 + kAiryError);
                EXPECT_LE(away, previous + kAiryError);
                previous = away;
            }
        }
    }
}

TEST(AiryFilm, HasNoEffectIfItsIndexIsThatOfANeighbour) {
    // A film of the outside's or of a lossless base's index changes nothing, however thick.
    for (const double cosine : kAiryCosines) {
        const double bare = AiryFilm(1, 1, 1.6, 0).reflectance(cosine, 0.0, splat(1 / 550.0))[0];
        for (const double index : {1.0, 1.6}) {
            const AiryFilm film(1, index, 1.6, 0);
            EXPECT_NEAR(film.reflectance(cosine, 320.0, splat(1 / 550.0))[0], bare, kAiryError);
        }
    }
}

TEST(AiryFilm, TakesTheExtinctionItselfNotItsRatioToTheIndex) {
    // At normal incidence, without a film, R = ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2).
    const double n = 0.2, k = 3.6,
                 expected = ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
    EXPECT_NEAR(AiryFilm(1, 1.5, n, k).reflectance(1.0, 0.0, splat(1 / 550.0))[0], expected, 1e-14);
}

TEST(AiryTerms, PhasesAreThoseOfTheProjectsConvention) {
    // exp(-i w t), k > 0 absorbs: with n - i k the phase off a metal would have the other sign.
    const double film = 1.5, cosine = 0.8, inside = std::sqrt(1 - (1 - 0.64) / (film * film));
    const auto top = fresnel(1, film, cosine), base = fresnel(film, {0.2, 3.6}, inside);
    const auto terms = AiryFilm(1, film, 0.2, 3.6).terms(cosine);
    ASSERT_TRUE(terms);
    EXPECT_NEAR(
        std::remainder(terms->s.phase - std::arg(-top.r_s * base.r_s), 2 * std::numbers::pi), 0,
        1e-12);
    EXPECT_NEAR(
        std::remainder(terms->p.phase - std::arg(-top.r_p * base.r_p), 2 * std::numbers::pi), 0,
        1e-12);
    EXPECT_GT(std::abs(std::sin(terms->s.phase)), 0.5);  // so that the sign matters
}

TEST(AiryFilm, UnpolarisedLightIsHalvedOnce) {
    // At normal incidence both polarisations reflect alike, and so does their mean.
    const auto angle = AiryFilm(1, 1.8, 1.08, 0.51).at(1.0);
    const DoubleLanes d = splat(158.333 / 550);
    EXPECT_NEAR(angle.polarised_reflectance(d).s[0], angle.reflectance(d)[0], 1e-15);
    EXPECT_NEAR(angle.polarised_reflectance(d).p[0], angle.reflectance(d)[0], 1e-15);
    // And the series halves once too: a thick film's mean over fringes is its c0.
    const auto terms = AiryFilm(1, 1.8, 1.08, 0.51).terms(1);
    const AiryMoments m = AiryFilm(1, 1.8, 1.08, 0.51).moments(1, {0, 550 / (2 * 1.8)}, 550);
    EXPECT_NEAR(m.mean, terms->s.c0, 1e-12);
}

TEST(AiryFilm, ConductorWithoutExtinctionIsADielectric) {
    for (const double cosine : kAiryCosines) {
        const double dielectric =
            AiryFilm(1, 1.8, 1.4, 0).reflectance(cosine, 200.0, splat(1 / 550.0))[0];
        const double nearly =
            AiryFilm(1, 1.8, 1.4, 1e-9).reflectance(cosine, 200.0, splat(1 / 550.0))[0];
        EXPECT_NEAR(nearly, dielectric, 1e-8);
    }
}

TEST(AiryFilm, DependsOnTheIndexOutside) {
    // Flakes lie in the binder: with index 1 instead the first minimum is elsewhere.
    const double binder = AiryFilm(1.5, 2.5, 1.58, 0).reflectance(0.8, 80.0, splat(1 / 550.0))[0];
    const double air = AiryFilm(1, 2.5, 1.58, 0).reflectance(0.8, 80.0, splat(1 / 550.0))[0];
    EXPECT_NEAR(binder, (Indices{1.5, 2.5, 1.58, 0}.exact(0.8, 80, 550)), kAiryError);
    EXPECT_GT(std::abs(binder - air), 0.05);
}

TEST(AiryFilm, StaysBetweenZeroAndOneForAnyArguments) {
    Rng rng(2, 1);
    const auto log_uniform = [&](const Range& r) {
        return r.lo * std::pow(r.hi / r.lo, rng.uniform_double());
    };
    for (int n = 0; n < 20000; ++n) {
        const double k = rng.uniform_float() < 0.3 ? 0 : 100 * std::pow(rng.uniform_double(), 8);
        const AiryFilm film(log_uniform(kAiryIndexRange), log_uniform(kAiryIndexRange),
                            log_uniform(kAiryIndexRange), k);
        const float cosine = n % 10 == 0 ? 0.0f : rng.uniform_float();
        const float nm = 1e5f * std::pow(rng.uniform_float(), 8.0f);
        const FloatLanes R =
            film.reflectance(cosine, nm, 1.0f / make_lanes([](int i) { return 380.0f + 50 * i; }));
        for (int i = 0; i < kLanes; ++i) {
            ASSERT_GE(R[i], 0);
            ASSERT_LE(R[i], 1);
        }
    }
}

TEST(AiryFilm, RefusesIndicesOutOfRange) {
    EXPECT_THROW(AiryFilm(0, 1.5, 1.5, 0), DomainError);
    EXPECT_THROW(AiryFilm(1, 11, 1.5, 0), DomainError);
    EXPECT_THROW(AiryFilm(1, 1.5, NAN, 0), DomainError);
    EXPECT_THROW(AiryFilm(1, 1.5, 1.5, -1), DomainError);
}

TEST(AiryTerms, SumUpToTheReflectance) {
    int compared = 0;
    for (const Indices& c : kCases) {
        for (const double cosine : {1.0, 0.8, 0.5, 0.2}) {
            const auto terms = c.film_object().terms(cosine);
            const double sine = std::sqrt(1 - cosine * cosine);
            ASSERT_EQ(terms.has_value(), c.outside * sine < c.film);
            if (!terms) continue;
            for (const double nm : {0.0, 90.0, 400.0}) {
                const double turns = terms->optical_path_per_thickness * nm / 520;
                double sum = 0;
                for (const auto& w : {terms->s, terms->p}) {
                    sum += w.c0 / 2;
                    // Ratios here stay below 0.9: 300 orders leave 1e-13.
                    ASSERT_LT(w.ratio, 0.9);
                    for (int m = 1; m < 300; ++m) {
                        sum += w.strength * std::pow(w.ratio, m) *
                               std::cos(m * (2 * std::numbers::pi * turns + w.phase));
                    }
                }
                EXPECT_NEAR(sum, c.exact(cosine, nm, 520), 1e-11);
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 80);
}

TEST(AiryMoments, AgreeWithSumsOverTheTransferMatrix) {
    for (const Indices& c : kCases) {
        const AiryFilm film = c.film_object();
        for (const double cosine : {1.0, 0.9999, 0.8, 0.5, 0.2, 0.01}) {
            for (const ThicknessRange range :
                 {ThicknessRange{158, 158}, {150, 150.001}, {148, 168}, {0, 40}, {900, 1400}}) {
                // Gauss panels, fine enough for the resonances.
                const int panels = range.hi_nm - range.lo_nm > 100 ? 60 : 4;
                const double step = (range.hi_nm - range.lo_nm) / panels;
                const Quadrature rule = gauss_legendre(16, 0, 1);
                double mean = 0, square = 0;
                for (int p = 0; p < panels; ++p) {
                    for (int k = 0; k < 16; ++k) {
                        const double R =
                            c.exact(cosine, range.lo_nm + step * (p + rule.nodes[k]), 450);
                        mean += rule.weights[k] * R / panels;
                        square += rule.weights[k] * R * R / panels;
                    }
                }
                const AiryMoments found = film.moments(cosine, range, 450);
                EXPECT_NEAR(found.mean, mean, kAiryMomentsError);
                EXPECT_NEAR(found.mean_square, square, kAiryMomentsError)
                    << c.outside << " " << c.film << " " << cosine << " " << range.hi_nm;
            }
        }
    }
}

TEST(AiryMoments, AllThicknessesAlikeHaveNoVariance) {
    const AiryMoments m = AiryFilm(1, 1.8, 1.08, 0.51).moments(0.7, {158, 158}, 550);
    EXPECT_NEAR(m.mean, (Indices{1, 1.8, 1.08, 0.51}.exact(0.7, 158, 550)), kAiryError);
    EXPECT_NEAR(m.variance(), 0, 1e-14);
}

}  // namespace
}  // namespace nacre::optics
