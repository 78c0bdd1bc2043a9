#include "nacre/bsdf/tabulated/fourier_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/bsdf/tabulated/tabulated.h"
#include "nacre/core/error.h"
#include "nacre/core/progress.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/rgb.h"
#include "nacre/testing/bsdf.h"
#include "nacre/testing/paints.h"
#include "nacre/testing/statistics.h"

namespace nacre::bsdf {
namespace {

constexpr BrdfTableSettings kFewNodes = {24, 96};

solver::SolvedPaint solved_flakes(const spectra::Spectrum& reflectance) {
    return solver::solve(test::metallic(0.1, reflectance), {400, 450, 500, 550, 600, 650, 700});
}

const spectra::Spectrum kPink({400.0, 550.0, 700.0}, {0.7, 0.3, 0.9});

Vec3d colour_of(const solver::SolvedPaint& paint, double theta_i, double theta_o, double phi) {
    const auto weights = spectra::rec709_weights(paint.wavelengths_nm());
    const std::vector<double> f = paint.brdf(theta_i, theta_o, phi);
    Vec3d rgb{};
    for (std::size_t w = 0; w < f.size(); ++w) rgb += f[w] * weights[w];
    return rgb;
}

Vec3f unit(double theta, double phi) {
    return {static_cast<float>(std::sin(theta) * std::cos(phi)),
            static_cast<float>(std::sin(theta) * std::sin(phi)),
            static_cast<float>(std::cos(theta))};
}

/// Largest error at polar nodes and any azimuth, over the peak of each incident node: what the
/// series leaves out, without the interpolation between nodes.
double worst_series_error(const solver::SolvedPaint& paint, const FourierBrdfTable& table) {
    double worst = 0;
    const int n = table.grid.angles;
    for (int i = 1; i < n; i += 4) {
        double peak = 0, error = 0;
        for (int o = 0; o < n - 1; o += 3) {
            const double theta_i = table.grid.angle(i), theta_o = table.grid.angle(o);
            BrdfCell cell{};
            cell.pair.fill(static_cast<std::size_t>(i) * n + o);
            cell.pair_weight = {1, 0, 0, 0};
            for (const double phi : {0.0, 1.1, 2.6, 3.0, 3.1, std::numbers::pi}) {
                const double ior = table.grid.ior;
                const Vec3f a = unit(std::asin(std::sin(theta_i) / ior), 0),
                            b = unit(std::asin(std::sin(theta_o) / ior), phi);
                const spectra::Rgb g =
                    table.interpolate(cell, static_cast<float>(std::cos(phi)),
                                      std::sqrt(std::max(0.0f, (1 + dot(a, b)) / 2)));
                const Vec3d expected = colour_of(paint, theta_i, theta_o, phi);
                for (int c = 0; c < 3; ++c) {
                    const double found = g[c] * table.grid.factor(theta_i, theta_o);
                    peak = std::max(peak, std::abs(expected[c]));
                    error = test::worse(error, std::abs(found - expected[c]));
                }
            }
        }
        worst = test::worse(worst, error / peak);
    }
    return worst;
}

TEST(FourierTable, AtItsNodesTheSeriesIsTheColourOfTheSolvedPaintAtEveryAzimuth) {
    const solver::SolvedPaint paint = solved_flakes(kPink);
    // Single precision sums of 96 orders: found 2e-6.
    EXPECT_LT(worst_series_error(paint, make_fourier_table(paint, kFewNodes)), 1e-5);
    // A lobe of roughness 0.1 under a coat takes some 26 orders.
    EXPECT_GT(worst_series_error(paint, make_fourier_table(paint, {24, 10})), 1e-2);
}

TEST(FourierTable, ReflectanceIsThatOfTheFlakesAndIsDividedOutWhereItCanBe) {
    const FourierBrdfTable gray = make_fourier_table(solved_flakes(spectra::Spectrum(0.6)), {8, 8});
    ASSERT_EQ(gray.reflectance.size(), 65u);
    for (const spectra::Rgb& R : gray.reflectance) {
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(R[c], 0.6, 1e-6);
    }
    // What is dark in one channel is not divided by that.
    const FourierBrdfTable red =
        make_fourier_table(solved_flakes(spectra::Spectrum({600.0, 650.0}, {0.0, 0.9})), {8, 8});
    EXPECT_NE(red.reflectance[0][0], 1);
    EXPECT_EQ(red.reflectance[0][1], 1);
    EXPECT_EQ(red.reflectance[0][2], 1);
}

TEST(FourierTable, CompressionErrsTheLessTheMoreTermsItKeeps) {
    const solver::SolvedPaint paint = solved_flakes(kPink);
    const FourierBrdfTable table = make_fourier_table(paint, kFewNodes);
    double before = 1;
    for (int rank : {2, 3, 5}) {
        const FourierBrdfTable svd = compress(table, {.rank = rank});
        const double error = worst_series_error(paint, svd);
        EXPECT_LT(error, before / 2) << rank;
        EXPECT_LT(svd.bytes(), table.bytes() / 2);
        before = error;
    }
    EXPECT_THROW(compress(compress(table, {.rank = 2}), {.rank = 2}), DomainError);
    EXPECT_THROW(compress(table, {.rank = 2, .clip_to_gamut = true}), DomainError);
}

TEST(FourierTable, HasThePapersSize) {
    FourierBrdfTable table;
    RawBrdfTable raw;
    raw.values.resize(256 * 256 * 128 * 3);
    table.coefficients = std::move(raw);
    EXPECT_EQ(table.bytes(), std::size_t{96} << 20);
}

TEST(FourierTable, RendersTheColourOfTheSolvedPaint) {
    const solver::SolvedPaint paint = solved_flakes(spectra::Spectrum(0.6));
    const auto table =
        std::make_shared<const FourierBrdfTable>(make_fourier_table(paint, {128, 64}));
    const auto bound = Tabulated(table).bind({418, 456, 493, 531, 568, 606, 643, 681});
    double peak = 0, error = 0;
    for (double theta_o = 3; theta_o < 70; theta_o += 4.3) {
        for (const double phi : {180.0, 170.0, 130.0, 20.0}) {
            const double degree = std::numbers::pi / 180;
            const double expected =
                colour_of(paint, 40 * degree, theta_o * degree, phi * degree)[1];
            const FloatLanes found = bound->eval(direction(40, 0), direction(theta_o, phi));
            peak = std::max(peak, expected);
            error = test::worse(error, std::abs(found[3] - expected));
        }
    }
    // Linear between 128 polar nodes: a quarter of the error with twice as many.
    EXPECT_LT(error, 2e-2 * peak);
    EXPECT_GT(peak, 0.1);
}

TEST(FourierTable, SaysThatItWasStopped) {
    const solver::SolvedPaint paint = solved_flakes(spectra::Spectrum(0.6));
    EXPECT_THROW(make_fourier_table(paint, {24, 20}, [](double) { return false; }), Stopped);
}

}  // namespace
}  // namespace nacre::bsdf
