#include "apps/studio/messages/own_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <random>

#include "apps/studio/answers.h"
#include "apps/studio/messages/stage.h"
#include "nacre/core/base64.h"
#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/io/image.h"
#include "nacre/render/environment.h"
#include "nacre/render/scene.h"

namespace nacre::studio {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// A roof of two triangles, 4 x 2 x 1 units.
constexpr const char* kObj =
    "v 0 0 0\nv 4 0 0\nv 4 2 1\nv 0 2 1\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";
constexpr const char* kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n100 0 0\n0 60 0\n3 0 1 2\n";

/// One triangle; its buffer is where `uri` says.
std::string gltf(const std::string& uri) {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"buffers":[{"byteLength":36,"uri":")" +
           uri + R"("}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
"min":[0,0,0],"max":[0.1,0.2,0]}]})";
}
std::string triangle_bytes() {
    const float places[] = {0, 0, 0, 0.1f, 0, 0, 0, 0.2f, 0};
    return {reinterpret_cast<const char*>(places), sizeof places};
}

/// Light of 1/2 from above and 1/8 from below, flat scan lines of Radiance HDR.
std::string hdr(int width, int height) {
    std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) +
                        " +X " + std::to_string(width) + "\n";
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x)
            bytes += y < height / 2 ? "\x80\x80\x80\x80" : "\x80\x80\x80\x7e";
    }
    return bytes;
}

constexpr const char* kRead = "was read";

std::string refusal_of_shape(const std::string& file, const std::string& bytes) {
    try {
        read_own_shape("own", file, bytes, false);
    } catch (const InputError& error) {
        return error.what();
    }
    return kRead;
}
std::string refusal_of_light(const std::string& file, const std::string& bytes) {
    try {
        read_own_light("own", file, bytes);
    } catch (const InputError& error) {
        return error.what();
    }
    return kRead;
}

TEST(OwnFiles, AMeshIsPutIntoTheMiddleAndScaled) {
    const auto roof = read_own_shape("own-shape-1", "roof.obj", kObj, false);
    EXPECT_EQ(roof->name, "own-shape-1");
    EXPECT_DOUBLE_EQ(roof->extent_mm, 4);
    EXPECT_DOUBLE_EQ(roof->shape.transform.scale, 50);  // too small to be seen: 200 mm
    EXPECT_EQ(roof->shape.transform.translation_mm, (Vec3f{-100, -50, -25}));
    EXPECT_GT(length(roof->camera.position_mm), 400.0f);
    EXPECT_FLOAT_EQ(read_own_shape("own", "roof.obj", kObj, true)->shape.transform.translation_mm.z,
                    -50);  // y is up
    const auto triangle = read_own_shape("own", "triangle.ply", kPly, false);
    EXPECT_DOUBLE_EQ(triangle->shape.transform.scale, 1);  // 100 mm stay so
}

TEST(OwnFiles, AGltfMustStandAlone) {
    const std::string inside =
        gltf("data:application/octet-stream;base64," + base64(triangle_bytes()));
    EXPECT_NEAR(read_own_shape("own", "t.gltf", inside, false)->extent_mm, 200, 1e-3);  // in metres
    // A file that is there, where relative names start and by its whole path.
    const std::filesystem::path secret = std::filesystem::current_path() / "own_files_test.bin";
    write_file_atomically(secret, triangle_bytes());
    for (const std::string& uri : {secret.filename().string(), secret.string()}) {
        const std::string refusal = refusal_of_shape("t.gltf", gltf(uri));
        EXPECT_THAT(refusal, StartsWith("mesh 't.gltf': "));
        EXPECT_THAT(refusal, testing::Not(HasSubstr(uri)));
    }
    std::filesystem::remove(secret);
    EXPECT_THAT(refusal_of_shape("roof.obj", "mtllib own_files_test.bin\n" + std::string(kObj)),
                kRead);  // materials are not looked at
}

TEST(OwnFiles, AWhitePanelThatLiesFlatIsWhite) {
    const auto light = read_own_light("own-light-2", "sky.hdr", hdr(16, 8));
    EXPECT_EQ(light->picture.width, 16);
    EXPECT_NEAR(light->picture.rgb[0], 1, 1e-6);
    EXPECT_NEAR(light->picture.rgb.back(), 0.25, 1e-3);
    const std::string bytes = light_bytes({.light = "own-light-2", .own_light = light}, 16);
    float first = 0;
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data(), 4);
    std::memcpy(&first, bytes.data() + 12 + length, 4);
    EXPECT_NEAR(first, 1, 0.01);
    EXPECT_THROW(light_bytes({.light = "own-light-1", .own_light = light}, 16), InputError);
    // What is too wide is reduced.
    const auto wide = read_own_light("own", "wide.exr", [] {
        io::Image image{.width = 2080, .height = 1040};
        for (const char* name : {"R", "G", "B"}) {
            image.channels.push_back({name, std::vector<float>(image.pixel_count(), 2.0f)});
        }
        return io::encode_exr(image, "wide.exr");
    }());
    EXPECT_EQ(wide->picture.width, 1040);
    EXPECT_NEAR(wide->picture.rgb[12345], 1, 1e-5);
}

