#include "apps/datasheet/catalogue.h"

#include <fmt/format.h>

#include <iterator>
#include <vector>

#include "nacre/core/csv.h"
#include "nacre/measure/measurement.h"
#include "nacre/optics/material.h"
#include "nacre/optics/thin_film.h"
#include "nacre/spectra/lab.h"
#include "nacre/spectra/rgb.h"
#include "nacre/spectra/spectrum.h"
#include "nacre/spectra/xyz.h"

namespace nacre::datasheet {

namespace {

/// "#rrggbb", or nothing where the data end before the default wavelengths do.
std::string chip_of(const optics::Material& material) {
    constexpr auto kLight = spectra::Illuminant::D65;
    constexpr auto kEye = spectra::Observer::cie1964_10deg;
    const std::vector<double> wavelengths = spectra::default_wavelengths_nm();
    if (material.first_wavelength_nm() > wavelengths.front() ||
        material.last_wavelength_nm() < wavelengths.back()) {
        return {};
    }
    std::vector<double> reflectance;
    for (const double nm : wavelengths) {
        reflectance.push_back(optics::stack_reflectance(1.0, {}, material.index(nm), 1, nm,
                                                        optics::Polarization::unpolarized)
                                  .reflectance);
    }
    const Vec3d lab = spectra::xyz_to_lab(
        spectra::reflectance_to_xyz(spectra::Spectrum(wavelengths, reflectance), kLight, kEye),
        spectra::white_point(kLight, kEye));
    return spectra::css_colour(measure::srgb_chip(lab));
}

}  // namespace

std::string materials_csv() {
    constexpr double kGreen_nm = 550;
    std::string csv = "name,from_nm,to_nm,n_550,k_550,chip,source\n";
    for (const std::string& name : optics::material_names()) {
        const optics::Material material = optics::find_material(name);
        const optics::ComplexIndex index = material.index(kGreen_nm);
        const std::string range = material.is_dispersive()
                                      ? fmt::format("{},{}", material.first_wavelength_nm(),
                                                    material.last_wavelength_nm())
                                      : ",";
        fmt::format_to(std::back_inserter(csv), "{},{},{:.5g},{:.5g},{},{}\n", name, range,
                       index.real(), index.imag(), chip_of(material), csv_cell(material.source()));
    }
    return csv;
}

}  // namespace nacre::datasheet
