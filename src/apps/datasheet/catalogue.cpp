#include "apps/datasheet/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "nacre/core/csv.h"
#include "nacre/fit/drawdown.h"
#include "nacre/io/pigment_file.h"
#include "nacre/measure/measurement.h"
#include "nacre/optics/material.h"
#include "nacre/optics/thin_film.h"
#include "nacre/spectra/lab.h"
#include "nacre/spectra/rgb.h"
#include "nacre/spectra/spectrum.h"
#include "nacre/spectra/xyz.h"

namespace nacre::datasheet {

namespace {

/// "#rrggbb" of a reflectance at the default wavelengths.
std::string chip_of(const std::vector<double>& reflectance) {
    constexpr auto kLight = spectra::Illuminant::D65;
    constexpr auto kEye = spectra::Observer::cie1964_10deg;
    const Vec3d lab = spectra::xyz_to_lab(
        spectra::reflectance_to_xyz(
            spectra::Spectrum(spectra::default_wavelengths_nm(), reflectance), kLight, kEye),
        spectra::white_point(kLight, kEye));
    return spectra::css_colour(measure::srgb_chip(lab));
}

/// Wavelengths in nm between which something is known.
using Known = std::pair<double, double>;
constexpr Known kEverywhere{0, std::numeric_limits<double>::infinity()};

Known known(const optics::Material& material) {
    return {material.first_wavelength_nm(), material.last_wavelength_nm()};
}

Known known(const spectra::Spectrum& spectrum) {
    if (spectrum.is_constant()) return kEverywhere;
    return {spectrum.wavelengths_nm().front(), spectrum.wavelengths_nm().back()};
}

Known known(const paint::Pigment& pigment) {
    if (const auto* particles = std::get_if<paint::PigmentParticles>(&pigment.body)) {
        return known(particles->spheres.material);
    }
    const paint::PigmentCoefficients coefficients = *pigment.layer_coefficients();
    const Known a = known(coefficients.scattering_per_mm),
                b = known(coefficients.absorption_per_mm);
    return {std::max(a.first, b.first), std::min(a.second, b.second)};
}

bool covers_default_wavelengths(const Known& range) {
    const std::vector<double> wavelengths = spectra::default_wavelengths_nm();
    return range.first <= wavelengths.front() && range.second >= wavelengths.back();
}

std::string range_cells(const Known& range) {
    return range == kEverywhere ? "," : fmt::format("{},{}", range.first, range.second);
}

/// Where data end within the default wavelengths, with their last index beyond: for a chip, which shows
/// the whole of the spectrum.
optics::Material continued(const optics::Material& material) {
    if (covers_default_wavelengths(known(material))) return material;
    std::vector<double> wavelengths_nm = material.wavelengths_nm();
    std::vector<optics::ComplexIndex> index = material.samples();
    const double first = spectra::default_wavelengths_nm().front(),
                 last = spectra::default_wavelengths_nm().back();
    if (wavelengths_nm.front() > first) {
        wavelengths_nm.insert(wavelengths_nm.begin(), first);
        index.insert(index.begin(), index.front());
    }
    if (wavelengths_nm.back() < last) {
        wavelengths_nm.push_back(last);
        index.push_back(index.back());
    }
    return {material.name(), std::move(wavelengths_nm), std::move(index), material.source()};
}

std::string chip_of(const optics::Material& material) {
    const optics::Material shown = continued(material);
    std::vector<double> reflectance;
    for (const double nm : spectra::default_wavelengths_nm()) {
        reflectance.push_back(optics::stack_reflectance(1.0, {}, shown.index(nm), 1, nm,
                                                        optics::Polarization::unpolarized)
                                  .reflectance);
    }
    return chip_of(reflectance);
}

constexpr double kChipVolume = 0.03, kChipThickness_um = 40;

std::string drawdown_chip(paint::Pigment pigment, double ground, const Progress& progress) {
    if (auto* particles = std::get_if<paint::PigmentParticles>(&pigment.body)) {
        particles->spheres.material = continued(particles->spheres.material);
    }
    paint::Recipe recipe;
    recipe.binder = optics::Material(1.5);
    recipe.layers.push_back({kChipThickness_um, {}, {pigment}});
    recipe.substrate_reflectance = ground;
    return chip_of(fit::drawdown_reflectance(recipe, spectra::default_wavelengths_nm(),
                                             measure::DrawdownGeometry::angle_45_0, progress));
}

}  // namespace

std::string materials_csv() {
    constexpr double kGreen_nm = 550;
    std::string csv = "name,from_nm,to_nm,n_550,k_550,chip,source\n";
    for (const std::string& name : optics::material_names()) {
        const optics::Material material = optics::find_material(name);
        const optics::ComplexIndex index = material.index(kGreen_nm);
        csv +=
            fmt::format("{},{},{:.5g},{:.5g},{},{}\n", name, range_cells(known(material)),
                        index.real(), index.imag(), chip_of(material), csv_cell(material.source()));
    }
    return csv;
}

std::string pigments_csv(const Progress& progress) {
    std::string csv = "name,title,kind,from_nm,to_nm,over_black,over_white,source\n";
    for (const io::ShippedPigment& shipped : io::shipped_pigments()) {
        const std::string name(shipped.name);
        const io::PigmentFile file =
            io::parse_pigment_file(shipped.toml, name + ".toml", kChipVolume);
        const bool particles = std::holds_alternative<paint::PigmentParticles>(file.pigment.body);
        csv +=
            fmt::format("{},{},{},{},{},{},{}\n", name, csv_cell(file.pigment.name),
                        particles ? "particles" : "coefficients", range_cells(known(file.pigment)),
                        drawdown_chip(file.pigment, 0.02, progress),
                        drawdown_chip(file.pigment, 0.9, progress), csv_cell(file.source));
    }
    return csv;
}

}  // namespace nacre::datasheet
