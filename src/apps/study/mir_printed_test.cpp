#include "apps/study/mir_printed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "apps/study/mir_2022.h"
#include "nacre/bsdf/tabulated/compression.h"
#include "nacre/core/file.h"
#include "nacre/io/recipe_file.h"
#include "nacre/spectra/rgb.h"

// The recipes of the study against the numbers that the paper prints [mir-2022], typed here anew.

namespace nacre::study {
namespace {

paint::Recipe shipped_recipe(const std::string& file) {
    return io::read_recipe(shipped_file(file));
}

struct PrintedSet {
    const char* recipe;
    double path_nm, film_ior, base_ior, base_extinction;
};

TEST(PrintedParameters, FacetsOfTable2AreThePapers) {
    int sets = 0;
    for (const PrintedSet& set :
         {PrintedSet{"studies/mir-2022/facets-570.toml", 570, 1.8, 1.08, 0.51},
          PrintedSet{"studies/mir-2022/facets-665.toml", 665, 1.97, 1.12, 0}}) {
        const paint::Recipe recipe = shipped_recipe(set.recipe);
        ASSERT_TRUE(recipe.microfacet) << set.recipe;
        const paint::Microfacet& m = *recipe.microfacet;
        ASSERT_TRUE(m.facets) << set.recipe;
        EXPECT_EQ(m.alpha, 0.07) << set.recipe;
        EXPECT_EQ(m.facets->cone_deg, 3) << set.recipe;
        EXPECT_EQ(m.film_ior, set.film_ior) << set.recipe;
        EXPECT_EQ(m.base_ior, set.base_ior) << set.recipe;
        EXPECT_EQ(m.base_extinction, set.base_extinction) << set.recipe;
        // A thickness in the recipe has three decimals.
        EXPECT_NEAR(2 * m.film_ior * m.film_thickness_nm, set.path_nm, 2 * m.film_ior * 5e-4);
        EXPECT_EQ(m.distribution, paint::FacetDistribution::beckmann);
        EXPECT_FALSE(recipe.clearcoat);
        ++sets;
    }
    EXPECT_EQ(sets, 2);
}

TEST(PrintedParameters, FlakesOfTable1ReflectThePapersColours) {
    const auto colour = [](const char* file) {
        const paint::FlakeSpecies flake = shipped_recipe(file).layers[0].flakes[0];
        std::vector<double> wavelengths_nm;
        for (int nm = 360; nm <= 780; nm += 5) wavelengths_nm.push_back(nm);
        const std::vector<Vec3d> weights = spectra::rec709_weights(wavelengths_nm);
        Vec3d rgb{};
        for (std::size_t w = 0; w < weights.size(); ++w) {
            rgb += std::get<paint::PrescribedFlake>(flake.body).reflectance(wavelengths_nm[w]) *
                   weights[w];
        }
        return rgb;
    };
    const double gray_rgb[] = {0.6, 0.6, 0.6}, red_rgb[] = {0.89, 0, 0.13};
    const Vec3d gray = colour("paints/metallic-gray.toml"), red = colour("paints/cadmium-red.toml");
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(gray[c], gray_rgb[c], 1e-9);
        EXPECT_NEAR(red[c], red_rgb[c], 1e-9);
    }
}

TEST(PrintedParameters, TablesHaveThePapersSizes) {
    constexpr double kMebibyte = 1 << 20;
    const bsdf::BrdfTableSettings size;
    EXPECT_EQ(size.angles, 256);
    EXPECT_EQ(size.azimuths, 128);
    const double pairs = 256. * 256, floats = sizeof(float);
    EXPECT_EQ(pairs * 128 * 3 * floats / kMebibyte, 96);
    // k = (r^2 + r)/2: r = 3 in three channels of the gray, r = 4 in two of the red.
    const auto compressed_mb = [&](int rank, int channels) {
        return (pairs + 128) * bsdf::terms_of_rank(rank) * channels * floats / kMebibyte;
    };
    EXPECT_NEAR(compressed_mb(3, 3), 4.5, 0.05);
    EXPECT_NEAR(compressed_mb(4, 2), 5, 0.05);
}

TEST(PrintedParameters, PearlsOfFigure4HaveThePapersTitania) {
    for (const auto& [file, titania_nm] :
         {std::pair{"paints/tio2-mica-80.toml", 80.}, {"paints/tio2-mica-110.toml", 110.}}) {
        const paint::FlakeSpecies flake = shipped_recipe(file).layers[0].flakes[0];
        const optics::Platelet& body = std::get<optics::Platelet>(flake.body);
        EXPECT_EQ(body.coats.at(0).thickness_nm, titania_nm) << file;
    }
}

TEST(PrintedParameters, PicturesHaveThePapersSizeUnlessToldOtherwise) {
    EXPECT_EQ(MirSettings{}.size, 512);
    EXPECT_EQ(MirSettings{}.samples, 1024);
}

// The numbers that the page prints, against a second typing of the paper's.
TEST(PrintedParameters, RatiosFollowFromThePapersTimes) {
    using namespace printed;
    EXPECT_NEAR(kTable1[0].monte_carlo_over_raw(), 379, 0.5);
    EXPECT_NEAR(kTable1[1].monte_carlo_over_raw(), 929, 0.5);
    EXPECT_NEAR(kTable1[0].compressed_over_raw(), 0.66, 0.005);
    EXPECT_NEAR(kTable1[1].compressed_over_raw(), 0.91, 0.005);
    EXPECT_NEAR(kTable2[0].max_min_ratio(), 1.57, 0.005);
    EXPECT_NEAR(kTable2[1].max_min_ratio(), 1.58, 0.005);
    EXPECT_NEAR(kTable4[0].belcour_over_ergun(), 10.7, 0.05);
    EXPECT_NEAR(kTable4[1].belcour_over_ergun(), 10.9, 0.05);
    EXPECT_NEAR(kTable4[0].guo_over_ergun(), 46, 0.5);
    EXPECT_NEAR(kTable4[1].guo_over_ergun(), 47, 0.5);
    EXPECT_EQ(kTable2[1].base_ior, 1.12);
    EXPECT_EQ(kTable2[1].base_extinction, 0);
}

}  // namespace
}  // namespace nacre::study
