#include "nacre/solver/film_cache.h"

#include <gtest/gtest.h>

#include "nacre/solver/solver.h"
#include "nacre/testing/layers.h"

namespace nacre::solver {
namespace {

paint::Recipe pearl(double thickness_nm) {
    paint::FlakeSpecies species;
    species.amount = paint::VolumeFraction{0.05};
    species.orientation.beckmann_alpha = 0.3;
    species.body = optics::Platelet{{optics::Material(1.58), 500, {30}},
                                    {{optics::Material(2.5), thickness_nm, {5}}}};
    paint::Recipe recipe;
    recipe.layers = {{15, {species}, {}}};
    return recipe;
}

TEST(FilmCache, ASolveWithCachedFilmsHasTheSameBits) {
    const std::vector<double> wavelengths = {450, 550, 650};
    FilmCache cache;
    const SolvedPaint without = solve(pearl(80), wavelengths);
    EXPECT_EQ(solve(pearl(80), wavelengths, {}, &cache), without);
    EXPECT_EQ(cache.computed(), 1u);
    EXPECT_EQ(solve(pearl(80), wavelengths, {}, &cache), without);
    EXPECT_EQ(cache.computed(), 1u);
}

TEST(FilmCache, ComputesEachDifferentPlateletBinderAndGrid) {
    const std::vector<double> wavelengths = {450, 550};
    FilmCache cache;
    make_medium(pearl(80), wavelengths, &cache);
    make_medium(pearl(81), wavelengths, &cache);
    make_medium(pearl(80), {450, 551}, &cache);
    paint::Recipe other_binder = pearl(80);
    other_binder.binder = optics::Material(1.6);
    make_medium(other_binder, wavelengths, &cache);
    EXPECT_EQ(cache.computed(), 4u);
    paint::Recipe thicker = pearl(80);
    thicker.layers[0].thickness_um = 20;  // no film
    make_medium(thicker, wavelengths, &cache);
    EXPECT_EQ(cache.computed(), 4u);
}

TEST(FilmCache, DropsTheLeastRecentlyUsed) {
    const std::vector<double> wavelengths = {550};
    FilmCache cache(2);
    make_medium(pearl(80), wavelengths, &cache);
    make_medium(pearl(90), wavelengths, &cache);
    make_medium(pearl(80), wavelengths, &cache);   // used again
    make_medium(pearl(100), wavelengths, &cache);  // evicts 90
    make_medium(pearl(80), wavelengths, &cache);
    EXPECT_EQ(cache.computed(), 3u);
    make_medium(pearl(90), wavelengths, &cache);
    EXPECT_EQ(cache.computed(), 4u);
}

}  // namespace
}  // namespace nacre::solver
