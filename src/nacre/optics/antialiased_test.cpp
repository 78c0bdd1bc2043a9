#include "nacre/optics/antialiased.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/optics/thin_film.h"
#include "nacre/spectra/rgb.h"

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

// The fit of [belcour-barla-2017], integrated numerically over wave numbers: an observer under
// equal energy with four Gaussian lobes in wave number. The numbers are those of the listing in the
// paper's supplement, evalSensitivity(), whose "var" is half of a variance: it multiplies
// exp(-var phase^2), and the Fourier transform of a Gaussian is exp(-variance phase^2 / 2).
struct Lobe {
    int channel;
    double val, pos_per_m, var_per_m2;
    double deviation_per_m() const { return std::sqrt(2 * var_per_m2); }
    double area() const { return val * std::sqrt(2 * std::numbers::pi * var_per_m2); }
};
constexpr Lobe kSupplement[] = {{0, 5.4856e-13, 1.6810e+06, 4.3278e+09},
                                {0, 9.7470e-14, 2.2399e+06, 4.5282e+09},
                                {1, 4.4201e-13, 1.7953e+06, 9.3046e+09},
                                {2, 5.2481e-13, 2.2084e+06, 6.6121e+09}};

/// Colour of a reflectance, a function of the wave number in 1/m; white is (1, 1, 1).
template <class Reflectance>
Vec3d colour_by_the_fit(Reflectance&& reflectance) {
    // The trapezoidal rule over +-8.5 deviations, whose error for a Gaussian is rounding only.
    constexpr int kSteps = 600;
    constexpr double kReach = 8.5;
    Vec3d xyz{}, white{};
    for (const Lobe& lobe : kSupplement) {
        double sum = 0, weights = 0;
        for (int i = 0; i <= kSteps; ++i) {
            const double x = kReach * (2.0 * i / kSteps - 1), weight = std::exp(-x * x / 2);
            sum += weight * reflectance(lobe.pos_per_m + x * lobe.deviation_per_m());
            weights += weight;
        }
        xyz[lobe.channel] += lobe.area() * sum / weights;
        white[lobe.channel] += lobe.area();
    }
    // Equal energy becomes the white of Rec. 709, channel by channel.
    const Vec3d d65 = spectra::linear_rec709_to_xyz({1, 1, 1});
    for (int c = 0; c < 3; ++c) xyz[c] *= d65[c] / white[c];
    return spectra::xyz_to_linear_rec709(xyz);
}

TEST(ObserverTransform, OfThePaperIsTheIntegralOfItsGaussians) {
    for (const double nm : {0.0, 90.0, 400.0, 1234.5, 3000.0, 7000.0}) {
        const auto found = observer_transform(ObserverTransform::paper, nm);
        const auto phase = [&](double per_m) { return 2 * std::numbers::pi * nm * 1e-9 * per_m; };
        const auto re = colour_by_the_fit([&](double per_m) { return std::cos(phase(per_m)); });
        const auto im = colour_by_the_fit([&](double per_m) { return std::sin(phase(per_m)); });
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(found[c].real(), re[c], 1e-11) << nm;
            EXPECT_NEAR(found[c].imag(), im[c], 1e-11) << nm;
        }
    }
}

TEST(ObserverTransform, OfThePaperIsNearlyThatOfTheObserverUnderEqualEnergy) {
    // The numbers themselves, against the tables of the CIE: the difference is the error of the
    // fit.
    const Vec3d d65 = spectra::linear_rec709_to_xyz({1, 1, 1});
    Vec3d area{};
    for (const Lobe& lobe : kSupplement) area[lobe.channel] += lobe.area();
    Vec3d observed{}, worst{};
    for (int nm = 360; nm <= 830; nm += 5) {
        const auto xyz = spectra::colour_matching(spectra::Observer::cie1931_2deg, nm);
        for (int c = 0; c < 3; ++c) observed[c] += 5e-9 * xyz[c];
    }
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(area[c] / observed[c], 1, 1e-3);
    for (double path_nm = 0; path_nm < 4000; path_nm += 20) {
        std::array<std::complex<double>, 3> expected{};
        for (int nm = 360; nm <= 830; nm += 5) {
            const auto xyz = spectra::colour_matching(spectra::Observer::cie1931_2deg, nm);
            for (int c = 0; c < 3; ++c) {
                expected[c] += 5e-9 * xyz[c] / observed[c] *
                               std::polar(1.0, 2 * std::numbers::pi * path_nm / nm);
            }
        }
        const auto rgb = observer_transform(ObserverTransform::paper, path_nm);
        const auto re =
            spectra::linear_rec709_to_xyz({rgb[0].real(), rgb[1].real(), rgb[2].real()});
        const auto im =
            spectra::linear_rec709_to_xyz({rgb[0].imag(), rgb[1].imag(), rgb[2].imag()});
        for (int c = 0; c < 3; ++c) {
            const std::complex<double> found(re[c] / d65[c], im[c] / d65[c]);
            worst[c] = std::max(worst[c], std::abs(found - expected[c]));
        }
    }
    // Half or twice a variance would make it 0.2, a centre that is off by a hundredth 0.1.
    for (int c = 0; c < 3; ++c) EXPECT_LT(worst[c], 0.07) << c;
}

