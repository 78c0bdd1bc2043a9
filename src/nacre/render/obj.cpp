#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "nacre/core/text.h"
#include "nacre/render/mesh_formats.h"

namespace nacre::render {
namespace {

class ObjReader {
 public:
    explicit ObjReader(std::string_view text) : rest_(text) {}

    PolygonMesh read() {
        while (next_line()) read_line();
        if (mesh_.end.empty()) throw MeshError("has no faces");
        for (int kind = 0; kind < 3; ++kind) {
            if (highest_[kind].number > count(kind)) refuse_number(highest_[kind].line, kind);
        }
        return std::move(mesh_);
    }

 private:
    /// A line that ends in a backslash goes on in the next.
    bool next_line() {
        if (rest_.empty()) return false;
        joined_.clear();
        first_of_line_ = line_number_ + 1;
        while (true) {
            const auto end = rest_.find('\n');
            std::string_view piece = trimmed(rest_.substr(0, end));
            rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
            ++line_number_;
            const bool goes_on = piece.ends_with('\\');
            if (goes_on) piece.remove_suffix(1);
            if (joined_.empty() && !goes_on) {
                line_ = piece;
                return true;
            }
            joined_ += piece;
            joined_ += ' ';
            if (!goes_on || rest_.empty()) {
                line_ = joined_;
                return true;
            }
        }
    }

    void read_line() {
        const std::string_view key = take_word();
        if (key == "v") {
            read_position();
        } else if (key == "vt") {
            read_texture_coordinate();
        } else if (key == "vn") {
            read_normal();
        } else if (key == "f") {
            read_face();
        } else if (key == "usemtl") {
            material_name_ = trimmed(line_);
            material_ = PolygonMesh::kNone;
        }
    }

    /// Of the line; empty at its end, and at a comment.
    std::string_view take_word() {
        line_ = trimmed(line_);
        if (line_.starts_with('#')) line_ = {};
        const std::string_view word = line_.substr(0, line_.find_first_of(" \t"));
        line_.remove_prefix(word.size());
        return word;
    }

    /// The numbers of the line, at most seven: what follows them is of no use.
    /// @return how many
    std::size_t take_numbers(std::array<double, 7>& numbers) {
        std::size_t taken = 0;
        while (taken < numbers.size()) {
            const std::string_view word = take_word();
            if (word.empty()) break;
            const auto number = parse_number(word);
            constexpr double kLargest = std::numeric_limits<float>::max();
            if (!number || std::abs(*number) > kLargest) refuse("has what is no finite number");
            numbers[taken++] = *number;
        }
        return taken;
    }

    static Vec3f vec(double x, double y, double z) {
        return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
    }

    void read_position() {
        std::array<double, 7> x{};
        const std::size_t taken = take_numbers(x);
        if (taken < 3) refuse("is a vertex of fewer than three coordinates");
        const double w =
            taken == 4 ? x[3] : 1;  // homogeneous; of six or seven the others are colours
        const Vec3f position = vec(x[0] / w, x[1] / w, x[2] / w);
        if (!std::isfinite(dot(position, Vec3f{0, 0, 0}))) refuse("is a vertex at infinity");
        mesh_.positions.push_back(position);
    }

    void read_texture_coordinate() {
        std::array<double, 7> x{};
        if (take_numbers(x) < 1) refuse("is a texture coordinate without numbers");
        mesh_.uv.push_back({static_cast<float>(x[0]), static_cast<float>(x[1])});
    }

    void read_normal() {
        std::array<double, 7> x{};
        if (take_numbers(x) < 3) refuse("is a normal of fewer than three numbers");
        mesh_.normals.push_back(vec(x[0], x[1], x[2]));
    }

    void read_face() {
        const std::size_t first = mesh_.corners.size();
        for (std::string_view word = take_word(); !word.empty(); word = take_word()) {
            mesh_.corners.push_back(corner(word));
        }
        if (mesh_.corners.size() == first) refuse("is a face without vertices");
        mesh_.end_face(material());
    }

    /// Of the faces that follow, which need not be any.
    std::uint32_t material() {
        if (material_ == PolygonMesh::kNone) material_ = mesh_.material_of(material_name_);
        return material_;
    }

    /// 3, 3/1, 3//2 or 3/1/2; numbers below 0 count back from the last that was read.
    PolygonMesh::Corner corner(std::string_view word) {
        std::array<std::uint32_t, 3> out{PolygonMesh::kNone, PolygonMesh::kNone,
                                         PolygonMesh::kNone};
        for (int kind = 0; kind < 3 && !word.empty(); ++kind) {
            const std::string_view digits = word.substr(0, word.find('/'));
            word.remove_prefix(std::min(word.size(), digits.size() + 1));
            if (digits.empty() && kind > 0) continue;
            const auto number = parse_number(digits);
            if (!number || *number != std::floor(*number)) {
                refuse("is a face of what are no whole numbers");
            }
            const double at =
                *number < 0 ? static_cast<double>(count(kind)) + 1 + *number : *number;
            if (at < 1 || at >= PolygonMesh::kNone) refuse_number(first_of_line_, kind);
            const auto whole = static_cast<std::uint32_t>(at);
            if (whole > highest_[kind].number) highest_[kind] = {whole, first_of_line_};
            out[kind] = whole - 1;
        }
        if (!word.empty()) refuse("is a face of corners with more than three numbers");
        return {out[0], out[1], out[2]};
    }

    /// Of positions, texture coordinates and normals so far.
    std::size_t count(int kind) const {
        return kind == 0   ? mesh_.positions.size()
               : kind == 1 ? mesh_.uv.size()
                           : mesh_.normals.size();
    }

    [[noreturn]] void refuse_number(std::size_t line, int kind) const {
        constexpr std::array kNames{"vertex", "texture coordinate", "normal"};
        throw MeshError(fmt::format("line {} is a face that names a {} that is not there: {} are",
                                    line, kNames[kind], count(kind)));
    }
    [[noreturn]] void refuse(std::string_view why) const {
        throw MeshError(fmt::format("line {} {}", first_of_line_, why));
    }

    /// Of the numbers that faces have; what they name may follow them.
    struct Highest {
        std::size_t number = 0, line = 0;
    };

    PolygonMesh mesh_;
    std::string_view rest_, line_;
    std::string joined_;  // a line that goes on
    std::size_t line_number_ = 0, first_of_line_ = 0;
    std::array<Highest, 3> highest_;
    std::string material_name_ = kUnnamedMaterial;
    std::uint32_t material_ = PolygonMesh::kNone;  // its number, when it has one
};

}  // namespace

PolygonMesh parse_obj(std::string_view text) { return ObjReader(text).read(); }

}  // namespace nacre::render
