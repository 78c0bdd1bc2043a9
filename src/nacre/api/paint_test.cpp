#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "nacre/api/paint_test_support.h"
#include "nacre/core/parallel.h"
#include "nacre/testing/errors.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;
using test::kThree;
using test::message_of;
using test::pearl_toml;
using test::samples;
using ::testing::AllOf;
using ::testing::HasSubstr;

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

}  // namespace
}  // namespace nacre
