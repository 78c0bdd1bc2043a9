#include "nacre/bsdf/leaning_flakes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>

#include "nacre/bsdf/models/microflake.h"
#include "nacre/core/math.h"
#include "nacre/core/random.h"
#include "nacre/optics/fresnel.h"
#include "nacre/paint/beckmann.h"
#include "nacre/solver/solver.h"
#include "nacre/testing/bsdf.h"
#include "nacre/testing/nacre_model.h"
#include "nacre/testing/paints.h"
#include "nacre/testing/statistics.h"

namespace nacre::bsdf {
namespace {

using Lean = LeaningFlakes::Lean;
constexpr Vec2f kTangents[] = {{0.02f, 0}, {-0.05f, 0.06f}, {0.1f, -0.14f}};

struct LeaningPaint {
    std::shared_ptr<const solver::SolvedPaint> solved;
    std::unique_ptr<const BoundBsdf> bound;
    explicit LeaningPaint(paint::Recipe recipe) {
        recipe.lean = paint::FlakeLean{5, 0};  // whichever: for the tables of paints that lean
        solved = std::make_shared<const solver::SolvedPaint>(
            solver::solve(recipe, spectra::default_wavelengths_nm()));
        bound = Microflake(solved).bind(kOnGrid);
    }
};

/// Under a clear coat that absorbs.
const BoundBsdf& tinted_metallic() {
    static const LeaningPaint paint([] {
        paint::Recipe recipe = test::metallic(0.3, 0.6);
        recipe.clearcoat = paint::Clearcoat{40, 3.0, 0};
        return recipe;
    }());
    return *paint.bound;
}

TEST(LeaningFlakes, TheirFrameIsTheShortestTurn) {
    for (const Vec2f tangents : kTangents) {
        const Lean lean(tangents);
        EXPECT_NEAR(lean.n.x / lean.n.z, tangents.x, 1e-6);
        EXPECT_NEAR(lean.n.y / lean.n.z, tangents.y, 1e-6);
        EXPECT_NEAR(length(lean.to_flakes(lean.n) - Vec3f{0, 0, 1}), 0, 1e-6);
        // What is perpendicular to both normals stays.
        const Vec3f axis = normalize(cross(Vec3f{0, 0, 1}, lean.n));
        EXPECT_NEAR(length(lean.to_flakes(axis) - axis), 0, 1e-6);
        const Vec3f w = direction(40, 70);
        EXPECT_NEAR(length(lean.from_flakes(lean.to_flakes(w)) - w), 0, 1e-6);
    }
}

TEST(LeaningFlakes, WithoutATiltTheyAreThePaintItself) {
    // With two layers of flakes, pigments and a bright ground; with the hot spot too.
    const LeaningPaint rich(recipe_with_every_feature());
    const std::unique_ptr<const BoundBsdf> nacre = Nacre(rich.solved).bind(kOnGrid);
    Rng rng(4);
    for (const BoundBsdf* flat : {&tinted_metallic(), rich.bound.get(), nacre.get()}) {
        const LeaningFlakes upright(*flat, Lean({0, 0}));
        for (int i = 0; i < 300; ++i) {
            const Vec3f wi = direction(88 * rng.uniform_double(), 360 * rng.uniform_double());
            const Vec3f wo = direction(88 * rng.uniform_double(), 360 * rng.uniform_double());
            const FloatLanes f = flat->eval(wi, wo), leaning = upright.eval(wi, wo);
            for (int lane = 0; lane < kLanes; ++lane) {
                ASSERT_NEAR(leaning[lane], f[lane], 2e-4f * f[lane]);
            }
        }
    }
}

// Light that met one flake, with the hot spot, by the formula of hot_spot.h: discs that lean block a ray
// within d/2 of it across their mean normal, as those that lie flat do, but the layer's surface cuts the
// heights off which both ways share, at c'/mu times the depth for each of them and midway between for
// both. The flat paint shares all of one depth, which is put right with the depths: that differs by the
// square of half the difference of the ways.                                        [kuusk-1985]
TEST(LeaningFlakes, HaveTheHotSpotOfWaysOfUnequalLength) {
    constexpr double kWide_um = 20, kThick_um = 15, kDense = 2 / kThick_um, kBeckmann = 0.15;
    paint::Recipe recipe = test::paint_of(1.5, {test::flake_layer(2, kBeckmann, 1e-3, 0)}, 0);
    recipe.layers[0].thickness_um = kThick_um;
    recipe.layers[0].flakes[0].amount = paint::AreaDensity{kDense};
    recipe.layers[0].flakes[0].diameter_um = kWide_um;
    const LeaningPaint plain(recipe);  // hardly anything is scattered twice
    const std::unique_ptr<const BoundBsdf> nacre = Nacre(plain.solved).bind(kOnGrid);
    const Lean lean({static_cast<float>(std::tan(6 * kDegree)), 0});
    const LeaningFlakes hot(*nacre, lean), without(*plain.bound, lean);
    double worst = 0, sum = 0;
    int compared = 0;
    for (const double lamp : {0.0, 90.0, 180.0}) {
        struct Ways {
            double theta_i, theta_o, phi;
        };
        for (const Ways& ways : {Ways{45, 60, 180},
                                 {45, 30, 180},
                                 {45, 20, 180},
                                 {45, 0, 180},
                                 {45, 35, 130},
                                 {10, 10, 0}}) {
            const Vec3f wi = direction(ways.theta_i, lamp),
                        wo = direction(ways.theta_o, lamp + ways.phi);
            const auto inside = [](Vec3f w) {
                const Vec3d in{w.x / 1.5, w.y / 1.5, 0};
                return Vec3d{in.x, in.y, std::sqrt(1 - in.x * in.x - in.y * in.y)};
            };
            const Vec3d i = inside(wi), o = inside(wo), m = to_double(lean.n);
            const double ci = dot(i, m), co = dot(o, m);
            const double si = kDense * paint::projected_area(ci, kBeckmann),
                         so = kDense * paint::projected_area(co, kBeckmann);
            const double met = si / i.z + so / o.z, shared = std::sqrt(si / ci * so / co),
                         apart = length(i * (1 / ci) - o * (1 / co)),
                         longer = 2 / (i.z / ci + o.z / co);
            constexpr int kSteps = 4000;
            double light = 0, transfer = 0, overlap_um = 0;
            for (int step = 0; step < kSteps; ++step) {
                const double z = kThick_um * (step + 0.5) / kSteps;
                const double x = apart * longer * z / kWide_um;
                const double half_um =
                    0.5 * longer * kThick_um / kSteps *
                    (x < 1 ? 2 * std::numbers::inv_pi * (std::acos(x) - x * std::sqrt(1 - x * x))
                           : 0);
                overlap_um += half_um;
                light += std::exp(-met * z + shared * overlap_um);
                transfer += std::exp(-met * z);
                overlap_um += half_um;
            }
            const double ratio = hot.eval(wi, wo)[2] / without.eval(wi, wo)[2] * transfer / light;
            worst = test::worse(worst, std::abs(ratio - 1));
            sum += ratio - 1;
            ++compared;
            EXPECT_GT(light, 1.3 * transfer);
        }
    }
    std::printf("[ measured ] over the closed form: by %.4f in the mean, up to %.4f\n",
                sum / compared, worst);
    EXPECT_LT(worst, 0.008);
    EXPECT_NEAR(sum / compared, 0, 0.003);
}

// By a paint of its own over black.
TEST(LeaningFlakes, LightFromTheGroundIsWhatTheFlakesOverBlackHaveNot) {
    const auto flakes_over = [](double reflectance) {
        paint::Recipe recipe =
            test::paint_of(1.5, {test::flake_layer(1, 0.16, 0.8, 0.1)}, reflectance);
        recipe.clearcoat = paint::Clearcoat{40, 3.0, 0};
        return recipe;
    };
    const LeaningPaint white(flakes_over(0.9)), black(flakes_over(0));
    Rng rng(5);
    double brightest = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec3f wi = direction(85 * rng.uniform_double(), 360 * rng.uniform_double());
        const Vec3f wo = direction(85 * rng.uniform_double(), 360 * rng.uniform_double());
        const MultiplyScattered over_white = white.bound->multiply_scattered(wi, wo);
        const MultiplyScattered over_black = black.bound->multiply_scattered(wi, wo);
        const float f = white.bound->eval(wi, wo)[0], ground = over_white.from_ground[0];
        ASSERT_NEAR(f - ground, black.bound->eval(wi, wo)[0], 2e-3f * f);
        brightest = std::max(brightest, double{ground / f});
        EXPECT_EQ(over_black.from_ground[0], 0);
        ASSERT_NEAR(over_white.no_internal_reflection[0], over_black.no_internal_reflection[0],
                    1e-3f * f);
    }
    EXPECT_GT(brightest, 0.8);
}

/// Answers 1 and remembers with what it was asked, as a paint of this index under a coat of this depth.
class Asked : public BoundBsdf {
 public:
    static constexpr float kIndex = 1.5f, kDepth = 0.3f, kFlakes = 0.7f, kPigments = 0.2f;
    FloatLanes eval(Vec3f i, Vec3f o) const override {
        wi = i;
        wo = o;
        return splat(1.0f);
    }
    float pdf(Vec3f, Vec3f) const override { return 1; }
    std::optional<BsdfSample> sample(Vec3f, float, Vec2f) const override { return std::nullopt; }
    FloatLanes albedo(Vec3f) const override { return splat(1.0f); }
    BinderIndex binder_index() const override { return {kIndex, splat(kIndex)}; }
    FloatLanes coat_depth() const override { return splat(kDepth); }
    OpticalDepths optical_depths(float cosine) const override {
        return {splat(kFlakes * cosine), FloatLanes{}, splat(kPigments), FloatLanes{}};
    }

