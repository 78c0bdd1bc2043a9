#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "nacre/core/text.h"
#include "nacre/render/mesh_formats.h"

namespace nacre::render {
namespace {

class PlyReader {
 public:
    explicit PlyReader(std::string_view bytes) : bytes_(bytes) {}

    PolygonMesh read() {
        read_header();
        check_size();
        for (const Element& element : elements_) {
            if (element.name == "vertex" && mesh_.positions.empty()) {
                read_vertices(element);
            } else if (element.name == "face" || element.name == "tristrips") {
                read_faces(element);
            } else {
                for (double i = 0; i < element.count; ++i) pass_over(element);
            }
        }
        if (mesh_.end.empty()) throw MeshError("has no faces");
        return std::move(mesh_);
    }

 private:
    enum class Kind { integer, natural, real };
    struct Scalar {
        Kind kind = Kind::integer;
        std::size_t size = 0;  ///< bytes, in a binary file
    };
    struct Property {
        std::string_view name;
        bool list = false;
        Scalar length;  ///< of a list
        Scalar value;
    };
    struct Element {
        std::string_view name;
        double count = 0;  // a double: counts may overflow integers
        std::vector<Property> properties;
    };

    static Scalar scalar(std::string_view type, int line) {
        constexpr auto integer = Kind::integer, natural = Kind::natural, real = Kind::real;
        static const std::map<std::string_view, Scalar> kScalars{
            {"char", {integer, 1}},  {"uchar", {natural, 1}},  {"int8", {integer, 1}},
            {"uint8", {natural, 1}}, {"short", {integer, 2}},  {"ushort", {natural, 2}},
            {"int16", {integer, 2}}, {"uint16", {natural, 2}}, {"int", {integer, 4}},
            {"uint", {natural, 4}},  {"int32", {integer, 4}},  {"uint32", {natural, 4}},
            {"float", {real, 4}},    {"float32", {real, 4}},   {"double", {real, 8}},
            {"float64", {real, 8}}};
        const auto found = kScalars.find(type);
        if (found == kScalars.end()) {
            throw MeshError(fmt::format("line {}: unknown type '{}'", line, excerpt(type)));
        }
        return found->second;
    }

    void read_header() {
        constexpr int kMaxHeaderLines = 1000;
        for (int line = 1; line <= kMaxHeaderLines && position_ < bytes_.size(); ++line) {
            const std::string_view rest = bytes_.substr(position_);
            const std::string_view text = rest.substr(0, rest.find('\n'));
            position_ += std::min(text.size() + 1, rest.size());
            const std::vector<std::string_view> word = words(text);
            if (line == 1 && (word.empty() || word[0] != "ply")) {
                throw MeshError("line 1: does not begin with 'ply'");
            }
            if (word.empty()) continue;
            if (word[0] == "end_header") return;
            if (word[0] == "format" && word.size() > 1) {
                binary_ = word[1] != "ascii";
                big_endian_ = word[1] == "binary_big_endian";
            }
            if (word[0] == "element") {
                const auto count = word.size() > 2 ? parse_number(word[2]) : std::nullopt;
                if (!count || *count < 0) {
                    throw MeshError(fmt::format("line {}: '{}' is not 'element NAME COUNT'", line,
                                                excerpt(text)));
                }
                elements_.push_back({word[1], *count, {}});
            }
            if (word[0] == "property" && !elements_.empty()) {
                elements_.back().properties.push_back(property_of(word, line));
            }
        }
        throw MeshError("has no end_header");
    }

    static Property property_of(const std::vector<std::string_view>& word, int line) {
        const auto at = [&](std::size_t i) {
            return i < word.size() ? word[i] : std::string_view();
        };
        if (at(1) != "list") return {at(2), false, {}, scalar(at(1), line)};
        const Scalar length = scalar(at(2), line);
        if (length.kind == Kind::real) throw MeshError("has a list whose length is no integer");
        return {at(4), true, length, scalar(at(3), line)};
    }

