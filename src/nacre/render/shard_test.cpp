#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "nacre/io/file_kind.h"
#include "nacre/io/hdf5_file.h"
#include "nacre/render/builtin_scenes.h"
#include "nacre/render/render.h"
#include "nacre/render/shard_file.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/files.h"
#include "nacre/testing/render.h"

// Shards of a picture's samples: their sums, and the files that hold them.

namespace nacre::render {
namespace {

using nacre::test::message_of;
using ::testing::HasSubstr;

const Scene& speckled_ball() {
    static const Scene scene(
        builtin_scene("sphere"),
        {{"paint", std::make_shared<testing::Speckled>([](Vec3f p, Vec3f) {
              return std::fmod(std::abs(p.x + 2 * p.y + 3 * p.z), 2.0f) < 1 ? 2.0f : 0.0f;
          })}});
    return scene;
}

/// All that a picture can hold; samples that nothing divides.
constexpr RenderOptions kAll{.width = 20,
                             .height = 17,
                             .samples_per_pixel = 13,
                             .seed = 5,
                             .sparkle = true,
                             .noise = true,
                             .spectral_bins = 7};

PictureShard shard_of(const Shard& shard, const RenderOptions& options = kAll) {
    return {options,
            shard,
            render_shard(speckled_ball(), options, shard),
            {{"nacre:scene", "ball"}},
            "0123"};
}

TEST(Shard, AllTogetherAreThePictureBitForBit) {
    const RenderResult whole = render(speckled_ball(), kAll);
    ASSERT_TRUE(whole.noise);
    ASSERT_GT(*std::ranges::max_element(whole.sparkle), 0);
    for (const int count : {1, 2, 5, 13}) {
        RenderSums sums(kAll);
        int samples = 0;
        for (int number = count; number >= 1; --number) {
            const RenderSums one = render_shard(speckled_ball(), kAll, {number, count});
            EXPECT_EQ(one.picture.passes.count, samples_of(kAll, {number, count}));
            EXPECT_NEAR(one.picture.passes.count, 13.0 / count, 1);
            samples += one.picture.passes.count;
            sums.add(one);
        }
        EXPECT_EQ(samples, kAll.samples_per_pixel);
        const RenderResult merged = develop(std::move(sums), kAll);
        EXPECT_EQ(merged.rgb, whole.rgb) << count;
        EXPECT_EQ(merged.albedo, whole.albedo) << count;
        EXPECT_EQ(merged.normal, whole.normal) << count;
        EXPECT_EQ(merged.alpha, whole.alpha) << count;
        EXPECT_EQ(merged.sparkle, whole.sparkle) << count;
        EXPECT_EQ(merged.spectral, whole.spectral) << count;
        EXPECT_EQ(merged.noise, whole.noise) << count;
        EXPECT_EQ(merged.samples, whole.samples);
        EXPECT_TRUE(merged.complete);
    }
}

TEST(Shard, IsRefusedWhereThereIsNone) {
    for (const Shard& shard : {Shard{0, 2}, Shard{3, 2}, Shard{1, 0}, Shard{1, 14}}) {
        EXPECT_THAT(message_of<DomainError>([&] { shard_of(shard); }),
                    HasSubstr("with N from 1 to the 13 samples of a pixel"));
    }
    EXPECT_THROW(render_shard(speckled_ball(), kAll, {1, 2}, [](double) { return false; }),
                 Stopped);
}

TEST(Render, TakesLightThatCannotBeSummedAsBlack) {
    SceneDescription bright = builtin_scene("sphere");
    bright.environment = ConstantEnvironment{{.scale = 1e9}};
    // Beyond 2^53 of the perfect diffuser, which no scene that makes sense reaches.
    const Scene scene(
        bright,
        {{"paint", std::make_shared<testing::Speckled>([](Vec3f, Vec3f) { return 1e9f; })}});
    const RenderResult picture = render(scene, {.width = 8, .height = 8, .samples_per_pixel = 2});
    EXPECT_GT(picture.invalid_paths, 0);
    EXPECT_LT(*std::ranges::max_element(picture.rgb), 1e10);
}

TEST(ShardFile, GivesBackTheSameShard) {
    RenderOptions plain = kAll;
    plain.sparkle = plain.noise = false;
    plain.spectral_bins = 0;
    plain.footprint_pixels = 0.1;
    plain.seed = ~std::uint64_t{0};
    for (const RenderOptions& options : {kAll, plain}) {
        const PictureShard shard = shard_of({2, 3}, options);
        const std::string bytes = shard_bytes(shard);
        EXPECT_EQ(parse_shard(bytes, "s"), shard);
        EXPECT_EQ(io::kind_of_bytes(bytes), io::FileKind::picture_shard);
    }
    const nacre::test::TempFolder folder;
    const PictureShard shard = shard_of({1, 3});
    write_shard(folder / "s.h5", shard);
    EXPECT_EQ(read_shard(folder / "s.h5"), shard);
}

TEST(ShardFile, RefusesWhatIsNone) {
    const PictureShard shard = shard_of({1, 2});
    const std::string bytes = shard_bytes(shard);
    const auto refused = [](const std::string& text) {
        return message_of<InputError>([&] { parse_shard(text, "s.h5"); });
    };
    EXPECT_THAT(refused("name = \"x\"\n"), HasSubstr("s.h5: is a recipe; a shard of a picture"));
    EXPECT_THAT(refused(bytes.substr(0, bytes.size() / 2)), HasSubstr("is cut short"));
    std::string damaged = bytes;
    damaged[damaged.size() / 2] ^= 1;
    EXPECT_THAT(refused(damaged), HasSubstr("its checksum does not fit"));
    PictureShard other = shard;
    other.sums.picture.passes.count = 3;
    EXPECT_THAT(refused(shard_bytes(other)), HasSubstr("the passes are not those of the shard"));
    other = shard;
    other.options.width = 21;
    EXPECT_THAT(refused(shard_bytes(other)), HasSubstr("the sizes of the arrays are not those"));
    other = shard;
    other.options.width = other.options.height = 1000;  // of 0.4 GB
    EXPECT_THAT(refused(shard_bytes(other)), HasSubstr("the sizes of the arrays are not those"));
    other = shard;
    other.shard.number = 3;
    EXPECT_THAT(refused(shard_bytes(other)), HasSubstr("shard = 3/2"));
    const io::SealedFormat format = {io::kPictureShardName, kShardFormatVersion,
                                     "shard of a picture"};
    EXPECT_THAT(refused(io::sealed_bytes(format, [](hid_t) {})), HasSubstr("that can be used"));
}

}  // namespace
}  // namespace nacre::render
