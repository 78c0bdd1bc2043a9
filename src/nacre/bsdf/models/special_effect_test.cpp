#include "nacre/bsdf/models/special_effect.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "nacre/bsdf/models/thin_film.h"
#include "nacre/core/error.h"
#include "nacre/core/random.h"
#include "nacre/testing/bsdf.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/paints.h"

namespace nacre::bsdf {
namespace {

using test::message_of;

paint::Recipe pigment(double count, bool coat = false) {
    paint::Recipe recipe = test::violet();
    recipe.microfacet->facets = paint::MicrofacetFacets{count, 3, 10};
    if (coat) recipe.clearcoat = paint::Clearcoat{45, spectra::Spectrum(2.0), 0.0};
    return recipe;
}

Patch somewhere(Rng& rng, double area) {
    const double side = std::sqrt(area), turn = 2 * std::numbers::pi * rng.uniform_double();
    const float c = static_cast<float>(side * std::cos(turn));
    const float s = static_cast<float>(side * std::sin(turn));
    const double room = 1 - 2 * side, u = side + room * rng.uniform_double();
    return {u, side + room * rng.uniform_double(), {c, s}, {-s, c}};
}

TEST(SpecialEffect, MeanOverPatchesIsTheSmoothMean) {
    struct Case {
        double facets, per_patch;
        int patches;
    };
    for (const bool coat : {false, true}) {
        for (const Case& c : {Case{1e7, 0.05, 40000}, Case{1e9, 5, 5000}, Case{1e12, 1e5, 500}}) {
            const auto bound = SpecialEffect(pigment(c.facets, coat), 3).bind(kOnGrid);
            for (const auto& [wi, wo] : {std::pair{direction(30, 0), direction(31, 179)},
                                         std::pair{direction(60, 0), direction(57, 184)}}) {
                FloatLanes sum{}, squares{};
                for (int i = 0; i < c.patches; ++i) {
                    Rng rng(5, i);
                    const FloatLanes f =
                        bound->evaluate_on(somewhere(rng, c.per_patch / c.facets), wi, wo).f;
                    sum += f;
                    squares += f * f;
                }
                const FloatLanes expected = bound->eval(wi, wo);
                for (int lane = 0; lane < kLanes; ++lane) {
                    const double mean = sum[lane] / c.patches;
                    const double variance = squares[lane] / c.patches - mean * mean;
                    EXPECT_NEAR(mean, expected[lane],
                                3.5 * std::sqrt(variance / c.patches) + 1e-4 * expected[lane])
                        << c.per_patch << " facets, lane " << lane;
                }
            }
        }
    }
}

// For a narrow cone and a single thickness the mean is ThinFilm.
TEST(SpecialEffect, MeanIsTheThinFilmModelAveragedOverConeAndThickness) {
    paint::Recipe recipe = pigment(1e6, true);
    recipe.microfacet->alpha = 0.2;
    recipe.microfacet->facets->cone_deg = 0.5;
    recipe.microfacet->facets->thickness_spread_nm = 0;
    const auto facets = SpecialEffect(recipe, 1).bind(kOnGrid);
    recipe.microfacet->facets.reset();
    const auto smooth = ThinFilm(recipe).bind(kOnGrid);
    for (const double theta : {0.0, 20.0, 50.0}) {
        const Vec3f wi = direction(theta, 0), wo = direction(theta + 5, 175);
        const FloatLanes a = facets->eval(wi, wo), b = smooth->eval(wi, wo);
        // The blur is of second order in (gamma/2) / alpha / cos: 1e-3 at most here.
        for (int i = 0; i < kLanes; ++i) EXPECT_NEAR(a[i], b[i], 2e-3 * b[i]) << theta;
    }
}

TEST(SpecialEffect, IsReciprocal) {
    for (const bool coat : {false, true}) {
        const auto bound = SpecialEffect(pigment(1e8, coat), 2).bind(kOnGrid);
        Rng rng(1);
        int lit = 0;
        for (int i = 0; i < 500; ++i) {
            const Patch patch = somewhere(rng, std::pow(10, -8 + 4 * rng.uniform_double()));
            const Vec3f wi = direction(70 * rng.uniform_double(), 360 * rng.uniform_double());
            const auto sample =
                bound->sample(wi, 0.99f, {rng.uniform_float(), rng.uniform_float()});
            if (!sample || sample->kind == SampleKind::specular) continue;
            const FloatLanes there = bound->evaluate_on(patch, wi, sample->wo).f;
            const FloatLanes back = bound->evaluate_on(patch, sample->wo, wi).f;
            const FloatLanes mean = bound->eval(wi, sample->wo);
            const FloatLanes mean_back = bound->eval(sample->wo, wi);
            for (int k = 0; k < kLanes; ++k) {
                EXPECT_NEAR(there[k], back[k], 1e-4 * there[k]);
                // The rule's nodes lie about one direction or about the other.
                EXPECT_NEAR(mean[k], mean_back[k], 1e-3 * mean[k]);
            }
            lit += there[0] > 0;
        }
        EXPECT_GT(lit, 100);
    }
}

TEST(SpecialEffect, PartsOfAPatchAverageToTheWhole) {
    paint::Recipe recipe = pigment(1e9);
    recipe.microfacet->facets->thickness_spread_nm = 0;
    const auto bound = SpecialEffect(recipe, 4).bind(kOnGrid);
    const Vec3f wi = direction(30, 0), wo = direction(30, 180);
    const float side = 0x1p-13f;
    Rng rng(2);
    double total = 0;
    for (int i = 0; i < 100; ++i) {
        const double u = std::floor(1024 * (0.1 + 0.8 * rng.uniform_double())) / 1024;
        const FloatLanes whole = bound->evaluate_on({u, 0.5, {side, 0}, {0, side}}, wi, wo).f;
        FloatLanes sum{};
        for (const double x : {-0.25, 0.25}) {
            sum += bound->evaluate_on({u + x * side, 0.5, {side / 2, 0}, {0, side}}, wi, wo).f;
        }
        EXPECT_NEAR(whole[3], 0.5 * sum[3], 1e-5 * whole[3]);
        total += whole[3];
    }
    EXPECT_GT(total, 0);
}

TEST(SpecialEffect, LosesButNeverGainsLight) {
    for (const bool coat : {false, true}) {
        const auto bound = SpecialEffect(pigment(1e7, coat), 1).bind(kOnGrid);
        Rng rng(3);
        for (const double theta : {5.0, 45.0, 80.0}) {
            const Vec3f wi = direction(theta, 20);
            constexpr int kSamples = 20000;
            FloatLanes sum{}, on_patches{};
            for (int i = 0; i < kSamples; ++i) {
                const float u_select = rng.uniform_float();
                const Vec2f u = {rng.uniform_float(), rng.uniform_float()};
                if (const auto s = bound->sample(wi, u_select, u)) sum += s->weight;
                const Patch patch = somewhere(rng, 3e-6);
                if (const auto s = bound->sample_on(patch, wi, u_select, u))
                    on_patches += s->weight;
            }
            const FloatLanes albedo = bound->albedo(wi);
            for (int k = 0; k < kLanes; ++k) {
                const double tolerance = kSpecialEffectAlbedoError + 4 * 0.5 / std::sqrt(kSamples);
                EXPECT_NEAR(sum[k] / kSamples, albedo[k], tolerance) << theta;
                EXPECT_LE(albedo[k], 1);
                // 30 facets a patch: the same mean, with more variance.
                EXPECT_NEAR(on_patches[k] / kSamples, albedo[k], 2 * tolerance) << theta;
            }
        }
    }
}

// Pearson's test of sample() against pdf() over cells of the sphere, as a z score.
double chi_square_z_score(const BoundBsdf& bound, const Vec3f wi, const Patch* patch) {
    constexpr int kRows = 24, kColumns = 24, kSamples = 60000, kSub = 12;
    std::vector<double> found(kRows * kColumns), expected(kRows * kColumns);
    // Cells are rectangles of slopes about the mirror direction, projected along the normal.
    const double x0 = -wi.x, y0 = -wi.y, reach = 0.35, step = 2 * reach / kRows;
    Rng rng(11);
    int drawn = 0;
    double specular = 0;
    for (int i = 0; i < kSamples; ++i) {
        const float u_select = rng.uniform_float();
        const Vec2f u = {rng.uniform_float(), rng.uniform_float()};
        const auto s =
            patch ? bound.sample_on(*patch, wi, u_select, u) : bound.sample(wi, u_select, u);
        if (!s) continue;
        specular += s->kind == SampleKind::specular;
        if (s->kind == SampleKind::specular) continue;
        ++drawn;
        EXPECT_NEAR(s->pdf, bound.pdf(wi, s->wo), 2e-3f * s->pdf);
        const int x = static_cast<int>(std::floor((s->wo.x - x0 + reach) / step));
        const int y = static_cast<int>(std::floor((s->wo.y - y0 + reach) / step));
        if (x >= 0 && y >= 0 && x < kRows && y < kColumns) ++found[x * kColumns + y];
    }
    for (int x = 0; x < kRows; ++x) {
        for (int y = 0; y < kColumns; ++y) {
            for (int k = 0; k < kSub * kSub; ++k) {
                const double sx = x0 - reach + step * (x + (k % kSub + 0.5) / kSub);
                const double sy = y0 - reach + step * (y + (k / kSub + 0.5) / kSub);
                const double z2 = 1 - sx * sx - sy * sy;
                if (z2 <= 0) continue;
                const double z = std::sqrt(z2);
                const Vec3f wo = {static_cast<float>(sx), static_cast<float>(sy),
                                  static_cast<float>(z)};
                expected[x * kColumns + y] +=
                    kSamples * bound.pdf(wi, wo) * step * step / (kSub * kSub) / z;
            }
        }
    }
    double chi2 = 0, cells = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (expected[i] < 10) continue;
        chi2 += (found[i] - expected[i]) * (found[i] - expected[i]) / expected[i];
        ++cells;
    }
    EXPECT_GT(cells, 30);
    EXPECT_GT(drawn, kSamples / 40);  // under a coat at 80 deg most are specular
    return (chi2 - cells) / std::sqrt(2 * cells);
}

TEST(SpecialEffect, SamplesFollowTheirDensity) {
    const Patch patch{0.5, 0.5, {1e-3f, 0}, {0, 1e-3f}};
    for (const bool coat : {false, true}) {
        const auto bound = SpecialEffect(pigment(1e7, coat), 1).bind(kOnGrid);
        for (const double theta : {0.0, 35.0, 65.0, 80.0}) {
            EXPECT_LT(chi_square_z_score(*bound, direction(theta, 15), nullptr), 4) << theta;
        }
        EXPECT_LT(chi_square_z_score(*bound, direction(35, 15), &patch), 4);
    }
}

// The mean weight is the integral of the BRDF of that patch, facet by facet.
TEST(SpecialEffect, SamplingAPatchIsUnbiased) {
    const auto bound = SpecialEffect(pigment(1e6), 6).bind(kOnGrid);
    const Patch patch{0.37, 0.61, {3e-3f, 0}, {0, 4e-3f}};  // 12 facets
    const Vec3f wi = direction(30, 0);
    Rng rng(12);
    constexpr int kSamples = 40000, kSide = 400;
    double sum = 0, squares = 0;
    for (int i = 0; i < kSamples; ++i) {
        const auto s = bound->sample_on(patch, wi, rng.uniform_float(),
                                        {rng.uniform_float(), rng.uniform_float()});
        const double w = s ? s->weight[4] : 0;
        sum += w;
        squares += w * w;
    }
    const double mean = sum / kSamples;
    double integral = 0;
    for (int x = 0; x < kSide; ++x) {
        for (int y = 0; y < kSide; ++y) {
            // Directions projected along the normal: the cosine is part of the measure.
            const double sx = -0.5 - 0.45 + 0.9 * (x + 0.5) / kSide;
            const double sy = -0.45 + 0.9 * (y + 0.5) / kSide;
            const double z2 = 1 - sx * sx - sy * sy;
            if (z2 <= 0) continue;
            const Vec3f wo = {static_cast<float>(sx), static_cast<float>(sy),
                              static_cast<float>(std::sqrt(z2))};
            integral += bound->evaluate_on(patch, wi, wo).f[4] * (0.9 / kSide) * (0.9 / kSide);
        }
    }
    EXPECT_GT(mean, 0);
    // The grid resolves the edge of a cone of 3 deg, some 40 points wide, to half a percent.
    EXPECT_NEAR(mean, integral,
                4 * std::sqrt((squares / kSamples - mean * mean) / kSamples) + 0.005 * mean);
}

TEST(SpecialEffect, APatchWithoutAreaGivesTheMean) {
    const auto bound = SpecialEffect(pigment(1e7), 1).bind(kOnGrid);
    const Vec3f wi = direction(30, 0), wo = direction(28, 180);
    const FloatLanes mean = bound->eval(wi, wo);
    const FloatLanes point = bound->evaluate_on({0.5, 0.5, {0, 0}, {0, 0}}, wi, wo).f;
    for (int i = 0; i < kLanes; ++i) EXPECT_EQ(point[i], mean[i]);
}

TEST(SpecialEffect, WithASmoothDistributionEveryPatchGivesTheMean) {
    const SpecialEffect counted(pigment(1e7), 1), smooth(pigment(1e7), 1, true);
    EXPECT_TRUE(counted.varies_over_surface());
    EXPECT_FALSE(smooth.varies_over_surface());
    const auto bound = counted.bind(kOnGrid), bound_smooth = smooth.bind(kOnGrid);
    const Vec3f wi = direction(30, 0), wo = direction(31, 179);
    const FloatLanes mean = bound->eval(wi, wo);
    Rng rng(2);
    int differ = 0;
    for (int n = 0; n < 20; ++n) {
        const Patch patch = somewhere(rng, 1e-6);
        const FloatLanes f = bound_smooth->evaluate_on(patch, wi, wo).f;
        for (int i = 0; i < kLanes; ++i) EXPECT_EQ(f[i], mean[i]);
        differ += bound->evaluate_on(patch, wi, wo).f[0] != mean[0];
    }
    EXPECT_GT(differ, 10);  // the patches hold few facets
}

TEST(SpecialEffect, StaysFiniteForAnyPatchAndDirection) {
    const auto bound = SpecialEffect(pigment(1e9, true), 1).bind(kOnGrid);
    constexpr float inf = std::numeric_limits<float>::infinity();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const float numbers[] = {0, 1e-30f, 1e-4f, 0.3f, 50, 1e30f, inf, nan};
    const Vec3f directions[] = {direction(0, 0), direction(30, 180), direction(89.999, 0),
                                direction(89.999, 180)};
    for (const double u : {-1e9, 0.0, 0.4, 1.0, 1e300}) {
        for (const float a : numbers) {
            for (const float b : numbers) {
                for (const Vec3f wi : directions) {
                    for (const Vec3f wo : directions) {
                        const auto value = bound->evaluate_on({u, 0.5, {a, b}, {-b, a}}, wi, wo);
                        for (int k = 0; k < kLanes; ++k) EXPECT_GE(value.f[k], 0);
                        EXPECT_GE(value.pdf, 0);
                    }
                }
            }
        }
    }
}

TEST(SpecialEffect, OneFacetAndATrillion) {
    const Vec3f wi = direction(30, 0), wo = direction(30, 180);
    const Patch all{0.5, 0.5, {1, 0}, {0, 1}};
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const auto f = SpecialEffect(pigment(1), seed).bind(kOnGrid)->evaluate_on(all, wi, wo).f;
        for (int i = 0; i < kLanes; ++i) EXPECT_TRUE(std::isfinite(f[i]) && f[i] >= 0);
    }
    const auto bound = SpecialEffect(pigment(1e12), 1).bind(kOnGrid);
    const FloatLanes f = bound->evaluate_on(all, wi, wo).f, mean = bound->eval(wi, wo);
    for (int i = 0; i < kLanes; ++i) EXPECT_NEAR(f[i], mean[i], 1e-4 * mean[i]);
}

