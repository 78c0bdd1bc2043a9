#include "nacre/solver/order_interpolation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "nacre/core/math.h"
#include "nacre/solver/directions.h"
#include "nacre/solver/solver.h"
#include "nacre/testing/layers.h"
#include "nacre/testing/statistics.h"

namespace nacre::solver {
namespace {

using test::kOneWavelength;

// Largest error of the orders that are left out among `orders` of f(l), at one pair of nodes of a
// tile that has all of them.
double error_of_series(int orders, const std::function<double(int)>& f) {
    const std::vector<int> first(orders, 0);
    std::vector<OrderValues> values(orders);
    const auto exact = [&](int l) { return OrderValues(triangle(kTile), splat(f(l))); };
    for (const int l : solved_orders(orders)) values[l] = exact(l);
    double worst = 0;
    for (int distance = 1024; distance > 0; distance /= 2) {
        for (int l = 0; l < orders; ++l) {
            if (!values[l].empty() || (l & -l) != distance) continue;
            values[l] = interpolate_order(l, values, first, kTile, 1);
            for (const DoubleLanes& at : values[l]) {
                worst = nacre::test::worse(worst, std::abs(at[3] - f(l)));
            }
        }
    }
    for (const OrderValues& of_order : values) EXPECT_FALSE(of_order.empty());
    return worst;
}

TEST(OrderInterpolation, DistancesGrowWithTheOrder) {
    for (int l = 0; l <= kDenseOrders; ++l) EXPECT_EQ(next_solved_order(l), l);
    EXPECT_EQ(next_solved_order(25), 26);
    EXPECT_EQ(next_solved_order(47), 48);
    EXPECT_EQ(next_solved_order(49), 52);
    EXPECT_EQ(next_solved_order(97), 104);
    EXPECT_EQ(solved_orders(24).size(), 24u);
    EXPECT_EQ(solved_orders(1024).size(), 94u);
    for (int orders = 1; orders < 300; ++orders) {
        const std::vector<int> solved = solved_orders(orders);
        EXPECT_EQ(solved.back(), orders - 1);
        EXPECT_TRUE(std::is_sorted(solved.begin(), solved.end()));
        for (const int probe : probe_orders(orders)) {
            EXPECT_FALSE(std::binary_search(solved.begin(), solved.end(), probe)) << orders;
        }
        // What is left out lies in the middle of two that are known when its turn comes.
        for (int l = 0; l < orders; ++l) {
            if (!std::binary_search(solved.begin(), solved.end(), l)) {
                EXPECT_LT(l + (l & -l), orders);
            }
        }
    }
    EXPECT_EQ(probe_orders(26), std::vector<int>{});
    EXPECT_EQ(probe_orders(200), (std::vector<int>{25, 50, 100}));
}

TEST(OrderInterpolation, LobesAreInterpolatedToTheStatedError) {
    // In steps of 2 %: the error is smooth in the width.
    double gaussian = 0, exponential = 0;
    for (double width = 1e-2; width < 2; width *= 1.02) {
        // As many orders as a lobe of this width has, down to 1e-6, or 1024.
        const int orders = std::clamp(static_cast<int>(5.3 / width), 2 * kDenseOrders + 4, 1024);
        gaussian = nacre::test::worse(gaussian, error_of_series(orders, [&](int l) {
                                          return std::exp(-0.5 * l * width * (l * width));
                                      }));
        if (width > 0.03) {
            exponential = nacre::test::worse(
                exponential, error_of_series(1024, [&](int l) { return std::exp(-width * l); }));
        }
    }
    // In the first stretch, where it is worst: 2.1e-8, 3.0e-10; in others twice that, as what is
    // interpolated from errs too. The end of a series at 1e-6 adds a fraction of that.
    EXPECT_LT(gaussian, 3e-7);
    EXPECT_LT(exponential, 1e-9);
    EXPECT_GT(gaussian, 1e-8);  // something was interpolated
}

TEST(OrderInterpolation, NodesThatHaveNoSuchOrderAreZeroThere) {
    // Two tiles, the first of which ends with order 26: its orders are 1e-5 then, as ActiveNodes cuts
    // them.
    constexpr int kOrders = 49, kNodes = 2 * kTile, kLast = 26;
    const auto f = [](int l) { return std::exp(-11.5 * l * l / (27.0 * 27.0)); };
    std::vector<int> first(kOrders, 0);
    std::vector<OrderValues> values(kOrders);
    for (int l = 0; l < kOrders; ++l) {
        first[l] = l > kLast ? kTile : 0;
        if (next_solved_order(l) == l) {
            values[l] = OrderValues(triangle(kNodes - first[l]), splat(f(l)));
        }
    }
    const OrderValues between = interpolate_order(25, values, first, kNodes, 1);
    ASSERT_EQ(between.size(), triangle(kNodes));
    EXPECT_NEAR(between[0][0], f(25), 3e-6);                     // of a tile that ends
    EXPECT_NEAR(between[triangle(kNodes) - 1][0], f(25), 3e-8);  // of one that goes on
    EXPECT_EQ(interpolate_order(27, values, first, kNodes, 1).size(), triangle(kTile));
}

// The BRDF of a paint with orders left out, against one with all of them solved, over the peak: a
// tolerance no interpolation meets makes the solver solve all.
double error_of_paint(const paint::Recipe& recipe, int min_orders) {
    SolverSettings settings{.tolerance = 1e-6};
    const SolvedPaint found = solve(recipe, kOneWavelength, settings);
    EXPECT_GT(found.report.orders, min_orders);
    settings.max_orders = found.report.orders;
    settings.tolerance = 1e-12;
    const SolvedPaint all = solve(recipe, kOneWavelength, settings);
    EXPECT_EQ(all.report.orders, found.report.orders);
    double worst = 0;
    for (const double theta_i : {10.0, 45.0, 70.0}) {
        double peak = 0, error = 0;
        for (const double theta_o : {0.0, 20.0, 45.0, 70.0, 80.0}) {
            for (const double phi : {0.0, 90.0, 150.0, 175.0, 180.0}) {
                const double i = theta_i * kDegree, o = theta_o * kDegree, p = phi * kDegree;
                const double exact = all.brdf(i, o, p)[0];
                peak = std::max(peak, exact);
                error = nacre::test::worse(error, std::abs(found.brdf(i, o, p)[0] - exact));
            }
        }
        worst = nacre::test::worse(worst, error / peak);
    }
    return worst;
}

TEST(OrderInterpolation, SolvedPaintsAreAsIfAllOrdersWereSolved) {
    // Orders are kept to 1e-7.
    EXPECT_LT(error_of_paint(test::flake_paint(0.03, 0.8, 0, 2, 1.5), 48), 1e-6);
    EXPECT_LT(error_of_paint(test::flake_paint(0.3, 0.6, 0, 2, 1.0), 96), 1e-6);
}

TEST(OrderInterpolation, WhatIsNotSmoothIsSolved) {
    // Light that is thrown back alternates in sign from order to order, which no order in between
    // shows: by the even ones alone it would be thrown forward too.
    EXPECT_LT(error_of_paint(test::pigment_paint(0.9, 2, -0.96, 1.5), 26), 1e-6);
}

}  // namespace
}  // namespace nacre::solver
