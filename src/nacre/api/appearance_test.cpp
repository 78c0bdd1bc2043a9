#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <thread>
#include <vector>

#include "nacre/api/paint_test_support.h"
#include "nacre/core/parallel.h"
#include "nacre/testing/errors.h"

namespace nacre {
namespace {

using test::message_of;
using test::samples;
using ::testing::HasSubstr;

TEST(Appearance, EveryKindIsShownAsWhatItIs) {
    int shown = 0;
    for (const auto& [name, kind, bytes] : samples()) {
        const Paint paint = open_text(bytes, name);
        if (kind == Kind::measured_colours) {
            EXPECT_THAT(message_of<InputError>([&] { paint.appearance(); }),
                        HasSubstr(name + ": holds measured colours"));
            continue;
        }
        ++shown;
        const PaintBrdf brdf = paint.brdf({.wavelengths_nm = {450, 550, 650}});
        const std::vector<double> values = brdf(0.6, 0.5, std::numbers::pi);
        ASSERT_EQ(values.size(), 3u);
        for (double value : values) EXPECT_TRUE(value >= 0 && std::isfinite(value)) << name;
        // A copy gives the same bits, in another thread too.
        std::vector<double> elsewhere;
        std::thread([&, copy = paint] {
            elsewhere = copy.brdf({.wavelengths_nm = {450, 550, 650}})(0.6, 0.5, std::numbers::pi);
        }).join();
        EXPECT_EQ(elsewhere, values) << name;
    }
    EXPECT_EQ(shown, 6);
}

TEST(Appearance, IsMadeOnceForAllWhoHoldIt) {
    const Paint paint(fit::testing::pearl());
    const auto look = paint.appearance(NacreModel{.specimen = 1});
    EXPECT_EQ(Paint(paint).appearance(NacreModel{.specimen = 1}), look);
    EXPECT_NE(paint.appearance(NacreModel{.specimen = 2}), look);
    EXPECT_NE(paint.appearance(), look);
}

TEST(Appearance, RefusesWhatDoesNotFit) {
    const Paint measured = open_text(samples()[4].bytes, "m.bsdf");
    EXPECT_THAT(message_of<InputError>([&] { measured.appearance(NacreModel{}); }),
                HasSubstr("m.bsdf: holds a measured BRDF, which is shown as it was measured"));
    EXPECT_THAT(message_of<SettingError>([&] { measured.brdf({.part = Part::single}); }),
                HasSubstr("part: m.bsdf holds a measured BRDF, which has no parts"));
    const Paint raw = open_text(samples()[2].bytes, "raw.h5");
    EXPECT_THAT(message_of<InputError>([&] { raw.appearance(NacreModel{}); }),
                HasSubstr("raw.h5: holds a table of a BRDF"));
    EXPECT_THAT(message_of<InputError>([&] { raw.appearance(ThinFilmModel{}); }),
                HasSubstr("raw.h5: holds a table of a BRDF; a recipe is needed here"));
    const MicroflakeModel svd{.table = MicroflakeModel::Table::svd};
    EXPECT_EQ(message_of<SettingError>([&] { raw.appearance(svd); }),
              "table = svd: raw.h5 holds a table of the kind raw");
    const Paint pearl = open_text(samples()[0].bytes, "pearl.toml");
    EXPECT_THAT(message_of<InputError>([&] { pearl.appearance(ThinFilmModel{}); }),
                HasSubstr("pearl.toml: microfacet: is missing"));
    EXPECT_EQ(message_of<SettingError>([&] { pearl.brdf({.model = WalkModel{}}); }),
              "model = walk: follows light and has no values to give");
    EXPECT_THAT(message_of<SettingError>([&] { pearl.brdf().on(0, 0, 1); }),
                HasSubstr("the surface is alike everywhere"));
}

TEST(Appearance, ValuesAreThoseOfTheSolutionOrAsRenderedWithinAPercent) {
    const Paint paint(fit::testing::pearl());
    const PaintBrdf exact = paint.brdf(), fast = paint.brdf({.as_rendered = true});
    const auto solved = paint.solved();
    EXPECT_EQ(exact.wavelengths_nm(), fast.wavelengths_nm());
    const std::vector<double> a = exact(0.5, 0.7, 2.5), b = fast(0.5, 0.7, 2.5);
    EXPECT_EQ(a, solved->brdf(0.5, 0.7, 2.5));
    EXPECT_NE(a, b);
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 0.01 * a[i]);
    const std::vector<double> single = paint.brdf({.part = Part::single})(0.5, 0.7, 2.5);
    EXPECT_EQ(single, solved->brdf(0.5, 0.7, 2.5, Part::single));
}

TEST(Appearance, PatchesShowTheirOwnFlakes) {
    const PaintBrdf mean =
        Paint(fit::testing::pearl()).brdf({.model = NacreModel{}, .wavelengths_nm = {550}});
    const auto at = [&](double x) { return mean.on(x, 0, 2)(0.3, 0.3, std::numbers::pi)[0]; };
    EXPECT_NE(at(0), at(5));
    EXPECT_EQ(at(5), at(5));
    EXPECT_THAT(message_of<SettingError>([&] { mean.on(0, 0, -1); }),
                HasSubstr("side = -1: must be a number in (0, 10000] mm"));
}

TEST(Appearance, ValuesAloneAreThoseOfTheWholeSurface) {
    // Smooth, rough and with flakes that lean.
    for (const auto& [name, tilt_deg] :
         {std::pair{"ruby", 0.0}, {"satin-silver", 0.0}, {"metallic-silver", 5.0}}) {
        paint::Recipe recipe = open(find_paint(name)).recipe();
        if (tilt_deg > 0) recipe.lean = paint::FlakeLean{tilt_deg, 0};
        const Paint paint(recipe);
        for (const Model& model : {Model(NacreModel{}), Model(NacreModel{.hot_spot = false})}) {
            const PaintBrdf alone = paint.brdf({.model = model});
            const auto look = paint.appearance(model);  // brdf() takes it as long as it is there
            const PaintBrdf whole = paint.brdf({.model = model});
            EXPECT_EQ(alone(0.8, 0.5, 3), whole(0.8, 0.5, 3)) << name;
            EXPECT_EQ(alone(0.8, 1.2, 0.1), whole(0.8, 1.2, 0.1)) << name;
            EXPECT_EQ(alone.on(1, 2, 0.5)(0.3, 0.3, 3), whole.on(1, 2, 0.5)(0.3, 0.3, 3)) << name;
            EXPECT_NE(alone.on(1, 2, 0.5)(0.3, 0.3, 3), alone(0.3, 0.3, 3)) << name;
        }
    }
}

TEST(Appearance, AnyNumberOfThreadsMayAskForTheFirstPatch) {
    const PaintBrdf brdf = open(find_paint("red-gold")).brdf({.model = NacreModel{}});
    std::vector<std::vector<double>> values(64);
    parallel_for(0, values.size(),
                 [&](std::size_t i) { values[i] = brdf.on(1, 2, 0.5)(0.3, 0.3, 3); });
    for (const auto& value : values) EXPECT_EQ(value, values[0]);
}

}  // namespace
}  // namespace nacre
