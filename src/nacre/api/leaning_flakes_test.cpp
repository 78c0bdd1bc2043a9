#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "nacre/core/math.h"
#include "nacre/nacre.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/fit.h"

// Paints whose flakes lean: what is told of them, and who refuses them.

namespace nacre {
namespace {

using test::message_of;
using ::testing::AllOf;
using ::testing::HasSubstr;

paint::Recipe leaning(double tilt_deg, double azimuth_deg = 0) {
    paint::Recipe recipe = fit::testing::pearl();
    recipe.lean = paint::FlakeLean{tilt_deg, azimuth_deg};
    return recipe;
}

const BrdfSettings kOne{.wavelengths_nm = {{550}}};

TEST(LeaningPaint, WithoutATiltIsThePaintToTheLastBit) {
    const PaintBrdf flat = Paint(fit::testing::pearl()).brdf(kOne);
    const PaintBrdf upright = Paint(leaning(0, 70)).brdf(kOne);
    const PaintBrdf tilted = Paint(leaning(0.01, 70)).brdf(kOne);
    for (const double theta : {0.1, 0.7, 1.2}) {
        for (const double phi : {0.0, 1.0, 3.1}) {
            const double f = flat(0.6, theta, phi)[0];
            EXPECT_EQ(upright(0.6, theta, phi)[0], f);
            EXPECT_NEAR(tilted(0.6, theta, phi)[0], f, 0.02 * f);
        }
    }
}

TEST(LeaningPaint, IsReadTowardsAndAwayFromTheLamp) {
    const auto luminances = [](const paint::Recipe& recipe) {
        std::vector<double> y;
        for (const auto& reading :
             Paint(recipe).measure(geometries("45as-15,45as15,45as75")).measurement.readings) {
            y.push_back(reading.lab[0]);
        }
        return y;
    };
    const auto flat = luminances(fit::testing::pearl());
    const auto towards = luminances(leaning(4)), away = luminances(leaning(4, 180));
    const auto across = luminances(leaning(4, 90)), other = luminances(leaning(4, -90));
    ASSERT_EQ(flat.size(), 3u);
    // The lobe moves to the side of the lamp, or beyond the mirror direction.
    EXPECT_LT(towards[0], flat[0] - 1);
    EXPECT_GT(away[0], flat[0] + 1);
    for (const int k : {1, 2}) {
        EXPECT_GT(towards[k], flat[k] + 1) << k;
        EXPECT_LT(away[k], flat[k] - 1) << k;
    }
    // To the left or to the right is the same in the plane of lamp and eye.
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(across[k], other[k], 2e-3) << k;
}

TEST(LeaningPaint, IsRefusedByNameWhereAllAzimuthsAreOne) {
    const Paint paint(leaning(5));
    const auto read = paint.measure(geometries("45as15,45as45"));
    std::optional<Paint> rough;
    {
        paint::Recipe recipe = leaning(5);
        recipe.clearcoat = paint::Clearcoat{40, 0.0, 0.2};
        rough.emplace(recipe);
    }
    BrdfSettings table = kOne, parts = kOne;
    table.model = MicroflakeModel{.table = bsdf::MicroflakeModel::Table::raw};
    table.wavelengths_nm = {};
    parts.part = Part::single;
    const std::vector<std::pair<const char*, std::function<void()>>> calls = {
        {"files", [&] { paint.export_rgl(); }},
        {"files", [&] { paint.export_merl(); }},
        {"files", [&] { paint.export_material(MaterialFormat::gltf); }},
        {"fits", [&] { paint.fit(read.measurement, {"coats[0].thickness_nm"}); }},
        {"uncertainties",
         [&] {
             paint.measure_uncertainty(geometries("45as15"), {}, {{{"alpha", 0.01}}});
         }},
        {"table = raw", [&] { paint.brdf(table); }},
        {"shell", [&] { paint.appearance(VolumeModel{}); }},
        {"clearcoat.roughness = 0.2", [&] { rough->appearance(MicroflakeModel{}); }},
        {"clearcoat.roughness = 0.2", [&] { rough->appearance(NacreModel{}); }},
    };
    for (const auto& [who, call] : calls) {
        EXPECT_THAT(message_of<Error>(call),
                    AllOf(HasSubstr("lean.tilt_deg = 5"), HasSubstr(who), HasSubstr("must be 0")));
    }
    EXPECT_THAT(message_of<Error>([&] { paint.brdf(parts)(0.5, 0.5, 0); }), HasSubstr("lean"));
}

}  // namespace
}  // namespace nacre
