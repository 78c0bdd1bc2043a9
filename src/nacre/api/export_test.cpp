#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "nacre/api/paint_test_support.h"
#include "nacre/testing/errors.h"

namespace nacre {
namespace {

using test::kThree;
using test::message_of;
using ::testing::HasSubstr;

TEST(Export, AShaderShowsTheModelThatWasChosenOrThatOfPictures) {
    const Paint paint(fit::testing::pearl());
    const ShaderMaterial usual = paint.export_threejs(),
                         smooth = paint.export_threejs(MicroflakeModel{});
    EXPECT_EQ(usual.model, "nacre");
    EXPECT_EQ(usual.standard, "nacre");
    EXPECT_EQ(smooth.model, "microflake");
    EXPECT_EQ(smooth.standard, "nacre");
    EXPECT_THAT(usual.bytes, HasSubstr("the paint by the model nacre, in CIEDE2000"));
    EXPECT_THAT(message_of<SettingError>([&] { paint.export_threejs(ThinFilmModel{}); }),
                HasSubstr("must be nacre, or microflake without tables"));
}

TEST(Export, AFittedMaterialSaysWhatItMisses) {
    const test::TempFolder folder;
    const Paint paint(fit::testing::pearl());
    const FittedMaterial made =
        paint.export_material(MaterialFormat::gltf, {.wavelengths_nm = {450, 550, 650}});
    made.write(folder / "pearl.gltf");
    EXPECT_THAT(made.bytes, HasSubstr("KHR_materials_clearcoat"));
    EXPECT_EQ(made.fit.instrument.angles.size(), exchange::kBykMacAngles);
    // The differences are those from what an instrument reads on the paint.
    const Measurement read =
        paint
            .measure(exchange::fit_geometries().tested,
                     {.observer = Observer::cie1931_2deg, .wavelengths_nm = {450, 550, 650}})
            .measurement;
    for (std::size_t i = 0; i < read.readings.size(); ++i) {
        EXPECT_EQ(made.fit.tested.angles[i].lab_standard, read.readings[i].lab);
    }
    const Paint colours = open_text(paint.measure(geometries("45as15")).csv(), "a.csv");
    EXPECT_THAT(message_of<InputError>([&] { colours.export_material(MaterialFormat::materialx); }),
                HasSubstr("a.csv: holds measured colours; a material is fitted to a recipe"));
}

TEST(Export, AnExportedBrdfGivesThePaintBack) {
    const test::TempFolder folder;
    const Paint paint(fit::testing::pearl());
    const RglSettings small{.resolution = 24, .incident = 16};
    const Exported rgl = paint.export_rgl(small, {.wavelengths_nm = {450, 550, 650}});
    EXPECT_LT(rgl.error.flux, 0.05);
    rgl.write(folder / "pearl.bsdf");
    const Paint measured = open(folder / "pearl.bsdf");
    EXPECT_EQ(measured.kind(), Kind::measured_brdf);
    const std::vector<double> before = paint.brdf({.wavelengths_nm = {550}})(0.7, 0.5, 3),
                              after = measured.brdf({.wavelengths_nm = {550}})(0.7, 0.5, 3);
    EXPECT_NEAR(after[0], before[0], 0.05 * before[0]);
    EXPECT_EQ(open_text(paint.export_merl({8, 8, 16}).bytes, "x").kind(), Kind::measured_brdf);
    EXPECT_EQ(*open_text(paint.export_solved(kThree), "x").solved(), *paint.solved(kThree));
    const MicroflakeModel raw{.table = MicroflakeModel::Table::raw, .table_size = {8, 8}};
    EXPECT_EQ(open_text(paint.export_table(raw, kThree), "x").kind(), Kind::brdf_table);
    EXPECT_THROW(paint.export_table(MicroflakeModel{}, kThree), SettingError);
    // As another process would open them, whose contents are the same again.
    for (const std::string& bytes :
         {paint.contents().bytes, paint.export_solved(kThree), paint.export_table(raw, kThree),
          paint.export_merl({8, 8, 16}).bytes, paint.measure(geometries("45as15")).csv()}) {
        const Paint there = open_text(open_text(bytes, "x").contents().bytes, "x");
        EXPECT_EQ(there.kind(), open_text(bytes, "x").kind());
        EXPECT_EQ(there.contents().bytes, open_text(bytes, "x").contents().bytes);
    }
    const Paint brushed(
        open_text(read_file(shipped_file("fuzz/corpus/rgl/anisotropic_rgb.bsdf")), "brushed.bsdf"));
    EXPECT_THAT(message_of<InputError>([&] { brushed.export_rgl(small); }),
                HasSubstr("brushed.bsdf: holds an anisotropic BRDF"));
    EXPECT_THROW(paint.export_rgl(small, {}, [](double) { return false; }), Error);
}

}  // namespace
}  // namespace nacre
