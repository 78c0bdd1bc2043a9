#include "nacre/render/mesh_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cctype>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/files.h"
#include "nacre/testing/render.h"

namespace nacre::render {
namespace {

using nacre::test::message_of;
using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

class MeshFileTest : public ::testing::Test {
 protected:
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        return folder_.write(name, text);
    }
    static std::string refusal(const std::filesystem::path& path) {
        return message_of<InputError>([&] { make_mesh(MeshFile{.path = path}); });
    }

    nacre::test::TempFolder folder_;
};

const char* const kObj = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n";
const char* const kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n2 0 0\n0 1 0\n3 0 1 2\n";
// One triangle (0 0 0) (1 0 0) (0 1 0) in a data URI.
const char* const kGltf = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}]})";

TEST_F(MeshFileTest, ReadsObjPlyAndGltf) {
    const Mesh obj = make_mesh(MeshFile{.path = write("quad.obj", kObj), .mm_per_unit = 10});
    EXPECT_EQ(obj.triangles.size(), 2u);
    EXPECT_NEAR(testing::area_mm2(obj), 200, 1e-3);
    EXPECT_NEAR(obj.normals[0].z, 1, 1e-6);
    EXPECT_NEAR(testing::area_mm2(make_mesh(MeshFile{.path = write("triangle.ply", kPly)})), 1,
                1e-6);
    // glTF's vertical is y, and the triangle stands upright in it.
    const Mesh gltf = make_mesh(MeshFile{.path = write("t.gltf", kGltf)});
    EXPECT_NEAR(testing::area_mm2(gltf), 0.5e6, 1);  // metres, unless told otherwise
    EXPECT_NEAR(std::abs(gltf.normals[0].y), 1, 1e-6);
    EXPECT_EQ(make_mesh(MeshFile{.path = write("t.gltf", kGltf), .y_up = true}).positions_mm,
              gltf.positions_mm);
    EXPECT_NEAR(
        testing::area_mm2(make_mesh(MeshFile{.path = write("t.gltf", kGltf), .mm_per_unit = 1})),
        0.5, 1e-6);
}

// A car's body and its windows in one file.
TEST_F(MeshFileTest, PartsAreToldByTheirMaterial) {
    const std::string obj =
        "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 4 0\nusemtl body\nf 1 2 3\nusemtl glass\nf 1 2 4\n";
    const auto area = [&](const MeshFile& file) { return testing::area_mm2(make_mesh(file)); };
    const std::filesystem::path car = write("car.obj", obj);
    EXPECT_NEAR(area({.path = car}), 5, 1e-5);
    EXPECT_NEAR(area({.path = car, .part = "body"}), 1, 1e-5);
    EXPECT_NEAR(area({.path = car, .part = "glass"}), 4, 1e-5);
    EXPECT_THAT(
        nacre::test::message_of<InputError>([&] { make_mesh({.path = car, .part = "boby"}); }),
        AllOf(HasSubstr("has no material 'boby' (did you mean 'body'?)"), HasSubstr("'glass'")));

    std::string gltf = kGltf;
    const std::string primitive = R"({"attributes":{"POSITION":0}})";
    gltf.replace(gltf.find(primitive), primitive.size(),
                 R"({"attributes":{"POSITION":0},"material":1})");
    gltf.insert(gltf.find("\"buffers\""), R"("materials":[{"name":"glass"},{"name":"body"}],)");
    const std::filesystem::path body = write("car.gltf", gltf);
    EXPECT_NEAR(area({.path = body, .part = "body"}), 0.5e6, 1);
    EXPECT_THROW(make_mesh({.path = body, .part = "glass"}), InputError);  // nothing has it
    gltf.replace(gltf.find("\"material\":1"), 12, "\"material\":2");
    EXPECT_THROW(make_mesh({.path = write("none.gltf", gltf)}), InputError);
}

