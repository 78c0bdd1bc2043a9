#include "nacre/nacre.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <thread>

#include "nacre/core/file.h"
#include "nacre/core/parallel.h"
#include "nacre/io/recipe_file.h"
#include "nacre/io/solved_paint_file.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/files.h"
#include "nacre/testing/fit.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;
using test::message_of;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// Flakes of so wide an orientation that they are solved in an instant.
std::string pearl_toml() { return io::write_recipe(fit::testing::pearl()); }
const SolveSettings kThree{{450, 550, 650}};

/// One file of each kind, or two.
struct Sample {
    std::string name;
    Kind kind;
    std::string bytes;
};
const std::vector<Sample>& samples() {
    static const std::vector<Sample> all = [] {
        std::vector<Sample> samples = {
            {"pearl.toml", Kind::recipe, pearl_toml()},
            {"pearl.h5", Kind::solved_paint,
             io::solved_paint_bytes(*Paint(fit::testing::pearl()).solved(kThree))}};
        const std::vector<std::pair<std::string, Kind>> files = {
            {"brdf_table/raw.h5", Kind::brdf_table},
            {"brdf_table/svd.h5", Kind::brdf_table},
            {"rgl/isotropic_spectral.bsdf", Kind::measured_brdf},
            {"merl/small.binary", Kind::measured_brdf},
            {"measurement/pearl.csv", Kind::measured_colours},
            {"measurement/pearl.json", Kind::measured_colours}};
        for (const auto& [name, kind] : files) {
            samples.push_back({fs::path(name).filename().string(), kind,
                               read_file(shipped_file("fuzz/corpus/" + name))});
        }
        return samples;
    }();
    return all;
}

class Files : public ::testing::Test {
 protected:
    fs::path write(const std::string& name, const std::string& text) const {
        return folder_.write(name, text);
    }

    test::TempFolder folder_;
};

TEST_F(Files, EveryKindIsToldByItsContents) {
    for (const auto& [name, kind, bytes] : samples()) {
        const Paint paint = open(write(name, bytes));
        EXPECT_EQ(paint.kind(), kind) << name;
        EXPECT_EQ(paint.file(), (folder_ / name).string());
        EXPECT_EQ(paint.name(), fs::path(name).stem());
        EXPECT_EQ(paint.has_recipe(), kind == Kind::recipe || kind == Kind::solved_paint);
        EXPECT_EQ(paint.recipe_sha256().empty(), !paint.has_recipe()) << name;
        EXPECT_EQ(open_text(bytes, "no name tells").kind(), kind) << name;
    }
    EXPECT_EQ(open(shipped_file("paints/tio2-mica-80.toml")).name(), "TiO2 on mica, 80 nm (gold)");
}

TEST_F(Files, GarbageIsRefusedByName) {
    const std::vector<std::pair<std::string, std::string>> garbage = {
        {"empty.toml", ""},
        {"noise.bin", std::string("\x01\x02\xff\x00zz", 6)},
        {"text.txt", "To be or not to be"},
        {"cut.h5", samples()[1].bytes.substr(0, 5000)},
        {"cut_table.h5", read_file(shipped_file("fuzz/corpus/brdf_table/raw.h5")).substr(0, 5000)},
        {"cut.bsdf", read_file(shipped_file("fuzz/corpus/rgl/isotropic_rgb.bsdf")).substr(0, 100)},
        {"cut.binary", read_file(shipped_file("fuzz/corpus/merl/cut.binary"))},
        {"no_angle.csv", "geometry,L,a,b\nsomewhere,1,2,3\n"},
        {"half.json", "{\"readings\": ["}};
    for (const auto& [name, bytes] : garbage) {
        const fs::path path = write(name, bytes);
        EXPECT_THAT(message_of<InputError>([&] { open(path); }), HasSubstr(path.string())) << name;
    }
    EXPECT_THAT(message_of<InputError>([&] { open(folder_); }), HasSubstr(folder_.path().string()));
    const fs::path missing = folder_ / "missing.toml";
    EXPECT_THAT(message_of<InputError>([&] { open(missing); }), HasSubstr(missing.string()));
}

