#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "nacre/core/text.h"
#include "nacre/render/mesh_formats.h"

namespace nacre::render {
namespace {

// A binary file: a header of text, the number of facets, and for each twelve floats, the lowest byte first:
// its normal and its corners; and two bytes more.
constexpr std::size_t kHeader = 80, kCount = 4, kFacet = 50;

// With which a text begins. Keywords are to be in lower case, but some programs write capitals.
constexpr std::string_view kSolid = "solid";

Vec3f vector(std::string_view bytes, std::size_t at) {
    const auto number = [&](std::size_t i) {
        return std::bit_cast<float>(little_endian(bytes, at + 4 * i));
    };
    return {number(0), number(1), number(2)};
}

/// A facet whose normal and corners are the last of the mesh.
void end_facet(PolygonMesh& mesh, std::uint32_t material, std::size_t corners) {
    const auto normal = static_cast<std::uint32_t>(mesh.normals.size() - 1);
    const auto after = static_cast<std::uint32_t>(mesh.positions.size());
    for (auto i = static_cast<std::uint32_t>(after - corners); i < after; ++i) {
        mesh.corners.push_back({i, PolygonMesh::kNone, normal});
    }
    mesh.end_face(material);
}

PolygonMesh parse_binary(std::string_view bytes, std::size_t facets) {
    PolygonMesh mesh;
    const std::uint32_t material = mesh.material_of(kUnnamedMaterial);
    for (std::size_t f = 0; f < facets; ++f) {
        const std::size_t at = kHeader + kCount + f * kFacet;
        mesh.normals.push_back(vector(bytes, at));
        for (std::size_t k = 1; k <= 3; ++k) mesh.positions.push_back(vector(bytes, at + 12 * k));
        end_facet(mesh, material, 3);
    }
    return mesh;
}

class TextReader {
 public:
    explicit TextReader(std::string_view text) : text_(text) {}

    PolygonMesh read() {
        const std::uint32_t material = mesh_.material_of(kUnnamedMaterial);
        if (take_keyword() != kSolid)
            throw MeshError("is no STL: neither binary nor does it begin with 'solid'");
        position_ = text_.find('\n', position_);  // after its name
        std::size_t corners = 0;
        bool in_facet = false;
        for (std::string word = take_keyword(); !word.empty(); word = take_keyword()) {
            if (word == "facet") {
                if (take_keyword() != "normal") refuse("a facet without a normal");
                mesh_.normals.push_back(take_vector());
                corners = 0;
                in_facet = true;
            } else if (word == "vertex") {
                if (!in_facet) refuse("a vertex outside of a facet");
                mesh_.positions.push_back(take_vector());
                ++corners;
            } else if (word == "endfacet") {
                if (!in_facet) refuse("the end of no facet");
                end_facet(mesh_, material, corners);
                in_facet = false;
            } else if (word == "endsolid" || word == kSolid) {
                position_ = text_.find('\n', position_);
            } else if (word != "outer" && word != "loop" && word != "endloop") {
                refuse("an unknown word");
            }
        }
        if (in_facet) throw MeshError("is cut short");
        return std::move(mesh_);
    }

 private:
    std::string take_keyword() { return lowercase(take_word(text_, position_)); }

    Vec3f take_vector() {
        std::array<float, 3> v{};
        for (float& x : v) {
            const auto number = parse_number(take_word(text_, position_));
            x = static_cast<float>(number.value_or(NAN));
            if (!number || !std::isfinite(x)) refuse("a number that is none, or not finite");
        }
        return {v[0], v[1], v[2]};
    }

    [[noreturn]] void refuse(std::string_view what) const {
        const auto end =
            text_.begin() + static_cast<std::ptrdiff_t>(std::min(position_, text_.size()));
        throw MeshError(
            fmt::format("line {} has {}", 1 + std::count(text_.begin(), end, '\n'), what));
    }

    std::string_view text_;
    std::size_t position_ = 0;
    PolygonMesh mesh_;
};

}  // namespace

PolygonMesh parse_stl(std::string_view bytes) {
    // Binary files may begin with 'solid' as well: their length tells.
    if (bytes.size() >= kHeader + kCount) {
        const std::size_t facets = little_endian(bytes, kHeader),
                          there = bytes.size() - kHeader - kCount;
        if (facets * kFacet == there) return parse_binary(bytes, facets);
        if (lowercase(bytes.substr(0, kSolid.size())) != kSolid) {
            if (facets * kFacet > there) {
                throw MeshError(fmt::format("is cut short: {} facets take {} bytes, there are {}",
                                            facets, facets * kFacet, there));
            }
            return parse_binary(bytes, facets);
        }
    }
    return TextReader(bytes).read();
}

}  // namespace nacre::render
