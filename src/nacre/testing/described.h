#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "nacre/core/file.h"
#include "nacre/paint/description.h"

// For tests of descriptions (paint/description.h): every key of an object, and values for it.

namespace nacre::test {

/// A key that an object has a value for.
struct KeyOfObject {
    std::string path;
    paint::Field field;
    bool is_number = false;   ///< or a spectrum, or a material that must be real
    bool is_settled = false;  ///< it has but one value
};

/// Lists the values of an object, and changes the one at a path if it is given.
class EveryKey final : public paint::PathVisitor {
 public:
    EveryKey() = default;
    /// @param value  the new one of a number; any other one if it is not given
    explicit EveryKey(std::string target, std::optional<double> value = {})
        : target_(std::move(target)), value_(value) {}

    void number(const paint::Field& field, double& value) override {
        if (found(field, true)) value = value_.value_or(another(field, value));
    }
    void spectrum(const paint::Field& field, spectra::Spectrum& value) override {
        if (found(field, true)) value = value_.value_or(another(field, value.max()));
    }
    void material(const paint::Field& field, optics::Material& value) override {
        if (found(field, field.real)) value = value_.value_or(1.75);
    }
    void text(const paint::Field& field, std::string& value) override {
        if (found(field)) value += "x";
    }
    void flag(const paint::Field& field, bool& value) override {
        if (found(field)) value = !value;
    }
    void vector(const paint::Field& field, Vec3f& value) override {
        if (!found(field, true)) return;
        value.x = static_cast<float>(value_.value_or(another(field, value.x)));
    }
    void path(const paint::Field& field, std::filesystem::path& value) override {
        if (found(field)) value += "x";
    }
    /// Left unchanged: another kind has other keys.
    void kind(const paint::Field& field, const paint::Choices&, std::size_t&) override {
        found(field);
        keys.back().is_settled = true;
    }
    void choice(const paint::Field& field, const paint::Choices& choices, std::size_t& i) override {
        const bool here = found(field);
        keys.back().is_settled = choices.size() == 1;
        if (here) i = (i + 1) % choices.size();
    }

    std::vector<KeyOfObject> keys;
    int changes = 0;

 private:
    bool found(const paint::Field& field, bool is_number = false) {
        keys.push_back({path_of(field), field, is_number});
        if (path_of(field) != target_) return false;
        ++changes;
        return true;
    }

    static double another(const paint::Field& field, double value) {
        const double lo = std::max(field.range.lo, -1.0), hi = std::min(field.range.hi, 3.0);
        const double low = lo + 0.25 * (hi - lo);
        return value == low ? lo + 0.125 * (hi - lo) : low;
    }

    std::string target_;
    std::optional<double> value_;
};

/// Values just outside a range, or at its open ends.
inline std::vector<double> values_outside(const Range& range) {
    const auto step = [](double end) { return std::max(0.5, 1e-6 * std::abs(end)); };  // a float's
    return {range.lo_open ? range.lo : range.lo - step(range.lo),
            range.hi_open ? range.hi : range.hi + step(range.hi)};
}

/// The key without the tables around it, and without the place in a list.
inline std::string last_key(const std::string& path) { return path.substr(path.rfind('.') + 1); }

/// The table that follows <!-- keys: NAME --> in a file of the documentation. If the environment
/// variable NACRE_WRITE_DOCS is set, `expected` is written there instead.
inline std::string documented_table(const std::string& file, const std::string& name,
                                    const std::string& expected) {
    const std::filesystem::path path = data_directory().parent_path() / "docs" / file;
    std::string text = read_file(path);
    const std::string mark = fmt::format("<!-- keys: {} -->\n", name);
    const std::size_t at = text.find(mark);
    if (at == std::string::npos) return fmt::format("{} has no line {}", path.string(), mark);
    const std::size_t begin = at + mark.size();
    std::size_t end = begin;
    while (end < text.size() && text[end] == '|') end = text.find('\n', end) + 1;
    if (std::getenv("NACRE_WRITE_DOCS")) {
        std::ofstream(path, std::ios::binary) << text.replace(begin, end - begin, expected);
        return expected;
    }
    return text.substr(begin, end - begin);
}

}  // namespace nacre::test
