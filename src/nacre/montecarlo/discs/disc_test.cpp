#include "nacre/montecarlo/discs/disc.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "nacre/core/error.h"
#include "nacre/montecarlo/medium.h"
#include "nacre/testing/discs.h"
#include "nacre/testing/errors.h"

namespace nacre::montecarlo {
namespace {

using nacre::test::message_of;

/// Mean and its standard error.
template <class F>
std::pair<double, double> mean_of(const std::vector<Disc>& discs, F&& f) {
    double sum = 0, squares = 0;
    for (const Disc& d : discs) {
        sum += f(d);
        squares += f(d) * f(d);
    }
    const double n = static_cast<double>(discs.size()), mean = sum / n;
    return {mean, std::sqrt(std::max(0.0, squares / n - mean * mean) / n)};
}

template <class F>
void expect_mean(const std::vector<Disc>& discs, double expected, const char* what, F&& f) {
    const auto [mean, error] = mean_of(discs, f);
    EXPECT_GT(error, 0) << what;
    EXPECT_LT(std::abs(mean - expected), test::kWorstZ * error) << what << ": " << mean;
}

TEST(Disc, NumberAreaPlaceAndNormalFollowTheRecipe) {
    paint::Recipe recipe = test::opaque(1.5, 15, 18, 0.2);
    recipe.layers[0].flakes[0].diameter_spread_um = 6;
    recipe.layers.emplace_back().thickness_um = 50;  // room below
    const Tile tile{3000, 2000};
    const auto discs = draw_discs(recipe, tile, {7}, 11);
    const double expected = expected_discs(recipe, tile);
    EXPECT_LT(std::abs(static_cast<double>(discs.size()) - expected), 4 * std::sqrt(expected));
    EXPECT_GT(expected, 20000);

    double area = 0;
    for (const Disc& d : discs) area += M_PI * d.radius_um * d.radius_um;
    // A compound Poisson sum: deviation of about 1.4 of the mean area over sqrt(n).
    EXPECT_NEAR(area / (tile.width_um * tile.height_um), 1.5, 4 * 1.5 * 1.4 / std::sqrt(expected));

    expect_mean(discs, tile.width_um / 2, "x", [](const Disc& d) { return d.centre_um.x; });
    expect_mean(discs, tile.height_um / 2, "y", [](const Disc& d) { return d.centre_um.y; });
    expect_mean(discs, -57.5, "z", [](const Disc& d) { return d.centre_um.z; });
    expect_mean(discs, 15 * 15 / 12., "variance of z",
                [](const Disc& d) { return (d.centre_um.z + 57.5) * (d.centre_um.z + 57.5); });
    const auto p = [](const Disc& d) { return d.normal.x / d.normal.z; };
    const auto q = [](const Disc& d) { return d.normal.y / d.normal.z; };
    expect_mean(discs, 0, "slope", p);
    expect_mean(discs, 0.02, "variance", [&](const Disc& d) { return p(d) * p(d); });
    expect_mean(discs, 0.02, "variance", [&](const Disc& d) { return q(d) * q(d); });
    expect_mean(discs, 3 * 0.0004, "Gaussian", [&](const Disc& d) { return std::pow(q(d), 4); });
    expect_mean(discs, 0, "covariance", [&](const Disc& d) { return p(d) * q(d); });
    expect_mean(discs, 0, "slope against size", [&](const Disc& d) { return p(d) * d.radius_um; });
    expect_mean(discs, 3, "film", [](const Disc& d) { return d.film; });
    for (const Disc& d : discs) ASSERT_NEAR(length(d.normal), 1, 1e-6);
}

TEST(Disc, LeaningFlakesSpreadAboutTheirMeanNormal) {
    paint::Recipe recipe = test::opaque(1.5, 15, 18, 0.2);
    recipe.layers.emplace_back().thickness_um = 50;  // room below
    recipe.lean = paint::FlakeLean{8, 30};
    const auto discs = draw_discs(recipe, {3000, 2000}, {7}, 11);
    EXPECT_GT(discs.size(), 20000u);
    const FlakeFrame frame(recipe.lean->tangents());
    EXPECT_NEAR(frame.n.z, std::cos(8 * M_PI / 180), 1e-12);
    EXPECT_NEAR(std::atan2(frame.n.y, frame.n.x), M_PI / 6, 1e-12);
    const auto in_frame = [&](const Disc& d) {
        const Vec3d m = frame.to_flakes({d.normal.x, d.normal.y, d.normal.z});
        return std::array{m.x / m.z, m.y / m.z};
    };
    const auto p = [&](const Disc& d) { return in_frame(d)[0]; };
    const auto q = [&](const Disc& d) { return in_frame(d)[1]; };
    expect_mean(discs, 0, "slope", p);
    expect_mean(discs, 0, "slope", q);
    expect_mean(discs, 0.02, "variance", [&](const Disc& d) { return p(d) * p(d); });
    expect_mean(discs, 0.02, "variance", [&](const Disc& d) { return q(d) * q(d); });
    expect_mean(discs, 0, "covariance", [&](const Disc& d) { return p(d) * q(d); });
    for (const Disc& d : discs) ASSERT_NEAR(length(d.normal), 1, 1e-6);
}

TEST(Disc, NoFlakeSticksOutOfThePaint) {
    paint::Recipe recipe = test::opaque(1, 15, 80, 0.3);
    recipe.clearcoat.reset();
    std::size_t moved = 0;
    for (const Disc& d : draw_discs(recipe, {20000, 20000}, {1}, 2)) {
        const double half = d.radius_um * std::hypot(d.normal.x, d.normal.y);
        const bool fits = 2 * half < 15;
        EXPECT_LE(d.centre_um.z + half, fits ? 1e-4 : 1e3);
        EXPECT_GE(d.centre_um.z - half, fits ? -15 - 1e-4 : -1e3);
        EXPECT_TRUE(fits || std::abs(d.centre_um.z + 7.5) < 1e-6);
        moved += !fits;
    }
    EXPECT_GT(moved, 100u);
}

TEST(Disc, SpeciesKeepToTheirLayers) {
    paint::Recipe recipe = test::opaque(0.5, 10, 4, 0.01);
    recipe.layers.push_back(recipe.layers[0]);
    recipe.layers[1].flakes.push_back(recipe.layers[0].flakes[0]);
    std::array<int, 3> count{};
    for (const Disc& d : draw_discs(recipe, {500, 500}, {1, 1, 1}, 5)) {
        ++count[d.species];
        const double top = d.species == 0 ? -50 : -60;
        EXPECT_LE(d.centre_um.z, top);
        EXPECT_GE(d.centre_um.z, top - 10 - 1e-4);
    }
    for (int n : count) EXPECT_GT(n, 8000);
}

TEST(Disc, SameSeedSameFlakes) {
    const paint::Recipe recipe = test::opaque(1, 15, 20);
    const Tile tile{500, 500};
    const auto a = draw_discs(recipe, tile, {1}, 9), b = draw_discs(recipe, tile, {1}, 9),
               c = draw_discs(recipe, tile, {1}, 10);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_EQ(a[i].centre_um, b[i].centre_um);
    EXPECT_FALSE(a[0].centre_um == c[0].centre_um);
}

TEST(Disc, RefusesMoreFlakesThanFit) {
    EXPECT_THROW(draw_discs(test::opaque(2, 15, 1), {1e5, 1e5}, {1}, 0), DomainError);
}

// Flakes far wider than the tile are met again and again: a few of them make a million copies.
TEST(Disc, RefusesFlakesThatReachFarOverTheEdges) {
    const paint::Recipe recipe = test::opaque(1000, 15, 10000);
    const Tile tile{20, 20};
    EXPECT_LT(expected_discs(recipe, tile), 1);
    EXPECT_NEAR(expected_copies(recipe, tile) / expected_discs(recipe, tile), 501 * 501, 1);
    EXPECT_NO_THROW(require_discs(recipe, tile));
    const paint::Recipe many = test::opaque(1e6, 15, 10000);
    EXPECT_LT(expected_discs(many, tile), 10);
    EXPECT_NO_THROW(require_discs(many, tile));
    EXPECT_THAT(message_of<DomainError>([&] { require_discs(test::opaque(1e9, 15, 10000), tile); }),
                testing::HasSubstr("light meets 1.28e+09 of them"));
}

TEST(Disc, StopsWhileTheyAreDrawn) {
    const Progress never = [](double) { return false; };
    SharedProgress stopped(never, 1);
    stopped.add(0);
    EXPECT_THROW(draw_discs(test::opaque(2, 15, 10), {1000, 1000}, {1}, 0, &stopped), Stopped);
}

}  // namespace
}  // namespace nacre::montecarlo