TEST_F(MeshFileTest, RefusesWhatIsNoMeshAndNamesTheFile) {
    EXPECT_THAT(refusal("/nonexistent/body.obj"), HasSubstr("'/nonexistent/body.obj'"));
    EXPECT_THAT(refusal(folder_), HasSubstr("Is a directory"));
    for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
             {"empty.obj", ""},
             {"points.obj", "v 0 0 0\nv 1 0 0\n"},
             {"headless.ply", "ply\nformat ascii 1.0\nelement vertex 99999\n"},
             {"short.ply",
              "ply\nformat ascii 1.0\nelement vertex 99999\nproperty float x\nend_header\n0\n"},
             {"type.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\n"},
             {"broken.gltf", "{\"asset\":"},
             {"unknown.xyz9", "hello"},
             // Of a format that assimp reads and Nacre does not.
             {"other.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
             {"disguised.obj", std::string("\0\0", 2)},
             {"nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}}) {
        const auto path = write(name, text);
        EXPECT_THAT(refusal(path), HasSubstr(path.string()));
    }
}

/// What is wrong with the contents of a file of this extension; "accepted" if nothing.
std::string fault(const std::string& extension, std::string_view bytes) {
    return message_of<InputError>(
        [&] { parse_mesh(bytes, MeshFile{.path = "/nowhere/mesh" + extension}); });
}

/// A glTF of the triangle with other nodes; the scene shows the first.
std::string gltf_with_nodes(const json& nodes, const json& roots = {0}) {
    json whole = json::parse(kGltf);
    whole["nodes"] = nodes;
    whole["scenes"] = {{{"nodes", roots}}};
    return whole.dump();
}

const std::string kCorners = "v 0 0 0\nv 2 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n";

TEST(MeshContents, ObjFacesNameWhatIsThere) {
    const auto of_line = [](const std::string& line) {
        return fault(".obj", kCorners + line + "\n");
    };
    for (const char* face :
         {"f 1 2 3", "f -3 -2 -1", "f 1/1 2/1 3/1", "f 1//1 2//1 3//-1",
          "f 1/1/1 2/1/1 3/1/1 # of one kind", "f 1/1/1 2 3/1", "f 1/ 2/ 3/", "f 1 2 4\nv 5 5 5",
          "f 1 2 \\\n  3", "f 1 2 3\nf 1 2\nl 1 2\np 9\nvp x"}) {
        EXPECT_EQ(of_line(face), "accepted") << face;
    }
    EXPECT_THAT(of_line("f 1 2 4"), HasSubstr("line 6 is a face that names a vertex that is not "
                                              "there: 3 are"));
    EXPECT_THAT(of_line("f 1 2 0"), HasSubstr("a vertex that is not there"));
    EXPECT_THAT(of_line("f 1 2 -4"), HasSubstr("a vertex that is not there"));
    EXPECT_THAT(of_line("f 1/2 2/2 3/2"),
                HasSubstr("a texture coordinate that is not there: 1 are"));
    EXPECT_THAT(of_line("f 1//2 2//2 3//2"), HasSubstr("a normal that is not there"));
    EXPECT_THAT(of_line("f 1 2 99999999999999999999"), HasSubstr("a vertex that is not there"));
    for (const char* face : {"f 1 2 1.5", "f 1 2 x", "f 1 2 /1", "f 1 2 nan"}) {
        EXPECT_THAT(of_line(face), HasSubstr("line 6 is a face of what are no whole")) << face;
    }
    EXPECT_THAT(of_line("f 1/1/1 2/1/1/1 3/1/1"), HasSubstr("more than three numbers"));
    EXPECT_THAT(of_line("f 1 2 3\nv 1 2"), HasSubstr("line 7 is a vertex of fewer"));
    EXPECT_THAT(of_line("v 1 2 1e39"), HasSubstr("no finite number"));
    EXPECT_THAT(of_line("v 1 2 3 0"), HasSubstr("at infinity"));
    EXPECT_THAT(of_line("f"), HasSubstr("without vertices"));
    EXPECT_THAT(fault(".obj", kCorners), HasSubstr("has no faces"));
}

TEST(MeshContents, ObjVerticesMayBeHomogeneousOrColoured) {
    const Mesh mesh = parse_mesh(
        "v 0 0 0 .5 .5 .5\nv 4 0 0 2\nv 0 1 0\nvt .5\nvt .25 .75 0\n"
        "f 1/1 2/2 3/1\n",
        {.path = "m.obj"});
    EXPECT_NEAR(testing::area_mm2(mesh), 1, 1e-6);
    ASSERT_EQ(mesh.uv.size(), 3u);
    EXPECT_EQ(mesh.uv[1].y, 0.75f);
}

// Corners without a normal among those with one: made, not taken for straight up.
TEST(MeshContents, NormalsThatSomeCornersLackAreMade) {
    const Mesh mesh = parse_mesh(
        "v 0 0 0\nv 0 1 0\nv 0 0 1\nv 0 1 1\nvn .6 .8 0\n"
        "f 1//1 2//1 3//1\nf 2 4 3\n",
        {.path = "m.obj"});
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_NEAR(mesh.normals[mesh.triangles[0][0]].y, 0.8, 1e-6);
    EXPECT_NEAR(mesh.normals[mesh.triangles[1][1]].x, 1, 1e-6);
}

// Both once took a time that goes with the square of their number, or its cube.
TEST(MeshContents, ManyTrianglesInOnePlaceAndManyMaterialsAreRead) {
    constexpr int kMany = 200'000;
    std::string same = kCorners, materials = kCorners;
    for (int i = 0; i < kMany; ++i) {
        same += "f 1 2 3\n";
        materials += fmt::format("usemtl m{}\nf 1 2 3\n", i % 1000);
    }
    EXPECT_EQ(parse_mesh(same, {.path = "m.obj"}).positions_mm.size(), 3u);
    EXPECT_EQ(parse_mesh(materials, {.path = "m.obj"}).triangles.size(), std::size_t{kMany});
    std::string too_many = kCorners, corners = kCorners + "f";
    for (std::size_t i = 0; i <= kMaxMeshMaterials; ++i) {
        too_many += fmt::format("usemtl m{}\nf 1 2 3\n", i);
    }
    for (unsigned i = 0; i <= kMaxFaceCorners; ++i) corners += " 1";
    EXPECT_THAT(fault(".obj", too_many), HasSubstr("more than 10000 materials"));
    EXPECT_THAT(fault(".obj", corners), HasSubstr("2001 corners; at most 2000"));
}

TEST(MeshContents, PlyFacesNeedVertices) {
    const std::string head =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n2 0 0\n0 1 0\n";
    EXPECT_EQ(fault(".ply", head + "3 0 1 2\n3 2 1 0\n"), "accepted");
    EXPECT_THAT(fault(".ply", head + "0\n3 0 1 2\n"), HasSubstr("face 0 has no vertices"));
    EXPECT_THAT(fault(".ply", head + "3 0 1 2\n3 0 1 7\n"), HasSubstr("vertex 7 of 3"));
    EXPECT_THAT(fault(".PLY", "solid"), HasSubstr("does not begin with 'ply'"));
}

TEST(MeshContents, BinaryPlyIsFollowedFromListToList) {
    const std::string head =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
        "property float y\nproperty float z\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n";
    const float corners[9] = {0, 0, 0, 2, 0, 0, 0, 1, 0};
    const int indices[3] = {0, 1, 2};
    std::string body(reinterpret_cast<const char*>(corners), sizeof corners);
    body += '\3';
    body.append(reinterpret_cast<const char*>(indices), sizeof indices);
    EXPECT_EQ(fault(".ply", head + body), "accepted");
    EXPECT_THAT(fault(".ply", head + body.substr(0, body.size() - 1)), HasSubstr("cut short"));
    body[sizeof corners] = '\xff';  // a face of 255 vertices
    EXPECT_THAT(fault(".ply", head + body), HasSubstr("cut short"));
    EXPECT_THAT(fault(".ply", "ply\nformat ascii 1.0\nelement a 1e18\nend_header\n"),
                HasSubstr("without properties"));
}

TEST(MeshContents, PlyMayHaveNormalsTexturesAndStrips) {
    const std::string head =
        "ply\r\nformat ascii 1.0\r\ncomment any\r\nelement material 1\nproperty list uchar int a\n"
        "element vertex 4\nproperty uchar red\nproperty double z\nproperty float x\n"
        "property float y\nproperty float nz\nproperty float ny\nproperty float nx\n"
        "property float s\nproperty float t\n";
    const std::string vertices =
        "end_header\n2 7 8\n"
        "9 5 0 0 0 2 0 .5 0\n9 5 1 0 0 2 0 .5 .25\n"
        "9 5 0 1 0 2 0 .5 .5\n9 5 1 1 0 2 0 .5 .75\n";
    const auto read = [](const std::string& text) { return parse_mesh(text, {.path = "m.ply"}); };
    const Mesh strip = read(head + "element tristrips 1\nproperty list int int vertex_indices\n" +
                            vertices + "8 0 1 2 3 -1 0 1 3\n");
    EXPECT_EQ(strip.triangles.size(), 3u);
    ASSERT_EQ(strip.positions_mm.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(strip.positions_mm[i].z, 5);
        EXPECT_EQ(strip.normals[i], (Vec3f{0, 1, 0}));
        EXPECT_EQ(strip.uv[i].x, 0.5f);
    }
    for (const auto& t : strip.triangles) {  // all turned alike
        const Vec3f a = strip.positions_mm[t[0]];
        EXPECT_GT(cross(strip.positions_mm[t[1]] - a, strip.positions_mm[t[2]] - a).z, 0);
    }
    const Mesh laid_out = read(head +
                               "element face 1\nproperty list uchar int vertex_index\n"
                               "property list uchar float texcoord\nproperty int flags\n" +
                               vertices + "3 0 1 2 6 .1 .2 .3 .4 .5 .6 0\n");
    EXPECT_EQ(laid_out.uv[1].y, 0.4f);
}

TEST(MeshContents, PlyFacesComeAfterTheirVertices) {
    const std::string head = "ply\nformat ascii 1.0\n", face = "element face 1\n";
    EXPECT_THAT(
        fault(".ply", head + face + "property list uchar int vertex_index\nend_header\n3 0 1 2\n"),
        HasSubstr("names vertex 0 of 0"));
    EXPECT_THAT(fault(".ply", head + face + "property int a\nend_header\n3\n"),
                HasSubstr("faces without vertex_indices"));
    EXPECT_THAT(fault(".ply", head + "element vertex 1\nproperty float x\nend_header\n3\n"),
                HasSubstr("without x, y and z"));
    EXPECT_THAT(fault(".ply", head + "element a 1\nproperty list float int b\nend_header\n3\n"),
                HasSubstr("length is no integer"));
    EXPECT_THAT(fault(".ply", head + "element a 1\nproperty int b\nend_header\nx\n"),
                HasSubstr("no number at byte"));
}

TEST(MeshContents, StlIsTextOrBinary) {
    const std::string text =
        "solid solid facet\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n"
        "   vertex 2 0 0\n   vertex 0 1 0\n  endloop\n endfacet\nendsolid solid facet\n";
    const Mesh mesh = parse_mesh(text, {.path = "m.stl"});
    EXPECT_NEAR(testing::area_mm2(mesh), 1, 1e-6);
    EXPECT_EQ(mesh.normals[0], (Vec3f{0, 0, 1}));
    std::string capitals = text;
    for (char& c : capitals) c = static_cast<char>(std::toupper(c));
    EXPECT_EQ(parse_mesh(capitals, {.path = "m.stl"}).positions_mm, mesh.positions_mm);
    std::string binary = "solid" + std::string(75, ' ') + std::string("\1\0\0\0", 4);
    const float facet[12] = {0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 1, 0};  // without a normal
    binary.append(reinterpret_cast<const char*>(facet), sizeof facet);
    binary.append(2, '\0');
    EXPECT_EQ(parse_mesh(binary, {.path = "m.stl"}).normals[0], (Vec3f{0, 0, 1}));
    binary.front() = 'x';
    EXPECT_THAT(fault(".stl", binary.substr(0, binary.size() - 1)),
                HasSubstr("cut short: 1 facets"));
    EXPECT_THAT(fault(".stl", "root"), HasSubstr("is no STL"));
    EXPECT_THAT(fault(".stl", text.substr(0, text.find("endloop"))), HasSubstr("cut short"));
    EXPECT_THAT(fault(".stl", "solid\nvertex 0 0 0"), HasSubstr("line 2 has a vertex outside"));
    EXPECT_THAT(fault(".stl", "solid\nfacet normal 0 0 x"),
                HasSubstr("line 2 has a number that is none"));
    EXPECT_THAT(fault(".stl", "solid\nfacets"), HasSubstr("an unknown word"));
}

TEST(MeshContents, NodesOfAGltfAreTreesOfLimitedDepthAndSize) {
    EXPECT_EQ(fault(".gltf", gltf_with_nodes({{{"mesh", 0}}})), "accepted");
    EXPECT_EQ(fault(".gltf", gltf_with_nodes({{{"children", {1}}}, {{"mesh", 0}}})), "accepted");

    json chain = json::array(), doubled = json::array();
    constexpr int kNodes = 20'000, kDoublings = 27;
    for (int i = 1; i < kNodes; ++i) chain.push_back({{"children", {i}}});
    chain.push_back({{"mesh", 0}});
    for (int i = 1; i < kDoublings; ++i) doubled.push_back({{"children", {i, i}}});
    doubled.push_back({{"mesh", 0}});
    EXPECT_THAT(fault(".gltf", gltf_with_nodes(chain)), HasSubstr("nodes more than 256 deep"));
    EXPECT_THAT(fault(".gltf", gltf_with_nodes(doubled)), HasSubstr("two parents"));
    EXPECT_THAT(fault(".gltf", gltf_with_nodes({{{"mesh", 0}}}, {0, 0})), HasSubstr("shown twice"));
    EXPECT_THAT(fault(".gltf", gltf_with_nodes({{{"mesh", 0}}, {{"children", {1}}}})),
                HasSubstr("its own descendant"));
    EXPECT_THAT(fault(".gltf", gltf_with_nodes({{{"mesh", 5}}})), HasSubstr("a mesh that it does"));
    const json many(kMaxMeshNodes + 1, json::object());
    EXPECT_THAT(fault(".gltf", gltf_with_nodes(many)), HasSubstr("100001 nodes"));
}

TEST(MeshContents, GltfCountsAndNestingAreBounded) {
    json whole = json::parse(kGltf);
    whole["accessors"][0]["count"] = 4e9;
    EXPECT_THAT(fault(".gltf", whole.dump()), HasSubstr("vertices and indices"));
    // A mesh of a million vertices on each of a hundred nodes.
    whole["accessors"][0]["count"] = 1'000'000;
    whole["nodes"] = json(100, {{"mesh", 0}});
    EXPECT_THAT(fault(".gltf", whole.dump()), HasSubstr("counted for each node"));

    constexpr std::size_t kDeep = 200'000;
    EXPECT_THAT(fault(".gltf", R"({"asset":{"version":"2.0"},"extras":)" + std::string(kDeep, '[') +
                                   std::string(kDeep, ']') + "}"),
                HasSubstr("nested more than 64 deep"));
    whole = json::parse(kGltf);
    whole["asset"]["version"] = "1.0";
    EXPECT_THAT(fault(".gltf", whole.dump()), HasSubstr("is glTF 1.0; 2 is read"));
    whole = json::parse(kGltf);
    whole["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    EXPECT_THAT(fault(".gltf", whole.dump()), HasSubstr("KHR_draco_mesh_compression"));
}

/// Four bytes, the lowest first.
std::string word(std::uint32_t number) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xff);
    return bytes;
}