TEST(AntialiasedRgb, OfThePaperIsWhatItsObserverSeesOfTheTransferMatrix) {
    struct Case {
        double outside, film;
        ComplexIndex base;
    };
    for (const Case& c : {Case{1, 1.8, {1.08, 0.51}}, Case{1, 1.33, {1.5, 0}},
                          Case{1.5, 2.5, {1.58, 0}}, Case{1, 1.5, {0.2, 3.6}}}) {
        const AiryFilm film(c.outside, c.film, c.base.real(), c.base.imag());
        for (const double cosine : {1.0, 0.7, 0.2}) {
            for (const double nm : {15.0, 158.333, 420.0, 1000.0}) {
                const ThinFilm layer{c.film, nm};
                const auto expected = colour_by_the_fit([&](double per_m) {
                    return stack_reflectance(c.outside, {&layer, 1}, c.base, cosine, 1e9 / per_m,
                                             Polarization::unpolarized)
                        .reflectance;
                });
                const auto found = antialiased_rgb(film, cosine, nm, {ObserverTransform::paper});
                // Sums stop where an order adds less than 1e-6, in each polarisation.
                for (int i = 0; i < 3; ++i) {
                    EXPECT_NEAR(found[i], expected[i], 3e-6)
                        << c.film << ", " << cosine << ", " << nm;
                }
            }
        }
    }
}

// X, Y, Z that the listing of the supplement computes, in double precision, by a second program
// written from it in another language: Fresnel terms, phases, three orders and sensitivities are all
// its own. Its base has the index eta_3 (1 + i kappa_3), its D_inc is 2 eta_2 d.
struct SupplementValue {
    double path_um, film, base, base_k, degrees;
    Vec3d xyz;
};
constexpr SupplementValue kSupplementValues[] = {
    {0.57, 1.8, 1.08, 0.51, 0, {0.102651616439, 0.060868603411, 0.067104386436}},
    {0.57, 1.8, 1.08, 0.51, 30, {0.129384142900, 0.092412677554, 0.036212018439}},
    {0.57, 1.8, 1.08, 0.51, 60, {0.250797111062, 0.248216930681, 0.073377108206}},
    {0.665, 1.97, 1.12, 0, 0, {0.100336055144, 0.129245823775, 0.291092144852}},
    {0.665, 1.97, 1.12, 0, 45, {0.067690518259, 0.078784442105, 0.269561445572}},
    {0.665, 1.97, 1.12, 0, 75, {0.190143717003, 0.180197731152, 0.393001320791}},
    {1.5, 1.3333, 1.5, 0, 20, {0.014943562843, 0.017836418925, 0.026804297580}},
    {2.4, 1.45, 1.2, 2.5, 50, {0.527759259662, 0.577780198347, 0.548064639217}}};
// Of its sensitivities for no path and no phase: they are normalised to 1 but for rounding.
constexpr Vec3d kSupplementWhite{1.0004583088164927, 1.0002218935839293, 1.0011224857215686};

TEST(AntialiasedRgb, OfThePaperIsWhatTheListingOfItsSupplementComputes) {
    const Vec3d d65 = spectra::linear_rec709_to_xyz({1, 1, 1});
    for (const SupplementValue& v : kSupplementValues) {
        const AiryFilm film(1, v.film, v.base, v.base * v.base_k);
        const double thickness_nm = 1e3 * v.path_um / (2 * v.film);
        const Vec3d xyz = spectra::linear_rec709_to_xyz(antialiased_rgb(
            film, std::cos(v.degrees * std::numbers::pi / 180), thickness_nm, kPaper));
        // Its white is that of equal energy, ours that of D65, channel by channel.
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(xyz[c] / d65[c] * kSupplementWhite[c], v.xyz[c], 2e-6)
                << v.path_um << " um, " << v.degrees << " deg, channel " << c;
        }
    }
}

TEST(AntialiasedRgb, OfAPerfectMirrorIsWhite) {
    // The wrong white in the matrix would tint it. Total reflection off a lossless base.
    const AiryFilm film(1, 2.5, 0.5, 0);
    for (const double nm : {0.0, 120.0, 700.0}) {
        for (const auto transform : {ObserverTransform::table, ObserverTransform::paper}) {
            const Vec3d rgb = antialiased_rgb(film, 0.3, nm, {transform});
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(rgb[c], 1, 1e-6);
        }
        const Vec3d rgb = integrated_rgb(film, 0.3, nm);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(rgb[c], 1, 1e-12);
    }
}

TEST(AntialiasedRgb, VanishesSmoothlyIntoTheBareBase) {
    // Glass on metal: strong orders, of which three do not sum to the bare base.
    const AiryFilm film(1, 1.5, 0.2, 3.6);
    for (const double cosine : {1.0, 0.6, 0.1}) {
        const double bare = film.reflectance(cosine, 0.0, splat(1 / 550.0))[0];
        for (const auto transform : {ObserverTransform::table, ObserverTransform::paper}) {
            for (const double nm : {1.0, 0.1, 0.0}) {
                const Vec3d rgb = antialiased_rgb(film, cosine, nm, {transform});
                // First order in d / lambda; sums stop at 1e-6.
                for (int c = 0; c < 3; ++c) EXPECT_NEAR(rgb[c], bare, 0.02 * nm + 2e-6);
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
        // The fit errs by more than twice as much as the table with as many orders, and its bound
        // is tight to 20 %.
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
