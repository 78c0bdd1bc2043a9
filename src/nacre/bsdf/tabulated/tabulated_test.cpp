#include "nacre/bsdf/tabulated/tabulated.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nacre/bsdf/models/microflake.h"
#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/core/random.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/rgb.h"
#include "nacre/testing/bsdf.h"
#include "nacre/testing/paints.h"
#include "nacre/testing/statistics.h"

namespace nacre::bsdf {
namespace {

using test::metallic;

const Wavelengths kUnsolvedWavelengths = {418, 456, 493, 531, 568, 606, 643, 681};

const spectra::Spectrum kGold({400.0, 500.0, 700.0}, {0.3, 0.5, 0.9});

struct Tables {
    solver::SolvedPaint paint;
    std::shared_ptr<const RawBrdfTable> raw;
    std::shared_ptr<const CompressedBrdfTable> compressed;

    explicit Tables(const paint::Recipe& recipe, const BrdfTableSettings& settings = {})
        : paint(solver::solve(recipe, {400, 450, 500, 550, 600, 650, 700})),
          raw(std::make_shared<const RawBrdfTable>(make_raw_table(paint, settings))),
          compressed(std::make_shared<const CompressedBrdfTable>(compress(*raw, {3, 0.5}))) {}
};

/// For what holds for a table of any size.
const Tables& gold() {
    static const Tables model(metallic(0.1, kGold), {64, 48});
    return model;
}

// The colour of the solved spectrum, as a spectrum by the basis at eight wavelengths.
FloatLanes expected(const solver::SolvedPaint& paint, double theta_i, double theta_o, double phi) {
    const auto f = paint.brdf(theta_i * kDegree, theta_o * kDegree, phi * kDegree);
    const auto weights = spectra::rec709_weights(paint.wavelengths_nm());
    Vec3d rgb{};
    for (std::size_t w = 0; w < f.size(); ++w) {
        for (int c = 0; c < 3; ++c) rgb[c] += weights[w][c] * f[w];
    }
    return make_lanes([&](int lane) {
        double sum = 0;
        for (int j = 0; j < 3; ++j) {
            sum += rgb[j] * spectra::linear_rec709_basis()[j](kUnsolvedWavelengths[lane]);
        }
        return static_cast<float>(std::max(0.0, sum));
    });
}

// Largest difference to expected() over the peak of each incident direction.
template <class Table>
double worst_error(const solver::SolvedPaint& paint, std::shared_ptr<const Table> table,
                   double step_deg = 4.3) {
    const auto bound = Tabulated(table).bind(kUnsolvedWavelengths);
    double worst = 0;
    for (const double theta_i : {0.1, 20.0, 45.0, 60.0, 75.0, 85.0, 89.0}) {
        double peak = 0, error = 0;
        for (const double phi : {180.0, 176.3, 165.5, 130.0, 1.0}) {
            for (double theta_o = 0.5; theta_o < 90; theta_o += step_deg) {
                const FloatLanes wanted = expected(paint, theta_i, theta_o, phi);
                const FloatLanes found =
                    bound->eval(direction(theta_i, 0), direction(theta_o, phi));
                peak = std::max<double>(peak, lane_max(wanted));
                error =
                    std::max<double>(error, lane_max(max_lanes(found - wanted, wanted - found)));
            }
        }
        worst = test::worse(worst, error / peak);
    }
    return worst;
}

TEST(Tabulated, AgreesWithTheColourOfTheSolvedPaintWhateverItsRoughness) {
    for (const double alpha : {0.07, 0.4}) {
        SCOPED_TRACE(alpha);
        const Tables model(metallic(alpha, kGold));
        EXPECT_LT(worst_error(model.paint, model.raw), kTabulatedError);
        EXPECT_LT(worst_error(model.paint, model.compressed), kTabulatedCompressedError);
    }
}

TEST(Tabulated, AgreesWithTheSolvedPaintWithoutACoat) {
    paint::Recipe recipe = metallic(0.3, kGold);
    recipe.binder = optics::Material(1.0);
    const Tables model(recipe);
    // Many nodes and orders make the solved paint slow to ask.
    EXPECT_LT(worst_error(model.paint, model.raw, 9.7), kTabulatedError);
}

// A rough interface has lobes that sharpen towards grazing: 2 % of the peak beyond 85 deg.
TEST(Tabulated, FollowsARoughInterface) {
    paint::Recipe recipe = metallic(0.1, kGold);
    recipe.clearcoat = paint::Clearcoat{40, 0.0, 0.2};
    const Tables model(recipe);
    EXPECT_LT(worst_error(model.paint, model.raw), 5e-3);
    EXPECT_LT(worst_error(model.paint, model.compressed), 4e-2);
}

TEST(Tabulated, GreyIsTheSameAtEveryWavelength) {
    const Tables model(metallic(0.2, 0.6), {64, 32});
    const FloatLanes f =
        Tabulated(model.raw).bind(kUnsolvedWavelengths)->eval(direction(45, 0), direction(40, 170));
    for (int lane = 1; lane < kLanes; ++lane) EXPECT_NEAR(f[lane], f[0], 1e-5 * f[0]);
}

TEST(Tabulated, IsReciprocalAndNeverNegative) {
    expect_reciprocal(*Tabulated(gold().compressed).bind(kUnsolvedWavelengths), 2000);
    expect_reciprocal(*Tabulated(gold().raw).bind(kUnsolvedWavelengths), 2000);
}

TEST(Tabulated, IsBlackBelowTheHorizon) {
    expect_black_below_the_horizon(*Tabulated(gold().raw).bind(kUnsolvedWavelengths));
}

TEST(Tabulated, IsFiniteAtTheNormalAndAtTheHorizon) {
    paint::Recipe bare = metallic(0.3, kGold);
    bare.binder = optics::Material(1.0);
    paint::Recipe satin = metallic(0.3, kGold);
    satin.clearcoat = paint::Clearcoat{40, 0.0, 0.1};
    for (const paint::Recipe& recipe : {metallic(0.1, kGold), bare, satin}) {
        const Tables model(recipe, {32, 16});
        const auto bound = Tabulated(model.compressed).bind(kUnsolvedWavelengths);
        const Vec3f edges[] = {{0, 0, 1},       {1e-30f, 0, 1}, {0, -1e-12f, 1},    {1, 0, 1e-20f},
                               {-1, 0, 1e-20f}, {0, 1, 1e-6f},  {0.6f, 0.8f, 1e-4f}};
        for (const Vec3f& a : edges) {
            for (const Vec3f& b : edges) {
                const BsdfValue both = bound->evaluate(a, b);
                for (int lane = 0; lane < kLanes; ++lane) {
                    ASSERT_TRUE(std::isfinite(both.f[lane]) && both.f[lane] >= 0);
                }
                ASSERT_TRUE(std::isfinite(both.pdf) && both.pdf >= 0)
                    << a.x << ' ' << a.y << ' ' << a.z << ' ' << b.x << ' ' << b.y << ' ' << b.z;
            }
            for (const float u : {0.0f, 0.3f, 0.7f, 0.99f}) {
                const auto s = bound->sample(a, u, {u, 1 - u});
                if (s) {
                    ASSERT_TRUE(std::isfinite(lane_max(s->weight)));
                }
            }
        }
    }
}

TEST(Tabulated, SampleReportsItsOwnDensityAndWeight) {
    const auto bound = Tabulated(gold().compressed).bind(kUnsolvedWavelengths);
    const Drawn drawn = expect_own_density_and_weight(*bound, 4000, 1e-4f);
    EXPECT_GT(drawn.specular, 100);
    EXPECT_GT(drawn.others, 2000);
    // A fiftieth of all samples is drawn from the cosine lobe, which bounds the weights.
    EXPECT_LT(drawn.largest_weight, 8);
}

TEST(Tabulated, SamplesFollowTheDensity) {
    paint::Recipe satin = metallic(0.2, kGold);
    satin.clearcoat = paint::Clearcoat{40, 0.0, 0.2};
    const Tables of_default_size(metallic(0.1, kGold)), rough(satin, {64, 48}),
        diffuse(metallic(0.4, kGold), {64, 48});
    int tests = 0;
    for (const Tables* model : {&of_default_size, &rough, &diffuse}) {
        const auto bound = Tabulated(model->raw).bind(kUnsolvedWavelengths);
        for (const double theta_i : {0.5, 35.0, 65.0, 85.0}) {
            // One-sided, twelve tests with fixed seeds: 3.5 deviations are one false alarm in 400.
            EXPECT_LT(chi_square_z_score(*bound, direction(theta_i, 0), 11 + tests, 100000), 3.5)
                << theta_i << ' ' << tests;
            ++tests;
        }
    }
    EXPECT_EQ(tests, 12);
}

TEST(Tabulated, AlbedoIsTheMeanWeightAndThatOfTheSolvedPaint) {
    // Grey, so that colours and spectra are the same.
    const Tables model(metallic(0.1, 0.8), {128, 64});
    const auto bound = Tabulated(model.compressed).bind(kUnsolvedWavelengths);
    const auto spectral = Microflake(std::make_shared<const solver::SolvedPaint>(model.paint))
                              .bind(kUnsolvedWavelengths);
    for (const double theta_i : {0.5, 40.0, 70.0, 86.0}) {
        const auto [mean, error] = mean_weight(*bound, direction(theta_i, 0), 4, 40000, 9);
        const double albedo = bound->albedo(direction(theta_i, 0))[4];
        EXPECT_NEAR(albedo, mean, 4 * error + 1e-3);  // quadrature and linear rows add up to 1e-3
        EXPECT_NEAR(albedo, spectral->albedo(direction(theta_i, 0))[4], 6e-3);  // its own 5e-3
        EXPECT_LT(albedo, 1);
    }
}

TEST(Tabulated, RefusesTablesThatDoNotFit) {
    RawBrdfTable raw;
    raw.grid.angles = raw.grid.azimuths = 8;
    raw.values.resize(3 * raw.grid.values() - 1);
    const auto make = [](const auto& table) {
        Tabulated(std::make_shared<const std::decay_t<decltype(table)>>(table));
    };
    EXPECT_THROW(make(raw), DomainError);
    raw.values.push_back(0);
    EXPECT_NO_THROW(make(raw));  // black
    raw.grid.ior = 0.9;
    EXPECT_THROW(make(raw), DomainError);

    CompressedBrdfTable compressed;
    compressed.grid.angles = compressed.grid.azimuths = 8;
    EXPECT_NO_THROW(make(compressed));  // black
    compressed.rank[1] = 2;
    EXPECT_THROW(make(compressed), DomainError);
    compressed.rank[1] = -1;
    EXPECT_THROW(make(compressed), DomainError);
}

}  // namespace
}  // namespace nacre::bsdf
