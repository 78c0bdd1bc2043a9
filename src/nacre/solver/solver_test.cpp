#include "nacre/solver/solver.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string>

#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/layers.h"

namespace nacre::solver {
namespace {

using nacre::test::message_of;
using test::flake_paint;
using test::kOneWavelength;
using test::pigment_paint;

// The worked example of docs/microflake.md, by two independent methods that agree within their
// error.
struct Worked {
    double theta_o_deg, phi_deg, total, single;
};
constexpr Worked kWorked[] = {
    {15, 180, 0.0986750, 0.0850942}, {30, 180, 0.660157, 0.630615},
    {45, 180, 1.21809, 1.17416},     {60, 180, 0.879130, 0.828999},
    {75, 180, 0.403080, 0.361052},   {0, 180, 0.00615526, 0.00215988},
    {30, 90, 0.00147852, 5.74e-5},   {45, 0, 2.5171e-5, 6.68e-13},
};

TEST(Solver, MatchesTheWorkedMetallic) {
    const SolvedPaint paint = solve(flake_paint(0.1, 0.6, 0.0, 1.5, 1.5), kOneWavelength);
    for (const Worked& w : kWorked) {
        SCOPED_TRACE(testing::Message() << w.theta_o_deg << ", " << w.phi_deg);
        const double theta_i = 45 * kDegree, theta_o = w.theta_o_deg * kDegree;
        const double single = paint.brdf(theta_i, theta_o, w.phi_deg * kDegree, Part::single)[0];
        const double total = paint.brdf(theta_i, theta_o, w.phi_deg * kDegree)[0];
        // The single part is a closed form given to three to six digits.
        EXPECT_NEAR(single, w.single, 1e-3 * w.single);
        // The project's bound is 1e-4 of the peak; this one is tighter in the tail.
        EXPECT_NEAR(total, w.total, 2e-6 + 5e-5 * w.total);
    }
}

TEST(Solver, MatchesChandrasekharsHalfSpace) {
    // Isotropic, albedo 0.9, no interface, by H functions [chandrasekhar-1960].
    const SolvedPaint paint = solve(pigment_paint(0.9, 1e4, 0, 1.0), kOneWavelength);
    EXPECT_NEAR(paint.brdf(0, 0, 0)[0], 0.122572, 2e-6);
    EXPECT_NEAR(paint.brdf(0, 60 * kDegree, 1.0)[0], 0.137453, 2e-6);
}

TEST(Solver, PartsAddUpToTheWhole) {
    const SolvedPaint paint = solve(flake_paint(0.2, 0.6, 0.1, 1, 1.5), {450, 550, 650});
    const auto total = paint.brdf(0.7, 0.5, 2.5), single = paint.brdf(0.7, 0.5, 2.5, Part::single),
               multiple = paint.brdf(0.7, 0.5, 2.5, Part::multiple);
    ASSERT_EQ(total.size(), 3u);
    for (int w = 0; w < 3; ++w) {
        EXPECT_GT(multiple[w], 0);
        EXPECT_NEAR(total[w], single[w] + multiple[w], 1e-15);
    }
}

TEST(Solver, ReportsWhatItChose) {
    const SolvedPaint paint = solve(flake_paint(0.1, 0.6, 0, 1, 1.5), kOneWavelength);
    EXPECT_GE(paint.report.exit_nodes, 12);
    EXPECT_EQ(paint.report.exit_nodes,
              static_cast<int>(paint.multiple_scattering.exit_angle.size()));
    EXPECT_EQ(paint.report.orders, paint.multiple_scattering.orders());
    EXPECT_GT(paint.report.orders, 8);
    EXPECT_LT(paint.report.azimuthal_tail, SolverSettings{}.tolerance);
    EXPECT_LT(paint.report.unresolved_scattering, 1e-2);
}

TEST(Solver, TooFewNodesShowInTheReport) {
    SolverSettings coarse;
    coarse.exit_nodes = coarse.inner_nodes = 4;
    const paint::Recipe recipe = flake_paint(0.05, 0.6, 0, 1, 1.5);
    const double fine = solve(recipe, kOneWavelength).report.unresolved_scattering;
    const SolvedPaint paint = solve(recipe, kOneWavelength, coarse);
    // Lobes of 0.05 between nodes 0.3 apart: no fraction of the cross section is found reliably.
    EXPECT_GT(paint.report.unresolved_scattering, 0.1);
    EXPECT_LT(fine, 0.02);
    EXPECT_EQ(paint.report.exit_nodes, 4);
}

// Silica of 900 nm on aluminium, whose fringes are many: what the flakes absorb and what they
// scatter add up to their area (kernel and loss are integrated apart), and twelve directions do.
TEST(Solver, FilmsOfManyFringesLoseNoLight) {
    paint::Recipe recipe = flake_paint(0.4, 0.6, 0, 1, 1.5);
    recipe.layers[0].flakes[0].body = optics::Platelet{
        {optics::find_material("Al"), 300, {60}},
        {{optics::find_material("SiO2"), 900, {8}}, {optics::find_material("Fe2O3"), 17, {2}}}};
    const SolverReport report = solve(recipe, {440, 500, 560}).report;
    EXPECT_LT(report.unresolved_scattering, 8e-3);
    EXPECT_LE(report.exit_nodes, 12);
}

TEST(Solver, TooFewOrdersShowInTheReport) {
    SolverSettings coarse;
    coarse.max_orders = 8;
    const SolvedPaint paint = solve(flake_paint(0.1, 0.6, 0, 1, 1.5), kOneWavelength, coarse);
    EXPECT_GT(paint.report.azimuthal_tail, coarse.tolerance);
    EXPECT_LE(paint.report.orders, 8);
}

TEST(Solver, RefusesSettingsAndAnglesOutOfRange) {
    const paint::Recipe recipe = flake_paint(0.1, 0.6, 0, 1, 1.5);
    const auto message = [&](auto&& change) -> std::string {
        SolverSettings settings;
        change(settings);
        return message_of<DomainError>([&] { solve(recipe, kOneWavelength, settings); });
    };
    EXPECT_EQ(message([](SolverSettings& s) { s.exit_nodes = 10; }),
              "exit_nodes = 10 is not a multiple of 4");
    EXPECT_NE(message([](SolverSettings& s) { s.exit_nodes = -4; }).find("exit_nodes = -4"),
              std::string::npos);
    EXPECT_NE(message([](SolverSettings& s) { s.inner_nodes = 1024; }).find("[0, 128]"),
              std::string::npos);
    EXPECT_NE(message([](SolverSettings& s) { s.max_orders = -1; }).find("max_orders"),
              std::string::npos);
    EXPECT_NE(message([](SolverSettings& s) { s.tolerance = 0; }).find("tolerance"),
              std::string::npos);
    EXPECT_NE(message([](SolverSettings& s) { s.tolerance = NAN; }).find("tolerance"),
              std::string::npos);

    const SolvedPaint paint = solve(pigment_paint(0.5, 1, 0, 1.5), kOneWavelength);
    EXPECT_THROW(paint.brdf(-0.1, 0, 0), DomainError);
    EXPECT_THROW(paint.brdf(0, 1.6, 0), DomainError);
    EXPECT_THROW(paint.brdf(0, 0, NAN), DomainError);
    EXPECT_NO_THROW(paint.brdf(89.999 * kDegree, 0, 100.0));
}

TEST(Solver, RefusesWhatTheRecipeForbids) {
    paint::Recipe none = flake_paint(0.1, 0.6, 0, 1, 1.5);
    none.layers.clear();
    EXPECT_THROW(solve(none, kOneWavelength), DomainError);
    EXPECT_THROW(solve(flake_paint(0.1, 0.6, 0.5, 1, 1.5), kOneWavelength), DomainError);
}

TEST(Solver, StopsWhenAskedTo) {
    const paint::Recipe recipe = flake_paint(0.1, 0.6, 0, 1, 1.5);
    for (int last = 1; last < 10; last *= 3) {
        int calls = 0;
        const Progress progress = [&](double) { return ++calls < last; };
        EXPECT_EQ(message_of<Error>([&] { solve(recipe, kOneWavelength, {}, nullptr, progress); }),
                  "solving the paint was stopped");
        EXPECT_EQ(calls, last);
    }
}

TEST(Solver, TellsWhatMemoryItTakes) {
    const paint::Recipe wide = flake_paint(0.1, 0.6, 0, 1, 1.5);
    const paint::Recipe narrow = flake_paint(0.01, 0.6, 0, 1, 1.5);
    std::vector<double> many;
    for (int i = 0; i < 300; ++i) many.push_back(400 + i);
    EXPECT_GT(memory_to_solve(narrow, kOneWavelength), 50 * memory_to_solve(wide, kOneWavelength));
    // All wavelengths are alike: they are solved once and stored three hundred times.
    EXPECT_GT(memory_to_solve(wide, many), memory_to_solve(wide, kOneWavelength));
    paint::Recipe coloured = wide;
    coloured.substrate_reflectance = spectra::Spectrum({400, 700}, {0.1, 0.9});
    EXPECT_GT(memory_to_solve(coloured, many), 5 * memory_to_solve(coloured, kOneWavelength));
}

TEST(Solver, RefusesWhatTheMemoryCannotHold) {
    paint::Recipe recipe = flake_paint(0.005, 0.6, 0, 1, 1.5);
    recipe.substrate_reflectance = spectra::Spectrum({400, 700}, {0.1, 0.9});
    std::vector<double> many;
    for (int i = 0; i < 301; ++i) many.push_back(400 + i);
    const auto solve_in_little_memory = [&] {
        const rlimit little{4'000'000'000, 4'000'000'000};
        setrlimit(RLIMIT_AS, &little);
        try {
            solve(recipe, many);
        } catch (const Error& error) {
            std::fputs(error.what(), stderr);
            std::_Exit(7);
        }
        std::_Exit(0);
    };
    EXPECT_EXIT(solve_in_little_memory(), testing::ExitedWithCode(7),
                "solving 301 wavelengths with .* GB of memory");
}

// Over a Lambertian ground under clear binder all that left at once is T T r / (pi n^2), and the rest of
// the geometric series is what the interface had returned.
TEST(Solver, WithoutInternalReflectionLightLeavesWhenItFirstMeetsTheInterface) {
    constexpr double kGround = 0.6;
    paint::Recipe recipe = flake_paint(0.1, 0.6, 0, 1, 1.5);
    recipe.layers[0].flakes.clear();
    recipe.substrate_reflectance = kGround;
    const SolvedPaint whole = solve(recipe, kOneWavelength);
    const SolvedPaint once = solve_without_internal_reflection(whole);
    for (const double theta_i : {0.0, 0.7, 1.3}) {
        for (const double theta_o : {0.2, 1.0}) {
            const double expected =
                interface_factor(1.5, theta_i, theta_o) * kGround / std::numbers::pi;
            EXPECT_NEAR(once.brdf(theta_i, theta_o, 2, Part::total)[0], expected, 1e-6);
            EXPECT_GT(whole.brdf(theta_i, theta_o, 2, Part::total)[0], 1.3 * expected);
        }
    }
    recipe.clearcoat = paint::Clearcoat{40, 0.0, 0.3};
    const SolvedPaint rough = solve(recipe, kOneWavelength);
    EXPECT_NE(message_of<DomainError>([&] {
                  solve_without_internal_reflection(rough);
              }).find("clearcoat.roughness = 0.3: must be 0"),
              std::string::npos);
}

TEST(Solver, WithoutTheGroundTheFlakesAreOverBlack) {
    paint::Recipe recipe = flake_paint(0.1, 0.6, 0, 1, 1.5);
    const SolvedPaint black = solve(recipe, kOneWavelength);
    EXPECT_EQ(without_ground(black.medium), black.medium);
    recipe.substrate_reflectance = 0.8;
    recipe.layers.push_back({30, {}, {{paint::PigmentCoefficients{200.0, 1.0, 0.3}}}});
    const SolvedPaint whole = solve(recipe, kOneWavelength);
    const SolvedPaint alone = solve_without_ground(whole);
    EXPECT_EQ(alone.medium, black.medium);
    EXPECT_EQ(alone.multiple_scattering, black.multiple_scattering);
    EXPECT_GT(whole.brdf(0.5, 0.2, 1, Part::total)[0],
              1.2 * alone.brdf(0.5, 0.2, 1, Part::total)[0]);
}

TEST(Solver, StopsWhileFilmsAreComputed) {
    paint::Recipe recipe = flake_paint(0.1, 0.6, 0, 1, 1.5);
    recipe.layers[0].flakes[0].body = optics::Platelet{{optics::find_material("mica"), 500, {100}},
                                                       {{optics::find_material("SiO2"), 80, {20}}}};
    const Progress never = [](double) { return false; };
    EXPECT_EQ(message_of<Stopped>([&] { solve(recipe, kOneWavelength, {}, nullptr, never); }),
              "computing the films of a flake was stopped");
}

}  // namespace
}  // namespace nacre::solver
