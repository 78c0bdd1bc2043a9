#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string>
#include <utility>

#include "nacre/core/random.h"
#include "nacre/solver/solver.h"
#include "nacre/testing/paints.h"
#include "nacre/testing/statistics.h"

// Laws of flakes that are not Beckmann's: the solver, to which they are mixtures and sublayers,
// against a walk that draws every flake from the law itself. The walk is one of its own: it shares
// neither the expansion nor the walks of this room.

namespace nacre::montecarlo {
namespace {

constexpr double kLawDensity = 0.1, kLawThickness_um = 20,
                 kLawReflectance = 0.8;  // two deep, over black
constexpr double kLawIncident = 0.6;     // rad, no interface

/// Fractions of the light that leave within ranges of the polar angle.
constexpr int kLawBins = 5;
constexpr std::array<double, kLawBins + 1> kLawEnds = {0,    0.3, 0.5,
                                                       0.75, 1.1, std::numbers::pi / 2};
using Fractions = std::array<double, kLawBins>;

/// @param slope  of a flake at a fraction of the depth, by a random number in [0, 1)
template <class Slope>
Fractions walk_of_law(const Slope& slope, int count, std::uint64_t seed) {
    Rng rng(seed);
    Fractions found{};
    for (int n = 0; n < count; ++n) {
        double x = std::sin(kLawIncident), y = 0, z = -std::cos(kLawIncident), depth = 0;
        for (;;) {
            // Candidates of the whole area of the flakes; the projected area decides.
            depth -= z * -std::log1p(-rng.uniform_double()) / kLawDensity;
            if (depth < 0 || depth >= kLawThickness_um) break;
            const double s = slope(depth / kLawThickness_um, rng.uniform_double());
            const double phi = 2 * std::numbers::pi * rng.uniform_double();
            const double upright = 1 / std::sqrt(1 + s * s);
            const double mx = s * std::cos(phi) * upright, my = s * std::sin(phi) * upright;
            const double facing = x * mx + y * my + z * upright;
            if (rng.uniform_double() >= std::abs(facing)) continue;
            if (rng.uniform_double() >= kLawReflectance) {
                depth = kLawThickness_um;
                break;
            }
            x -= 2 * facing * mx;
            y -= 2 * facing * my;
            z -= 2 * facing * upright;
        }
        if (depth >= 0) continue;
        const double theta = std::acos(std::min(1.0, z));
        int bin = 0;
        while (bin + 1 < kLawBins && theta >= kLawEnds[bin + 1]) ++bin;
        found[bin] += 1.0 / count;
    }
    return found;
}

Fractions solved_fractions(const paint::Orientation& orientation) {
    paint::FlakeSpecies species = test::flakes(kLawDensity, 0.1, kLawReflectance);
    species.orientation = orientation;
    const auto paint =
        solver::solve(test::paint_of(1, {{kLawThickness_um, {species}, {}}}), {550}, {});
    Fractions found{};
    constexpr int kThetas = 24, kPhis = 32;  // 64 of phi change no fraction by 1e-7
    for (int bin = 0; bin < kLawBins; ++bin) {
        const double step = (kLawEnds[bin + 1] - kLawEnds[bin]) / kThetas;
        for (int i = 0; i < kThetas; ++i) {
            const double theta = kLawEnds[bin] + (i + 0.5) * step;
            for (int k = 0; k < kPhis; ++k) {
                const double phi = std::numbers::pi * (k + 0.5) / kPhis;
                found[bin] += paint.brdf(kLawIncident, theta, phi)[0] * std::cos(theta) *
                              std::sin(theta) * step * 2 * std::numbers::pi / kPhis;
            }
        }
    }
    return found;
}

/// @param model_error  what the solver's description of the law may be off by, of all light
void expect_same_fractions(const std::string& name, const Fractions& a, const Fractions& b,
                           int walks, double model_error) {
    for (int bin = 0; bin < kLawBins; ++bin) {
        const double error = std::sqrt(b[bin] * (1 - b[bin]) / walks);
        EXPECT_NEAR(a[bin], b[bin], 4.5 * error + model_error) << name << ", bin " << bin;
    }
}

double largest_difference(const Fractions& a, const Fractions& b) {
    double largest = 0;
    for (int bin = 0; bin < kLawBins; ++bin)
        largest = test::worse(largest, std::abs(a[bin] - b[bin]));
    return largest;
}

double beckmann_slope(double alpha, double u) { return alpha * std::sqrt(-std::log1p(-u)); }
double ggx_slope(double alpha, double u) { return alpha * std::sqrt(u / (1 - u)); }
double slope_by_depth(double bottom, double depth, double u) {
    return beckmann_slope(0.2 + depth * (bottom - 0.2), u);
}

/// A law, and what kWalksOfLaw walks found of it. The walk is code of this file alone, so that
/// nothing but the numbers would be made anew each time; NACRE_WRITE_TRUTH=1 and
/// --gtest_filter='FlakeLaws.FrozenWalks*' make them again.
struct WalkedLaw {
    const char* name;
    double (*slope)(double depth, double u);
    Fractions found;
};
constexpr int kWalksOfLaw = 10'000'000;
constexpr WalkedLaw kBeckmann = {"Beckmann",
                                 [](double, double u) { return beckmann_slope(0.2, u); },
                                 {0.044346, 0.096121, 0.163241, 0.135193, 0.024413}};
constexpr WalkedLaw kGgxNarrow = {"GGX of 0.1",
                                  [](double, double u) { return ggx_slope(0.1, u); },
                                  {0.022902, 0.086267, 0.238081, 0.094133, 0.020283}};
constexpr WalkedLaw kGgxWide = {"GGX of 0.25",
                                [](double, double u) { return ggx_slope(0.25, u); },
                                {0.041720, 0.079393, 0.133006, 0.132391, 0.059328}};
constexpr WalkedLaw kFlatterBelow = {
    "0.2 to 0.1",
    [](double depth, double u) { return slope_by_depth(0.1, depth, u); },
    {0.037867, 0.099357, 0.181994, 0.128295, 0.016753}};
constexpr WalkedLaw kRougherBelow = {
    "0.2 to 0.4",
    [](double depth, double u) { return slope_by_depth(0.4, depth, u); },
    {0.049264, 0.089481, 0.142979, 0.137802, 0.040175}};
constexpr WalkedLaw kTwoAlphas = {"half of 0.08, half of 0.3",
                                  [](double, double u) {
                                      return u < 0.5 ? beckmann_slope(0.08, 2 * u)
                                                     : beckmann_slope(0.3, 2 * u - 1);
                                  },
                                  {0.030751, 0.082476, 0.219336, 0.097759, 0.032062}};

TEST(FlakeLaws, FrozenWalksAreThoseOfTheWalk) {
    constexpr int kAgain = 100'000;
    for (const WalkedLaw& law :
         {kBeckmann, kGgxNarrow, kGgxWide, kFlatterBelow, kRougherBelow, kTwoAlphas}) {
        if (std::getenv("NACRE_WRITE_TRUTH")) {
            std::printf("%s:", law.name);
            for (const double f : walk_of_law(law.slope, kWalksOfLaw, 2027))
                std::printf(" %.6f,", f);
            std::printf("\n");
        }
        expect_same_fractions(law.name, law.found, walk_of_law(law.slope, kAgain, 2026), kAgain, 0);
    }
}

// The walk itself, where nothing is expanded; anew, and the frozen one.
TEST(FlakeLaws, WalkOfBeckmannIsTheSolver) {
    constexpr int kWalks = 1'000'000;
    const Fractions solved = solved_fractions({0.2});
    expect_same_fractions("again", solved, walk_of_law(kBeckmann.slope, kWalks, 2026), kWalks,
                          5e-4);
    expect_same_fractions("frozen", solved, kBeckmann.found, kWalksOfLaw, 5e-4);
}

TEST(FlakeLaws, GgxIsTheSolverOfItsMixture) {
    for (const auto& [alpha, walked] : {std::pair{0.1, kGgxNarrow}, {0.25, kGgxWide}}) {
        paint::Orientation law{alpha};
        law.law = paint::Orientation::Law::ggx;
        expect_same_fractions(walked.name, solved_fractions(law), walked.found, kWalksOfLaw, 2e-3);
    }
    // Or the walk would not see the law: Beckmann's of the same alpha is far off.
    EXPECT_GT(largest_difference(solved_fractions({0.1}), kGgxNarrow.found), 0.01);
}

TEST(FlakeLaws, AlphaByDepthIsTheSolverOfItsSublayers) {
    for (const auto& [bottom, walked] : {std::pair{0.1, kFlatterBelow}, {0.4, kRougherBelow}}) {
        paint::Orientation law{0.2};
        law.alpha_bottom = bottom;
        expect_same_fractions(walked.name, solved_fractions(law), walked.found, kWalksOfLaw, 1e-3);
    }
    // The walk would see which way alpha changes.
    paint::Orientation down{0.2}, up{0.4};
    down.alpha_bottom = 0.4;
    up.alpha_bottom = 0.2;
    EXPECT_GT(largest_difference(solved_fractions(down), solved_fractions(up)), 0.01);
}

TEST(FlakeLaws, TabulatedTiltsAreTheSolverOfTheirMixture) {
    // Half of Beckmann's of 0.08, half of 0.3, as a table by half degrees.
    paint::Orientation law;
    law.law = paint::Orientation::Law::tabulated;
    law.table.emplace();
    for (double tilt = 0; tilt < 60; tilt += 0.5) {
        const double t = tilt * std::numbers::pi / 180, s = std::tan(t);
        const auto density = [&](double a) { return std::exp(-s * s / (a * a)) / (a * a); };
        law.table->tilts.push_back(
            {tilt, s / std::pow(std::cos(t), 2) * (density(0.08) + density(0.3))});
    }
    expect_same_fractions(kTwoAlphas.name, solved_fractions(law), kTwoAlphas.found, kWalksOfLaw,
                          4e-3);
}

}  // namespace
}  // namespace nacre::montecarlo
