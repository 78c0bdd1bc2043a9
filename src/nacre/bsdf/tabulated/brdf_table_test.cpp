#include "nacre/bsdf/tabulated/brdf_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/bsdf/tabulated/compression.h"
#include "nacre/core/error.h"
#include "nacre/core/progress.h"
#include "nacre/core/random.h"
#include "nacre/spectra/rgb.h"
#include "nacre/testing/layers.h"
#include "nacre/testing/statistics.h"

namespace nacre::bsdf {
namespace {

optics::Platelet titania_on_mica() {
    optics::Platelet platelet;
    platelet.core = {optics::find_material("mica"), 500, {60}};
    platelet.coats = {{optics::find_material("TiO2_anatase"), 80, {5}}};
    return platelet;
}

// Pearl over opaque flakes, a pigment, an absorbing clearcoat, a substrate.
paint::Recipe everything(double roughness) {
    paint::Recipe recipe = solver::test::flake_paint(
        0.15, spectra::Spectrum({400.0, 700.0}, {0.4, 0.8}), 0.1, 1.5, 1.5);
    paint::FlakeSpecies pearl = solver::test::flake_species(0.2, 0, 0);
    pearl.body = titania_on_mica();
    recipe.layers.insert(recipe.layers.begin(),
                         paint::Layer{8, {pearl}, {{paint::PigmentCoefficients{20.0, 5.0, 0.4}}}});
    recipe.clearcoat =
        paint::Clearcoat{40, spectra::Spectrum({400.0, 700.0}, {6.0, 1.0}), roughness};
    recipe.substrate_reflectance = 0.3;
    return recipe;
}

solver::SolvedPaint solved(const paint::Recipe& recipe) {
    solver::SolverSettings coarse;  // the table is compared with this very solution
    coarse.exit_nodes = 16;
    coarse.inner_nodes = 8;
    return solve(recipe, {400, 450, 500, 550, 600, 650, 700}, coarse);
}

constexpr BrdfTableSettings kSmall = {24, 20};

// Largest difference between f at the nodes and the colour of solver::SolvedPaint::brdf, over the
// peak of each incident node.
double worst_node_error(const solver::SolvedPaint& paint) {
    const RawBrdfTable table = make_raw_table(paint, kSmall);
    const std::vector<Vec3d> weights = spectra::rec709_weights(paint.wavelengths_nm());
    const int n = table.grid.angles, m = table.grid.azimuths;
    double worst = 0;
    for (int i = 0; i < n; i += 5) {
        double peak = 0, error = 0;
        for (int o = 0; o < n; o += 3) {
            const double theta_i = table.grid.angle(i), theta_o = table.grid.angle(o);
            const double factor = table.grid.factor(theta_i, theta_o);
            for (int j = 0; j < m; j += 4) {
                const double phi = table.grid.azimuth(theta_i, theta_o, j);
                const std::vector<double> f = paint.brdf(theta_i, theta_o, phi);
                for (int c = 0; c < 3; ++c) {
                    double expected = 0;
                    for (std::size_t w = 0; w < f.size(); ++w) expected += weights[w][c] * f[w];
                    const double found =
                        factor *
                        table.values[3 * ((static_cast<std::size_t>(i) * n + o) * m + j) + c];
                    peak = std::max(peak, std::abs(expected));
                    error = test::worse(error, std::abs(found - expected));
                }
            }
        }
        EXPECT_GT(peak, 0);
        worst = test::worse(worst, error / peak);
    }
    return worst;
}

TEST(BrdfTable, HoldsTheColourOfTheSolvedPaintAtItsNodes) {
    EXPECT_LT(worst_node_error(solved(everything(0))), kRawNodeError);
}

TEST(BrdfTable, HoldsTheLobeOfARoughInterfaceToo) {
    EXPECT_LT(worst_node_error(solved(everything(0.2))), kRawNodeError);
}

TEST(BrdfTable, FollowsADispersiveBinder) {
    paint::Recipe recipe = solver::test::flake_paint(0.2, 0.8, 0, 1, 1.5);
    recipe.binder = optics::Material("crown", {400, 700}, {{1.56, 0}, {1.48, 0}});
    EXPECT_LT(worst_node_error(solved(recipe)), kRawNodeError);
}

TEST(BrdfTable, IsReciprocalAndDoesNotDependOnThreads) {
    const solver::SolvedPaint paint = solved(everything(0));
    const RawBrdfTable table = make_raw_table(paint, kSmall);
    const int n = table.grid.angles, line = 3 * table.grid.azimuths;
    for (int i = 0; i < n; ++i) {
        for (int o = 0; o < i; ++o) {
            const auto row = [&](int a, int b) {
                return table.values.begin() + (a * n + b) * line;
            };
            ASSERT_TRUE(std::equal(row(i, o), row(i, o) + line, row(o, i)));
        }
    }
    EXPECT_EQ(make_raw_table(paint, kSmall), table);
}

TEST(BrdfTable, HasTheSizeOfThePaper) {
    BrdfGrid grid;
    EXPECT_EQ(3 * grid.values() * sizeof(float), std::size_t{96} << 20);  // [mir-2022]
}

TEST(BrdfTable, ReportsProgressAndStopsWhenAsked) {
    const solver::SolvedPaint paint = solved(solver::test::flake_paint(0.3, 0.6, 0, 1, 1.5));
    double last = 0;
    make_raw_table(paint, kSmall, [&](double fraction) {
        EXPECT_GE(fraction, last);
        last = fraction;
        return true;
    });
    EXPECT_DOUBLE_EQ(last, 1);
    EXPECT_THROW(make_raw_table(paint, kSmall, [](double) { return false; }), Error);
}

TEST(BrdfTable, RefusesSizesOutOfRange) {
    const solver::SolvedPaint paint = solved(solver::test::flake_paint(0.3, 0.6, 0, 1, 1.5));
    EXPECT_THROW(make_raw_table(paint, {7, 128}), DomainError);
    EXPECT_THROW(make_raw_table(paint, {256, 1000}), DomainError);
}

TEST(BrdfGrid, PositionsAreTheInverseOfNodes) {
    for (const double roughness : {0.0, 0.1}) {
        BrdfGrid grid;
        grid.roughness = roughness;
        for (const int i : {1, 40, 200, 254}) {
            for (const int o : {1, 3, 90, 253}) {
                for (const int j : {0, 1, 64, 126, 127}) {
                    const double theta_i = grid.angle(i), theta_o = grid.angle(o);
                    const double phi = grid.azimuth(theta_i, theta_o, j);
                    const auto sine = [](double x) { return static_cast<float>(std::sin(x)); };
                    const auto cosine = [](double x) { return static_cast<float>(std::cos(x)); };
                    const auto mu = [&](double theta) {
                        return static_cast<float>(solver::inside_cosine(grid.side_ior(), theta));
                    };
                    const Vec3f wi = {sine(theta_i), 0, cosine(theta_i)};
                    const Vec3f wo = {sine(theta_o) * cosine(phi), sine(theta_o) * sine(phi),
                                      cosine(theta_o)};
                    const BrdfCell cell = locate(grid, wi, wo, sine(theta_i), sine(theta_o),
                                                 mu(theta_i), mu(theta_o));
                    double at_i = 0, at_o = 0, at_j = 0, sum = 0;
                    for (int k = 0; k < 4; ++k) {
                        at_i += cell.pair_weight[k] * (cell.pair[k] / grid.angles);
                        at_o += cell.pair_weight[k] * (cell.pair[k] % grid.angles);
                        at_j += cell.azimuth_weight[k] * (cell.azimuth + k);
                        sum += cell.azimuth_weight[k];
                    }
                    // Single precision, at 256 nodes; near u = 0 the root amplifies rounding of the
                    // difference of two directions.
                    EXPECT_NEAR(at_i, i, 1e-3);
                    EXPECT_NEAR(at_o, o, 1e-3);
                    EXPECT_NEAR(at_j, j, 0.02) << i << ' ' << o;
                    EXPECT_NEAR(sum, 1, 1e-5);
                }
            }
        }
    }
}

const RawBrdfTable& pearl_table() {
    static const RawBrdfTable table = make_raw_table(solved(everything(0)), {64, 48});
    return table;
}

TEST(BrdfTableSvd, EachRankAtLeastHalvesTheError) {
    double last = 1;
    for (int r = 1; r <= 5; ++r) {
        const double error = relative_error(compress(pearl_table(), {r, 0.5}), pearl_table());
        EXPECT_LT(error, last / 2) << r;
        last = error;
    }
    // All terms that a row of 48 azimuths can have: nothing is lost but single precision.
    EXPECT_LT(relative_error(compress(pearl_table(), {10, 0.5}), pearl_table()), 1e-6);
}

TEST(BrdfTableSvd, ChoosesTheSmallestRankWithinTheTolerance) {
    const CompressedBrdfTable found = compress(pearl_table(), {0, 2e-3});
    int r = 1;
    while (terms_of_rank(r) < found.rank[0]) ++r;
    ASSERT_GT(r, 1);
    EXPECT_LE(relative_error(found, pearl_table()), 2e-3);
    EXPECT_GT(relative_error(compress(pearl_table(), {r - 1, 0.5}), pearl_table()), 2e-3);
}

TEST(BrdfTableSvd, HasTheSizesOfThePaper) {
    // n^2 k + m k floats for each channel; [mir-2022] gives 4.5 and 5.0 MB.
    constexpr double kMiB = 1 << 20;
    EXPECT_NEAR(3 * (65536 + 128) * terms_of_rank(3) * 4 / kMiB, 4.509, 5e-4);
    EXPECT_NEAR(2 * (65536 + 128) * terms_of_rank(4) * 4 / kMiB, 5.010, 5e-4);
    const CompressedBrdfTable c = compress(pearl_table(), {3, 0.5});
    EXPECT_EQ(c.bytes(), 3u * (64 * 64 + 48) * 6 * 4);
}

TEST(BrdfTableSvd, LeavesOutAChannelThatIsZero) {
    RawBrdfTable table = pearl_table();
    for (std::size_t at = 1; at < table.values.size(); at += 3) table.values[at] = 0;
    const CompressedBrdfTable c = compress(table, {3, 0.5});
    EXPECT_EQ(c.rank, (std::array<int, 3>{6, 0, 6}));
    EXPECT_LT(relative_error(c, table), 1e-3);  // found: 9e-5
    for (float& v : table.values) v = 0;
    const CompressedBrdfTable black = compress(table, {});
    EXPECT_EQ(black.terms(), 0);
    EXPECT_EQ(relative_error(black, table), 0);
}

TEST(BrdfTableSvd, ClipsToTheGamutWhenAsked) {
    RawBrdfTable table = pearl_table();
    for (std::size_t at = 1; at < table.values.size(); at += 3) table.values[at] *= -0.01f;
    EXPECT_EQ(compress(table, {3, 0.5, false}).rank, (std::array<int, 3>{6, 6, 6}));
    const CompressedBrdfTable clipped = compress(table, {3, 0.5, true});
    EXPECT_EQ(clipped.rank, (std::array<int, 3>{6, 0, 6}));
    EXPECT_EQ(clipped.bytes(), 2u * (64 * 64 + 48) * 6 * 4);
}

TEST(BrdfTableSvd, StaysReciprocal) {
    const CompressedBrdfTable c = compress(pearl_table(), {3, 0.5});
    const int n = c.grid.angles, all = c.terms();
    for (int i = 0; i < n; ++i) {
        for (int o = 0; o < i; ++o) {
            for (int k = 0; k < all; ++k) {
                ASSERT_EQ(c.left[(i * n + o) * all + k], c.left[(o * n + i) * all + k]);
            }
        }
    }
}

TEST(BrdfTableSvd, RefusesSettingsOutOfRange) {
    EXPECT_THROW(compress(pearl_table(), {11, 0.1}), DomainError);
    EXPECT_THROW(compress(pearl_table(), {0, 0}), DomainError);
    RawBrdfTable noise;  // of full rank
    noise.grid.angles = 16;
    noise.values.resize(3 * noise.grid.values());
    Rng rng(1);
    for (float& v : noise.values) v = rng.uniform_float();
    EXPECT_THROW(compress(noise, {0, 0.01}), Error);
}

TEST(BrdfTable, SaysThatItWasStopped) {
    const solver::SolvedPaint paint = solved(everything(0));
    EXPECT_THROW(make_raw_table(paint, kSmall, [](double) { return false; }), Stopped);
}

}  // namespace
}  // namespace nacre::bsdf
