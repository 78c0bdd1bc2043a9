#include "nacre/io/solved_paint_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/sha256.h"
#include "nacre/io/hdf5_file.h"
#include "nacre/io/recipe_file.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/files.h"

namespace nacre::io {
namespace {

using nacre::test::message_of;
using ::testing::HasSubstr;

/// Silver flakes over white at three wavelengths: quick to solve, with every kind of data.
const solver::SolvedPaint& silver() {
    static const solver::SolvedPaint paint = solver::solve(parse_recipe(R"(
name = "silver"
ior = 1.5
[[layer]]
thickness_um = 10
[[layer.flakes]]
area_density_per_um = 0.05
orientation = { distribution = "beckmann", alpha = 0.3 }
reflectance = { wavelengths_nm = [400, 700], values = [0.5, 0.9] }
[substrate]
reflectance = 0.5
)",
                                                                        "silver.toml", ""),
                                                           {450, 550, 650});
    return paint;
}

/// The same under a rough interface, whose single scattering is a tensor too.
const solver::SolvedPaint& satin() {
    static const solver::SolvedPaint paint = [] {
        paint::Recipe recipe = silver().recipe;
        recipe.clearcoat = paint::Clearcoat{40, 0.0, 0.3};
        return solver::solve(recipe, {450, 550, 650});
    }();
    return paint;
}

std::string refused_paint(const std::string& bytes) {
    return message_of<InputError>([&] { parse_solved_paint(bytes, "paint.h5"); });
}

/// The bytes with a new head that fits them, as of a file that was edited on purpose.
std::string resealed(const std::string& bytes) {
    const std::string body = bytes.substr(512);
    std::string head = "nacre solved paint\nversion 2\nbytes " + std::to_string(body.size()) +
                       "\nsha256 " + sha256_hex(body) + "\n";
    head.resize(512, '\0');
    return head + body;
}

TEST(SolvedPaintFile, GivesBackTheSamePaint) {
    const std::string bytes = solved_paint_bytes(silver());
    EXPECT_EQ(parse_solved_paint(bytes, "paint.h5"), silver());
    EXPECT_EQ(solved_paint_bytes(silver()), bytes);  // nothing in it depends on the time
    EXPECT_EQ(refused_paint(resealed(bytes)), "accepted");
}

TEST(SolvedPaintFile, GivesBackTheSingleScatteringUnderARoughInterface) {
    ASSERT_GT(satin().rough_single.rank(), 0);
    const solver::SolvedPaint read = parse_solved_paint(solved_paint_bytes(satin()), "paint.h5");
    EXPECT_EQ(read, satin());
    for (const auto part : {Part::single, Part::multiple, Part::total}) {
        for (const double theta_o : {0.0, 0.4, 1.5}) {
            const std::vector<double> before = satin().brdf(0.7, theta_o, 2.5, part);
            EXPECT_EQ(read.brdf(0.7, theta_o, 2.5, part), before);
            EXPECT_GT(before[0], 0);
        }
    }
}

TEST(SolvedPaintFile, GoesThroughTheDisk) {
    const nacre::test::TempFolder folder;
    const std::filesystem::path path = folder / "paint.h5";
    write_solved_paint(path, silver());
    EXPECT_EQ(read_solved_paint(path), silver());
    std::filesystem::remove(path);
    EXPECT_THROW(read_solved_paint(path), InputError);
}

/// Glass flakes, their material taken from a user's file in a folder of its own.
class SolvedPaintOfAUsersMaterial : public ::testing::Test {
 protected:
    void write_material(const std::string& rows) const {
        folder_.write("glass.csv", "wavelength_nm,n,k\n" + rows);
    }
    solver::SolvedPaint solved() const {
        return solver::solve(parse_recipe(R"(
ior = 1.5
[[layer]]
thickness_um = 10
[[layer.flakes]]
area_density_per_um = 0.05
orientation = { distribution = "beckmann", alpha = 0.3 }
core = { material = "glass.csv", thickness_nm = 400 }
)",
                                          "glass.toml", folder_),
                             {450, 650});
    }

    nacre::test::TempFolder folder_;
};

