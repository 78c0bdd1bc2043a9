#include "nacre/io/colour_agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "nacre/spectra/lab.h"
#include "nacre/spectra/observer.h"

namespace nacre::io {

namespace {

/// One statement of a colour.
struct Statement {
    const char* columns;
    Vec3d lab;
    double rounding;  ///< Delta E 2000 by which the digits that are written may be off
};

/// @param lab_of  L*a*b* of the numbers in the columns
template <class LabOf>
Statement stated(const char* columns, const WrittenColour& written, const LabOf& lab_of) {
    const Vec3d lab = lab_of(written.values);
    double rounding = 0;
    for (int signs = 0; signs < 8; ++signs) {
        Vec3d corner = written.values;
        for (int c = 0; c < 3; ++c) corner[c] += (signs >> c & 1 ? 0.5 : -0.5) * written.unit[c];
        rounding = std::max(rounding, spectra::delta_e_2000(lab, lab_of(corner)));
    }
    return {columns, lab, rounding};
}

std::string text_of(const Vec3d& lab) {
    return fmt::format("L* = {:.2f}, a* = {:.2f}, b* = {:.2f}", lab[0], lab[1], lab[2]);
}

/// All that a row states, that which counts first.
/// @param whites  of the spectrum's wavelengths, and that of the CIE's tables, where they are two: instruments
///                state X, Y, Z by either
std::vector<Statement> statements_of(const MeasurementRow& row, const std::vector<Vec3d>& whites) {
    std::vector<Statement> all;
    const auto same = [](const Vec3d& lab) { return lab; };
    if (row.lab && row.states_lab) all.push_back(stated("L, a, b", {*row.lab, row.lab_unit}, same));
    if (row.lch) all.push_back(stated("L, C, h", *row.lch, lab_of_lch));
    if (!row.xyz) return all;
    std::optional<Statement> nearest;
    for (const Vec3d& white : whites) {
        const Statement here = stated("X, Y, Z", {*row.xyz, row.xyz_unit}, [&](const Vec3d& xyz) {
            return spectra::xyz_to_lab(xyz, white);
        });
        const auto off = [&](const Statement& s) {
            return all.empty() ? 0 : spectra::delta_e_2000(all[0].lab, s.lab);
        };
        if (!nearest || off(here) < off(*nearest)) nearest = here;
    }
    all.push_back(*nearest);
    return all;
}

/// That of the spectrum, whose reflectances are off by half of their last digit at most.
Statement of_spectrum(const MeasurementRow& row, const std::vector<double>& wavelengths_nm,
                      const measure::Conditions& conditions) {
    const auto lab_of = [&](double added) {
        std::vector<double> factors = row.reflectance_factor;
        for (double& factor : factors) factor += added;
        return measure::coloured({}, wavelengths_nm, std::move(factors), conditions).lab;
    };
    const Vec3d lab = lab_of(0);
    const double half = row.reflectance_unit / 2;
    return {"the spectrum", lab,
            std::max(spectra::delta_e_2000(lab, lab_of(half)),
                     spectra::delta_e_2000(lab, lab_of(-half)))};
}

}  // namespace

Vec3d lab_of_lch(const Vec3d& lch) {
    const double h = lch[2] * std::numbers::pi / 180;
    return {lch[0], lch[1] * std::cos(h), lch[1] * std::sin(h)};
}

void ColourAgreement::check(const MeasurementRow& row, const std::vector<double>& wavelengths_nm,
                            const measure::Conditions& conditions) {
    const bool has_spectrum = !row.reflectance_factor.empty();
    std::vector<Vec3d> whites = {measure::white_point({}, conditions)};
    if (has_spectrum)
        whites.insert(whites.begin(), measure::white_point(wavelengths_nm, conditions));
    const std::vector<Statement> all = statements_of(row, whites);
    const auto compare = [&](const Statement& counts, const Statement& other, double tolerance,
                             const std::string& where) {
        const double delta_e = spectra::delta_e_2000(counts.lab, other.lab);
        if (delta_e <= tolerance + counts.rounding + other.rounding) return;
        add(fmt::format("{}/{}", counts.columns, other.columns), delta_e,
            fmt::format("{}{} and {} contradict each other{}: {} and {}, Delta E 2000 = {:.3g}; "
                        "what counts is {}",
                        row.place, counts.columns, other.columns, where, text_of(counts.lab),
                        text_of(other.lab), delta_e, counts.columns));
    };
    if (has_spectrum && !all.empty()) {
        const Statement spectrum = of_spectrum(row, wavelengths_nm, conditions);
        const std::string light =
            fmt::format(" under {} for {} degrees", spectra::name(conditions.illuminant),
                        spectra::name(conditions.observer));
        if (row.lab) {
            compare(all[0], spectrum, kSpectrumTolerance, light);
        } else {
            compare(spectrum, all[0], kSpectrumTolerance, light);
        }
    }
    for (std::size_t i = 1; i < all.size(); ++i) compare(all[0], all[i], kColourTolerance, "");
}

void ColourAgreement::add(const std::string& kind, double delta_e, std::string text) {
    Contradiction& worst = worst_[kind];
    if (++worst.rows > 1 && delta_e <= worst.delta_e) return;
    worst.delta_e = delta_e;
    worst.text = std::move(text);
}

std::vector<std::string> ColourAgreement::contradictions() const {
    std::vector<std::string> lines;
    for (const auto& [kind, worst] : worst_) {
        lines.push_back(worst.text);
        if (worst.rows > 1) {
            lines.back() += fmt::format("; so in {} rows, here most", worst.rows);
        }
    }
    return lines;
}

}  // namespace nacre::io
