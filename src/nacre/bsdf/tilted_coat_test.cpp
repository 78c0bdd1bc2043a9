#include "nacre/bsdf/tilted_coat.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "nacre/bsdf/flake_lobe.h"
#include "nacre/bsdf/models/microflake.h"
#include "nacre/core/random.h"
#include "nacre/optics/fresnel.h"
#include "nacre/solver/solver.h"
#include "nacre/testing/bsdf.h"
#include "nacre/testing/nacre_model.h"
#include "nacre/testing/paints.h"
#include "nacre/testing/statistics.h"

namespace nacre::bsdf {
namespace {

constexpr float kIndex = 1.5f;
constexpr Vec2f kSlopes[] = {{0.01f, 0}, {-0.03f, 0.02f}, {0.1f, 0.05f}};

/// Remembers the directions that it is asked with, and answers 1.
class Recorder final : public BoundBsdf {
 public:
    FloatLanes eval(Vec3f i, Vec3f o) const override {
        wi = i;
        wo = o;
        return splat(1.0f);
    }
    float pdf(Vec3f, Vec3f) const override { return 1; }
    std::optional<BsdfSample> sample(Vec3f, float, Vec2f) const override { return std::nullopt; }
    FloatLanes albedo(Vec3f) const override { return splat(1.0f); }
    BinderIndex binder_index() const override { return {kIndex, splat(kIndex)}; }