    [[noreturn]] static void refuse_short(double wanted, std::size_t there) {
        throw MeshError(
            fmt::format("is cut short: its header asks for at least {:.0f} bytes of data, "
                        "there are {}",
                        wanted, there));
    }

    /// A file must be as long as its counts ask for at least, before anything is made of their size.
    void check_size() const {
        double least = 0;
        for (const Element& element : elements_) {
            double one = 0;
            for (const Property& p : element.properties) {
                const std::size_t size = p.list ? p.length.size : p.value.size;
                one += binary_ ? static_cast<double>(size) : 2;  // of text, a digit and a space
            }
            if (one == 0 && element.count > 0) throw MeshError("has an element without properties");
            least += element.count * one;
        }
        // The last of a text may do without its space.
        const std::size_t there = bytes_.size() - position_;
        if (least > static_cast<double>(there) + (binary_ ? 0 : 1)) refuse_short(least, there);
    }

    double take(Scalar scalar) { return binary_ ? take_binary(scalar) : take_text(); }

    double take_text() {
        const std::string_view word = take_word(bytes_, position_);
        if (word.empty()) throw MeshError("is cut short");
        const auto number = parse_number(word);
        if (!number)
            throw MeshError(
                fmt::format("has what is no number at byte {}", position_ - word.size()));
        return *number;
    }

    double take_binary(Scalar scalar) {
        if (scalar.size > bytes_.size() - position_) throw MeshError("is cut short");
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < scalar.size; ++i) {
            const std::size_t at = big_endian_ ? i : scalar.size - 1 - i;
            bits = bits << 8 | static_cast<unsigned char>(bytes_[position_ + at]);
        }
        position_ += scalar.size;
        if (scalar.kind == Kind::natural) return static_cast<double>(bits);
        if (scalar.kind == Kind::real) {
            return scalar.size == 8 ? std::bit_cast<double>(bits)
                                    : std::bit_cast<float>(static_cast<std::uint32_t>(bits));
        }
        const std::size_t unused = 64 - 8 * scalar.size;
        return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
    }

    std::size_t take_length(const Property& list) {
        const double length = take(list.length);
        if (!(length >= 0) || length != std::floor(length)) {
            throw MeshError("has a list whose length is no count");
        }
        const std::size_t size = binary_ ? list.value.size : 2;
        if (length * static_cast<double>(size) >
            static_cast<double>(bytes_.size() - position_) + 1) {
            throw MeshError("is cut short");
        }
        return static_cast<std::size_t>(length);
    }

    void take_list(const Property& list, std::vector<double>& values) {
        values.resize(take_length(list));
        for (double& value : values) value = take(list.value);
    }

    void pass_over(const Element& element) {
        for (const Property& p : element.properties) {
            p.list ? take_list(p, passed_over_) : static_cast<void>(take(p.value));
        }
    }

    void read_vertices(const Element& element) {
        std::vector<int> place;  // of each property among those below; -1: none
        constexpr int kPlaces = 8;
        for (const Property& p : element.properties) {
            static const std::map<std::string_view, int> kNames{
                {"x", 0}, {"y", 1}, {"z", 2}, {"nx", 3}, {"ny", 4},        {"nz", 5},
                {"s", 6}, {"t", 7}, {"u", 6}, {"v", 7},  {"texture_u", 6}, {"texture_v", 7}};
            const auto found = kNames.find(p.name);
            place.push_back(p.list || found == kNames.end() ? -1 : found->second);
        }
        const auto has = [&](int first, int last) {
            for (int i = first; i <= last; ++i) {
                if (std::find(place.begin(), place.end(), i) == place.end()) return false;
            }
            return true;
        };
        if (!has(0, 2)) throw MeshError("has vertices without x, y and z");
        has_normals_ = has(3, 5);
        has_uv_ = has(6, 7);
        for (double i = 0; i < element.count; ++i) {
            std::array<float, kPlaces> values{};
            for (std::size_t k = 0; k < place.size(); ++k) {
                const Property& p = element.properties[k];
                if (p.list) {
                    take_list(p, passed_over_);
                    continue;
                }
                const double value = take(p.value);
                if (place[k] >= 0) values[static_cast<std::size_t>(place[k])] = to_float(value);
            }
            mesh_.positions.push_back({values[0], values[1], values[2]});
            if (has_normals_) mesh_.normals.push_back({values[3], values[4], values[5]});
            if (has_uv_) mesh_.uv.push_back({values[6], values[7]});
        }
    }