TEST_F(Files, ErrorsNameFileKeyValueAndRange) {
    const fs::path path = write("thin.toml", "ior = 1.5\n[[layer]]\nthickness_um = -3\n");
    EXPECT_THAT(message_of<InputError>([&] { open(path); }),
                AllOf(HasSubstr(path.string()), HasSubstr("layer[0].thickness_um"), HasSubstr("-3"),
                      HasSubstr("(0, 1000000] um")));
    const Paint paint = open_text(pearl_toml(), "pearl.toml");
    EXPECT_THAT(message_of<DomainError>([&] { paint.with("beckmann", 1); }), HasSubstr("beckmann"));
    EXPECT_THAT(message_of<DomainError>([&] { paint.with("orientation.alpha", 7); }),
                AllOf(HasSubstr("orientation.alpha"), HasSubstr("7"), HasSubstr("[0.005, 1]")));
    const Paint gold = open(shipped_file("paints/tio2-mica-80.toml"));
    EXPECT_THAT(message_of<InputError>([&] { gold.solved({{5}}); }),
                AllOf(HasSubstr(gold.file()), HasSubstr("TiO2_anatase"), HasSubstr("5 nm")));
    const Paint solved = open_text(samples()[1].bytes, "solved.h5");
    EXPECT_THAT(message_of<InputError>([&] { solved.solved({{333}}); }),
                HasSubstr("solved.h5: has been solved at 3 wavelengths from 450 to 650 nm, 333"));
    SolveSettings odd = kThree;
    odd.resolution.exit_nodes = 13;
    EXPECT_THAT(message_of<InputError>([&] { paint.solved(odd); }),
                AllOf(HasSubstr("exit_nodes"), HasSubstr("13")));
}

TEST(Open, SaysWhatAFileHoldsWhereARecipeIsNeeded) {
    const std::map<Kind, std::string> words = {{Kind::brdf_table, "holds a table of a BRDF"},
                                               {Kind::measured_brdf, "holds a measured BRDF"},
                                               {Kind::measured_colours, "holds measured colours"}};
    int refused = 0;
    for (const auto& [name, kind, bytes] : samples()) {
        const Paint paint = open_text(bytes, name);
        if (paint.has_recipe()) continue;
        ++refused;
        for (const auto& ask :
             {+[](const Paint& p) { p.recipe(); }, +[](const Paint& p) { p.solved(); },
              +[](const Paint& p) { p.with("alpha", 0.1); },
              +[](const Paint& p) { p.fit(Measurement{}, {"alpha"}); }}) {
            EXPECT_THAT(message_of<InputError>([&] { ask(paint); }),
                        AllOf(HasSubstr(name), HasSubstr(words.at(kind)),
                              HasSubstr("a recipe is needed here")));
        }
    }
    EXPECT_EQ(refused, 6);
}

TEST_F(Files, AFileIsReadOnce) {
    for (const auto& [name, kind, bytes] : samples()) {
        const fs::path path = write(name, bytes);
        const Paint paint = open(path);
        fs::remove(path);
        EXPECT_EQ(paint.kind(), kind);
        if (kind == Kind::measured_colours) {
            EXPECT_FALSE(paint.measure().measurement.readings.empty()) << name;
        } else {
            EXPECT_NE(paint.appearance(), nullptr) << name;
        }
    }
}

TEST(Solving, HappensOnceForAllCopiesAndOnlyWhenAsked) {
    const Paint paint = open_text(pearl_toml(), "pearl.toml");
    const Paint copy = paint;
    const auto solved = paint.solved(kThree);
    EXPECT_EQ(copy.solved(kThree), solved);
    EXPECT_EQ(Paint(copy).solved({{650, 450, 550, 450}}), solved);  // the same wavelengths
    EXPECT_NE(paint.solved({{450, 550}}), solved);
    EXPECT_EQ(paint.solved(kThree), solved);
    EXPECT_EQ(paint.solved()->wavelengths_nm().size(), 31u);
    // Another paint, even of the same recipe, has its own.
    EXPECT_NE(open_text(pearl_toml(), "pearl.toml").solved(kThree), solved);
}