    mutable Vec3f wi, wo;
};

/// By angles, in double precision: the direction refracted at a plane of this normal.
Vec3d refracted(Vec3d w, Vec3d normal, double index) {
    const double cosine = dot(w, normal);
    const Vec3d along = w - cosine * normal;
    const double sine = length(along), inside = sine / index;
    return sine > 0 ? (inside / sine) * along + std::sqrt(1 - inside * inside) * normal : normal;
}

double transmittance(double index, double cosine) {
    return 1 - optics::dielectric_reflectance(1.0, index, cosine);
}

Vec3d normal_of(Vec2f slope) { return normalize(Vec3d{-slope.x, -slope.y, 1}); }

// The flat coat is asked with directions that are the same inside, and its answer is turned into what
// the prism of the tilted interface gives: transmittances, and the irradiance of the layers below.
TEST(TiltedCoat, LightIsRefractedThroughTheTiltedInterface) {
    const Recorder flat;
    Rng rng(2);
    int compared = 0;
    for (const Vec2f slope : kSlopes) {
        const Vec3d m = normal_of(slope);
        for (int i = 0; i < 300; ++i) {
            const Vec3f a = direction(55 * rng.uniform_double(), 360 * rng.uniform_double());
            const Vec3f b = direction(55 * rng.uniform_double(), 360 * rng.uniform_double());
            const TiltedCoat coat(flat, slope, a);
            const double f = coat.eval(a, b)[0];
            const Vec3d a_in = refracted(to_double(a), m, kIndex);
            const Vec3d b_in = refracted(to_double(b), m, kIndex);
            const Vec3d z{0, 0, 1};
            EXPECT_NEAR(length(refracted(to_double(flat.wi), z, kIndex) - a_in), 0, 1e-6);
            EXPECT_NEAR(length(refracted(to_double(flat.wo), z, kIndex) - b_in), 0, 1e-6);
            const double expected =
                transmittance(kIndex, dot(to_double(a), m)) / transmittance(kIndex, flat.wi.z) *
                transmittance(kIndex, dot(to_double(b), m)) / transmittance(kIndex, flat.wo.z) *
                b_in.z * dot(to_double(b), m) / (dot(b_in, m) * b.z);
            EXPECT_NEAR(f, expected, 1e-5 * expected);
            ++compared;
        }
    }
    EXPECT_EQ(compared, 900);
}

// Near the normal the light inside turns by (1 - 1/n) of the slope, which looks from outside like n - 1.
TEST(TiltedCoat, FlakesAreSeenTurnedByNMinusOneSlopes) {
    const Recorder flat;
    const Vec2f slope{0.002f, -0.001f};
    const TiltedCoat coat(flat, slope, {0, 0, 1});
    coat.eval({0, 0, 1}, {0, 0, 1});
    EXPECT_NEAR(flat.wi.x, -(kIndex - 1) * slope.x, 1e-6);
    EXPECT_NEAR(flat.wi.y, -(kIndex - 1) * slope.y, 1e-6);
}

struct Paints {
    std::shared_ptr<const solver::SolvedPaint> solved;
    std::unique_ptr<const BoundBsdf> bound;
    explicit Paints(const paint::Recipe& recipe)
        : solved(std::make_shared<const solver::SolvedPaint>(
              solver::solve(recipe, spectra::default_wavelengths_nm()))),
          bound(Microflake(solved).bind(kOnGrid)) {}
};

const BoundBsdf& wide_metallic() {
    static const Paints paints(test::metallic(0.3, 0.6));
    return *paints.bound;
}

TEST(TiltedCoat, AFlatOneIsThePaintItself) {
    const BoundBsdf& flat = wide_metallic();
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

TEST(TiltedCoat, SamplesHaveTheDensityThatPdfGives) {
    int cases = 0;
    for (const Vec2f slope : kSlopes) {
        for (const double theta : {10.0, 50.0, 80.0}) {
            const Vec3f wi = direction(theta, 30);
            const TiltedCoat coat(wide_metallic(), slope, wi);
            EXPECT_LT(std::abs(chi_square_z_score(coat, wi, 17, 200'000)), test::kWorstZ)
                << slope.x << " " << theta;
            ++cases;
        }
    }
    EXPECT_EQ(cases, 9);
}

TEST(TiltedCoat, SamplesAreWorthTheirValueOverTheirDensity) {
    Rng rng(6);
    int specular = 0, others = 0;
    for (int i = 0; i < 6000; ++i) {
        const Vec2f slope = kSlopes[i % std::size(kSlopes)];
        const Vec3f wi = direction(89 * rng.uniform_double(), 360 * rng.uniform_double());
        const TiltedCoat coat(wide_metallic(), slope, wi);
        const float u_select = rng.uniform_float();
        const auto s = coat.sample(wi, u_select, {rng.uniform_float(), rng.uniform_float()});
        if (!s) continue;
        EXPECT_GT(s->wo.z, 0);
        EXPECT_EQ(s->kind == SampleKind::specular, u_select < coat.specular_probability(wi));
        EXPECT_NEAR(coat.pdf(wi, s->wo), coat.evaluate(wi, s->wo).pdf, 1e-6 * s->pdf);
        if (s->kind == SampleKind::specular) {
            // The law of reflection, but where the next wave turns it up.
            const Vec3f across = cross(wi + s->wo, coat.normal());
            const Vec3f mirrored = 2 * dot(wi, coat.normal()) * coat.normal() - wi;
            if (mirrored.z > 1e-5f) {
                EXPECT_NEAR(length(across), 0, 1e-6);
            }
            ++specular;
            continue;
        }
        ++others;
        const BsdfValue value = coat.evaluate(wi, s->wo);
        // Found: 2e-5 and 3e-5.
        EXPECT_NEAR(s->pdf, value.pdf, 2e-4f * value.pdf);
        for (int lane = 0; lane < kLanes; ++lane) {
            EXPECT_NEAR(s->weight[lane] * s->pdf, value.f[lane] * s->wo.z,
                        2e-4f * value.f[lane] * s->wo.z);
        }
    }
    EXPECT_GT(specular, 300);
    EXPECT_GT(others, 3000);
}

// What leaves beyond the flat coat's critical angle is bright, and few: single samples of it that are
// worth more than ten are specks in a picture.
TEST(TiltedCoat, NoSampleIsWorthMuch) {
    Rng rng(8);
    float most = 0;
    for (int i = 0; i < 400'000; ++i) {
        const double slope = 0.15 * rng.uniform_double(), turn = 360 * rng.uniform_double();
        const Vec3f turned = direction(90, turn), wi = direction(30 + 40 * rng.uniform_double());
        const TiltedCoat coat(wide_metallic(), {float(slope) * turned.x, float(slope) * turned.y},
                              wi);
        const auto s =
            coat.sample(wi, rng.uniform_float(), {rng.uniform_float(), rng.uniform_float()});
        if (s && s->kind != SampleKind::specular) most = test::worse(most, lane_max(s->weight));
    }
    EXPECT_LT(most, 10);
}

// Up to the factor by which a plane wave spreads over the layers below.
TEST(TiltedCoat, ValuesAreReciprocalUpToTheSpreadOfPlaneWaves) {
    Rng rng(9);
    for (const Vec2f slope : kSlopes) {
        const Vec3d m = normal_of(slope);
        const auto spread = [&](Vec3f w) {
            const Vec3d inside = refracted(to_double(w), m, kIndex);
            return inside.z * dot(to_double(w), m) / (dot(inside, m) * w.z);
        };
        for (int i = 0; i < 200; ++i) {
            const Vec3f a = direction(75 * rng.uniform_double(), 360 * rng.uniform_double());
            const Vec3f b = direction(75 * rng.uniform_double(), 360 * rng.uniform_double());
            const TiltedCoat coat(wide_metallic(), slope, a);
            const double forth = coat.eval(a, b)[0] / spread(b);
            const double back = coat.eval(b, a)[0] / spread(a);
            ASSERT_NEAR(forth, back, 1e-5 + 1e-3 * forth);
        }
    }
}

/// Lossless: what goes in comes out.
const BoundBsdf& lossless() {
    static const Paints paints([] {
        paint::Recipe recipe = test::paint_of(1.5, {test::flake_layer(1.5, 0.15, 0.7, 0.3)}, 1.0);
        return recipe;
    }());
    return *paints.bound;
}

/// What a furnace of radiance 1 sends to wi, on average over slopes and their opposites.
double furnace(double theta, float slope) {
    double sum = 0;
    int count = 0;
    for (const double phi : {0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0}) {
        const Vec3f turned = direction(90, phi);
        const Vec3f wi = direction(theta, 0);
        const TiltedCoat coat(lossless(), {slope * turned.x, slope * turned.y}, wi);
        // Samples differ most at grazing incidence.
        sum += mean_weight(coat, wi, 3, theta > 80 ? 1'000'000 : 120'000, 21 + count).mean;
        ++count;
    }
    return sum / count;
}

// A slope of 0.02 loses up to 0.3 % of the light, one of 0.1 up to 2.1 %, and none makes light. A facet
// alone may send more to one side and less to the other.
TEST(TiltedCoat, AFurnaceIsWhite) {
    for (const double theta : {5.0, 40.0, 60.0, 75.0, 86.0}) {
        EXPECT_NEAR(mean_weight(lossless(), direction(theta, 0), 3, 480'000, 21).mean, 1, 0.001);
        const double gentle = furnace(theta, 0.02f), steep = furnace(theta, 0.1f);
        EXPECT_NEAR(gentle, 1 - 0.002, 0.0025) << theta;
        EXPECT_NEAR(steep, 1 - 0.01, 0.0125) << theta;
    }
}

TEST(TiltedCoat, DensitiesOfEightDirectionsAreThoseOfEach) {
    for (const Vec2f slope : kSlopes) {
        expect_densities_of_eight(TiltedCoat(wide_metallic(), slope, direction(20, 30)), 1e-3f);
    }
}

TEST(TiltedCoat, NothingComesFromBelowEitherHorizon) {
    const Vec3f wi = direction(60);
    const TiltedCoat coat(wide_metallic(), {0.2f, 0}, wi);  // the normal leans to -x
    EXPECT_EQ(coat.eval(wi, direction(85, 0))[0], 0);       // behind the facet
    EXPECT_GT(coat.eval(wi, direction(85, 180))[0], 0);
    EXPECT_EQ(coat.eval(wi, {-0.995f, 0, -0.1f})[0], 0);  // in front of it, below the surface
    EXPECT_EQ(coat.pdf(wi, direction(85, 0)), 0);
    // A facet that faces away is just seen.
    const Vec3f grazing = direction(85, 0);
    const TiltedCoat away(wide_metallic(), {0.2f, 0}, grazing);
    EXPECT_GT(dot(away.normal(), grazing), 0);
    EXPECT_TRUE(away.sample(grazing, 0.999f, {0.3f, 0.4f}).has_value() ||
                away.sample(grazing, 0.5f, {0.3f, 0.4f}).has_value());
}

// What flakes give to light samples is what they give when sampled: f cos over all that leaves a flat coat too.
// Beyond its critical angle no flake is sampled.
TEST(TiltedCoat, FlakesSampledOneByOneGiveTheirLight) {
    const SparklingModel model(paint_of({metal_flake(40, 0.7)}));
    Rng rng(3);
    PatchMemory memory(model.bound->patch_memory_bytes());
    Patch patch = random_square_patch(rng, 0.2);
    patch.memory = &memory;
    patch.flakes = Patch::Flakes::sampled;
    const Vec3f wi = direction(30, 20);
    const TiltedCoat coat(*model.bound, {0.06f, -0.04f}, wi);
    const float ior = coat.binder_index().mean;
    const auto leaves_flat_coat = [&](Vec3f wo) {
        const float cosine = dot(wo, coat.normal());
        const float z = (wo.z - cosine * coat.normal().z) / ior +
                        coat.normal().z * std::sqrt(1 - (1 - cosine * cosine) / (ior * ior));
        return z > std::sqrt(1 - 1 / (ior * ior));
    };
    double sum = 0;
    constexpr int kGrid = 1400;  // far finer than the lobe of a flake
    for (int a = 0; a < kGrid; ++a) {
        for (int b = 0; b < kGrid; ++b) {
            const double x = 2 * (a + 0.5) / kGrid - 1, y = 2 * (b + 0.5) / kGrid - 1;
            if (x * x + y * y >= 1) continue;
            const Vec3f wo = to_float(Vec3d{x, y, std::sqrt(1 - x * x - y * y)});
            if (!leaves_flat_coat(wo)) continue;
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
    // 1 %: the wings of a flake's pattern are drawn more rarely than they are bright.
    EXPECT_NEAR(sampled.mean, sum, test::kWorstZ * sampled.mean_error + 0.01 * sum);
}

}  // namespace
}  // namespace nacre::bsdf
