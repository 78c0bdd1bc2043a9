#include <fmt/format.h>

#include "nacre/core/error.h"
#include "nacre/optics/material_file.h"
#include "nacre/optics/number_text.h"

namespace nacre::optics {

namespace {

constexpr std::string_view kSourceMark = "source:";

double require_number(std::string_view field, const char* column, const std::string& place) {
    const auto value = parse_number(field);
    if (!value) {
        throw InputError(
            fmt::format("{}: {} = \"{}\" is not a finite number", place, column, excerpt(field)));
    }
    return *value;
}

}  // namespace

Material parse_material_csv(std::string_view text, const std::string& name) {
    std::string source;
    std::vector<double> wavelengths_nm;
    std::vector<ComplexIndex> index;
    std::size_t columns = 0, line_number = 0;

    for (std::string_view line : split(text, '\n')) {
        ++line_number;
        const std::string place = fmt::format("{}:{}", name, line_number);
        if (line_number == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);  // BOM
        if (line.empty()) continue;
        if (line.front() == '#') {
            const auto comment = trimmed(line.substr(1));
            if (comment.starts_with(kSourceMark)) {
                source = trimmed(comment.substr(kSourceMark.size()));
            }
            continue;
        }
        const auto fields = split(line, ',');
        if (columns == 0) {
            const bool with_k = fields.size() == 3 && fields[2] == "k";
            if (!(fields[0] == "wavelength_nm" && fields.size() >= 2 && fields[1] == "n" &&
                  (with_k || fields.size() == 2))) {
                throw InputError(
                    fmt::format("{}: the header is \"{}\"; it must be \"wavelength_nm,n,k\" or "
                                "\"wavelength_nm,n\"",
                                place, excerpt(line)));
            }
            columns = fields.size();
            continue;
        }
        if (fields.size() != columns) {
            throw InputError(fmt::format("{}: {} fields in \"{}\"; the header has {}", place,
                                         fields.size(), excerpt(line), columns));
        }
        const double wavelength_nm = require_number(fields[0], "wavelength_nm", place);
        const double n = require_number(fields[1], "n", place);
        const double k = columns == 3 ? require_number(fields[2], "k", place) : 0.0;
        if (!(wavelength_nm > (wavelengths_nm.empty() ? 0.0 : wavelengths_nm.back()))) {
            throw InputError(fmt::format(
                "{}: wavelength_nm = {} is not above {}; wavelengths are positive and increase",
                place, wavelength_nm, wavelengths_nm.empty() ? 0.0 : wavelengths_nm.back()));
        }
        if (!kRefractiveIndexRange.contains(n)) {
            throw InputError(
                fmt::format("{}: n = {} is outside {}", place, n, kRefractiveIndexRange.text()));
        }
        if (!kExtinctionRange.contains(k)) {
            throw InputError(
                fmt::format("{}: k = {} is outside {}", place, k, kExtinctionRange.text()));
        }
        wavelengths_nm.push_back(wavelength_nm);
        index.emplace_back(n, k);
    }
    if (index.empty()) {
        throw InputError(
            fmt::format("{}: no row of data after the header \"wavelength_nm,n,k\"", name));
    }
    if (index.size() == 1) return Material(name, index.front(), source);
    return Material(name, std::move(wavelengths_nm), std::move(index), source);
}

}  // namespace nacre::optics