TEST(Solving, AChangedNumberIsSolvedAnew) {
    const Paint thin(fit::testing::pearl(80));
    const Paint thick = thin.with("coats[0].thickness_nm", 120);
    EXPECT_EQ(thick.recipe(), fit::testing::pearl(120));
    EXPECT_EQ(thin.recipe(), fit::testing::pearl(80));
    EXPECT_EQ(*thick.solved(kThree), *Paint(fit::testing::pearl(120)).solved(kThree));
    EXPECT_FALSE(*thick.solved(kThree) == *thin.solved(kThree));
}

TEST(Solving, ASolvedPaintIsTakenAsItIs) {
    const Paint paint = open_text(samples()[1].bytes, "pearl.h5");
    const auto solved = paint.solved();
    EXPECT_EQ(*solved, *Paint(fit::testing::pearl()).solved(kThree));
    EXPECT_EQ(paint.solved({{}, {.exit_nodes = 32}}), solved);
    EXPECT_EQ(paint.solved({{550}}), solved);
}

TEST(Solving, AnyNumberOfThreadsGetTheSameOne) {
    const Paint paint(fit::testing::pearl());
    std::vector<std::shared_ptr<const solver::SolvedPaint>> seen(8);
    std::vector<std::thread> threads;
    for (auto& mine : seen) {
        threads.emplace_back([&mine, copy = paint] { mine = copy.solved(kThree); });
    }
    for (std::thread& thread : threads) thread.join();
    for (const auto& one : seen) EXPECT_EQ(one, seen[0]);
    // A thread that solves waits for its own work only: it must not begin another piece of the
    // caller's loop meanwhile, which would wait for the same solution and so for itself.
    const Paint again(fit::testing::pearl());
    parallel_for(0, 64, [&](std::size_t) { again.solved(kThree); });
    EXPECT_EQ(*again.solved(kThree), *seen[0]);
}

TEST(Solving, FailureIsReportedToEveryoneWhoAsks) {
    const Paint paint = open_text(
        "ior = 1.5\n[microfacet]\nalpha = 0.1\nfilm_ior = 1.8\n"
        "film_thickness_nm = 150\nbase_ior = 1.1\nbase_extinction = 0.5\n",
        "facets.toml");
    for (int i = 0; i < 2; ++i) {
        EXPECT_THAT(message_of<InputError>([&] { paint.solved(); }),
                    HasSubstr("facets.toml: layer: is missing"));
    }
    EXPECT_TRUE(paint.warnings().empty());
}

TEST(Solving, WarnsOfWhatItCouldNotResolve) {
    paint::Recipe sharp = fit::testing::pearl();
    sharp.layers[0].flakes[0].orientation.beckmann_alpha = 0.02;
    const Paint paint(sharp);
    EXPECT_TRUE(paint.warnings().empty());
    SolveSettings coarse = kThree;
    coarse.resolution = {.exit_nodes = 12, .inner_nodes = 8, .max_orders = 3};
    paint.solved(coarse);
    const std::vector<SolverWarning> warnings = paint.warnings();
    ASSERT_EQ(warnings.size(), 2u);
    EXPECT_EQ(warnings[0].what, SolverWarning::What::scattering);
    EXPECT_EQ(warnings[1].what, SolverWarning::What::azimuthal_series);
    for (const SolverWarning& warning : warnings) EXPECT_TRUE(warning.held_back);
    EXPECT_THAT(warnings[0].message, HasSubstr("recipe: 12 + 8 nodes miss"));
}

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