    /// Infinite where a float cannot hold it, which is found later.
    static float to_float(double x) {
        const double largest = std::numeric_limits<float>::max();
        if (x > largest) return std::numeric_limits<float>::infinity();
        if (x < -largest) return -std::numeric_limits<float>::infinity();
        return static_cast<float>(x);
    }

    void read_faces(const Element& element) {
        const bool strips = element.name == "tristrips";
        const std::uint32_t material = mesh_.material_of(kUnnamedMaterial);
        std::vector<double> numbers, uv;
        for (double i = 0; i < element.count; ++i) {
            numbers.clear();
            uv.clear();
            bool has_numbers = false;
            for (const Property& p : element.properties) {
                if (!p.list) {
                    take(p.value);
                } else if (p.name == "vertex_indices" || p.name == "vertex_index") {
                    take_list(p, numbers);
                    has_numbers = true;
                } else {
                    take_list(p, p.name == "texcoord" ? uv : passed_over_);
                }
            }
            if (!has_numbers) throw MeshError("has faces without vertex_indices");
            strips ? add_strips(numbers, material) : add_face(numbers, uv, material);
        }
    }

    void add_face(const std::vector<double>& numbers, const std::vector<double>& uv,
                  std::uint32_t material) {
        const std::size_t face = mesh_.end.size();
        if (numbers.empty()) throw MeshError(fmt::format("face {} has no vertices", face));
        const bool laid_out = uv.size() == 2 * numbers.size();
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            PolygonMesh::Corner corner = corner_of(numbers[k]);
            if (laid_out) {
                corner.uv = static_cast<std::uint32_t>(mesh_.uv.size());
                mesh_.uv.push_back({to_float(uv[2 * k]), to_float(uv[2 * k + 1])});
            }
            mesh_.corners.push_back(corner);
        }
        mesh_.end_face(material);
    }

    PolygonMesh::Corner corner_of(double number) const {
        if (!(number >= 0 && number < static_cast<double>(mesh_.positions.size())) ||
            number != std::floor(number)) {
            throw MeshError(fmt::format("face {} names vertex {} of {}", mesh_.end.size(), number,
                                        mesh_.positions.size()));
        }
        const auto i = static_cast<std::uint32_t>(number);
        return {i, has_uv_ ? i : PolygonMesh::kNone, has_normals_ ? i : PolygonMesh::kNone};
    }

    /// Every vertex makes a triangle with the two before it, turned the other way every other time; -1
    /// begins anew.
    void add_strips(const std::vector<double>& numbers, std::uint32_t material) {
        std::size_t first = 0;
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            if (numbers[k] == -1) {
                first = k + 1;
            } else if (k >= first + 2) {
                const bool turned = (k - first) % 2 != 0;
                for (const std::size_t i : {turned ? k - 1 : k - 2, turned ? k - 2 : k - 1, k}) {
                    mesh_.corners.push_back(corner_of(numbers[i]));
                }
                mesh_.end_face(material);
            }
        }
    }

    std::string_view bytes_;
    std::size_t position_ = 0;
    bool binary_ = false, big_endian_ = false;
    std::vector<Element> elements_;
    std::vector<double> passed_over_;
    bool has_normals_ = false, has_uv_ = false;  // vertices
    PolygonMesh mesh_;
};

}  // namespace

PolygonMesh parse_ply(std::string_view bytes) { return PlyReader(bytes).read(); }

}  // namespace nacre::render