    mutable Vec3f wi, wo;
};

// In double precision, by the formula of the header: the flakes see inside what they would see lying
// flat, interface and coat are crossed along the true directions.
TEST(LeaningFlakes, AreAskedInTheirOwnFrameUnderTheCoatAsItLies) {
    const Asked flat;
    const auto inside = [](Vec3d w) {
        const double s2 = (w.x * w.x + w.y * w.y) / (Asked::kIndex * Asked::kIndex);
        return Vec3d{w.x / Asked::kIndex, w.y / Asked::kIndex, std::sqrt(1 - s2)};
    };
    const auto passed = [](double cosine) {
        return 1 - optics::dielectric_reflectance(1.0, double{Asked::kIndex}, cosine);
    };
    Rng rng(3);
    int compared = 0;
    for (const Vec2f tangents : kTangents) {
        const Lean lean(tangents);
        const LeaningFlakes leaning(flat, lean);
        for (int k = 0; k < 300; ++k) {
            const Vec3f a = direction(45 * rng.uniform_double(), 360 * rng.uniform_double());
            const Vec3f b = direction(45 * rng.uniform_double(), 360 * rng.uniform_double());
            const double f = leaning.eval(a, b)[0];
            double expected = 1, here = 0, there = 0, longer = 0;
            for (const auto& [w, asked] : {std::pair{a, flat.wi}, std::pair{b, flat.wo}}) {
                const Vec3d in = inside(to_double(w)), of_flat = inside(to_double(asked));
                const Vec3d turned{dot(in, to_double(lean.s)), dot(in, to_double(lean.t)),
                                   dot(in, to_double(lean.n))};
                EXPECT_NEAR(length(turned - of_flat), 0, 2e-6);
                expected *= passed(w.z) / passed(asked.z);
                expected *= turned.z / in.z;
                const double depth = Asked::kFlakes * turned.z + Asked::kPigments;
                here += depth / in.z;
                there += depth / turned.z;
                longer += 1 / in.z - 1 / turned.z;
            }
            expected *= (1 - std::exp(-here)) / here / ((1 - std::exp(-there)) / there) *
                        std::exp(-longer * Asked::kDepth);
            EXPECT_NEAR(f, expected, 2e-5 * expected);
            ++compared;
        }
    }
    EXPECT_EQ(compared, 900);
}

/// Of which a quarter is left where flakes are apart, and these show 2.
class AskedWithFlakes final : public Asked {
 public:
    BsdfValue evaluate_on(const Patch& patch, Vec3f i, Vec3f o) const override {
        const float left = patch.flakes == Patch::Flakes::shown ? 2 : 0.25f;
        return {left * eval(i, o), pdf(i, o)};
    }
    bool samples_flakes() const override { return true; }
    FloatLanes flakes_at(const Patch&, Vec3f, Vec3f, float) const override { return splat(2.0f); }
};

// Beyond the critical angle no flake is sampled: met by chance, with wide light, one alone would be a
// speck. Narrow light is sampled by itself and meets all of them.
TEST(LeaningFlakes, ShowTheirMeanUnderWideLightBeyondTheCriticalAngle) {
    using Flakes = Patch::Flakes;
    const AskedWithFlakes flat;
    const LeaningFlakes leaning(flat, Lean({0.1f, 0}));
    int beyond = 0;
    for (int azimuth = 0; azimuth < 360; azimuth += 15) {
        const Vec3f wi = direction(20, 0), wo = direction(75, azimuth);
        const float mean = leaning.eval(wi, wo)[0];
        Patch patch;
        const auto left = [&](Flakes flakes, float narrow_light_pdf) {
            patch.flakes = flakes;
            patch.narrow_light_pdf = narrow_light_pdf;
            return leaning.evaluate_on(patch, wi, wo).f[0];
        };
        EXPECT_FLOAT_EQ(left(Flakes::shown, 0), 2 * mean);
        EXPECT_FLOAT_EQ(left(Flakes::sampled, 1e4f), 0.25f * mean);
        EXPECT_GT(leaning.flakes_at(patch, wi, wo, 1)[0], 0);
        const float wide = left(Flakes::sampled, 0);
        EXPECT_EQ(wide, left(Flakes::left_out, 0));
        if (leaning.flakes_at(patch, wi, wo, 1)[0] > 0) {
            EXPECT_FLOAT_EQ(wide, 0.25f * mean);
        } else {
            EXPECT_FLOAT_EQ(wide, mean);
            ++beyond;
        }
    }
    EXPECT_GT(beyond, 3);
    EXPECT_LT(beyond, 20);
}

TEST(LeaningFlakes, TurnWithTheirAzimuth) {
    constexpr double kTurn = 65 * kDegree;
    const auto turned = [](Vec3f w) {
        const auto c = static_cast<float>(std::cos(kTurn)), s = static_cast<float>(std::sin(kTurn));
        return Vec3f{c * w.x - s * w.y, s * w.x + c * w.y, w.z};
    };
    Rng rng(8);
    for (const Vec2f t : kTangents) {
        const Vec3f there = turned({t.x, t.y, 0});
        const LeaningFlakes one(tinted_metallic(), Lean(t));
        const LeaningFlakes other(tinted_metallic(), Lean({there.x, there.y}));
        for (int i = 0; i < 200; ++i) {
            const Vec3f wi = direction(75 * rng.uniform_double(), 360 * rng.uniform_double());
            const Vec3f wo = direction(75 * rng.uniform_double(), 360 * rng.uniform_double());
            const double f = one.eval(wi, wo)[3];
            ASSERT_NEAR(other.eval(turned(wi), turned(wo))[3], f, 1e-5 + 1e-3 * f);
        }
    }
}

TEST(LeaningFlakes, AreReciprocal) {
    Rng rng(9);
    for (const Vec2f t : kTangents) {
        const LeaningFlakes leaning(tinted_metallic(), Lean(t));
        for (int i = 0; i < 200; ++i) {
            const Vec3f a = direction(80 * rng.uniform_double(), 360 * rng.uniform_double());
            const Vec3f b = direction(80 * rng.uniform_double(), 360 * rng.uniform_double());
            const double forth = leaning.eval(a, b)[0], back = leaning.eval(b, a)[0];
            ASSERT_NEAR(forth, back, 1e-5 + 1e-3 * forth);
        }
    }
}

// Where directions pass the critical angle of the flakes' frame, on any side of the lamp, also where no
// flake would mirror between the two.
TEST(LeaningFlakes, ChangeLittleFromOneDirectionToTheNext) {
    const LeaningFlakes leaning(tinted_metallic(), Lean({-0.176f, 0.0f}));
    const Vec3f wi = direction(70, 0);
    int beyond = 0;
    double change = 0, largest = 0;
    for (const double azimuth : {0.0, 40.0, 90.0, 140.0, 180.0}) {
        double before = leaning.eval(wi, direction(40, azimuth))[0];
        constexpr double kStep_deg = 0.05;
        for (double theta = 40 + kStep_deg; theta < 85; theta += kStep_deg) {
            const Vec3f wo = direction(theta, azimuth);
            const double f = leaning.eval(wi, wo)[0];
            change = test::worse(change, std::abs(f - before));
            largest = std::max(largest, f);
            before = f;
            beyond += leaning.pdf(wi, wo) <= 0.26 * std::numbers::inv_pi * wo.z;
        }
    }
    std::printf("[ measured ] steps of up to %.4f\n", change / largest);
    EXPECT_LT(change, 0.01 * largest);
    EXPECT_GT(beyond, 500);  // there only a quarter of the samples arrive, evenly
}

TEST(LeaningFlakes, SamplesHaveTheDensityThatPdfGives) {
    int cases = 0;
    for (const Vec2f t : kTangents) {
        for (const double theta : {10.0, 50.0, 80.0}) {
            const LeaningFlakes leaning(tinted_metallic(), Lean(t));
            EXPECT_LT(std::abs(chi_square_z_score(leaning, direction(theta, 30), 17, 200'000)),
                      test::kWorstZ)
                << t.x << " " << theta;
            ++cases;
        }
    }
    EXPECT_EQ(cases, 9);
}

TEST(LeaningFlakes, SamplesAreWorthTheirValueOverTheirDensity) {
    Rng rng(6);
    int specular = 0, others = 0;
    for (int i = 0; i < 6000; ++i) {
        const LeaningFlakes leaning(tinted_metallic(), Lean(kTangents[i % std::size(kTangents)]));
        const Vec3f wi = direction(89 * rng.uniform_double(), 360 * rng.uniform_double());
        const auto s =
            leaning.sample(wi, rng.uniform_float(), {rng.uniform_float(), rng.uniform_float()});
        if (!s) continue;
        EXPECT_GT(s->wo.z, 0);
        if (s->kind == SampleKind::specular) {  // of the interface, which lies as ever
            EXPECT_EQ(length(s->wo - Vec3f{-wi.x, -wi.y, wi.z}), 0);
            const double reflectance = optics::dielectric_reflectance(
                1.0, double{leaning.binder_index().mean}, double{wi.z});
            EXPECT_NEAR(s->weight[0] * s->pdf, reflectance, 1e-4);
            ++specular;
            continue;
        }
        ++others;
        const BsdfValue value = leaning.evaluate(wi, s->wo);
        // Found: 8e-5 and 1.6e-4.
        EXPECT_NEAR(s->pdf, value.pdf, 5e-4f * value.pdf);
        for (int lane = 0; lane < kLanes; ++lane) {
            EXPECT_NEAR(s->weight[lane] * s->pdf, value.f[lane] * s->wo.z,
                        1e-3f * value.f[lane] * s->wo.z);
        }
    }
    EXPECT_GT(specular, 300);
    EXPECT_GT(others, 3000);
}

// In the mean over all directions flakes that lean let more of the ground's light pass, by the square of
// the tilt, and how often the ground has it back is of the flat paint: so much light is made.
TEST(LeaningFlakes, SamplesAreWorthAboutTheSame) {
    // What only few samples find, beyond the critical angle of the flat paint, is grain in pictures: with a
    // thirty-second of the samples for it the ratio was 4.4.
    Rng rng(8);
    constexpr int kCount = 20'000;
    double worst = 0;
    for (const Vec2f t : kTangents) {
        for (const double azimuth : {0.0, 90.0, 180.0, 270.0}) {
            const LeaningFlakes leaning(tinted_metallic(), Lean(t));
            double sum = 0, squares = 0;
            int count = 0;
            for (int i = 0; i < kCount; ++i) {
                const auto s = leaning.sample(direction(60, azimuth), rng.uniform_float(),
                                              {rng.uniform_float(), rng.uniform_float()});
                if (s && s->kind == SampleKind::specular) continue;
                ++count;
                if (!s) continue;
                const double weight = lane_mean(s->weight);
                sum += weight;
                squares += weight * weight;
            }
            ASSERT_GT(sum, 0);
            worst = test::worse(worst, squares * count / (sum * sum));
        }
    }
    std::printf("[ measured ] mean square of weights over square of their mean: %.2f\n", worst);
    EXPECT_LT(worst, 2.8);
}

TEST(LeaningFlakes, GiveBackTheLightButForTheirTilt) {
    static const LeaningPaint lossless(
        test::paint_of(1.5, {test::flake_layer(1.5, 0.15, 0.7, 0.3)}, 1.0));
    for (const double tilt : {0.05, 0.1}) {
        for (const double azimuth : {0.0, 90.0, 180.0}) {
            const auto t = static_cast<float>(tilt);
            const LeaningFlakes leaning(
                *lossless.bound, Lean({t * static_cast<float>(std::cos(azimuth * kDegree)),
                                       t * static_cast<float>(std::sin(azimuth * kDegree))}));
            const Vec3f wi = direction(45, 0);
            Rng rng(12);
            double sum = 0, squares = 0;
            constexpr int kCount = 200'000;
            for (int i = 0; i < kCount; ++i) {
                const auto s = leaning.sample(wi, rng.uniform_float(),
                                              {rng.uniform_float(), rng.uniform_float()});
                const double weight = s ? s->weight[0] : 0;
                sum += weight;
                squares += weight * weight;
            }
            const double mean = sum / kCount,
                         error = std::sqrt((squares / kCount - mean * mean) / kCount);
            std::printf("[ measured ] tilt %g, azimuth %g: furnace %.4f +- %.4f\n", tilt, azimuth,
                        mean, error);
            EXPECT_NEAR(mean, 1, 0.25 * tilt + 4 * error) << tilt << " " << azimuth;
        }
    }
}

}  // namespace
}  // namespace nacre::bsdf