TEST(SpecialEffect, RefusesWhatItCannotCount) {
    const auto message = [](const paint::Recipe& recipe) -> std::string {
        return message_of<DomainError>([&] { SpecialEffect(recipe, 0); });
    };
    EXPECT_THAT(message(paint::Recipe{}), testing::HasSubstr("microfacet"));
    paint::Recipe recipe = pigment(1e6);
    recipe.microfacet->facets.reset();
    EXPECT_THAT(message(recipe), testing::HasSubstr("microfacet.facets"));
    recipe = pigment(1e6);
    recipe.microfacet->distribution = paint::FacetDistribution::ggx;
    EXPECT_THAT(message(recipe), testing::HasSubstr("microfacet.distribution"));
    recipe = pigment(1e6);
    recipe.microfacet->facets->thickness_spread_nm = 92;
    EXPECT_THAT(message(recipe), testing::HasSubstr("[0, 91.4136] nm"));
    recipe = pigment(1e6);
    recipe.microfacet->facets->cone_deg = 60;
    EXPECT_THAT(message(recipe), testing::HasSubstr("microfacet.facets.cone_deg = 60"));
    recipe.microfacet->facets->cone_deg = 10;
    recipe.microfacet->alpha = 0.001;
    EXPECT_THAT(message(recipe), testing::HasSubstr("1.432"));  // 25 alpha
    EXPECT_THAT(message(pigment(0.5)), testing::HasSubstr("microfacet.facets.count"));
    EXPECT_THAT(message(pigment(10.5)), testing::HasSubstr("whole number"));
}

