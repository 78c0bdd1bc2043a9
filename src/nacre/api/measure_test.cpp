#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "nacre/api/paint_test_support.h"
#include "nacre/testing/errors.h"

namespace nacre {
namespace {

using test::message_of;
using test::samples;
using ::testing::HasSubstr;

TEST(Measuring, ReadsWhatTheInstrumentReads) {
    const Readings readings = Paint(fit::testing::pearl()).measure();
    EXPECT_EQ(readings.measurement, fit::testing::read(fit::testing::pearl()));
    // And from a file: measured colours, of which the readings asked for are picked.
    const Paint colours = open_text(readings.csv(), "pearl.csv");
    EXPECT_EQ(colours.kind(), Kind::measured_colours);
    EXPECT_EQ(colours.measure().measurement, readings.measurement);
    const Readings two =
        colours.measure(geometries("45as45,45as15"), {.illuminant = Illuminant::A});
    ASSERT_EQ(two.measurement.readings.size(), 2u);
    EXPECT_EQ(two.measurement.readings[0].geometry.name, "45as45");
    EXPECT_EQ(two.measurement.readings[0].lab,
              Paint(fit::testing::pearl())
                  .measure(geometries("45as45"), {.illuminant = Illuminant::A})
                  .measurement.readings[0]
                  .lab);
    EXPECT_THAT(message_of<InputError>([&] { colours.measure(geometries("15as15")); }),
                HasSubstr("pearl.csv: has no reading at 15as15"));
    EXPECT_THAT(message_of<InputError>([&] {
                    colours.measure({}, {.aperture = Aperture{1, 1}});
                }),
                HasSubstr("pearl.csv: was measured with half angles of 0 and 0 deg"));
    EXPECT_EQ(message_of<SettingError>([] { geometries("byk-mc"); }).substr(0, 48),
              "geometry = byk-mc: is no set (did you mean 'byk-");
    EXPECT_EQ(message_of<SettingError>([] { geometries("45as15,45as15"); }),
              "geometry = 45as15,45as15: 45as15 appears twice");
}

TEST(Measuring, WalksEstimateWhatTheSolverSays) {
    const Paint paint(fit::testing::pearl());
    const std::vector<Geometry> angles = geometries("45as25,45as75");
    const MeasureSettings walk{
        .model = WalkModel{}, .wavelengths_nm = {450, 550, 650}, .walks = 20000, .seed = 3};
    const Readings estimated = paint.measure(angles, walk);
    MeasureSettings settings;
    settings.wavelengths_nm = walk.wavelengths_nm;
    const Readings exact = paint.measure(angles, settings);
    ASSERT_EQ(estimated.standard_error.size(), 2u);
    EXPECT_TRUE(exact.standard_error.empty());
    for (std::size_t g = 0; g < 2; ++g) {
        for (std::size_t w = 0; w < 3; ++w) {
            const double error = estimated.standard_error[g][w];
            EXPECT_GT(error, 0);
            EXPECT_NEAR(estimated.measurement.readings[g].reflectance_factor[w],
                        exact.measurement.readings[g].reflectance_factor[w], 4.5 * error);
        }
    }
    MeasureSettings cones = walk;
    cones.aperture = Aperture{1, 1};
    EXPECT_THAT(message_of<SettingError>([&] { paint.measure(angles, cones); }),
                HasSubstr("aperture: the model walk reads with points only"));
    EXPECT_THROW(paint.measure(angles, walk, [](double) { return false; }), Error);
}

TEST(Reference, IsTheWalkThroughTheRecipe) {
    const Paint paint(fit::testing::pearl());
    const std::vector<Direction> lamps = {{45, 0}}, views = {{20, 180}, {70, 30}};
    const ReferenceSettings settings{{450, 650}, {.samples = 1000, .seed = 3}};
    const std::vector<Estimate> got = paint.reference(lamps, views, settings);
    const std::vector<Estimate> want = montecarlo::reference_brdf(
        paint.recipe(), lamps, views, settings.wavelengths_nm, settings.walks);
    ASSERT_EQ(got.size(), 4u);
    for (std::size_t i = 0; i < got.size(); ++i) {
        EXPECT_EQ(got[i].value, want[i].value);
        EXPECT_EQ(got[i].standard_error, want[i].standard_error);
    }
    EXPECT_EQ(paint.reference(lamps, views, {{}, {.samples = 2}}).size(), 2u * 31u);
}

TEST(Reference, SaysWhetherASettingIsWrongOrThePaint) {
    const Paint paint(fit::testing::pearl());
    const auto complaint = [&](const Paint& of, const Direction& lamp, const Direction& view,
                               const ReferenceSettings& settings) {
        return message_of<SettingError>(
            [&] { of.reference(std::vector{lamp}, std::vector{view}, settings); });
    };
    const ReferenceSettings few{{550}, {.samples = 2}};
    EXPECT_EQ(complaint(paint, {90, 0}, {20, 0}, few),
              "incident = 90: must be a number in [0, 90) deg");
    EXPECT_EQ(complaint(paint, {45, 0}, {-1, 0}, few),
              "outgoing = -1: must be a number in [0, 90) deg");
    EXPECT_THAT(complaint(paint, {45, 0}, {20, std::nan("")}, few),
                HasSubstr("outgoing = nan: must have a finite azimuth"));
    EXPECT_THAT(complaint(paint, {45, 0}, {20, 0}, {{-5}, {.samples = 2}}),
                HasSubstr("wavelength = -5: must be a number in "));
    EXPECT_THAT(complaint(paint, {45, 0}, {20, 0}, {{550}, {.samples = 1}}),
                HasSubstr("samples = 1: must be a number in [2, "));
    paint::Recipe facets = io::read_recipe(shipped_file("paints/tio2-mica-80.toml"));
    facets.layers.clear();
    const Paint none(facets);
    const std::vector<Direction> up = {{0, 0}};
    EXPECT_THAT(message_of<InputError>([&] { none.reference(up, up, few); }),
                HasSubstr("recipe: layer: is missing; light is followed"));
    EXPECT_THROW(paint.reference(up, up, few, [](double) { return false; }), Stopped);
}

TEST(Measuring, APaintIsReadAsTheColoursBesideItWere) {
    const Paint pearl(fit::testing::pearl());
    const Paint colours = open_text(
        pearl.measure(geometries("45as15,45as110"), {.illuminant = Illuminant::A}).csv(), "a.csv");
    const auto [sample, standard] = measure_alike(pearl, colours);
    EXPECT_EQ(sample.measurement.conditions, standard.measurement.conditions);
    EXPECT_EQ(sample.measurement.readings, standard.measurement.readings);
    const auto [first, second] = measure_alike(colours, pearl);
    EXPECT_EQ(first.measurement, standard.measurement);
    EXPECT_EQ(second.measurement, sample.measurement);
}

}  // namespace
}  // namespace nacre
