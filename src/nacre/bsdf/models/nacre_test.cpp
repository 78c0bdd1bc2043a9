#include "nacre/bsdf/models/nacre.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "nacre/core/error.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/nacre_model.h"
#include "nacre/testing/statistics.h"

// What the nacre model takes and refuses.

namespace nacre::bsdf {
namespace {

using nacre::test::message_of;

TEST(Nacre, WithoutFlakesNothingSparkles) {
    paint::Recipe recipe = paint_of({});
    recipe.layers[0].pigments = {{paint::PigmentCoefficients{200.0, 50.0, 0.3}}};
    const SparklingModel model(recipe);
    EXPECT_EQ(model.bound->patch_memory_bytes(), 0u);
    Patch patch;
    patch.footprint.edge_mm[0] = {0.01f, 0, 0};
    patch.footprint.edge_mm[1] = {0, 0.01f, 0};
    const Vec3f wi = direction(30, 0), wo = direction(40, 100);
    const BsdfValue on = model.bound->evaluate_on(patch, wi, wo),
                    mean = model.bound->evaluate(wi, wo);
    EXPECT_EQ(on.f[0], mean.f[0]);
    EXPECT_EQ(on.pdf, mean.pdf);
    const auto s = model.bound->sample_on(patch, wi, 0.9f, {0.2f, 0.3f});
    ASSERT_TRUE(s.has_value());
    EXPECT_EQ(s->weight[0], model.bound->sample(wi, 0.9f, {0.2f, 0.3f})->weight[0]);
}

// A rougher or smoother one takes the solver minutes.
TEST(Nacre, TakesTheSmallestAndTheLargestFlakes) {
    for (const double diameter_um : {0.5, 1e3}) {
        for (const double alpha : {0.02, 1.0}) {
            SCOPED_TRACE(testing::Message() << diameter_um << " um, alpha " << alpha);
            const SparklingModel model(paint_of({metal_flake(diameter_um, 0.6, alpha)}));
            PatchMemory memory(model.bound->patch_memory_bytes());
            Rng rng(3);
            test::Sample weights;
            const int patches = alpha < 0.1 ? 40000 : 200000;  // to see 2 %
            for (int n = 0; n < patches; ++n) {
                Patch patch = random_square_patch(rng, 5);
                patch.memory = &memory;
                memory.forget();
                const auto s = model.bound->sample_on(patch, direction(20, 0), rng.uniform_float(),
                                                      {rng.uniform_float(), rng.uniform_float()});
                weights.add(s ? s->weight[3] : 0);
            }
            // Twenty or more flakes on each patch: the light of the mean.
            const MeanWeight smooth = mean_weight(*model.bound, direction(20, 0), 3, patches, 4);
            const double error = std::hypot(weights.error(), smooth.error);
            EXPECT_LT(error, 0.005 * smooth.mean);
            EXPECT_NEAR(weights.mean(), smooth.mean, test::kWorstZ * error);
        }
    }
}

TEST(Nacre, StopsWhileFilmsAreComputed) {
    const auto coated = [](double coat_nm) {
        paint::FlakeSpecies flake = pearl_flake(12);
        std::get<optics::Platelet>(flake.body).coats[0].thickness_nm = coat_nm;
        return std::make_shared<const solver::SolvedPaint>(
            solver::solve(paint_of({flake}), {500, 600}));
    };
    const auto stop = [](double) { return false; };
    EXPECT_NO_THROW(Nacre(coated(101), {}, [](double) { return true; }));
    EXPECT_THROW(Nacre(coated(102), {}, stop), Stopped);
    // What was computed is kept, and what was stopped is not.
    EXPECT_NO_THROW(Nacre(coated(101), {}, stop));
    EXPECT_THROW(Nacre(coated(102), {}, stop), Stopped);
}

}  // namespace
}  // namespace nacre::bsdf
