#include "nacre/bsdf/models/thin_film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/core/random.h"
#include "nacre/optics/antialiased.h"
#include "nacre/optics/fresnel.h"
#include "nacre/optics/thin_film.h"
#include "nacre/spectra/colour.h"
#include "nacre/spectra/rgb.h"
#include "nacre/testing/bsdf.h"
#include "nacre/testing/paints.h"

namespace nacre::bsdf {
namespace {

using paint::FacetDistribution;
using test::violet;
constexpr Wavelengths kNm = {418, 456, 493, 531, 568, 606, 643, 681};
paint::Recipe coated(paint::Recipe recipe) {
    recipe.clearcoat = paint::Clearcoat{40, spectra::Spectrum({400, 700}, {8.0, 1.0}), 0};
    return recipe;
}

// Reflects all light: extinction so high that the film does not matter.
paint::Recipe mirror(FacetDistribution law, double alpha) {
    paint::Recipe recipe;
    recipe.microfacet = paint::Microfacet{alpha, law, 1.0, 0, 0.01, 100, {}};
    return recipe;
}

std::unique_ptr<const BoundBsdf> bind(const paint::Recipe& recipe,
                                      ThinFilmColour colour = ThinFilmColour::spectral) {
    return ThinFilm(recipe, colour).bind(kNm);
}

double smith_lambda(FacetDistribution law, double alpha, double theta) {
    if (theta == 0) return 0;
    const double a = 1 / (alpha * std::tan(theta));
    if (law == FacetDistribution::ggx) return 0.5 * (std::sqrt(1 + 1 / (a * a)) - 1);
    return 0.5 * (std::erf(a) - 1) + std::exp(-a * a) / (2 * a * std::sqrt(std::numbers::pi));
}

TEST(ThinFilm, IsTheMicrofacetFormulaWithTheTransferMatrix) {
    for (const auto law : kFacetLaws) {
        const paint::Recipe recipe = violet(0.3, law);
        const auto bound = bind(recipe);
        for (const double theta_o : {10.0, 45.0, 75.0}) {
            const Vec3f wi = direction(50, 0), wo = direction(theta_o, 170);
            const Vec3f h = normalize(wi + wo);
            const double theta_h = std::acos(h.z), tan2 = std::pow(std::tan(theta_h), 2) / 0.09;
            const double shape =
                law == FacetDistribution::ggx ? 1 / ((1 + tan2) * (1 + tan2)) : std::exp(-tan2);
            const double d = shape / (std::numbers::pi * 0.09 * std::pow(h.z, 4));
            const double g = 1 / (1 + smith_lambda(law, 0.3, 50 * kDegree) +
                                  smith_lambda(law, 0.3, theta_o * kDegree));
            const optics::ThinFilm film{1.8, 158.333};
            const FloatLanes f = bound->eval(wi, wo);
            for (int lane = 0; lane < kLanes; ++lane) {
                const double airy =
                    optics::stack_reflectance(1, {&film, 1}, {1.08, 0.51}, dot(wi, h), kNm[lane],
                                              optics::Polarization::unpolarized)
                        .reflectance;
                const double expected = d * g * airy / (4 * wi.z * wo.z);
                // Single precision: roundings amplified by the lobe's exponent.
                EXPECT_NEAR(f[lane], expected, 2e-5 * expected);
            }
        }
    }
}

TEST(ThinFilm, UnderACoatIsTheFormulaInTheBinder) {
    const paint::Recipe recipe = coated(violet(0.3, FacetDistribution::ggx));
    const Vec3f wi = direction(50, 0), wo = direction(35, 165);
    const auto inside = [](Vec3f w) {
        return Vec3f{w.x / 1.5f, w.y / 1.5f, std::sqrt(1 - (w.x * w.x + w.y * w.y) / 2.25f)};
    };
    const Vec3f i = inside(wi), o = inside(wo), h = normalize(i + o);
    const double tan2 = (h.x * h.x + h.y * h.y) / (h.z * h.z) / 0.09;
    const double d = 1 / (std::numbers::pi * 0.09 * std::pow(h.z, 4) * (1 + tan2) * (1 + tan2));
    const double g = 1 / (1 + smith_lambda(FacetDistribution::ggx, 0.3, std::acos(i.z)) +
                          smith_lambda(FacetDistribution::ggx, 0.3, std::acos(o.z)));
    const double transmitted = (1 - optics::fresnel_dielectric(1.5, double{wi.z})) *
                               (1 - optics::fresnel_dielectric(1.5, double{wo.z}));
    const optics::ThinFilm film{1.8, 158.333};
    const FloatLanes f = bind(recipe)->eval(wi, wo);
    for (int lane = 0; lane < kLanes; ++lane) {
        const double airy = optics::stack_reflectance(1.5, {&film, 1}, {1.08, 0.51}, dot(i, h),
                                                      kNm[lane], optics::Polarization::unpolarized)
                                .reflectance;
        const double depth = recipe.clearcoat->absorption_per_mm(kNm[lane]) * 0.04;
        const double expected = transmitted / 2.25 * std::exp(-depth * (1 / i.z + 1 / o.z)) * d *
                                g * airy / (4 * i.z * o.z);
        EXPECT_NEAR(f[lane], expected, 2e-5 * expected);
    }
}

TEST(ThinFilm, VanishesSmoothlyIntoTheBareBase) {
    for (const auto colour :
         {ThinFilmColour::spectral, ThinFilmColour::table, ThinFilmColour::paper}) {
        paint::Recipe recipe = violet();
        const Vec3f wi = direction(40, 0), wo = direction(44, 180);
        recipe.microfacet->film_thickness_nm = 0;
        const FloatLanes none = bind(recipe, colour)->eval(wi, wo);
        // A film of air changes nothing.
        paint::Recipe air = violet();
        air.microfacet->film_ior = 1;
        const FloatLanes bare = bind(air)->eval(wi, wo);
        for (int lane = 0; lane < kLanes; ++lane) EXPECT_NEAR(none[lane] / bare[lane], 1, 1e-4);
        for (const double nm : {3.0, 0.3}) {
            recipe.microfacet->film_thickness_nm = nm;
            const FloatLanes thin = bind(recipe, colour)->eval(wi, wo);
            // First order in d / lambda: a tenth of the base's 6 % for each nanometre.
            for (int lane = 0; lane < kLanes; ++lane) {
                EXPECT_NEAR(thin[lane] / bare[lane], 1, 0.12 * nm + 1e-4);
            }
        }
    }
}

TEST(ThinFilm, IsReciprocalAndNeverNegative) {
    for (const auto colour :
         {ThinFilmColour::spectral, ThinFilmColour::table, ThinFilmColour::paper}) {
        for (const bool coat : {false, true}) {
            const paint::Recipe recipe = violet(0.4, FacetDistribution::ggx);
            expect_reciprocal(*bind(coat ? coated(recipe) : recipe, colour), 1000, 1e-6f);
        }
    }
}

TEST(ThinFilm, IsBlackBelowTheHorizon) { expect_black_below_the_horizon(*bind(coated(violet()))); }

// A lossless surface that scatters once keeps what is not masked on the way out: the mean over
// visible normals of (1 + Lambda_i) / (1 + Lambda_i + Lambda_o). By a sum over the hemisphere of
// outgoing directions, in formulas of its own.
double smith_albedo(FacetDistribution law, double alpha, double theta_i) {
    const double lambda_i = smith_lambda(law, alpha, theta_i);
    constexpr int kThetas = 900, kPhis = 900;
    double sum = 0;
    for (int t = 0; t < kThetas; ++t) {
        const double theta = (t + 0.5) / kThetas * std::numbers::pi / 2;
        const double lambda_o = smith_lambda(law, alpha, theta);
        for (int p = 0; p < kPhis; ++p) {
            const double phi = 2 * std::numbers::pi * (p + 0.5) / kPhis;
            const double x = std::sin(theta_i) + std::sin(theta) * std::cos(phi);
            const double y = std::sin(theta) * std::sin(phi);
            const double z = std::cos(theta_i) + std::cos(theta);
            const double tan2 = (x * x + y * y) / (z * z), a2 = alpha * alpha;
            const double d = law == FacetDistribution::ggx ? 1 / std::pow(1 + tan2 / a2, 2)
                                                           : std::exp(-tan2 / a2);
            sum += d * std::pow(1 + tan2, 2) / (std::numbers::pi * a2) /
                   (4 * std::cos(theta_i) * (1 + lambda_i + lambda_o)) * std::sin(theta);
        }
    }
    return sum * std::numbers::pi / 2 / kThetas * 2 * std::numbers::pi / kPhis;
}

TEST(ThinFilm, LosesNoMoreLightThanSmithsMaskingSays) {
    for (const auto law : kFacetLaws) {
        for (const double alpha : {0.2, 0.6}) {
            const auto bound = bind(mirror(law, alpha));
            for (const double theta : {0.5, 45.0, 75.0}) {
                const double expected = smith_albedo(law, alpha, theta * kDegree);
                const MeanWeight found = mean_weight(*bound, direction(theta, 20), 3, 60000, 17);
                // The base absorbs below 1e-3.
                EXPECT_NEAR(found.mean, expected, 4 * found.error + 2e-3)
                    << "alpha " << alpha << ", theta " << theta;
                EXPECT_LE(found.mean, 1 + 4 * found.error);
            }
        }
    }
}

TEST(ThinFilm, SmoothFacetsUnderACoatKeepTheEnergyOfOneBounce) {
    // The coat's reflectance plus t_i t_o for one lossless reflection below: less than 1 by the
    // interreflection, which is neglected.
    paint::Recipe recipe = mirror(FacetDistribution::beckmann, 0.002);
    recipe.clearcoat = paint::Clearcoat{40, 0.0, 0};
    const auto bound = bind(recipe);
    for (const double theta : {0.5, 45.0, 75.0}) {
        const double r = optics::fresnel_dielectric(1.5, std::cos(theta * kDegree));
        const MeanWeight found = mean_weight(*bound, direction(theta, 20), 3, 60000, 5);
        EXPECT_NEAR(found.mean, r + (1 - r) * (1 - r), 4 * found.error + 3e-3) << theta;
    }
}

TEST(ThinFilm, NeverReflectsMoreThanItReceives) {
    for (const auto colour :
         {ThinFilmColour::spectral, ThinFilmColour::table, ThinFilmColour::paper}) {
        for (const double nm : {0.0, 120.0, 400.0}) {
            for (const bool coat : {false, true}) {
                paint::Recipe recipe = mirror(FacetDistribution::beckmann, 0.1);
                recipe.microfacet->film_ior = 2.2;
                recipe.microfacet->film_thickness_nm = nm;
                const auto bound = bind(coat ? coated(recipe) : recipe, colour);
                for (const double theta : {0.5, 60.0, 85.0}) {
                    for (int lane = 0; lane < kLanes; ++lane) {
                        EXPECT_LE(bound->albedo(direction(theta, 0))[lane], 1);
                    }
                    const MeanWeight found = mean_weight(*bound, direction(theta, 20), 5, 60000, 3);
                    EXPECT_LE(found.mean, 1 + 4 * found.error + 1e-5);
                }
            }
        }
    }
}

TEST(ThinFilm, AlbedoIsTheMeanWeight) {
    for (const auto law : kFacetLaws) {
        for (const bool coat : {false, true}) {
            const paint::Recipe recipe = violet(0.25, law);
            const auto bound = bind(coat ? coated(recipe) : recipe);
            for (const double theta : {0.5, 40.0, 70.0}) {
                const MeanWeight found = mean_weight(*bound, direction(theta, 20), 4, 60000, 9);
                EXPECT_NEAR(bound->albedo(direction(theta, 0))[4], found.mean,
                            4 * found.error + kThinFilmAlbedoError)
                    << theta;
            }
        }
    }
}

TEST(ThinFilm, SampleReportsItsOwnDensityAndWeight) {
    for (const auto law : kFacetLaws) {
        for (const bool coat : {false, true}) {
            const paint::Recipe recipe = violet(0.2, law);
            const auto bound = bind(coat ? coated(recipe) : recipe);
            const Drawn drawn = expect_own_density_and_weight(*bound, 3000, 1e-5f);
            EXPECT_EQ(drawn.specular > 100, coat);
            EXPECT_GT(drawn.others, 500);
        }
    }
}

TEST(ThinFilm, SamplesFollowTheDensity) {
    int tests = 0;
    for (const auto law : kFacetLaws) {
        for (const double alpha : {0.25, 0.7}) {
            for (const bool coat : {false, true}) {
                const paint::Recipe recipe = violet(alpha, law);
                const auto bound = bind(coat ? coated(recipe) : recipe);
                for (const double theta_i : {0.5, 50.0, 80.0}) {
                    SCOPED_TRACE(testing::Message()
                                 << (law == FacetDistribution::ggx ? "ggx " : "beckmann ") << alpha
                                 << (coat ? " coated" : "") << ", theta_i " << theta_i);
                    // One-sided, 24 tests with fixed seeds: 4 deviations, one alarm in 1000.
                    EXPECT_LT(chi_square_z_score(*bound, direction(theta_i, 0), 11 + tests, 100000),
                              4);
                    ++tests;
                }
            }
        }
    }
    EXPECT_EQ(tests, 24);
}

TEST(ThinFilm, WeightsNeverExceedOneWithoutACoat) {
    // Visible normals leave F G2 / G1 <= 1.
    Rng rng(5, 1);
    for (const auto law : kFacetLaws) {
        for (const double alpha : {0.01, 0.1, 1.0}) {
            const auto bound = bind(mirror(law, alpha));
            for (const double theta : {0.5, 60.0, 88.0, 89.9}) {
                for (int i = 0; i < 3000; ++i) {
                    const auto s = bound->sample(direction(theta, 10), rng.uniform_float(),
                                                 {rng.uniform_float(), rng.uniform_float()});
                    if (s) {
                        ASSERT_LE(lane_max(s->weight), 1.001f);
                    }
                }
            }
        }
    }
}

TEST(ThinFilm, ColourModesShowTheColourOfTheAntialiasedReflectance) {
    // Rendered as a spectrum and seen under D65 again, the colour is that of the film.
    const paint::Recipe recipe = violet();
    const optics::AiryFilm film(1, 1.8, 1.08, 0.51);
    const Vec3f w = direction(30, 0), specular = direction(30, 180);
    paint::Recipe white = mirror(FacetDistribution::beckmann, 0.07);
    for (const auto colour : {ThinFilmColour::table, ThinFilmColour::paper}) {
        std::vector<double> wavelengths_nm;
        for (int nm = 360; nm < 760; nm += 5) wavelengths_nm.push_back(nm);
        ASSERT_EQ(wavelengths_nm.size() % kLanes, 0u);
        std::vector<double> ratio;
        for (std::size_t first = 0; first < wavelengths_nm.size(); first += kLanes) {
            Wavelengths nm;
            for (int i = 0; i < kLanes; ++i) nm[i] = wavelengths_nm[first + i];
            const FloatLanes f = ThinFilm(recipe, colour).bind(nm)->eval(w, specular);
            const FloatLanes one = ThinFilm(white).bind(nm)->eval(w, specular);
            for (int i = 0; i < kLanes; ++i) ratio.push_back(f[i] / one[i]);
        }
        const auto weights = spectra::rec709_weights(wavelengths_nm);
        Vec3d seen{};
        for (std::size_t i = 0; i < ratio.size(); ++i) {
            for (int c = 0; c < 3; ++c) seen[c] += weights[i][c] * ratio[i];
        }
        optics::Antialiasing how;
        if (colour == ThinFilmColour::paper) how.transform = optics::ObserverTransform::paper;
        const auto expected = optics::antialiased_rgb(film, std::cos(30 * kDegree), 158.333, how);
        // The facets' 99.98 % cancels; 1024 steps of the cosine: found 1e-6.
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], expected[c], 1e-5);
    }
}

TEST(ThinFilm, RefusesWhatItCannotDo) {
    EXPECT_THROW(ThinFilm(paint::Recipe{}), DomainError);
    paint::Recipe rough = coated(violet());
    rough.clearcoat->roughness = 0.2;
    EXPECT_THROW(ThinFilm{rough}, DomainError);
    paint::Recipe bad = violet();
    bad.microfacet->film_ior = 0;
    EXPECT_THROW(ThinFilm{bad}, DomainError);
}

}  // namespace
}  // namespace nacre::bsdf