TEST_F(SolvedPaintOfAUsersMaterial, NeedsItsFileNoMore) {
    write_material("400,1.9,0.01\n700,1.7,0\n");
    const solver::SolvedPaint paint = solved();
    const std::string bytes = solved_paint_bytes(paint);
    write_material("400,1.1,0\n700,1.1,0\n");  // another file of that name
    EXPECT_EQ(parse_solved_paint(bytes, "paint.h5"), paint);
    std::filesystem::remove_all(folder_.path());
    EXPECT_EQ(parse_solved_paint(bytes, "elsewhere/paint.h5"), paint);
}

TEST_F(SolvedPaintOfAUsersMaterial, IsNotWrittenIfItCouldNotBeReadBack) {
    std::string rows;
    for (int i = 0; i <= 10'000; ++i) rows += std::to_string(400 + 0.03 * i) + ",1.9,0\n";
    write_material(rows);
    const std::string message = message_of<Error>([&] { solved_paint_bytes(solved()); });
    EXPECT_THAT(message, HasSubstr("a solved file cannot keep this paint: recipe:"));
    EXPECT_THAT(message, HasSubstr("1 to 10000 numbers"));
}

TEST(SolvedPaintFile, IsRefusedWhereverItIsCut) {
    const std::string bytes = solved_paint_bytes(silver());
    int cuts = 0;
    for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 20, ++cuts) {
        EXPECT_THAT(refused_paint(bytes.substr(0, size)), HasSubstr("paint.h5: ")) << size;
    }
    EXPECT_GT(cuts, 50);
    EXPECT_THAT(refused_paint(bytes + "x"), HasSubstr("cut short or altered"));
}

TEST(SolvedPaintFile, IsRefusedWhicheverBitFlips) {
    const std::string bytes = solved_paint_bytes(silver());
    const std::size_t remark = bytes.find("The rest is HDF5");
    ASSERT_LT(remark, 200u);
    int flips = 0;
    for (std::size_t at = 0; at < bytes.size(); at += 1 + at / 10) {
        // A remark ends the head, and is not read.
        if (at >= remark && at < 512) continue;
        std::string damaged = bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ 4);
        EXPECT_THAT(refused_paint(damaged), HasSubstr("paint.h5: ")) << at;
        ++flips;
    }
    EXPECT_GT(flips, 40);
}

TEST(SolvedPaintFile, ForeignFilesAndNewerVersionsAreNamedAsSuch) {
    EXPECT_THAT(refused_paint(""), HasSubstr("is not a solved paint of Nacre"));
    EXPECT_THAT(refused_paint("\x89HDF\r\n\x1a\n"), HasSubstr("is not a solved paint of Nacre"));
    std::string newer = solved_paint_bytes(silver());
    newer.replace(newer.find("version 2"), 9, "version 3");
    EXPECT_THAT(refused_paint(newer), HasSubstr("has format version 3; this program reads 2"));
    std::string no_hdf5 = solved_paint_bytes(silver());
    no_hdf5.replace(512, 4, "none");
    EXPECT_THAT(refused_paint(resealed(no_hdf5)), HasSubstr("cannot open it as an HDF5 file"));
}

TEST(SolvedPaintFile, ContentsThatCannotBeAreRefusedEvenUnderAValidChecksum) {
    solver::SolvedPaint paint = silver();
    ASSERT_FALSE(paint.multiple_scattering.coefficient.empty());
    paint.multiple_scattering.coefficient[0] = NAN;
    EXPECT_THAT(refused_paint(solved_paint_bytes(paint)), HasSubstr("a coefficient is not finite"));

    paint = silver();
    paint.multiple_scattering.exit_angle[0] = 2;
    EXPECT_THAT(refused_paint(solved_paint_bytes(paint)), HasSubstr("exit angles must increase"));

    paint = silver();
    paint.multiple_scattering.first[0] = -1;
    EXPECT_THAT(refused_paint(solved_paint_bytes(paint)),
                HasSubstr("a first node is out of range"));

    paint = silver();
    paint.multiple_scattering.coefficient.resize(
        paint.multiple_scattering.coefficient.size() -
        static_cast<std::size_t>(paint.multiple_scattering.rank()));
    EXPECT_THAT(refused_paint(solved_paint_bytes(paint)), HasSubstr("do not fit together"));

    paint = silver();
    std::swap(paint.medium.wavelengths_nm[0], paint.medium.wavelengths_nm[1]);
    EXPECT_THAT(refused_paint(solved_paint_bytes(paint)), HasSubstr("wavelengths must increase"));

    paint = silver();
    paint.multiple_scattering.lobe_width = 1e3;
    EXPECT_THAT(refused_paint(solved_paint_bytes(paint)),
                HasSubstr("the width of the lobe is out of range"));

    paint = silver();
    ++(paint.multiple_scattering.table_rank = paint.multiple_scattering.rank());
    EXPECT_THAT(refused_paint(solved_paint_bytes(paint)),
                HasSubstr("the rank of tables is out of range"));

    std::string bytes = solved_paint_bytes(silver());
    const std::string thickness = "thickness_um = 10";
    ASSERT_NE(bytes.find(thickness), std::string::npos);
    bytes.replace(bytes.find(thickness), thickness.size(), "thickness_um = -1");
    EXPECT_THAT(refused_paint(resealed(bytes)),
                HasSubstr("paint.h5/recipe:5:16: layer[0].thickness_um = -1"));
}

