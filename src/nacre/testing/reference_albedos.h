#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "nacre/testing/montecarlo.h"

// Only for tests of walks that are surfaces: albedos by the reference, frozen.

namespace nacre::montecarlo::test {

struct FrozenAlbedo {
    const char* recipe;
    double theta_deg;
    double albedo[kLanes][2];  ///< at kOnGrid, with standard errors
};

/// By 2 million walks of reference_albedo() of Nacre 0.1.0, seed 7, where tests take a tenth of them.
/// They are printed by
///     NACRE_WRITE_TRUTH=1 nacre_montecarlo_test --gtest_filter='*Walk.*Albedo*Reference*'
inline constexpr FrozenAlbedo kFrozenAlbedos[] = {
    {"pearl",
     0,
     {{0.1969997, 0.000267},
      {0.1743843, 0.000185},
      {0.143537, 0.000111},
      {0.1285042, 0.000108},
      {0.1381879, 0.000113},
      {0.1624739, 0.000127},
      {0.2033638, 0.000185},
      {0.2402016, 0.000252}}},
    {"pearl",
     60,
     {{0.1820196, 0.000165},
      {0.1704529, 0.000109},
      {0.1569522, 8.43e-05},
      {0.1588907, 9.39e-05},
      {0.1760187, 0.000102},
      {0.2034204, 0.00014},
      {0.2258338, 0.00018},
      {0.2354352, 0.000193}}},
    {"rough pearl",
     40,
     {{0.1652175, 0.000255},
      {0.1477161, 0.000197},
      {0.1297471, 0.000172},
      {0.1260923, 0.000177},
      {0.1412541, 0.000179},
      {0.1699328, 0.000198},
      {0.2034464, 0.000243},
      {0.222974, 0.000272}}},
    {"pearl in flint",
     60,
     {{0.2080129, 8.88e-05},
      {0.1934472, 8.3e-05},
      {0.1804317, 7.53e-05},
      {0.1763644, 7.73e-05},
      {0.1851633, 9.67e-05},
      {0.2043849, 0.000126},
      {0.2241148, 0.000153},
      {0.2347127, 0.000168}}},
    {"pearl",
     20,
     {{0.1920894, 0.000256},
      {0.1673386, 0.000171},
      {0.1388511, 0.000106},
      {0.1258427, 0.000106},
      {0.1374823, 0.000112},
      {0.1643663, 0.00013},
      {0.2074514, 0.000195},
      {0.2413067, 0.000257}}},
    {"pearl",
     45,
     {{0.171476, 0.000208},
      {0.1510767, 0.000133},
      {0.1308902, 9.29e-05},
      {0.1269985, 0.000101},
      {0.143401, 0.000107},
      {0.1752655, 0.000142},
      {0.2104275, 0.000203},
      {0.2282261, 0.000233}}},
    {"pearl",
     30,
     {{0.1846156, 0.000241},
      {0.1596123, 0.000157},
      {0.1340407, 0.000101},
      {0.1239474, 0.000105},
      {0.1375482, 0.00011},
      {0.1671963, 0.000134},
      {0.2099334, 0.000203},
      {0.2386341, 0.000255}}},
};

/// What a walk found of a recipe, which goes by its name, against what is frozen.
inline void expect_frozen_albedo(const std::array<Estimate, kLanes>& found,
                                 const paint::Recipe& recipe, double theta_deg) {
    if (std::getenv("NACRE_WRITE_TRUTH")) {
        std::printf("{\"%s\", %g, {", recipe.name.c_str(), theta_deg);
        for (const Albedo& a : reference_albedo(recipe, std::vector<Direction>{{theta_deg, 0}},
                                                kOnGrid, {.samples = 2'000'000, .seed = 7})) {
            std::printf("{%.7g, %.3g}, ", a.reflectance.value, a.reflectance.standard_error);
        }
        std::printf("}},\n");
    }
    for (const FrozenAlbedo& frozen : kFrozenAlbedos) {
        if (recipe.name != frozen.recipe || theta_deg != frozen.theta_deg) continue;
        for (int lane = 0; lane < kLanes; ++lane) {
            const double value = frozen.albedo[lane][0], error = frozen.albedo[lane][1];
            EXPECT_GT(found[lane].standard_error, 0);
            EXPECT_LT(std::abs(z_score(found[lane], value, error)), kWorstZ)
                << recipe.name << ' ' << theta_deg << " deg, " << kOnGrid[lane]
                << " nm: " << found[lane].value << " against " << value;
        }
        return;
    }
    ADD_FAILURE() << "no albedo of " << recipe.name << " at " << theta_deg << " deg is frozen";
}

}  // namespace nacre::montecarlo::test
