#include "nacre/io/image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/spectra/colour.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/files.h"

namespace nacre::io {
namespace {

using nacre::test::message_of;
using ::testing::HasSubstr;

class ImageFiles : public ::testing::Test {
 protected:
    nacre::test::TempFolder folder_;
};

/// 5 x 3 pixels, every value different, beyond [0, 1] too.
Image example_image() {
    Image image{5, 3, {}, {{"nacre:seed", "7"}, {"comments", "two\nlines"}}};
    float value = -0.25f;
    for (const char* name : {"B", "G", "R", "albedo.R", "S0.550,000000nm"}) {
        Channel channel{name, {}};
        for (int i = 0; i < 15; ++i) channel.pixels.push_back(value += 0.0371f);
        image.channels.push_back(channel);
    }
    return image;
}

TEST_F(ImageFiles, ExrKeepsEveryChannelBitForBitAndTheMetadata) {
    const Image image = example_image();
    write_exr(folder_ / "a.exr", image);
    const Image read = read_image(folder_ / "a.exr");
    EXPECT_EQ(read.width, 5);
    EXPECT_EQ(read.height, 3);
    ASSERT_EQ(read.channels.size(), image.channels.size());
    for (const Channel& channel : image.channels) {
        ASSERT_TRUE(read.find(channel.name)) << channel.name;
        EXPECT_EQ(read.find(channel.name)->pixels, channel.pixels);
    }
    EXPECT_EQ(read.metadata, image.metadata);
    // The folder holds the file and nothing else.
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_),
                            std::filesystem::directory_iterator()),
              1);
}

TEST_F(ImageFiles, PngKeepsLightBelowTheShoulderToHalfAStep) {
    Image image{256, 1, {{"R", {}}, {"G", {}}, {"B", {}}}, {{"nacre:seed", "7"}}};
    for (Channel& channel : image.channels) {
        for (int i = 0; i < 256; ++i) {
            channel.pixels.push_back(static_cast<float>(spectra::srgb_decode(i / 255.0)));
        }
    }
    write_png(folder_ / "a.png", image);
    const Image read = read_image(folder_ / "a.png");
    ASSERT_EQ(read.width, 256);
    EXPECT_EQ(read.metadata.at("nacre:seed"), "7");
    int compared = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i < 256 && image.channels[c].pixels[i] <= kShoulderStart; ++i) {
            // A value that is one of the 256 codes comes back as that code.
            EXPECT_EQ(read.channels[c].pixels[i], image.channels[c].pixels[i]) << i;
            ++compared;
        }
    }
    EXPECT_GT(compared, 3 * 200);
}

TEST_F(ImageFiles, ThePngBesideAnExrIsReplacedOnlyIfItIsOneOfOurs) {
    const std::filesystem::path exr = folder_ / "a.b.exr", png = folder_ / "a.b.png";
    EXPECT_EQ(png_beside(exr), png);
    EXPECT_NO_THROW(check_png_beside(png));  // none
    Image image = example_image();
    image.metadata = {{"comments", "no word of Nacre"}};
    write_exr_and_png(exr, image);
    EXPECT_EQ(read_image(png).metadata.count("nacre:version"), 1u);
    EXPECT_EQ(read_image(exr).metadata, read_image(png).metadata);
    write_exr_and_png(exr, image);  // over its own

    write_png(png, image);  // as another program may write it
    const std::string foreign = read_file(png), old = read_file(exr);
    image.channels[0].pixels[0] += 1;
    EXPECT_THAT([&] { write_exr_and_png(exr, image); },
                ::testing::ThrowsMessage<InputError>(HasSubstr(png.string())));
    EXPECT_EQ(read_file(png), foreign);
    EXPECT_EQ(read_file(exr), old);
    for (const std::string& bytes : {std::string(), foreign.substr(0, 20), std::string("text")}) {
        write_file_atomically(png, bytes);
        EXPECT_THROW(check_png_beside(png), InputError);
    }
}

TEST(ToneMap, IsTheIdentityThenBendsSmoothlyAndNeverBurnsOut) {
    EXPECT_EQ(soft_shoulder(0), 0);
    EXPECT_EQ(soft_shoulder(0.5), 0.5);
    EXPECT_EQ(soft_shoulder(-1), 0);
    EXPECT_EQ(soft_shoulder(std::nan("")), 0);
    const double h = 1e-6;
    EXPECT_NEAR((soft_shoulder(kShoulderStart + h) - kShoulderStart) / h, 1, 1e-4);
    for (double x = 0.8; x < 4; x += 0.01) EXPECT_LT(soft_shoulder(x), soft_shoulder(x + 0.01));
    EXPECT_LE(soft_shoulder(1e30), 1);
    EXPECT_EQ(display_byte(1e30, 1), 255);
    EXPECT_EQ(display_byte(0.25, 2), display_byte(0.5, 1));
}