TEST(SolvedPaintFile, FilesFromBeforeThereWereLobesAreReadAsTheyWere) {
    solver::MultipleScattering expected = silver().multiple_scattering;
    EXPECT_GT(expected.lobe_width, 0);
    expected.lobe_width = 0;
    expected.table_rank = expected.rank();
    // Under other names the attributes are not there.
    std::string bytes = solved_paint_bytes(silver());
    for (const std::string name : {"lobe_width", "table_rank"}) {
        ASSERT_NE(bytes.find(name + '\0'), std::string::npos);
        bytes[bytes.find(name + '\0')] = '_';
    }
    EXPECT_EQ(parse_solved_paint(resealed(bytes), "paint.h5").multiple_scattering, expected);
}

TEST(SolvedPaintFile, TensorsThatDoNotFitTheInterfaceAreRefused) {
    solver::SolvedPaint paint = satin();
    paint.rough_single.coefficient.resize(paint.rough_single.coefficient.size() -
                                          static_cast<std::size_t>(paint.rough_single.rank()));
    EXPECT_THAT(refused_paint(solved_paint_bytes(paint)), HasSubstr("do not fit together"));

    paint = satin();
    paint.rough_single.basis[0] = INFINITY;
    EXPECT_THAT(refused_paint(solved_paint_bytes(paint)),
                HasSubstr("spectral basis is not finite"));

    paint = satin();
    paint.rough_single.first[0] = 1000;
    EXPECT_THAT(refused_paint(solved_paint_bytes(paint)),
                HasSubstr("a first node is out of range"));

    paint = satin();
    paint.rough_single.exit_angle[0] /= 2;
    EXPECT_THAT(refused_paint(solved_paint_bytes(paint)),
                HasSubstr("exit angles of remainder and"));

    paint = satin();  // a smooth paint whose file has been given a rough recipe, and the reverse
    paint.medium.roughness = 0;
    EXPECT_THAT(refused_paint(solved_paint_bytes(paint)),
                HasSubstr("cannot open group rough_single"));
    paint = satin();
    paint.recipe.clearcoat->roughness = 0;
    EXPECT_THAT(refused_paint(solved_paint_bytes(paint)), HasSubstr("the interface is smooth"));
}

// A seed that is refused at once leads a fuzzer nowhere.
TEST(SolvedPaintFile, SeedsOfTheFuzzerAreRead) {
    const solver::SolvedPaint paint =
        read_solved_paint(shipped_file("fuzz/corpus/solved_paint/silver.h5"));
    EXPECT_EQ(paint.wavelengths_nm().size(), 1u);
}

TEST(SolvedPaintFile, StaysBelow300KilobytesFor31Wavelengths) {
    paint::Recipe recipe = read_recipe(shipped_file("paints/tio2-mica-80.toml"));
    // From an ordinary pearl to the narrowest lobes: 76 orders between 44 nodes.
    for (const double alpha : {0.1, 0.02}) {
        recipe.layers[0].flakes[0].orientation.beckmann_alpha = alpha;
        const solver::SolvedPaint paint = solver::solve(recipe, spectra::default_wavelengths_nm());
        EXPECT_EQ(paint.wavelengths_nm().size(), 31u);
        EXPECT_LE(solved_paint_bytes(paint).size(), 300'000u) << "alpha " << alpha;
    }
}

}  // namespace
}  // namespace nacre::io
