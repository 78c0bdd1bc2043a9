#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "nacre/bsdf/models/interface_lobe.h"
#include "nacre/bsdf/models/microflake.h"
#include "nacre/bsdf/tilted_coat.h"
#include "nacre/core/random.h"
#include "nacre/optics/fresnel.h"
#include "nacre/solver/rough_interface.h"
#include "nacre/solver/solver.h"
#include "nacre/testing/bsdf.h"
#include "nacre/testing/nacre_model.h"
#include "nacre/testing/paints.h"
#include "nacre/testing/statistics.h"

// A coat that is rough and not flat: orange peel on satin and matte paint.

namespace nacre::bsdf {
namespace {

constexpr double kSatinIndex = 1.5;
constexpr Vec2f kTilts[] = {{0.01f, 0}, {-0.03f, 0.02f}, {0.1f, 0.05f}};

struct SatinPaint {
    std::shared_ptr<const solver::SolvedPaint> solved;
    std::unique_ptr<const BoundBsdf> bound;
    SatinPaint(paint::Recipe recipe, double roughness) {
        recipe.clearcoat = paint::Clearcoat{0, 0.0, roughness};
        solved = std::make_shared<const solver::SolvedPaint>(
            solver::solve(recipe, spectra::default_wavelengths_nm()));
        bound = Microflake(solved).bind(kOnGrid);
    }
};

const BoundBsdf& satin_metallic() {
    static const SatinPaint paint(test::metallic(0.3, 0.6), 0.2);
    return *paint.bound;
}
const BoundBsdf& satin_black() {
    static const SatinPaint paint(test::paint_of(kSatinIndex, {test::pigment_layer(0, 50, 0)}),
                                  0.1);
    return *paint.bound;
}

Vec3d tilted_normal(Vec2f slope) { return normalize(Vec3d{-slope.x, -slope.y, 1}); }

double angle_between(Vec3d a, Vec3d b) { return std::acos(std::clamp(dot(a, b), -1.0, 1.0)); }

// Black reflects by its interface alone: the solver's, by angles to the tilted normal.
TEST(TiltedRoughCoat, TheLobeIsThatOfTheInterfaceAboutTheTiltedNormal) {
    Rng rng(2);
    int compared = 0;
    for (const Vec2f slope : kTilts) {
        const Vec3d m = tilted_normal(slope);
        for (int i = 0; i < 300; ++i) {
            const Vec3f a = direction(75 * rng.uniform_double(), 360 * rng.uniform_double());
            const Vec3f b = direction(75 * rng.uniform_double(), 360 * rng.uniform_double());
            const Vec3d u = to_double(a), v = to_double(b);
            const double cos_u = dot(u, m), cos_v = dot(v, m);
            const double azimuth =
                angle_between(normalize(u - cos_u * m), normalize(v - cos_v * m));
            const double expected = solver::rough_interface_brdf(kSatinIndex, 0.1, std::acos(cos_u),
                                                                 std::acos(cos_v), azimuth) *
                                    cos_v / v.z;
            const TiltedCoat coat(satin_black(), slope, a);
            // 1e-5: what the table of the layers takes black for.
            EXPECT_NEAR(coat.eval(a, b)[0], expected, 2e-3 * expected + 1e-5);
            ++compared;
        }
    }
    EXPECT_EQ(compared, 900);
}

// What would go below the surface is turned up, as the mirror image is.
TEST(TiltedRoughCoat, NothingOfTheLobeIsLostBelowTheSurface) {
    for (const double theta : {70.0, 80.0, 86.0}) {
        const Vec3f wi = direction(theta, 0);
        const Vec2f slope{0.1f, 0};  // leans away from the eye
        const TiltedCoat coat(satin_black(), slope, wi);
        const double cosine = dot(to_double(wi), tilted_normal(slope));
        const double whole =
            solver::rough_interface(kSatinIndex, 0.1)->albedo(std::acos(std::max(cosine, 1e-3)));
        const MeanWeight found = mean_weight(coat, wi, 3, 400'000, 5);
        EXPECT_NEAR(found.mean, whole, test::kWorstZ * found.error + 0.005 * whole) << theta;
    }
}

TEST(TiltedRoughCoat, AFlatOneIsThePaintItself) {
    const BoundBsdf& flat = satin_metallic();
    Rng rng(4);
    for (int i = 0; i < 300; ++i) {
        const Vec3f wi = direction(88 * rng.uniform_double(), 360 * rng.uniform_double());
        const Vec3f wo = direction(88 * rng.uniform_double(), 360 * rng.uniform_double());
        const TiltedCoat coat(flat, {0, 0}, wi);
        const FloatLanes f = flat.eval(wi, wo), tilted = coat.eval(wi, wo);
        for (int lane = 0; lane < kLanes; ++lane) {
            ASSERT_NEAR(tilted[lane], f[lane], 1e-4f * f[lane]);
        }
    }
}

// As facets lie ever flatter, the layers are those under the waves of a smooth coat, and the lobe holds
// what it mirrors where it mirrors it.
TEST(TiltedRoughCoat, ANearlySmoothOneIsThatOfASmoothCoat) {
    const SatinPaint smooth(test::metallic(0.3, 0.6), 0), rough(test::metallic(0.3, 0.6), 0.01);
    const Vec2f slope{0.03f, -0.02f};
    Rng rng(8);
    int compared = 0;
    for (int i = 0; i < 400; ++i) {
        const Vec3f a = direction(60 * rng.uniform_double(), 360 * rng.uniform_double());
        const Vec3f b = direction(60 * rng.uniform_double(), 360 * rng.uniform_double());
        const TiltedCoat mirror(*smooth.bound, slope, a), coat(*rough.bound, slope, a);
        const Vec3f mirrored = 2 * dot(a, mirror.normal()) * mirror.normal() - a;
        if (dot(mirrored, b) > 0.99f) continue;
        const float peak = mirror.eval(a, mirrored.z > 0 ? mirrored : a)[0];
        const float f = mirror.eval(a, b)[0];
        const auto table_error = static_cast<float>(kMicroflakeRoughError) * peak;
        EXPECT_NEAR(coat.eval(a, b)[0], f, table_error);
        ++compared;
    }
    EXPECT_GT(compared, 300);
    for (const double theta : {20.0, 60.0}) {
        const Vec3f wi = direction(theta, 40);
        const TiltedCoat mirror(*smooth.bound, slope, wi), coat(*rough.bound, slope, wi);
        const Vec3f mirrored = 2 * dot(wi, mirror.normal()) * mirror.normal() - wi;
        constexpr float kNear = 0.998f;  // 3.6 deg: ten times the spread of the facets' images
        double lobe = 0;
        constexpr int kSamples = 200'000;
        for (int i = 0; i < kSamples; ++i) {
            const auto s =
                coat.sample(wi, rng.uniform_float(), {rng.uniform_float(), rng.uniform_float()});
            if (!s || dot(s->wo, mirrored) < kNear) continue;
            const float layers = mirror.eval(wi, s->wo)[0];
            lobe += s->weight[0] - layers * s->wo.z / s->pdf;
        }
        const double reflectance = optics::dielectric_reflectance(
            1.0, kSatinIndex, dot(to_double(wi), to_double(mirror.normal())));
        EXPECT_NEAR(lobe / kSamples, reflectance, 0.01 * reflectance) << theta;
    }
}

TEST(TiltedRoughCoat, SamplesHaveTheDensityThatPdfGives) {
    int cases = 0;
    for (const Vec2f slope : kTilts) {
        for (const double theta : {10.0, 50.0, 80.0}) {
            const Vec3f wi = direction(theta, 30);
            const TiltedCoat coat(satin_metallic(), slope, wi);
            EXPECT_LT(std::abs(chi_square_z_score(coat, wi, 17, 200'000)), test::kWorstZ)
                << slope.x << " " << theta;
            ++cases;
        }
    }
    EXPECT_EQ(cases, 9);
}

TEST(TiltedRoughCoat, SamplesAreWorthTheirValueOverTheirDensity) {
    const SparklingModel sparkling([] {
        paint::Recipe recipe = paint_of({metal_flake(40, 0.7)});
        recipe.clearcoat = paint::Clearcoat{0, 0.0, 0.1};
        return recipe;
    }());
    PatchMemory memory(sparkling.bound->patch_memory_bytes());
    Rng rng(6);
    int alone = 0, on_patch = 0;
    for (int i = 0; i < 6000; ++i) {
        const Vec2f slope = kTilts[i % std::size(kTilts)];
        const Vec3f wi = direction(89 * rng.uniform_double(), 360 * rng.uniform_double());
        const bool with_flakes = i % 2;
        const TiltedCoat coat(with_flakes ? *sparkling.bound : satin_metallic(), slope, wi);
        EXPECT_EQ(coat.specular_probability(wi), 0);
        Patch patch = random_square_patch(rng, 0.2);
        memory.forget();
        patch.memory = &memory;
        const float u_select = rng.uniform_float();
        const Vec2f u{rng.uniform_float(), rng.uniform_float()};
        const auto s =
            with_flakes ? coat.sample_on(patch, wi, u_select, u) : coat.sample(wi, u_select, u);
        if (!s) continue;
        ASSERT_EQ(s->kind, SampleKind::density);
        EXPECT_GT(s->wo.z, 0);
        const BsdfValue value =
            with_flakes ? coat.evaluate_on(patch, wi, s->wo) : coat.evaluate(wi, s->wo);
        // Found: 1e-4 and 3e-5.
        EXPECT_NEAR(s->pdf, value.pdf, 5e-4f * value.pdf);
        for (int lane = 0; lane < kLanes; ++lane) {
            EXPECT_NEAR(s->weight[lane] * s->pdf, value.f[lane] * s->wo.z,
                        2e-4f * value.f[lane] * s->wo.z);
        }
        if (with_flakes) {
            ++on_patch;
            continue;
        }
        ++alone;
        EXPECT_NEAR(coat.pdf(wi, s->wo), value.pdf, 1e-5f * value.pdf);
    }
    EXPECT_GT(alone, 1500);
    EXPECT_GT(on_patch, 1500);
}

// The lobe is up to the cosines of the tilted plane, the layers up to the spread of plane waves.
TEST(TiltedRoughCoat, ValuesAreReciprocalUpToTheTiltedPlane) {
    Rng rng(9);
    for (const Vec2f slope : kTilts) {
        const Vec3d m = tilted_normal(slope);
        const Frame frame = Frame::around(to_float(m));
        const auto cosines = [&](Vec3f w) { return dot(to_double(w), m) / w.z; };
        const auto spread = [&](Vec3f w) {
            const double cosine = dot(to_double(w), m);
            const double inside =
                std::sqrt(1 - (1 - cosine * cosine) / (kSatinIndex * kSatinIndex));
            const double z = (w.z + (kSatinIndex * inside - cosine) * m.z) / kSatinIndex;
            return z * cosine / (inside * w.z);
        };
        for (int i = 0; i < 200; ++i) {
            const Vec3f a = direction(75 * rng.uniform_double(), 360 * rng.uniform_double());
            const Vec3f b = direction(75 * rng.uniform_double(), 360 * rng.uniform_double());
            const TiltedCoat coat(satin_metallic(), slope, a);
            const double lobe =
                satin_metallic().interface_lobe()->eval(frame.to_local(a), frame.to_local(b))[0];
            const double forth = (coat.eval(a, b)[0] - lobe * cosines(b)) / spread(b);
            const double back = (coat.eval(b, a)[0] - lobe * cosines(a)) / spread(a);
            ASSERT_NEAR(forth, back, 2e-5 + 1e-3 * forth + 1e-5 * lobe);
        }
    }
}

/// What a furnace of radiance 1 sends to wi, on average over slopes and their opposites.
double satin_furnace(const BoundBsdf& lossless, double theta, float slope) {
    double sum = 0;
    int count = 0;
    for (const double phi : {0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0}) {
        const Vec3f turned = direction(90, phi), wi = direction(theta, 0);
        const TiltedCoat coat(lossless, {slope * turned.x, slope * turned.y}, wi);
        sum += mean_weight(coat, wi, 3, 60'000, 21 + count).mean;
        ++count;
    }
    return sum / count;
}

// As under a smooth coat: a slope of 0.02 changes the light by less than 0.4 %, one of 0.1 loses up to
// 2.3 %, the errors of the sums among it.
TEST(TiltedRoughCoat, AFurnaceIsWhite) {
    for (const double roughness : {0.05, 0.2}) {
        const SatinPaint paint(test::paint_of(1.5, {test::flake_layer(1.5, 0.15, 0.7, 0.3)}, 1.0),
                               roughness);
        for (const double theta : {5.0, 60.0, 86.0}) {
            EXPECT_NEAR(satin_furnace(*paint.bound, theta, 0.02f), 1, 0.004)
                << roughness << " " << theta;
            EXPECT_NEAR(satin_furnace(*paint.bound, theta, 0.1f), 1 - 0.01, 0.0125)
                << roughness << " " << theta;
        }
    }
}

TEST(TiltedRoughCoat, DensitiesOfEightDirectionsAreThoseOfEach) {
    for (const Vec2f slope : kTilts) {
        expect_densities_of_eight(TiltedCoat(satin_metallic(), slope, direction(20, 30)), 1e-3f);
    }
}

// What flakes give to light samples is what they give when sampled: f cos over the hemisphere.
TEST(TiltedRoughCoat, FlakesSampledOneByOneGiveTheirLight) {
    paint::Recipe recipe = paint_of({metal_flake(40, 0.7)});
    recipe.clearcoat = paint::Clearcoat{0, 0.0, 0.05};
    const SparklingModel model(recipe);
    Rng rng(3);
    PatchMemory memory(model.bound->patch_memory_bytes());
    Patch patch = random_square_patch(rng, 0.2);
    patch.memory = &memory;
    patch.flakes = Patch::Flakes::sampled;
    const Vec3f wi = direction(30, 20);
    const TiltedCoat coat(*model.bound, {0.06f, -0.04f}, wi);
    double sum = 0;
    constexpr int kGrid = 700;  // far finer than the lobe of a flake
    for (int a = 0; a < kGrid; ++a) {
        for (int b = 0; b < kGrid; ++b) {
            const double x = 2 * (a + 0.5) / kGrid - 1, y = 2 * (b + 0.5) / kGrid - 1;
            if (x * x + y * y >= 1) continue;
            const Vec3f wo = to_float(Vec3d{x, y, std::sqrt(1 - x * x - y * y)});
            constexpr double kArea = 4.0 / (kGrid * kGrid);  // cos d omega
            sum += kArea * coat.flakes_at(patch, wi, wo, std::numeric_limits<float>::infinity())[3];
        }
    }
    std::vector<FlakeSample> list;
    std::vector<double> light;
    for (int time = 0; time < 400; ++time) {
        list = flake_samples(coat, patch, wi, static_cast<std::uint32_t>(hash_of(time)));
        light.push_back(0);
        for (const FlakeSample& flake : list)
            light.back() += coat.flake_weight(patch, wi, flake)[3];
    }
    const test::Moments sampled(light);
    ASSERT_GT(list.size(), 5u);
    ASSERT_GT(sampled.mean, 0.02);
    EXPECT_NEAR(sampled.mean, sum, test::kWorstZ * sampled.mean_error + 0.01 * sum);
}

}  // namespace
}  // namespace nacre::bsdf