struct Film {
    optics::AiryFilm film{1, 1.8, 1.08, 0.51};
    optics::ThicknessRange range{130, 190};
    SpreadFilm spread{film, 1.8, range, kOnGrid};
};

TEST(SpreadFilm, MeanIsTheClosedForm) {
    const Film f;
    for (const float cosine : {1.0f, 0.7f, 0.3f}) {
        const FloatLanes mean = f.spread.mean(cosine);
        for (int i = 0; i < kLanes; ++i) {
            EXPECT_NEAR(mean[i], f.film.moments(cosine, f.range, kOnGrid[i]).mean,
                        kSpreadFilmError);
        }
    }
}

// Facets one by one, and 32 for a thousand, have the mean and variance of the paper's Gaussian:
// E_d[R] and Var_d[R] / N, in closed form.
TEST(SpreadFilm, SumsHaveTheMeanAndVarianceOfTheFacets) {
    const Film f;
    constexpr float kCosine = 0.8f;
    for (const int count : {1, 8, 32, 1000}) {
        constexpr int kDraws = 4000;
        DoubleLanes sum{}, squares{};
        double product = 0;
        for (int draw = 0; draw < kDraws; ++draw) {
            Rng rng(9, draw);
            sparkle::FacetTally tally;
            for (int k = 0; k < count; ++k) tally.add(rng.uniform_float());
            const FloatLanes r = f.spread.sum(kCosine, tally) * (1.0f / count);
            for (int i = 0; i < kLanes; ++i) {
                sum[i] += r[i];
                squares[i] += static_cast<double>(r[i]) * r[i];
                EXPECT_GE(r[i], 0);
                EXPECT_LE(r[i], 1);
            }
            product += static_cast<double>(r[0]) * r[7];
        }
        for (int i = 0; i < kLanes; ++i) {
            const auto moments = f.film.moments(kCosine, f.range, kOnGrid[i]);
            const double mean = sum[i] / kDraws, variance = moments.variance() / count;
            EXPECT_NEAR(mean, moments.mean, 4 * std::sqrt(variance / kDraws) + kSpreadFilmError);
            EXPECT_NEAR(squares[i] / kDraws - mean * mean, variance,
                        5 * variance * std::sqrt(2.0 / kDraws))
                << count << " facets, lane " << i;
        }
        // Blue and red: E_d[R R'] - E_d[R] E_d[R'], by the sum over thickness.
        double blue = 0, red = 0, both = 0;
        constexpr int kSteps = 2000;
        for (int k = 0; k < kSteps; ++k) {
            const float d = static_cast<float>(f.range.lo_nm + (f.range.hi_nm - f.range.lo_nm) *
                                                                   (k + 0.5) / kSteps);
            const FloatLanes r = f.film.reflectance(
                kCosine, d, make_lanes([](int i) { return static_cast<float>(1 / kOnGrid[i]); }));
            blue += r[0] / kSteps;
            red += r[7] / kSteps;
            both += static_cast<double>(r[0]) * r[7] / kSteps;
        }
        const double scale = std::sqrt(f.film.moments(kCosine, f.range, kOnGrid[0]).variance() *
                                       f.film.moments(kCosine, f.range, kOnGrid[7]).variance());
        EXPECT_NEAR(product / kDraws - sum[0] / kDraws * (sum[7] / kDraws),
                    (both - blue * red) / count, 5 * scale / count * std::sqrt(2.0 / kDraws));
    }
}

}  // namespace
}  // namespace nacre::bsdf