TEST(OwnFiles, SayWhatIsWrongAndWithWhichFile) {
    EXPECT_THAT(refusal_of_shape("car.3ds", kObj), HasSubstr("'car.3ds': is none of .obj, .ply"));
    EXPECT_THAT(refusal_of_shape("/etc/passwd.obj", "root:x\n"),
                StartsWith("mesh '/etc/passwd.obj'"));
    EXPECT_THAT(refusal_of_shape("cut.ply", std::string(kPly).substr(0, 160)),
                HasSubstr("'cut.ply': "));
    EXPECT_EQ(refusal_of_shape("none.obj", ""), "none.obj: is empty");
    EXPECT_THAT(refusal_of_shape("big.obj", std::string(kMaxOwnFileBytes + 1, ' ')),
                "big.obj: has 6000001 bytes; at most 6000000 are taken");
    EXPECT_THAT(refusal_of_light("a.hdr", "no picture"),
                StartsWith("a.hdr: is no picture of light"));
    EXPECT_THAT(refusal_of_light("a.hdr", hdr(16, 16)), HasSubstr("a.hdr: has 16 x 16 pixels"));
    EXPECT_THAT(refusal_of_light("a.hdr", hdr(16, 8).substr(0, 200)), StartsWith("a.hdr: "));
}

TEST(OwnFiles, DamagedFilesAreReadOrRefused) {
    std::mt19937 random(1);
    const std::string seeds[] = {kObj, kPly, gltf("data:;base64," + base64(triangle_bytes())),
                                 hdr(16, 8)};
    const char* names[] = {"a.obj", "a.ply", "a.gltf", "a.hdr"};
    int read[4] = {}, refused[4] = {};  // by kind of file
    for (int round = 0; round < 400; ++round) {
        const int which = round % 4;
        std::string bytes = seeds[which];
        // Any bytes, or, as most of these are refused, others of the file.
        for (int i = 0; i <= round % 3; ++i) {
            const char other = bytes[random() % bytes.size()];
            const auto any = static_cast<char>(random());
            bytes[random() % bytes.size()] = round % 8 < 4 ? any : other;
        }
        if (round % 5 == 0) bytes.resize(random() % bytes.size());
        // Anything but an InputError fails the test.
        const std::string refusal = which == 3 ? refusal_of_light(names[which], bytes)
                                               : refusal_of_shape(names[which], bytes);
        ++(refusal == kRead ? read : refused)[which];
    }
    for (int which = 0; which < 4; ++which) {
        EXPECT_GT(read[which], 0) << names[which];
        EXPECT_GT(refused[which], 0) << names[which];
    }
}

TEST(OwnFiles, ArePaintedAndLitByThePathTracer) {
    Memory memory;
    SolvedPaints solved;
    const Context context{1, memory, solved, {}, [](const std::string&, Frames) {}};
    const Frames shape = answer(ShapeRequest{"roof.obj", kObj, false}, context);
    const Tree told = Tree::parse(shape.at(0).text);
    EXPECT_EQ(told["triangles"], 2);
    EXPECT_EQ(told["shape"]["title"], "roof.obj");
    EXPECT_EQ(told["binary"][0]["shape"][0], shape[0].binary.size());
    const Frames light = answer(LightRequest{"sky.hdr", hdr(16, 8)}, context);
    RenderRequest request;
    request.recipe = tree_of_toml(read_file(find_paint("ruby")), "ruby.toml");
    request.stage.shape = told["shape"]["name"];
    request.stage.light = Tree::parse(light.at(0).text)["light"]["name"];
    request.width = request.height = 16;
    request.samples = 4;
    const Frames picture = answer(request, context);
    // The middle is paint, which is darker than the sky behind it, and red.
    const auto byte = [&](int x, int y, int c) {
        return static_cast<unsigned char>(picture.at(0).binary[3 * (16 * y + x) + c]);
    };
    EXPECT_GT(byte(8, 8, 0), byte(8, 8, 1) + 20);
    EXPECT_LT(byte(8, 8, 1), 200);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(byte(0, 0, c), 137, 8);  // 1/4, below the horizon
    // The next takes the place and another name.
    answer(ShapeRequest{"roof.obj", kObj, true}, context);
    EXPECT_THROW(answer(request, context), InputError);
}

TEST(LightBooth, LooksWhiteToAnEyeThatHasAdapted) {
    for (const char* name : {"booth-d65", "booth-a", "booth-fl11"}) {
        const std::string bytes = light_bytes({.light = name}, 16);
        std::uint32_t length = 0;
        std::memcpy(&length, bytes.data(), 4);
        const Tree lamp = Tree::parse(bytes.substr(4, length))["rectangles"][0]["rgb"];
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(lamp[c].get<double>(), 2.5, 0.01) << name;
        EXPECT_EQ(Adaptation({.light = name}).is_none(), name == std::string("booth-d65"));
    }
    EXPECT_TRUE(Adaptation({.light = "sun"}).is_none());
    EXPECT_EQ(lamp_of({.light = "booth-fl11"}), spectra::Illuminant::FL11);
    EXPECT_EQ(lamp_of({.light = "booth-a"}), spectra::Illuminant::A);
    EXPECT_EQ(lamp_of({.light = "sun"}), spectra::Illuminant::D65);

    // And the path tracer's grey walls are grey.
    Memory memory;
    SolvedPaints solved;
    const Context context{1, memory, solved, {}, [](const std::string&, Frames) {}};
    RenderRequest request;
    request.recipe = tree_of_toml(read_file(find_paint("ruby")), "ruby.toml");
    request.stage.light = "booth-fl11";
    request.width = request.height = 16;
    request.samples = 2;  // as few as show lines of FL11 or miss them
    request.linear = true;
    const Frames picture = answer(request, context);
    float wall[3];
    std::memcpy(wall, picture.at(0).binary.data() + 16 * 16 * 3, sizeof wall);
    for (const float value : wall) EXPECT_NEAR(value, 0.2, 1e-5);
}

}  // namespace
}  // namespace nacre::studio
