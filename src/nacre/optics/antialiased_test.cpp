#include "nacre/optics/antialiased.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "nacre/core/error.h"

namespace nacre::optics {
namespace {

constexpr Antialiasing kPaper{ObserverTransform::paper, 3};
constexpr Antialiasing kTable3{ObserverTransform::table, 3};

std::vector<double> every(double first, double last, double step) {
    std::vector<double> values;
    for (double x = first; x <= last; x += step) values.push_back(x);
    return values;
}

std::vector<double> cosines_of_degrees(const std::vector<double>& degrees) {
    std::vector<double> cosines;
    for (const double d : degrees) cosines.push_back(std::cos(d * std::numbers::pi / 180));
    return cosines;
}

TEST(ObserverTransform, OfNoPathIsWhite) {
    for (const auto transform : {ObserverTransform::table, ObserverTransform::paper}) {
        for (const auto s : observer_transform(transform, 0)) {
            EXPECT_NEAR(s.real(), 1, 1e-12);
            EXPECT_NEAR(s.imag(), 0, 1e-12);
        }
    }
}

// A wave R = cos^2(pi OPD / lambda) = (1 + cos(2 pi OPD / lambda)) / 2 is what a lossless film
// between weak mirrors shows; its colour by the transform is (1 + Re S) / 2.
TEST(ObserverTransform, TableIsTheTransformOfTheSums) {
    const AiryFilm weak(1, 1.001, 1, 0);
    const auto terms = weak.terms(1.0);
    ASSERT_TRUE(terms);
    int compared = 0;
    for (double nm = 3; nm < 29900; nm += 171.3, ++compared) {
        // R = c0 + 2 C_1 cos(...), higher orders are 1e-7 of it.
        const auto rgb = integrated_rgb(weak, 1, nm);
        const auto s =
            observer_transform(ObserverTransform::table, terms->optical_path_per_thickness * nm);
        const double c1 = terms->s.strength * terms->s.ratio;
        for (int c = 0; c < 3; ++c) {
            const double expected = (rgb[c] - terms->s.c0) / (2 * c1);
            const auto turned = s[c] * std::polar(1.0, terms->s.phase);
            EXPECT_NEAR(turned.real(), expected, kTransformError) << nm;
        }
    }
    EXPECT_GT(compared, 100);
}

TEST(ObserverTransform, HasFallenBelowTheTailWhereTheTableEnds) {
    for (double nm = 0.8 * kTransformReach_nm; nm < kTransformReach_nm; nm += 97) {
        for (const auto s : observer_transform(ObserverTransform::table, nm)) {
            EXPECT_LT(std::abs(s), kTransformTail);
        }
    }
    for (const auto s : observer_transform(ObserverTransform::table, 1e9)) EXPECT_EQ(s, 0.0);
}

TEST(AntialiasedRgb, OfAPerfectMirrorIsWhite) {
    // The wrong white in the matrix would tint it. Total reflection off a lossless base.
    const AiryFilm film(1, 2.5, 0.5, 0);
    for (const double nm : {0.0, 120.0, 700.0}) {
        for (const auto transform : {ObserverTransform::table, ObserverTransform::paper}) {
            for (const double c : antialiased_rgb(film, 0.3, nm, {transform})) {
                EXPECT_NEAR(c, 1, 1e-6);
            }
        }
        for (const double c : integrated_rgb(film, 0.3, nm)) EXPECT_NEAR(c, 1, 1e-12);
    }
}

TEST(AntialiasedRgb, VanishesSmoothlyIntoTheBareBase) {
    // Metal under glass: strong orders, of which three would leave a rest.
    const AiryFilm film(1, 1.5, 0.2, 3.6);
    for (const double cosine : {1.0, 0.6, 0.1}) {
        const double bare = film.reflectance(cosine, 0.0, splat(1 / 550.0))[0];
        for (const auto transform : {ObserverTransform::table, ObserverTransform::paper}) {
            for (const double nm : {1.0, 0.1, 0.0}) {
                for (const double c : antialiased_rgb(film, cosine, nm, {transform})) {
                    // First order in d / lambda; sums stop at 1e-6.
                    EXPECT_NEAR(c, bare, 0.02 * nm + 2e-6);
                }
            }
        }
    }
}

TEST(AntialiasedRgb, BeyondTheCriticalAngleAgreesWithTheSums) {
    const AiryFilm film(1.5, 1.3, 1.7, 0.2);
    const double critical = std::sqrt(1 - std::pow(1.3 / 1.5, 2));
    for (const double cosine : {critical * 0.5, critical * 0.999, critical * 1.001}) {
        for (const double nm : {20.0, 300.0}) {
            const auto c = compare_antialiasing(film, cosine, nm, {});
            // 5 nm against 1 nm of a smooth spectrum.
            EXPECT_LT(c.rgb_error, 1e-4) << cosine;
        }
    }
}

struct ErrorCase {
    const char* name;
    AiryFilm film;
    double paper_mean, paper_max, three_mean, three_max;  // Delta E 2000, bounds
};

// docs/thin-film.md shows these numbers.
TEST(AntialiasedRgb, KeepsItsErrorBounds) {
    const ErrorCase cases[] = {
        {"eta2 1.8 on 1.08 + 0.51i in air", {1, 1.8, 1.08, 0.51}, 1.7, 5.9, 0.05, 1.3},
        {"water on glass in air", {1, 1.33, 1.5, 0}, 0.9, 3.2, 4e-4, 0.01},
        {"titania on glass in air", {1, 2.5, 1.5, 0}, 1.6, 5.6, 0.02, 0.5},
        {"titania on mica in resin", {1.5, 2.5, 1.58, 0}, 1.9, 5.7, 0.05, 3.1},
        {"glass on silver in air", {1, 1.5, 0.2, 3.6}, 0.3, 3.9, 0.08, 4.4},
        {"titania on steel in air", {1, 2.5, 3.2, 3.3}, 1.9, 6.2, 0.11, 2.7},
    };
    const auto cosines = cosines_of_degrees(every(0, 80, 10));
    const auto thicknesses_nm = every(0, 1000, 10);
    for (const ErrorCase& c : cases) {
        SCOPED_TRACE(c.name);
        const auto paper = antialiasing_error(c.film, cosines, thicknesses_nm, kPaper);
        const auto three = antialiasing_error(c.film, cosines, thicknesses_nm, kTable3);
        const auto table = antialiasing_error(c.film, cosines, thicknesses_nm, {});
        EXPECT_LT(paper.mean_delta_e, c.paper_mean);
        EXPECT_LT(paper.max_delta_e, c.paper_max);
        EXPECT_LT(three.mean_delta_e, c.three_mean);
        EXPECT_LT(three.max_delta_e, c.three_max);
        EXPECT_LT(table.mean_delta_e, 1e-3);
        EXPECT_LT(table.max_delta_e, 0.01);
        // The fit is worse than the table by more than an order: no bound above is idle.
        EXPECT_GT(paper.mean_delta_e, 2 * three.mean_delta_e);
        EXPECT_GT(paper.mean_delta_e, 0.8 * c.paper_mean);
    }
}

TEST(AntialiasedRgb, RefusesUnknownStepsAndEmptySets) {
    const AiryFilm film(1, 1.5, 1.5, 0);
    EXPECT_THROW(integrated_rgb(film, 1, 100, 7), DomainError);
    EXPECT_THROW(antialiasing_error(film, {}, {}, {}), DomainError);
}

}  // namespace
}  // namespace nacre::optics