TEST(SpectralChannelName, HasSixDecimalsBehindAComma) {
    EXPECT_EQ(spectral_channel_name(550), "S0.550,000000nm");
    EXPECT_EQ(spectral_channel_name(412.5), "S0.412,500000nm");
}

// 2 x 2 pixels, flat: red 1, then 0.5, black, and 2 in all three.
const std::string kHdrHeader = "#?RADIANCE\n# made by hand\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 2\n";
const std::string kHdrPixels("\x80\x00\x00\x81\x80\x00\x00\x80\x00\x00\x00\x00\x80\x80\x80\x82",
                             16);

TEST(RadianceHdr, ReadsSharedExponents) {
    const Image image = parse_image(kHdrHeader + kHdrPixels, "a.hdr");
    ASSERT_EQ(image.pixel_count(), 4u);
    const std::vector<float>& red = image.find("R")->pixels;
    // (128 + 1/2) / 256 * 2^(exponent - 128): the middle of the mantissa's step.
    EXPECT_FLOAT_EQ(red[0], 128.5f / 128);
    EXPECT_FLOAT_EQ(red[1], 128.5f / 256);
    EXPECT_EQ(red[2], 0);
    EXPECT_FLOAT_EQ(image.find("B")->pixels[3], 128.5f / 64);
}

TEST(RadianceHdr, DividesByTheExposure) {
    const Image image = parse_image(
        "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=4\nEXPOSURE= 0.5\n\n-Y 2 +X 2\n" + kHdrPixels,
        "a.hdr");
    EXPECT_FLOAT_EQ(image.find("R")->pixels[0], 128.5f / 128 / 2);
}

TEST(RadianceHdr, ReadsBothKindsOfRuns) {
    // Separate components: nine pixels, a run of nine for each but green, which is spelled out.
    std::string runs = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 9\n";
    runs += std::string("\x02\x02\x00\x09", 4) + std::string("\x89\x80", 2) +
            std::string("\x09\x01\x02\x03\x04\x05\x06\x07\x08\x09", 10) +
            std::string("\x89\x00", 2) + std::string("\x89\x81", 2);
    const Image separate = parse_image(runs, "a.hdr");
    EXPECT_FLOAT_EQ(separate.find("R")->pixels[8], 128.5f / 128);
    EXPECT_FLOAT_EQ(separate.find("G")->pixels[6], 7.5f / 128);
    // The older kind: one pixel, then 1 1 1 3 repeats it.
    std::string old = "#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 4\n";
    old += std::string("\x80\x00\x00\x81\x01\x01\x01\x03", 8);
    EXPECT_FLOAT_EQ(parse_image(old, "a.hdr").find("R")->pixels[3], 128.5f / 128);
}

TEST_F(ImageFiles, CutAnywhereIsRefusedAndNamed) {
    write_exr(folder_ / "a.exr", example_image());
    write_png(folder_ / "a.png", example_image());
    const std::string files[] = {read_file(folder_ / "a.exr"), read_file(folder_ / "a.png"),
                                 kHdrHeader + kHdrPixels};
    for (const std::string& bytes : files) {
        // PNG: the last chunk ends the file and holds nothing; without it the pixels are whole.
        const std::size_t essential = bytes.size() - (bytes[1] == 'P' ? 16 : 0);
        for (std::size_t size = 0; size < essential; size += 1 + size / 40) {
            EXPECT_THAT(
                message_of<InputError>([&] { parse_image(bytes.substr(0, size), "cut.img"); }),
                HasSubstr("cut.img"))
                << size;
        }
    }
}

