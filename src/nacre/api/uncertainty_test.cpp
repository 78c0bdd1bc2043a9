#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "nacre/nacre.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/fit.h"
#include "nacre/testing/paints.h"

namespace nacre {
namespace {

using test::message_of;
using ::testing::HasSubstr;

TEST(Uncertain, ReadingsAreThoseOfTheModelAndSpreadAsWide) {
    const Paint paint(fit::testing::pearl(90), {},
                      {{"layer[0].flakes[0].coats[0].thickness_nm", 0.5}});
    const std::vector<Geometry> angles = geometries("45as15,45as45");
    for (const Model& model : {Model(MicroflakeModel{}), Model(NacreModel{})}) {
        const MeasureSettings settings{.model = model, .illuminant = Illuminant::A};
        const Uncertainty u = paint.measure_uncertainty(angles, settings);
        const Measurement read = paint.measure(angles, settings).measurement;
        EXPECT_EQ(u.measurement.conditions, read.conditions);
        ASSERT_EQ(u.readings.size(), 2u);
        for (std::size_t i = 0; i < 2; ++i) {
            // A renderer's table of the hot spot is coarser than the values themselves.
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(u.measurement.readings[i].lab[c], read.readings[i].lab[c], 0.5);
            }
        }
        // Beside it, by hand: the difference of paints that are 1 nm apart.
        const auto at = [&](double nm) {
            return paint.with("coats[0].thickness_nm", nm)
                .measure(angles, settings)
                .measurement.readings[0]
                .lab;
        };
        const Vec3d change = at(90.5) - at(89.5);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(u.readings[0].change[0][c], change[c] / 2,
                        0.01 * std::abs(change[c]) + 0.01);
        }
    }
    // More numbers, by the ends of their keys, and one in the place of the recipe's own.
    const Uncertainty more = paint.measure_uncertainty(
        angles, {}, {{{"alpha", 0.01, true}, {"coats[0].thickness_nm", 0}}});
    ASSERT_EQ(more.numbers.size(), 2u);
    EXPECT_EQ(more.numbers[0].standard_deviation, 0);
    EXPECT_NEAR(more.numbers[1].standard_deviation, 0.0025, 1e-15);
    EXPECT_EQ(fit::variance_fractions(more.readings[0].change), (std::vector<double>{0, 1}));
}

TEST(Uncertain, ThinFilmsOfFacetsAreReadToo) {
    const Paint paint(test::violet());
    const auto read = [&](double deviation_nm) {
        return paint.measure_uncertainty(geometries("45as15"), {.model = ThinFilmModel{}},
                                         {{{"microfacet.film_thickness_nm", deviation_nm}}});
    };
    const Uncertainty u = read(1);
    EXPECT_GT(u.readings[0].first_order.lab()[2], 0.1);
    EXPECT_NEAR(read(0.5).readings[0].first_order.lab()[2], u.readings[0].first_order.lab()[2] / 2,
                1e-9);
}

TEST(Uncertain, SaysWhatItCannotDo) {
    const Paint paint(fit::testing::pearl());
    const auto message = [&](const MeasureSettings& settings, const UncertaintySettings& of) {
        return message_of<DomainError>([&] { paint.measure_uncertainty({}, settings, of); });
    };
    EXPECT_THAT(message({}, {}), HasSubstr("[uncertainty]"));
    EXPECT_THAT(message({.model = WalkModel{}}, {{{"alpha", 0.01}}}), HasSubstr("exact values"));
    EXPECT_THAT(message({}, {{{"alhpa", 0.01}}}), HasSubstr("is not a number of this recipe"));
    EXPECT_THROW(
        paint.measure_uncertainty({}, {}, {{{"alpha", 0.01}}}, [](double) { return false; }),
        Error);
    EXPECT_FALSE(has_uncertainty(VolumeModel{}));
    EXPECT_TRUE(has_uncertainty(SpecialEffectModel{}));
}

}  // namespace
}  // namespace nacre
