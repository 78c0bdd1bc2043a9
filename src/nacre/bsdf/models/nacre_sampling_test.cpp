#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "nacre/spectra/spectrum.h"
#include "nacre/testing/allocations.h"
#include "nacre/testing/nacre_model.h"
#include "nacre/testing/statistics.h"

// Sampling of the nacre model on a patch, with and without a patch's memory.

namespace nacre::bsdf {
namespace {

// One patch of a surface, as a surface that does not vary.
class OnPatch final : public BoundBsdf {
 public:
    OnPatch(const BoundBsdf& surface, const Patch& patch)
        : surface_(surface), patch_(patch), memory_(surface.patch_memory_bytes()) {
        patch_.memory = &memory_;
    }
    FloatLanes eval(Vec3f wi, Vec3f wo) const override {
        return surface_.evaluate_on(patch_, wi, wo).f;
    }
    float pdf(Vec3f wi, Vec3f wo) const override {
        return surface_.evaluate_on(patch_, wi, wo).pdf;
    }
    std::optional<BsdfSample> sample(Vec3f wi, float u_select, Vec2f u) const override {
        return surface_.sample_on(patch_, wi, u_select, u);
    }
    FloatLanes albedo(Vec3f) const override { return FloatLanes{}; }

 private:
    const BoundBsdf& surface_;
    Patch patch_;
    mutable PatchMemory memory_;
};

double side_of(const SparklingModel& model, double flakes) {
    return std::sqrt(flakes / model.flakes_per_mm2());
}

TEST(NacreSampling, ReportsTheDensityAndValueOfThePatch) {
    for (const bool rough : {false, true}) {
        SCOPED_TRACE(rough);
        const SparklingModel& model = model_with_every_feature(rough);
        Rng rng(8);
        int specular = 0, others = 0, brighter = 0;
        for (int n = 0; n < 4000; ++n) {
            const OnPatch on(*model.bound, random_square_patch(rng, side_of(model, 3)));
            const Vec3f wi = direction(85 * rng.uniform_double(), 360 * rng.uniform_double());
            const auto s =
                on.sample(wi, rng.uniform_float(), {rng.uniform_float(), rng.uniform_float()});
            if (!s) continue;
            specular += s->kind == SampleKind::specular;
            if (s->kind == SampleKind::specular) continue;
            ++others;
            ASSERT_NEAR(s->pdf, on.pdf(wi, s->wo), 1e-3f * s->pdf);
            const FloatLanes expected = on.eval(wi, s->wo) * (s->wo.z / s->pdf);
            ASSERT_NEAR(s->weight[2], expected[2], 1e-3f * expected[2]);
            brighter += on.eval(wi, s->wo)[2] > 3 * model.bound->eval(wi, s->wo)[2];
        }
        EXPECT_TRUE(rough ? specular == 0 : specular > 100);
        EXPECT_GT(others, 2000);
        EXPECT_GT(brighter, 300);  // it does find the flakes
    }
}

// Flakes so small that their lobes of some 10 deg are resolved by the bins.
TEST(NacreSampling, FollowsTheDensityThatEvaluationReports) {
    paint::Recipe recipe = paint_of({metal_flake(2, 0.7, 0.2), metal_flake(3, 0.5, 0.3)});
    int tests = 0;
    for (const double roughness : {0.0, 0.2}) {
        recipe.clearcoat = paint::Clearcoat{0, spectra::Spectrum(0.0), roughness};
        const SparklingModel model(recipe);
        Rng rng(9);
        for (const double flakes : {0.0, 1.0, 6.0, 1e3}) {
            for (const double theta : {10.0, 55.0}) {
                const OnPatch on(*model.bound, random_square_patch(rng, side_of(model, flakes)));
                // As for the smooth model: 3.5 deviations are one false alarm in 500.
                EXPECT_LT(chi_square_z_score(on, direction(theta, 30), 31 + tests, 100000), 3.5)
                    << flakes << " flakes, " << theta << " deg";
                ++tests;
            }
        }
    }
    EXPECT_EQ(tests, 16);
}

TEST(NacreSampling, MeanWeightIsTheIntegralOverThePatch) {
    const SparklingModel model(paint_of({metal_flake(5, 0.7)}));
    Rng rng(12);
    const Vec3f wi = direction(30, 0);
    int differ = 0;
    for (const double flakes : {0.0, 2.0, 30.0, 1e5}) {
        const OnPatch on(*model.bound, random_square_patch(rng, side_of(model, flakes)));
        // Directions projected along the normal: the cosine is part of the measure. The lobes are
        // 0.1 wide, ten points.
        constexpr int kSide = 200;
        double integral = 0, mean = 0;
        for (int x = 0; x < kSide; ++x) {
            for (int y = 0; y < kSide; ++y) {
                const double sx = 2 * (x + 0.5) / kSide - 1, sy = 2 * (y + 0.5) / kSide - 1;
                const double z2 = 1 - sx * sx - sy * sy;
                if (z2 <= 0) continue;
                const Vec3f wo = {static_cast<float>(sx), static_cast<float>(sy),
                                  static_cast<float>(std::sqrt(z2))};
                integral += on.eval(wi, wo)[4] * 4 / (kSide * kSide);
                mean += model.bound->eval(wi, wo)[4] * 4 / (kSide * kSide);
            }
        }
        double sum = 0, squares = 0;
        int specular = 0;
        constexpr int kSamples = 40000;
        for (int n = 0; n < kSamples; ++n) {
            const auto s =
                on.sample(wi, rng.uniform_float(), {rng.uniform_float(), rng.uniform_float()});
            specular += s && s->kind == SampleKind::specular;
            const double w = s && s->kind == SampleKind::density ? s->weight[4] : 0;
            sum += w;
            squares += w * w;
        }
        const double found = sum / kSamples;
        const double error = std::sqrt((squares / kSamples - found * found) / kSamples);
        EXPECT_NEAR(found, integral, 4 * error + 0.003 * integral) << flakes << " flakes";
        // The standard deviation of a weight, the specular reflection left out, is below its mean.
        const double rest = kSamples - specular;
        EXPECT_LT(rest * squares, 2 * sum * sum) << flakes << " flakes";
        differ += std::abs(integral - mean) > 0.05 * mean;
    }
    EXPECT_GE(differ, 2);
}

TEST(NacreSampling, WeightsStayBounded) {
    int cases = 0;
    for (const bool rough : {false, true}) {
        SCOPED_TRACE(rough);
        const SparklingModel& model = model_with_every_feature(rough);
        Rng rng(17);
        for (const double flakes : {0.05, 1.0, 30.0}) {
            for (const double theta : {0.5, 45.0, 85.0}) {
                // The facets' own weights, of the mean as well, reach 11 there.
                if (rough && theta > 80) continue;
                int drawn = 0;
                for (int n = 0; n < 100; ++n) {
                    const OnPatch on(*model.bound,
                                     random_square_patch(rng, side_of(model, flakes)));
                    double sum = 0, largest = 0;
                    for (int k = 0; k < 300; ++k) {
                        const auto s = on.sample(direction(theta, 10), rng.uniform_float(),
                                                 {rng.uniform_float(), rng.uniform_float()});
                        const double w = s ? lane_max(s->weight) : 0.0;
                        drawn += w > 0;
                        sum += w / 300;
                        largest = test::worse(largest, w);
                    }
                    EXPECT_LT(largest, 10 * std::max(sum, 0.3)) << flakes << ' ' << theta;
                }
                EXPECT_GT(drawn, 25'000) << flakes << ' ' << theta;  // of 30 000
                ++cases;
            }
        }
    }
    EXPECT_EQ(cases, 15);
}

TEST(NacreSampling, LosesNoLightWhereNothingAbsorbs) {
    paint::Recipe recipe = paint_of({metal_flake(20, 1.0)});
    recipe.substrate_reflectance = 1.0;
    for (const double roughness : {0.0, 0.15}) {
        recipe.clearcoat = paint::Clearcoat{0, spectra::Spectrum(0.0), roughness};
        const SparklingModel model(recipe);
        PatchMemory memory(model.bound->patch_memory_bytes());
        Rng rng(13);
        for (const double flakes : {0.25, 1e4}) {
            double sum = 0, squares = 0;
            constexpr int kSamples = 200000;
            for (int n = 0; n < kSamples; ++n) {
                Patch patch = random_square_patch(rng, side_of(model, flakes));
                memory.forget();
                patch.memory = &memory;
                const auto s = model.bound->sample_on(patch, direction(30, 0), rng.uniform_float(),
                                                      {rng.uniform_float(), rng.uniform_float()});
                const double w = s ? s->weight[0] : 0;
                sum += w;
                squares += w * w;
            }
            const double mean = sum / kSamples;
            const double error = std::sqrt((squares / kSamples - mean * mean) / kSamples);
            EXPECT_LT(error, 0.01);
            EXPECT_NEAR(mean, 1,
                        3 * error + (roughness > 0 ? kMicroflakeRoughError : kMicroflakeError))
                << flakes << ' ' << roughness;
        }
    }
}

TEST(NacrePatch, IsReciprocal) {
    paint::Recipe dispersive = recipe_with_every_feature();
    dispersive.binder = optics::Material("crown", {400, 700}, {{1.56, 0}, {1.48, 0}});
    const auto solved = std::make_shared<const solver::SolvedPaint>(
        solver::solve(dispersive, spectra::default_wavelengths_nm()));
    for (const auto& paint :
         {model_with_every_feature().paint, model_with_every_feature(true).paint, solved}) {
        for (const bool hot_spot : {false, true}) {
            const auto bound = Nacre(paint, {.specimen = 4, .hot_spot = hot_spot}).bind(kOnGrid);
            Rng rng(5);
            int pairs = 0;
            for (int n = 0; n < 1000; ++n) {
                const OnPatch on(
                    *bound, random_square_patch(rng, std::pow(10, -3 + 3 * rng.uniform_double())));
                const Vec3f wi = direction(80 * rng.uniform_double(), 360 * rng.uniform_double());
                const auto s =
                    on.sample(wi, rng.uniform_float(), {rng.uniform_float(), rng.uniform_float()});
                if (!s || s->kind == SampleKind::specular) continue;
                const FloatLanes there = on.eval(wi, s->wo), back = on.eval(s->wo, wi);
                for (int k = 0; k < kLanes; ++k) {
                    // A few dozen roundings in single precision, some amplified by exponentials:
                    // found 1.2e-6.
                    EXPECT_NEAR(there[k], back[k], 2e-5f * there[k] + 1e-6f);
                }
                ++pairs;
            }
            EXPECT_GT(pairs, 500);  // the others are specular or empty
        }
    }
}

// Side by side along each edge, halves average to the whole while every flake is resolved.
TEST(NacrePatch, PartsAverageToTheWhole) {
    for (const bool rough : {false, true}) {
        SCOPED_TRACE(rough);
        const SparklingModel& model = model_with_every_feature(rough);
        Rng rng(6);
        const Vec3f wi = direction(30, 0), wo = direction(33, 182);
        double change = 0;
        for (int n = 0; n < 200; ++n) {
            Patch whole = random_square_patch(rng, 0.012);
            // Near the origin, where single precision resolves a thousandth of the side.
            whole.footprint.position_mm = 0.05f * whole.footprint.position_mm;
            for (const int edge : {0, 1}) {
                double sum = 0;
                std::vector<double> halves;
                for (const float side : {-0.25f, 0.25f}) {
                    Patch half = whole;
                    half.footprint.edge_mm[edge] = 0.5f * whole.footprint.edge_mm[edge];
                    half.footprint.position_mm =
                        whole.footprint.position_mm + side * whole.footprint.edge_mm[edge];
                    halves.push_back(model.bound->evaluate_on(half, wi, wo).f[3]);
                    sum += halves.back() / 2;
                }
                const double f = model.bound->evaluate_on(whole, wi, wo).f[3];
                EXPECT_NEAR(f, sum, 2e-3 * (f + sum));
                change += std::abs(halves[0] - halves[1]);
            }
        }
        EXPECT_GT(change, 10);
    }
}

TEST(NacrePatch, IsTheSameWithAndWithoutMemoryInAnyOrder) {
    for (const bool rough : {false, true}) {
        SCOPED_TRACE(rough);
        const SparklingModel& model = model_with_every_feature(rough);
        Rng rng(7);
        for (int n = 0; n < 100; ++n) {
            const Patch bare = random_square_patch(rng, side_of(model, n % 2 ? 5 : 5000));
            PatchMemory memory(model.bound->patch_memory_bytes());
            Patch remembering = bare;
            remembering.memory = &memory;
            std::vector<Vec3f> wi, wo;
            for (int k = 0; k < 8; ++k) {
                wi.push_back(direction(40 * rng.uniform_double(), 360 * rng.uniform_double()));
                wo.push_back({-wi[k].x, -wi[k].y, wi[k].z});
            }
            std::vector<BsdfValue> forwards;
            for (int k = 0; k < 8; ++k) {
                forwards.push_back(model.bound->evaluate_on(remembering, wi[k], wo[k]));
            }
            for (int k = 7; k >= 0; --k) {
                const BsdfValue alone = model.bound->evaluate_on(bare, wi[k], wo[k]);
                EXPECT_EQ(alone.f[2], forwards[k].f[2]);
                EXPECT_EQ(alone.pdf, forwards[k].pdf);
                const auto a = model.bound->sample_on(bare, wi[k], 0.4f, {0.3f, 0.6f});
                const auto b = model.bound->sample_on(remembering, wi[k], 0.4f, {0.3f, 0.6f});
                ASSERT_EQ(a.has_value(), b.has_value());
                EXPECT_TRUE(!a || a->weight[2] == b->weight[2]);
            }
        }
    }
}

TEST(NacrePatch, QueriesWithMemoryAllocateNothing) {
    for (const bool rough : {false, true}) {
        SCOPED_TRACE(rough);
        const SparklingModel& model = model_with_every_feature(rough);
        Rng rng(7);
        PatchMemory memory(model.bound->patch_memory_bytes());
        const long before = test::allocations;
        float sum = 0;
        for (int n = 0; n < 100; ++n) {
            Patch patch = random_square_patch(rng, 0.05);
            memory.forget();
            patch.memory = &memory;
            const Vec3f wi = direction(30, 0);
            sum += model.bound->evaluate_on(patch, wi, direction(30, 180)).pdf;
            const auto s = model.bound->sample_on(patch, wi, rng.uniform_float(), {0.3f, 0.6f});
            if (s) sum += s->pdf;
        }
        EXPECT_EQ(test::allocations, before);
        EXPECT_GT(sum, 0);
        const auto* another = new double(sum);
        EXPECT_EQ(test::allocations, before + 1);  // it does count
        delete another;
    }
}

TEST(NacrePatch, SpecimensHaveFlakesOfTheirOwn) {
    paint::Recipe recipe = paint_of({metal_flake(20, 0.6)});
    const SparklingModel one(recipe, {.specimen = 1}), other(recipe, {.specimen = 2}),
        again(recipe, {.specimen = 1});
    const Vec3f wi = direction(30, 0), wo = direction(30, 180);
    Rng rng(7);
    int differ = 0;
    for (int n = 0; n < 50; ++n) {
        const Patch patch = random_square_patch(rng, 0.03);
        const float f = one.bound->evaluate_on(patch, wi, wo).f[0];
        EXPECT_EQ(f, again.bound->evaluate_on(patch, wi, wo).f[0]);
        differ += f != other.bound->evaluate_on(patch, wi, wo).f[0];
    }
    EXPECT_GT(differ, 5);
}

TEST(NacrePatch, StaysFiniteForAnyPatchAndDirection) {
    for (const bool rough : {false, true}) {
        SCOPED_TRACE(rough);
        const SparklingModel& model = model_with_every_feature(rough);
        constexpr float inf = std::numeric_limits<float>::infinity();
        constexpr float nan = std::numeric_limits<float>::quiet_NaN();
        const float numbers[] = {0, 1e-30f, 1e-3f, 3, 1e6f, 1e30f, inf, nan};
        const Vec3f directions[] = {direction(0, 0), direction(30, 180), direction(89.999, 0)};
        for (const float at : numbers) {
            for (const float a : numbers) {
                for (const float b : numbers) {
                    Patch patch;
                    patch.footprint = {{at, -at, 0}, {0, 0, 1}, {1, 0, 0}, {{a, b, 0}, {-b, a, 0}}};
                    for (const Vec3f wi : directions) {
                        for (const Vec3f wo : directions) {
                            const auto value = model.bound->evaluate_on(patch, wi, wo);
                            for (int k = 0; k < kLanes; ++k) EXPECT_GE(value.f[k], 0);
                            EXPECT_GE(value.pdf, 0);
                        }
                        const auto s = model.bound->sample_on(patch, wi, 0.5f, {0.9f, 0.1f});
                        EXPECT_TRUE(!s || s->weight[0] >= 0);
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace nacre::bsdf
