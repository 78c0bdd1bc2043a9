#include "nacre/render/obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "nacre/core/text.h"
#include "nacre/render/mesh_fault.h"
#include "nacre/render/mesh_file.h"

namespace nacre::render {
namespace {

class PlainObj {
 public:
    explicit PlainObj(std::string_view text) : rest_(text) {}

    std::string text() {
        while (next_line()) read_line();
        if (faces_.empty()) throw MeshFault("has no faces");
        for (int kind = 0; kind < 3; ++kind) {
            if (highest_[kind].number > counts_[kind]) refuse_number(highest_[kind].line, kind);
        }
        std::string out = std::move(vertices_);
        // Those without a material come first, before any is named.
        for (const auto& [material, faces] : faces_) {
            if (!material.empty()) out += fmt::format("usemtl {}\n", material);
            out += faces;
        }
        return out;
    }

 private:
    /// A corner of a face: numbers of a position, a texture coordinate and a normal, from 1; 0: none.
    using Corner = std::array<std::size_t, 3>;

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
            constexpr std::size_t kLongestName = 1000;
            material_ = excerpt(trimmed(line_), kLongestName);
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
        std::size_t count = 0;
        for (std::string_view word = take_word(); !word.empty() && count < numbers.size();
             word = take_word()) {
            const auto number = parse_number(word);
            constexpr double kLargest = std::numeric_limits<float>::max();
            if (!number || std::abs(*number) > kLargest) refuse("has what is no finite number");
            numbers[count++] = *number;
        }
        return count;
    }

    void read_position() {
        std::array<double, 7> x{};
        const std::size_t count = take_numbers(x);
        if (count < 3) refuse("is a vertex of fewer than three coordinates");
        const double w = count == 4 ? x[3] : 1;  // homogeneous; of six or seven the others are colours
        if (!(std::abs(x[0] / w) + std::abs(x[1] / w) + std::abs(x[2] / w) <=
              std::numeric_limits<float>::max())) {
            refuse("is a vertex at infinity");
        }
        write("v", {x[0] / w, x[1] / w, x[2] / w});
        ++counts_[0];
    }

    void read_texture_coordinate() {
        std::array<double, 7> x{};
        if (take_numbers(x) < 1) refuse("is a texture coordinate without numbers");
        write("vt", {x[0], x[1]});
        ++counts_[1];
    }

    void read_normal() {
        std::array<double, 7> x{};
        if (take_numbers(x) < 3) refuse("is a normal of fewer than three numbers");
        write("vn", {x[0], x[1], x[2]});
        ++counts_[2];
    }

    void write(std::string_view key, std::initializer_list<double> numbers) {
        vertices_ += key;
        for (const double x : numbers) {
            fmt::format_to(std::back_inserter(vertices_), " {}", static_cast<float>(x));
        }
        vertices_ += '\n';
    }

    /// Corners say all of a kind of number or none.
    void read_face() {
        corners_.clear();
        for (std::string_view word = take_word(); !word.empty(); word = take_word()) {
            corners_.push_back(corner(word));
        }
        if (corners_.empty()) refuse("is a face without vertices");
        if (corners_.size() < 3) return;  // a point or a line, which have no area
        std::array<bool, 3> said{true, true, true};
        for (const Corner& c : corners_) {
            for (int kind = 0; kind < 3; ++kind) said[kind] = said[kind] && c[kind] != 0;
        }
        std::string& out = faces_[material_];
        if (faces_.size() > kMaxMeshMaterials) {
            throw MeshFault(fmt::format("has more than {} materials", kMaxMeshMaterials));
        }
        out += 'f';
        for (const Corner& c : corners_) {
            out += fmt::format(" {}", c[0]);
            if (said[1] || said[2]) out += '/';
            if (said[1]) out += fmt::format("{}", c[1]);
            if (said[2]) out += fmt::format("/{}", c[2]);
        }
        out += '\n';
    }

    /// 3, 3/1, 3//2 or 3/1/2; numbers below 0 count back from the last that was read.
    Corner corner(std::string_view word) {
        Corner out{};
        for (int kind = 0; kind < 3 && !word.empty(); ++kind) {
            const std::string_view digits = word.substr(0, word.find('/'));
            word.remove_prefix(std::min(word.size(), digits.size() + 1));
            if (digits.empty() && kind > 0) continue;
            const auto number = parse_number(digits);
            if (!number || *number != std::floor(*number)) {
                refuse("is a face of what are no whole numbers");
            }
            const double at =
                *number < 0 ? static_cast<double>(counts_[kind]) + 1 + *number : *number;
            if (at < 1 || at > kLargestNumber) refuse_number(first_of_line_, kind);
            out[kind] = static_cast<std::size_t>(at);
            if (out[kind] > highest_[kind].number) highest_[kind] = {out[kind], first_of_line_};
        }
        if (!word.empty() || out[0] == 0) refuse("is a face of corners with more than three numbers");
        return out;
    }

    [[noreturn]] void refuse_number(std::size_t line, int kind) const {
        constexpr std::array kNames{"vertex", "texture coordinate", "normal"};
        throw MeshFault(fmt::format("line {} is a face that names a {} that is not there: {} are",
                                    line, kNames[kind], counts_[kind]));
    }
    [[noreturn]] void refuse(std::string_view why) const {
        throw MeshFault(fmt::format("line {} {}", first_of_line_, why));
    }

    static constexpr double kLargestNumber = std::numeric_limits<std::uint32_t>::max();
    /// Of the numbers that faces have; what they name may follow them.
    struct Highest {
        std::size_t number = 0, line = 0;
    };

    std::string_view rest_, line_;
    std::string joined_;  // a line that goes on
    std::size_t line_number_ = 0, first_of_line_ = 0;
    std::array<std::size_t, 3> counts_{};  // of positions, texture coordinates and normals so far
    std::array<Highest, 3> highest_;
    std::vector<Corner> corners_;  // of a face
    std::string material_, vertices_;
    std::map<std::string, std::string> faces_;  // by material
};

}  // namespace

std::string plain_obj(std::string_view text) { return PlainObj(text).text(); }

}  // namespace nacre::render