TEST(Appearance, AShaderShowsTheModelThatWasChosenOrThatOfPictures) {
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

TEST_F(Files, AFittedMaterialSaysWhatItMisses) {
    const Paint paint(fit::testing::pearl());
    const FittedMaterial made =
        paint.export_material(MaterialFormat::gltf, {.wavelengths_nm = {450, 550, 650}});
    made.write(folder_ / "pearl.gltf");
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

TEST_F(Files, AnExportedBrdfGivesThePaintBack) {
    const Paint paint(fit::testing::pearl());
    const RglSettings small{.resolution = 24, .incident = 16};
    const Exported rgl = paint.export_rgl(small, {.wavelengths_nm = {450, 550, 650}});
    EXPECT_LT(rgl.error.flux, 0.05);
    rgl.write(folder_ / "pearl.bsdf");
    const Paint measured = open(folder_ / "pearl.bsdf");
    EXPECT_EQ(measured.kind(), Kind::measured_brdf);
    const std::vector<double> before = paint.brdf({.wavelengths_nm = {550}})(0.7, 0.5, 3),
                              after = measured.brdf({.wavelengths_nm = {550}})(0.7, 0.5, 3);
    EXPECT_NEAR(after[0], before[0], 0.05 * before[0]);
    EXPECT_EQ(open_text(paint.export_merl({8, 8, 16}).bytes, "x").kind(), Kind::measured_brdf);
    EXPECT_EQ(*open_text(paint.export_solved(kThree), "x").solved(), *paint.solved(kThree));
    const MicroflakeModel raw{.table = MicroflakeModel::Table::raw, .table_size = {8, 8}};
    EXPECT_EQ(open_text(paint.export_table(raw, kThree), "x").kind(), Kind::brdf_table);
    EXPECT_THROW(paint.export_table(MicroflakeModel{}, kThree), SettingError);
    const Paint brushed(
        open_text(read_file(shipped_file("fuzz/corpus/rgl/anisotropic_rgb.bsdf")), "brushed.bsdf"));
    EXPECT_THAT(message_of<InputError>([&] { brushed.export_rgl(small); }),
                HasSubstr("brushed.bsdf: holds an anisotropic BRDF"));
    EXPECT_THROW(paint.export_rgl(small, {}, [](double) { return false; }), Error);
}

TEST(Fit, FindsThePaintThatTheStandardWasMeasuredOn) {
    const Measurement standard = fit::testing::read(fit::testing::pearl(110));
    const Paint start(fit::testing::pearl(90),
                      {{"layer[0].flakes[0].coats[0].thickness_nm", 60, 160}});
    FitSettings settings;
    settings.starts = 1;
    const Match match = start.fit(standard, {}, settings);
    ASSERT_EQ(match.parameters.size(), 1u);
    EXPECT_NEAR(match.parameters[0].value, 110, 0.1);
    EXPECT_EQ(match.paint.recipe(), match.recipe);
    EXPECT_EQ(match.paint.bounds(), start.bounds());
    EXPECT_EQ(start.free_keys({"*thickness_nm"}).keys.size(), 2u);
    EXPECT_THAT(message_of<SettingError>([] { Paint(fit::testing::pearl()).free_keys({}); }),
                HasSubstr("[fit]"));
}

TEST(Fit, StopsWhenAskedTo) {
    const Measurement standard = fit::testing::read(fit::testing::pearl(110));
    EXPECT_THROW(Paint(fit::testing::pearl())
                     .fit(standard, {"coats[0].thickness_nm"}, {}, [](double) { return false; }),
                 Stopped);
}

TEST(Fit, SeesTheHotSpotOfTheModelThatHasOne) {
    EXPECT_TRUE(Model(NacreModel{.specimen = 2}).shows_hot_spot());
    EXPECT_FALSE(Model(NacreModel{.hot_spot = false}).shows_hot_spot());
    EXPECT_FALSE(Model(MicroflakeModel{}).shows_hot_spot());
}

TEST(Fit, RefusesAModelThatHasNoPartInIt) {
    const Paint pearl(fit::testing::pearl());
    const Paint colours = open_text(pearl.measure(geometries("45as15")).csv(), "a.csv");
    EXPECT_EQ(message_of<SettingError>([&] { require_part_in_fit(WalkModel{}, colours); }),
              "model = walk: a.csv is measured, and the paint that is sought is seen by nacre or "
              "microflake");
    require_part_in_fit(NacreModel{}, colours);
    require_part_in_fit(MicroflakeModel{}, colours);
    require_part_in_fit(WalkModel{}, pearl);  // sees the standard
}

}  // namespace
}  // namespace nacre
