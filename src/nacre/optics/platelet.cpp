#include <fmt/format.h>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/optics/platelet_average.h"
#include "nacre/optics/thin_film.h"

namespace nacre::optics {

namespace {

void require_thickness(double nm) {
    require_in_range(nm, kFlakeFilmThicknessRange.lo, kFlakeFilmThicknessRange.hi,
                     "thickness of a flake's film in nm");
}

void require_film(const FilmPopulation& film) {
    require_thickness(film.thickness_nm);
    require_in_range(film.spread.standard_deviation_nm, 0, kFlakeFilmThicknessRange.hi,
                     "standard deviation of a film's thickness in nm");
}

void require_arguments(const Platelet& platelet, std::span<const double> cosines,
                       std::span<const double> wavelengths_nm) {
    require_film(platelet.core);
    for (const auto& coat : platelet.coats) require_film(coat);
    for (double c : cosines) require_in_range(c, 0, 1, "cosine of the incidence on a flake");
    for (double w : wavelengths_nm) {
        require_in_range(w, kThinFilmWavelengthRange.lo, kThinFilmWavelengthRange.hi,
                         "wavelength in nm");
    }
}

}  // namespace

PlateletTable platelet_table(const Platelet& platelet, const Material& binder,
                             std::span<const double> cosines,
                             std::span<const double> wavelengths_nm, SharedProgress* work) {
    require_arguments(platelet, cosines, wavelengths_nm);
    PlateletAverage average(platelet, binder, wavelengths_nm, work);
    average.prepare(cosines);
    const std::size_t columns = wavelengths_nm.size();
    PlateletTable table;
    table.reflectance.resize(cosines.size() * columns);
    table.transmittance.resize(cosines.size() * columns);
    parallel_for(0, cosines.size(), [&](std::size_t i) {
        average.row(i, cosines[i], &table.reflectance[i * columns],
                    &table.transmittance[i * columns]);
    });
    return table;
}

std::vector<double> platelet_reflectances(const Platelet& platelet,
                                          std::span<const std::vector<double>> thicknesses_nm,
                                          const Material& binder, std::span<const double> cosines,
                                          std::span<const double> wavelengths_nm,
                                          SharedProgress* work) {
    require_arguments(platelet, cosines, wavelengths_nm);
    std::vector<std::vector<ThicknessRule>> members;  // by film
    for (const std::vector<double>& films : thicknesses_nm) {
        if (films.size() != platelet.coats.size() + 1) {
            throw DomainError(fmt::format("{} thicknesses of a platelet of {} films", films.size(),
                                          platelet.coats.size() + 1));
        }
        std::vector<ThicknessRule>& rules = members.emplace_back();
        for (const double nm : films) {
            require_thickness(nm);
            rules.push_back({{nm}, {1.0}});
        }
    }
    const PlateletAverage average(platelet, binder, wavelengths_nm, work);
    const std::size_t columns = wavelengths_nm.size(), stride = cosines.size() * columns;
    std::vector<double> reflectance(members.size() * stride);
    parallel_for(0, cosines.size(), [&](std::size_t i) {
        average.row(members, cosines[i], &reflectance[i * columns], stride);
    });
    return reflectance;
}

}  // namespace nacre::optics
