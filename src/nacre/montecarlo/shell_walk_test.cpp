#include "nacre/montecarlo/shell_walk.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nacre/core/error.h"
#include "nacre/montecarlo/plane_walk.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/montecarlo.h"
#include "nacre/testing/reference_albedos.h"

namespace nacre::montecarlo {
namespace {

using nacre::test::message_of;
using test::direction;
using test::kOnGrid;
using test::kWorstZ;
using test::walked_albedo;

constexpr int kShellWalks = 200'000;
constexpr double kFlat = std::numeric_limits<double>::infinity();

/// Lossless flakes that transmit some light, and a pigment that absorbs nothing, over white.
paint::Recipe lossless(double thickness_um) {
    paint::Layer layer = test::flake_layer(1.5, 0.2, 0.7, 0.3);
    const double fraction = 10 / thickness_um;
    layer.thickness_um = thickness_um;
    layer.flakes[0].amount = paint::AreaDensity{0.15 * fraction};
    layer.pigments.push_back({paint::PigmentCoefficients{20 * fraction, 0, 0.5}});
    return test::paint_of(1.5, {layer}, 1);
}

void expect_reference_albedo(const VolumeModel& settings, double theta_deg) {
    SCOPED_TRACE(settings.radius_mm);
    const paint::Recipe recipe = test::pearl();
    const auto surface = ShellWalk(recipe, settings).bind(kOnGrid);
    test::expect_frozen_albedo(walked_albedo(*surface, direction(theta_deg, 30), kShellWalks / 2),
                               recipe, theta_deg);
}

TEST(ShellWalk, ThinShellHasTheAlbedoOfTheReference) {
    // 80 um on 50 mm: the radial direction changes by less than 1e-3 along a walk.
    expect_reference_albedo({.radius_mm = kFlat}, 20);
    expect_reference_albedo({.radius_mm = 1e9}, 45);
    expect_reference_albedo({.radius_mm = 50}, 60);
    expect_reference_albedo({.radius_mm = 50, .tracking = Tracking::simpson}, 30);
}

/// Power into bins of solid angle, specular reflection left out: by cosine and by azimuth.
test::Estimates power_by_direction(const bsdf::Bsdf& model, Vec3f wi, std::uint64_t seed) {
    constexpr int kRings = 4, kSectors = 4;
    return test::estimate(
        *model.bind(kOnGrid), wi, 2 * kShellWalks, kRings * kSectors, seed,
        [&](const bsdf::BsdfSample& s, std::vector<FloatLanes>& values) {
            if (s.kind == bsdf::SampleKind::specular || s.wo.z <= 0) return;
            const int ring = std::min(static_cast<int>(s.wo.z * s.wo.z * kRings), kRings - 1);
            const double turn = std::abs(std::atan2(s.wo.y, s.wo.x)) / std::numbers::pi;
            const int sector = std::min(static_cast<int>(turn * kSectors), kSectors - 1);
            values[ring * kSectors + sector] = s.weight;
        });
}

TEST(ShellWalk, ThinShellHasTheDirectionsOfThePositionFreeWalk) {
    const paint::Recipe recipe = test::pearl();
    const Vec3f wi = direction(50, 0);
    const auto expected = power_by_direction(PlaneWalk(recipe), wi, 1);
    std::uint64_t seed = 2;
    for (const VolumeModel& settings :
         {VolumeModel{}, VolumeModel{.radius_mm = 50},
          VolumeModel{.radius_mm = 50, .tracking = Tracking::simpson}}) {
        const auto found = power_by_direction(ShellWalk(recipe, settings), wi, seed++);
        for (std::size_t bin = 0; bin < expected.size(); ++bin) {
            for (int lane = 0; lane < kLanes; ++lane) {
                EXPECT_GT(expected[bin][lane].value, 5 * expected[bin][lane].standard_error);
                EXPECT_LT(std::abs(z_score(found[bin][lane], expected[bin][lane])), kWorstZ)
                    << "bin " << bin << ", " << kOnGrid[lane] << " nm, radius "
                    << settings.radius_mm;
            }
        }
    }
}

TEST(ShellWalk, TrackingsAgreeInAThickShell) {
    // 5 mm on 10 mm, where extinction varies along every ray. The place and the direction of exit
    // must agree, not only the power.
    const paint::Recipe recipe = [] {
        paint::Recipe r = lossless(5000);
        r.layers[0].flakes[0].body = paint::PrescribedFlake{0.6, 0.3, 0.3};
        return r;
    }();
    const Vec3f wi = direction(60, 0);
    const auto measure = [&](Tracking tracking, std::uint64_t seed) {
        const ShellWalk model(recipe, {.radius_mm = 10, .tracking = tracking});
        return test::estimate(*model.bind(kOnGrid), wi, kShellWalks, 5, seed,
                              [&](const bsdf::BsdfSample& s, std::vector<FloatLanes>& values) {
                                  values[0] = s.weight;
                                  values[1] = s.weight * (1 + s.wo.x);
                                  values[2] = s.weight * (1 + s.wo.z);
                                  values[3] = s.weight * (10 + s.exit_mm.x);
                                  values[4] = s.weight * dot(s.exit_mm, s.exit_mm);
                              });
    };
    const auto delta = measure(Tracking::delta, 1), simpson = measure(Tracking::simpson, 2);
    for (std::size_t q = 0; q < delta.size(); ++q) {
        EXPECT_LT(std::abs(z_score(delta[q][0], simpson[q][0])), kWorstZ)
            << q << ": " << delta[q][0].value << " against " << simpson[q][0].value;
    }
}

TEST(ShellWalk, LosesNoLightWhereNothingAbsorbs) {
    // White furnace test: nothing absorbs, so that each walk leaves with the weight that it entered
    // with.
    for (const Tracking tracking : {Tracking::delta, Tracking::simpson}) {
        for (const double radius_mm : {0.02, 10., 50.}) {
            const double half_radius_um = 500 * radius_mm;
            const ShellWalk model(lossless(half_radius_um), {radius_mm, tracking});
            const auto surface = model.bind(kOnGrid);
            Rng rng(3, 4);
            for (const double theta : {0., 45., 89.}) {
                for (int i = 0; i < 5000; ++i) {
                    const float u_select = rng.uniform_float(), u = rng.uniform_float();
                    const auto sample =
                        surface->sample(direction(theta, 20), u_select, {u, rng.uniform_float()});
                    ASSERT_TRUE(sample);
                    // Products of a few thousand doubles, rounded to float.
                    for (int lane = 0; lane < kLanes; ++lane)
                        EXPECT_NEAR(sample->weight[lane], 1, 1e-6);
                }
            }
        }
    }
}

TEST(ShellWalk, LeavesOnTheSphereAndOutwards) {
    const double radius_mm = 10;
    const ShellWalk model(lossless(4000), {.radius_mm = radius_mm});
    const auto surface = model.bind(kOnGrid);
    Rng rng(8, 9);
    int below_the_horizon = 0;
    for (int i = 0; i < 5000; ++i) {
        const float u_select = rng.uniform_float(), u = rng.uniform_float();
        const auto sample = surface->sample(direction(70, 0), u_select, {u, rng.uniform_float()});
        ASSERT_TRUE(sample);
        const Vec3f from_centre = sample->exit_mm + Vec3f{0, 0, static_cast<float>(radius_mm)};
        EXPECT_NEAR(length(from_centre), radius_mm, 1e-5) << "float";
        EXPECT_NEAR(length(sample->wo), 1, 1e-6);
        EXPECT_GE(dot(sample->wo, from_centre), -1e-5);
        below_the_horizon += sample->wo.z < 0;
    }
    EXPECT_GT(below_the_horizon, 100);
}

TEST(ShellWalk, LateralShiftOnAFlatSlabIsOfTheOrderOfItsThickness) {
    // A walk goes about as far as the paint is thick, whatever the radius.
    const auto surface = ShellWalk(test::worked_paint(), {}).bind(kOnGrid);
    Rng rng(1, 2);
    double furthest = 0;
    for (int i = 0; i < 2000; ++i) {
        const float u_select = rng.uniform_float(), u = rng.uniform_float();
        const auto sample = surface->sample(direction(45, 0), u_select, {u, rng.uniform_float()});
        if (!sample) continue;
        EXPECT_NEAR(sample->exit_mm.z, 0, 1e-6);
        furthest = std::max<double>(furthest, length(sample->exit_mm));
    }
    EXPECT_GT(furthest, 0.01);
    EXPECT_LT(furthest, 1);
}

TEST(ShellWalk, WavelengthsWithoutReflectionHaveTheSpecularOneOnly) {
    // Reflectance 0.8 from 550 nm on, 0 below: each lane has the mean it has alone.
    paint::Layer layer = test::flake_layer(2, 0.2, 0, 0);
    layer.flakes[0].body =
        paint::PrescribedFlake{spectra::Spectrum({550, 551}, {0, 0.8}), 0.0, 0.3};
    const paint::Recipe recipe = test::paint_of(1.5, {layer});
    const Vec3f wi = direction(30, 0);
    const ShellWalk model(recipe, {.radius_mm = 50});
    const auto mixed =
        walked_albedo(*model.bind({400, 410, 420, 430, 440, 450, 460, 600}), wi, kShellWalks);
    const auto alone =
        walked_albedo(*model.bind({600, 610, 620, 630, 640, 650, 660, 670}), wi, kShellWalks);
    EXPECT_LT(std::abs(z_score(mixed[7], alone[0])), kWorstZ);
    EXPECT_LT(std::abs(z_score(mixed[0], 0.0415)), kWorstZ + 0.1) << "Fresnel at 30 deg: 0.04152";
    EXPECT_GT(alone[0].value, 0.3);
}

TEST(ShellWalk, DispersiveBinderHasTheAlbedoOfEachIndex) {
    paint::Recipe recipe = test::worked_paint();
    recipe.binder = optics::Material("flint", std::vector<double>{400, 700},
                                     std::vector<optics::ComplexIndex>{1.9, 1.5});
    const Vec3f wi = direction(60, 0);
    const auto found =
        walked_albedo(*ShellWalk(recipe, {.radius_mm = 50}).bind(kOnGrid), wi, 2 * kShellWalks);
    for (int lane = 0; lane < kLanes; ++lane) {
        paint::Recipe single = test::worked_paint();
        single.binder = recipe.binder.index(kOnGrid[lane]);
        const auto expected = walked_albedo(*PlaneWalk(single).bind(kOnGrid), wi, kShellWalks);
        EXPECT_LT(std::abs(z_score(found[lane], expected[lane])), kWorstZ) << lane;
    }
}

TEST(ShellWalk, SameNumbersGiveTheSameWalk) {
    const ShellWalk model(test::pearl(), {.radius_mm = 50});
    const auto one = model.bind(kOnGrid), two = model.bind(kOnGrid);
    int different = 0;
    const auto first = one->sample({0, 0, 1}, 0.99f, {0, 0.5f});
    for (int i = 0; i < 100; ++i) {
        const Vec2f u{static_cast<float>(i) * 1e-6f, 0.5f};
        const auto a = one->sample({0, 0, 1}, 0.99f, u), b = two->sample({0, 0, 1}, 0.99f, u);
        ASSERT_EQ(a.has_value(), b.has_value());
        if (!a) continue;
        EXPECT_EQ(a->wo, b->wo);
        EXPECT_EQ(a->exit_mm, b->exit_mm);
        for (int lane = 0; lane < kLanes; ++lane) EXPECT_EQ(a->weight[lane], b->weight[lane]);
        different += !first || !(a->wo == first->wo);
    }
    EXPECT_GT(different, 20) << "and others another";
}

TEST(ShellWalk, RefusesWhatItCannotFollowAndSaysWhy) {
    const auto message = [](const paint::Recipe& recipe, const VolumeModel& settings) {
        return message_of<DomainError>([&] { ShellWalk model(recipe, settings); });
    };
    using testing::HasSubstr;
    const paint::Recipe good = test::worked_paint();
    EXPECT_EQ(message(good, {}), "accepted");
    EXPECT_THAT(message(good, {.radius_mm = 0}), HasSubstr("radius_mm = 0"));
    EXPECT_THAT(message(good, {.radius_mm = NAN}), HasSubstr("radius_mm = nan"));
    EXPECT_THAT(message(good, {.simpson_panels = 0}), HasSubstr("simpson_panels = 0"));
    EXPECT_THAT(message(good, {.radius_mm = 0.015}), HasSubstr("15 um does not fit"));
    paint::Recipe rough = good;
    rough.clearcoat.emplace();
    rough.clearcoat->thickness_um = 10;
    rough.clearcoat->roughness = 0.1;
    EXPECT_THAT(message(rough, {}), HasSubstr("clearcoat.roughness = 0.1"));
}

TEST(ShellWalk, StopsWhileFilmsAreComputed) {
    const std::vector<double> nm = spectra::default_wavelengths_nm();
    const Progress never = [](double) { return false; };
    EXPECT_THROW(ShellWalk(test::pearl(), {}, nm, never), Stopped);
}

}  // namespace
}  // namespace nacre::montecarlo
