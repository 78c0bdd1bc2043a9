#include "nacre/render/ply.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "nacre/core/text.h"
#include "nacre/render/mesh_fault.h"

namespace nacre::render {
namespace {

class PlyCheck {
 public:
    explicit PlyCheck(std::string_view bytes) : bytes_(bytes) {}

    void run() {
        read_header();
        binary_ ? check_binary() : check_text();
    }

 private:
    struct Property {
        bool list = false;
        int length_size = 0;  ///< bytes of a list's length
        int size = 0;         ///< bytes of a value
    };
    struct Element {
        double count = 0;  // a double: counts may overflow integers
        std::vector<Property> properties;
    };

    /// Bytes of a scalar in a binary file.
    static int scalar_size(std::string_view type, int line) {
        static const std::map<std::string_view, int> kSizes{
            {"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2}, {"ushort", 2},
            {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4}, {"uint32", 4},
            {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
        const auto found = kSizes.find(type);
        if (found == kSizes.end()) {
            throw MeshFault(fmt::format("line {}: unknown type '{}'", line, excerpt(type)));
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
                throw MeshFault("line 1: does not begin with 'ply'");
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
                    throw MeshFault(fmt::format("line {}: '{}' is not 'element NAME COUNT'", line,
                                                excerpt(text)));
                }
                elements_.push_back({*count, {}});
            }
            if (word[0] == "property" && !elements_.empty()) {
                elements_.back().properties.push_back(property_of(word, line));
            }
        }
        throw MeshFault("has no end_header");
    }

    static Property property_of(const std::vector<std::string_view>& word, int line) {
        const auto type = [&](std::size_t i) {
            return scalar_size(i < word.size() ? word[i] : std::string_view(), line);
        };
        if (word.size() > 1 && word[1] == "list") return {true, type(2), type(3)};
        return {false, 0, type(1)};
    }

    [[noreturn]] static void refuse_short(double wanted, std::size_t there) {
        throw MeshFault(
            fmt::format("is cut short: its header asks for at least {:.0f} bytes of data, "
                        "there are {}",
                        wanted, there));
    }

    /// The least bytes of all elements, a value taking `text_size` where the file is text.
    double least_bytes(int text_size) const {
        double least = 0;
        for (const Element& element : elements_) {
            double one = 0;
            for (const Property& p : element.properties) {
                one += binary_ ? (p.list ? p.length_size : p.size) : text_size;
            }
            if (one == 0 && element.count > 0) throw MeshFault("has an element without properties");
            least += element.count * one;
        }
        return least;
    }

    void check_text() const {
        // One digit and one space a value; the last may do without its space.
        const double least = least_bytes(2);
        const std::size_t there = bytes_.size() - position_;
        if (least > static_cast<double>(there) + 1) refuse_short(least, there);
    }

    /// Goes from list to list.
    void check_binary() {
        const std::size_t there = bytes_.size() - position_;
        const double least = least_bytes(0);
        if (least > static_cast<double>(there)) refuse_short(least, there);
        for (const Element& element : elements_) {
            for (double i = 0; i < element.count; ++i) {
                for (const Property& p : element.properties) {
                    const std::size_t size =
                        p.list ? list_bytes(p) : static_cast<std::size_t>(p.size);
                    if (size > bytes_.size() - position_) throw MeshFault("is cut short");
                    position_ += size;
                }
            }
        }
    }

    /// Of the list that starts here.
    std::size_t list_bytes(const Property& list) const {
        const auto length_size = static_cast<std::size_t>(list.length_size);
        if (length_size > bytes_.size() - position_) throw MeshFault("is cut short");
        if (length_size > 4) throw MeshFault("has a list whose length is no integer");
        std::size_t length = 0;
        for (std::size_t i = 0; i < length_size; ++i) {
            const std::size_t at = big_endian_ ? i : length_size - 1 - i;
            length = length << 8 | static_cast<unsigned char>(bytes_[position_ + at]);
        }
        return length_size + length * static_cast<std::size_t>(list.size);
    }

    std::string_view bytes_;
    std::size_t position_ = 0;
    bool binary_ = false, big_endian_ = false;
    std::vector<Element> elements_;
};

}  // namespace

void check_ply(std::string_view bytes) { PlyCheck(bytes).run(); }

}  // namespace nacre::render