TEST(MeshContents, GlbIsReadAsFarAsItsChunksGo) {
    json whole = json::parse(kGltf);
    const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::string buffer(reinterpret_cast<const char*>(corners), sizeof corners);
    whole["buffers"] = {{{"byteLength", buffer.size()}}};
    std::string text = whole.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const auto length = static_cast<std::uint32_t>(28 + text.size() + buffer.size());
    const auto glb = [&](std::uint32_t claimed, std::uint32_t claimed_text) {
        return "glTF" + word(2) + word(claimed) + word(claimed_text) + "JSON" + text +
               word(static_cast<std::uint32_t>(buffer.size())) + std::string("BIN\0", 4) + buffer;
    };
    const auto text_size = static_cast<std::uint32_t>(text.size());
    EXPECT_NEAR(testing::area_mm2(parse_mesh(glb(length, text_size),
                                             MeshFile{.path = "m.glb", .mm_per_unit = 1})),
                0.5, 1e-6);
    EXPECT_THAT(fault(".glb", glb(0xfffffff0, text_size)), HasSubstr("4294967280 bytes"));
    EXPECT_THAT(fault(".glb", glb(length, 0xffffff00)), HasSubstr("a chunk is longer"));
    EXPECT_THAT(fault(".glb", text), HasSubstr("does not begin with 'glTF'"));
}