TEST(ReadImage, RefusesForeignBytesAndAbsurdSizes) {
    EXPECT_THROW(parse_image("", "x"), InputError);
    EXPECT_THROW(parse_image("GIF89a", "x"), InputError);
    EXPECT_THROW(read_image("no/such/file.exr"), InputError);
    for (const char* size : {"-Y 40000 +X 2", "-Y 0 +X 2", "-Y -1 +X 2", "+Y 2 +X 2", "nonsense"}) {
        EXPECT_THROW(
            parse_image("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + std::string(size) + "\n", "x"),
            InputError)
            << size;
    }
    EXPECT_THROW(parse_image(kHdrHeader + kHdrPixels, "x", 11), InputError);  // 2 x 2 x 3 = 12
    EXPECT_NO_THROW(parse_image(kHdrHeader + kHdrPixels, "x", 12));
}

TEST_F(ImageFiles, AnExrCannotAskForMoreMemoryThanItsSizeJustifies) {
    write_exr(folder_ / "a.exr", example_image());
    const std::string bytes = read_file(folder_ / "a.exr");
    const auto damaged = [&](const std::string& attribute, std::size_t offset, char value) {
        std::string copy = bytes;
        copy.at(copy.find(attribute) + attribute.size() + 1 + offset) = value;
        return copy;
    };
    // The third byte of a text's length: 7 bytes become 4 million.
    EXPECT_THROW(parse_image(damaged("nacre:seed", 7 + 2, 64), "x"), InputError);
    // dataWindow: "box2i", its size, then minimum and maximum: 5 x 3 becomes 16 million x 3.
    EXPECT_THROW(parse_image(damaged("dataWindow", 6 + 4 + 8 + 3, 1), "x"), InputError);
    EXPECT_NO_THROW(parse_image(bytes, "x", 5 * 15));
    EXPECT_THROW(parse_image(bytes, "x", 5 * 15 - 1), InputError);
}

TEST_F(ImageFiles, AnExrCannotHideAnAttributeInTheValueOfAnother) {
    // OpenEXR reads four bytes of a float whatever its size says, and would then take the rest of
    // the value, here a text of a gigabyte, for the next attribute.
    write_exr(folder_ / "a.exr", example_image());
    std::string bytes = read_file(folder_ / "a.exr");
    const std::string type("pixelAspectRatio\0float\0", 23);
    const std::size_t size_at = bytes.find(type) + type.size();
    const std::string hidden("b\0string\0\0\0\0\x40", 13);
    bytes.at(size_at) = static_cast<char>(4 + hidden.size());
    bytes.insert(size_at + 8, hidden);
    EXPECT_THAT(message_of<InputError>([&] { parse_image(bytes, "x"); }),
                ::testing::HasSubstr("'float' has the wrong size"));
}

TEST_F(ImageFiles, APngCannotAskForMoreMemoryThanItsSizeJustifies) {
    write_png(folder_ / "a.png", example_image());
    std::string bytes = read_file(folder_ / "a.png");
    bytes.at(bytes.find("tEXt") - 4) = 0x7f;  // the first byte of its length: two gigabytes
    EXPECT_THROW(parse_image(bytes, "x"), InputError);
}

TEST_F(ImageFiles, NothingIsWrittenWhereItCannotBe) {
    EXPECT_THROW(write_exr(folder_ / "no" / "a.exr", example_image()), Error);
    EXPECT_THROW(write_png(folder_ / "no" / "a.png", example_image()), Error);
    Image broken = example_image();
    broken.channels[0].pixels.pop_back();
    EXPECT_THROW(write_exr(folder_ / "a.exr", broken), DomainError);
    EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

// Colours of a display come back as the light that they were, in files that name its primaries.
TEST(Png, KeepsColoursOfWiderDisplays) {
    Image image = blank_image("t", 2, 1, {"R", "G", "B"}, 100);
    // Half of Rec. 2020's green, and a grey.
    const Vec3d green = spectra::to_rec709(spectra::Gamut::rec2020, {0, 0.5, 0});
    for (int c = 0; c < 3; ++c) image.channels[c].pixels = {static_cast<float>(green[c]), 0.25f};
    EXPECT_LT(green[0], 0);
    EXPECT_EQ(outside_gamut(image, spectra::Gamut::rec709), 0.5);
    EXPECT_EQ(outside_gamut(image, spectra::Gamut::display_p3), 0.5);
    EXPECT_EQ(outside_gamut(image, spectra::Gamut::rec2020), 0);
    const std::string wide = encode_png(image, "t", {.gamut = spectra::Gamut::rec2020});
    EXPECT_NE(wide.find("cICP"), std::string::npos);
    EXPECT_EQ(wide.find("sRGB"), std::string::npos);
    const Image back = parse_png(wide, "t", 100);
    const std::string narrow = encode_png(image, "t");
    EXPECT_EQ(narrow.find("cICP"), std::string::npos);
    const Image clipped = parse_png(narrow, "t", 100);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(back.channels[c].pixels[0], green[c], 5e-3);
        EXPECT_NEAR(back.channels[c].pixels[1], 0.25, 2e-3);
        EXPECT_NEAR(clipped.channels[c].pixels[0], std::max(0.0, green[c]), 5e-3);
    }
    std::string strange = wide;
    strange[wide.find("cICP") + 5] = 16;  // the transfer function: PQ
    EXPECT_THAT(message_of<InputError>([&] { parse_png(strange, "t.png", 100); }),
                ::testing::HasSubstr("t.png"));
}

}  // namespace
}  // namespace nacre::io
