#include "nacre/io/brdf_table_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "nacre/core/error.h"
#include "nacre/io/hdf5_file.h"
#include "nacre/solver/solver.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/files.h"
#include "nacre/testing/paints.h"

namespace nacre::io {
namespace {

using nacre::test::message_of;
using ::testing::HasSubstr;

const bsdf::RawBrdfTable& raw() {
    static const bsdf::RawBrdfTable table = [] {
        paint::Recipe recipe =
            nacre::test::metallic(0.3, spectra::Spectrum({400.0, 700.0}, {0.3, 0.8}));
        recipe.name = "copper";
        return bsdf::make_raw_table(solver::solve(recipe, {450, 550, 650}), {12, 10});
    }();
    return table;
}

const bsdf::CompressedBrdfTable& compressed() {
    static const bsdf::CompressedBrdfTable table = bsdf::compress(raw(), {3, 0.5});
    return table;
}

std::string refused_brdf_table(const std::string& bytes) {
    return message_of<InputError>([&] { parse_brdf_table(bytes, "table.h5"); });
}

TEST(BrdfTableFile, GivesBackTheSameTable) {
    EXPECT_EQ(std::get<bsdf::RawBrdfTable>(parse_brdf_table(brdf_table_bytes(raw()), "t")), raw());
    EXPECT_EQ(
        std::get<bsdf::CompressedBrdfTable>(parse_brdf_table(brdf_table_bytes(compressed()), "t")),
        compressed());
    // Nothing in it depends on the time.
    EXPECT_EQ(brdf_table_bytes(raw()), brdf_table_bytes(raw()));
    EXPECT_TRUE(looks_like_brdf_table(brdf_table_bytes(raw())));
    EXPECT_FALSE(looks_like_brdf_table("nacre solved paint\n"));
}

TEST(BrdfTableFile, KeepsABlackTable) {
    bsdf::CompressedBrdfTable black = compressed();
    black.rank = {};
    black.left.clear();
    black.right.clear();
    EXPECT_EQ(std::get<bsdf::CompressedBrdfTable>(parse_brdf_table(brdf_table_bytes(black), "t")),
              black);
}

TEST(BrdfTableFile, GoesThroughTheDisk) {
    const nacre::test::TempFolder folder;
    const std::filesystem::path path = folder / "table.h5";
    write_brdf_table(path, compressed());
    EXPECT_EQ(std::get<bsdf::CompressedBrdfTable>(read_brdf_table(path)), compressed());
    write_brdf_table(path, raw());
    EXPECT_EQ(std::get<bsdf::RawBrdfTable>(read_brdf_table(path)), raw());
    std::filesystem::remove(path);
    EXPECT_THROW(read_brdf_table(path), InputError);
}

TEST(BrdfTableFile, IsRefusedWhereverItIsCutOrABitFlips) {
    const std::string bytes = brdf_table_bytes(compressed());
    const std::size_t remark = bytes.find("The rest is HDF5");
    ASSERT_LT(remark, 200u);
    int tried = 0;
    for (std::size_t at = 0; at < bytes.size(); at += 1 + at / 10, ++tried) {
        EXPECT_THAT(refused_brdf_table(bytes.substr(0, at)), HasSubstr("table.h5: ")) << at;
        if (at >= remark && at < 512) continue;  // a remark ends the head, and is not read
        std::string damaged = bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ 4);
        EXPECT_THAT(refused_brdf_table(damaged), HasSubstr("table.h5: ")) << at;
    }
    EXPECT_GT(tried, 40);
    EXPECT_THAT(refused_brdf_table(""), HasSubstr("is not a BRDF table of Nacre"));
}

TEST(BrdfTableFile, ContentsThatCannotBeAreRefusedEvenUnderAValidChecksum) {
    bsdf::RawBrdfTable table = raw();
    table.values[7] = NAN;
    EXPECT_THAT(refused_brdf_table(brdf_table_bytes(table)), HasSubstr("a value is not finite"));
    table = raw();
    table.grid.ior = 0.5;
    EXPECT_THAT(refused_brdf_table(brdf_table_bytes(table)),
                HasSubstr("ior of a BRDF table = 0.5"));
    table = raw();
    table.grid.lobe_alpha = NAN;
    EXPECT_THAT(refused_brdf_table(brdf_table_bytes(table)), HasSubstr("lobe_alpha"));

    bsdf::CompressedBrdfTable c = compressed();
    c.rank[0] = -1;
    c.rank[1] += 7;  // the sum is right
    EXPECT_THAT(refused_brdf_table(brdf_table_bytes(c)), HasSubstr("number of terms"));

    // Sizes are compared with the grid before anything is allocated.
    constexpr SealedFormat kFormat = {"nacre BRDF table", kBrdfTableFormatVersion, "BRDF table"};
    const auto sealed = [&](int angles, int azimuths) {
        return sealed_bytes(kFormat, [&](hid_t file) {
            write_attribute(file, "paint", std::string("x"));
            write_attribute(file, "kind", std::string("raw"));
            const Hdf5Handle grid(H5Gcreate2(file, "grid", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                                  "make a group");
            write_attribute(grid, "angles", angles);
            write_attribute(grid, "azimuths", azimuths);
            for (const char* name : {"ior", "roughness", "lobe_alpha"}) {
                write_attribute(grid, name, *name == 'i' ? 1.5 : 0.5);
            }
            write_array(file, "values", {12, 12, 10, 3}, raw().values.data(), "1/sr", "g");
        });
    };
    EXPECT_EQ(refused_brdf_table(sealed(12, 10)), "accepted");
    EXPECT_THAT(refused_brdf_table(sealed(13, 10)), HasSubstr("do not fit the grid"));
    EXPECT_THAT(refused_brdf_table(sealed(512, 512)), HasSubstr("do not fit the grid"));
    EXPECT_THAT(refused_brdf_table(sealed(1 << 30, 10)), HasSubstr("angles of a BRDF table"));
    EXPECT_THAT(refused_brdf_table(sealed(-12, 10)), HasSubstr("angles of a BRDF table"));
}

// Arrays of many megabytes are compressed piece by piece.
TEST(BrdfTableFile, LargeTablesComeBackAndStopWhenAskedTo) {
    bsdf::RawBrdfTable large = raw();
    large.grid.angles = large.grid.azimuths = 96;
    large.values.resize(3 * large.grid.values());
    for (std::size_t i = 0; i < large.values.size(); ++i) {
        large.values[i] = static_cast<float>(i % 1009);
    }
    int calls = 0;
    const std::string bytes = brdf_table_bytes(large, [&](double) { return ++calls > 0; });
    EXPECT_EQ(std::get<bsdf::RawBrdfTable>(parse_brdf_table(bytes, "t")), large);
    EXPECT_GT(calls, 0);
    EXPECT_THROW(brdf_table_bytes(large, [](double) { return false; }), Stopped);
    EXPECT_THROW(brdf_table_bytes(compressed(), [](double) { return false; }), Stopped);
}

}  // namespace
}  // namespace nacre::io