// Neither what lies outside the mesh's folder, nor a pipe on which the program would wait.
TEST_F(MeshFileTest, BuffersComeFromItsFolderOnly) {
    namespace fs = std::filesystem;
    const fs::path folder = folder_, inside = folder / "model";
    fs::create_directory(inside);
    const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    for (const char* name : {"out.bin", "model/in.bin"}) {
        write(name, std::string(reinterpret_cast<const char*>(corners), sizeof corners));
    }
    fs::create_symlink("../out.bin", inside / "link.bin");
    ASSERT_EQ(::mkfifo((inside / "pipe.bin").c_str(), 0600), 0);
    const auto with_buffer = [&](const std::string& uri) {
        json whole = json::parse(kGltf);
        whole["buffers"][0]["uri"] = uri;
        return refusal(write("model/mesh.gltf", whole.dump()));
    };
    EXPECT_EQ(with_buffer("in.bin"), "accepted");
    EXPECT_THAT(with_buffer("../out.bin"), HasSubstr("outside the folder"));
    EXPECT_THAT(with_buffer((folder / "out.bin").string()), HasSubstr("outside the folder"));
    EXPECT_THAT(with_buffer("link.bin"), HasSubstr("outside the folder"));
    EXPECT_THAT(with_buffer("pipe.bin"), HasSubstr("is a pipe"));
    EXPECT_THAT(with_buffer("absent.bin"), HasSubstr("absent.bin"));
}

}  // namespace
}  // namespace nacre::render
