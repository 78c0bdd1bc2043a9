#include "apps/study/query_cost.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nacre/bsdf/models/lambertian.h"
#include "nacre/bsdf/models/nacre.h"
#include "nacre/bsdf/models/special_effect.h"
#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/io/recipe_file.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"

namespace nacre::study {
namespace {

TEST(QueryCost, PatchesHaveTheirAreaInBothLayoutsAndLieInside) {
    const double area_mm2 = 0.02, fraction = 0.04;
    for (const bsdf::Patch& p : square_patches(area_mm2, fraction, 100)) {
        EXPECT_NEAR(length(cross(p.footprint.edge_mm[0], p.footprint.edge_mm[1])), area_mm2, 1e-6);
        EXPECT_NEAR(p.edge_1.x * p.edge_2.y - p.edge_1.y * p.edge_2.x, fraction, 1e-6);
        EXPECT_NEAR(length(p.footprint.position_mm), 50, 1e-4);
        for (const Vec3f& edge : p.footprint.edge_mm)
            EXPECT_NEAR(dot(edge, p.footprint.normal), 0, 1e-6);
        const double u_reach = 0.5 * (std::abs(p.edge_1.x) + std::abs(p.edge_2.x));
        const double v_reach = 0.5 * (std::abs(p.edge_1.y) + std::abs(p.edge_2.y));
        EXPECT_LE(std::abs(p.u - 0.5) + u_reach, 0.5 + 1e-6);
        EXPECT_LE(std::abs(p.v - 0.5) + v_reach, 0.5 + 1e-6);
    }
    EXPECT_THROW(square_patches(0, fraction, 1), DomainError);
    EXPECT_THROW(square_patches(area_mm2, 0.5, 1), DomainError);
}

// Over many patches both models of single reflectors have the BRDF of their own mean, so that the
// times that are compared are those of the same computation.
TEST(QueryCost, MeanOverPatchesIsThatOfTheSurface) {
    constexpr int kQueries = 4096;
    bsdf::ModelInput paint;
    paint.recipe = io::read_recipe(shipped_file("paints/tio2-mica-80.toml"));
    paint.recipe.microfacet->facets->count = 1e9;
    paint.solved = std::make_shared<const solver::SolvedPaint>(
        solver::solve(paint.recipe, spectra::default_wavelengths_nm(), {}));
    for (const bsdf::Model& model :
         {bsdf::Model(bsdf::SpecialEffectModel{}), bsdf::Model(bsdf::NacreModel{})}) {
        const QuerySubject subject(*model.make(paint), kQueries);
        const auto patches = square_patches(10, 1e-5, kQueries);  // some 1e4 of each
        const double mean = subject.measure({}, QueryKind::value).mean_answer;
        ASSERT_GT(mean, 0);
        for (QueryKind kind : {QueryKind::value, QueryKind::value_and_sample}) {
            const QueryCost cost = subject.measure(patches, kind);
            // 1e4 reflectors, of which those within a lobe of one or two degrees reflect, deviate
            // by some 10 % in a patch, and by 0.2 % in the mean over patches.
            EXPECT_NEAR(cost.mean_answer / mean, 1, 0.02) << model.info().name;
            EXPECT_GT(cost.nanoseconds, 0);
        }
        EXPECT_GT(subject.measure(patches, QueryKind::repeated_value).nanoseconds, 0);
    }
}

TEST(QueryCost, RefusesAnotherNumberOfPatches) {
    const bsdf::Lambertian white(1.0);
    const QuerySubject subject(white, 16);
    EXPECT_THROW(subject.measure(square_patches(1, 0.01, 15), QueryKind::value), DomainError);
    EXPECT_THROW(QuerySubject(white, 0), DomainError);
}

}  // namespace
}  // namespace nacre::study
