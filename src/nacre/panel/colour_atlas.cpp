#include "nacre/panel/colour_atlas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/layers/recipe_limits.h"
#include "nacre/layers/recipe_parameter.h"
#include "nacre/measure/instrument.h"

namespace nacre::panel {

namespace {

void require_cells(std::size_t values, std::size_t geometries) {
    if (values == 0 || geometries == 0) {
        throw DomainError("an atlas needs at least one thickness and one angle");
    }
    if (values > kMostAtlasCells / geometries) {
        throw DomainError(fmt::format("an atlas of {} x {} chips: must have at most {}", values,
                                      geometries, kMostAtlasCells));
    }
}

void go_on(const Progress& progress, std::size_t done, std::size_t all) {
    const double fraction = static_cast<double>(done) / static_cast<double>(all);
    if (progress && !progress(fraction)) throw Error("stopped");
}

double real_index(const optics::Material& binder, double wavelength_nm) {
    const optics::ComplexIndex index = binder.index(wavelength_nm);
    const Range range = layers::limits::kBinderIndex;
    if (!range.contains(index.real())) {
        throw DomainError(fmt::format("index of the binder = {} at {} nm: must be in {}",
                                      index.real(), wavelength_nm, range.text()));
    }
    return index.real();
}

/// Cosines [geometry][wavelength], and whether they are alike at all wavelengths.
struct Cosines {
    std::vector<std::vector<double>> values;
    bool alike = true;
};

Cosines cosines(const std::vector<measure::Geometry>& geometries, const optics::Material& binder,
                const std::vector<double>& wavelengths_nm) {
    Cosines result{{}, !binder.is_dispersive()};
    for (const measure::Geometry& geometry : geometries) {
        auto& row = result.values.emplace_back();
        for (const double wavelength : wavelengths_nm) {
            row.push_back(cos_on_flake(geometry, real_index(binder, wavelength)));
        }
    }
    return result;
}

/// Reflectance [geometry][wavelength], row-major.
std::vector<double> reflectance(const optics::Platelet& platelet, const optics::Material& binder,
                                const Cosines& cosines, const std::vector<double>& wavelengths_nm) {
    const std::size_t geometries = cosines.values.size(), n = wavelengths_nm.size();
    std::vector<double> column(geometries);
    const auto fill = [&](std::size_t w) {
        for (std::size_t g = 0; g < geometries; ++g) column[g] = cosines.values[g][w];
    };
    if (cosines.alike) {
        fill(0);
        return optics::platelet_table(platelet, binder, column, wavelengths_nm).reflectance;
    }
    std::vector<double> result(geometries * n);
    for (std::size_t w = 0; w < n; ++w) {
        fill(w);
        const auto table = optics::platelet_table(platelet, binder, column,
                                                  std::span(wavelengths_nm).subspan(w, 1));
        for (std::size_t g = 0; g < geometries; ++g) result[g * n + w] = table.reflectance[g];
    }
    return result;
}

std::string title_of(const AtlasFlake& flake) {
    std::string title;
    for (auto outer = flake.outer.rbegin(); outer != flake.outer.rend(); ++outer) {
        title += fmt::format("{} {:g} nm on ", outer->material.name(), outer->thickness_nm);
    }
    title += flake.film.name();
    if (flake.core) {
        title +=
            fmt::format(" on {} {:g} nm", flake.core->material.name(), flake.core->thickness_nm);
    }
    return title;
}

}  // namespace

double cos_on_flake(const measure::Geometry& geometry, double binder_index) {
    constexpr double kDeg = std::numbers::pi / 180;
    const double sin_i = std::sin(geometry.theta_i_deg * kDeg) / binder_index;
    const double sin_o = std::sin(geometry.theta_o_deg * kDeg) / binder_index;
    const double dot = std::sqrt((1 - sin_i * sin_i) * (1 - sin_o * sin_o)) +
                       sin_i * sin_o * std::cos(geometry.phi_deg * kDeg);
    return std::sqrt(std::clamp((1 + dot) / 2, 0.0, 1.0));
}

Atlas flake_atlas(const AtlasFlake& flake, const std::vector<double>& thickness_nm,
                  const std::vector<measure::Geometry>& geometries,
                  const std::vector<double>& wavelengths_nm, const measure::Conditions& conditions,
                  const Progress& progress) {
    require_cells(thickness_nm.size(), geometries.size());
    Atlas atlas{.title = title_of(flake),
                .quantity = fmt::format("thickness of {}, nm", flake.film.name()),
                .column = "thickness_nm",
                .caption = fmt::format(
                    "One flake in a binder of index {}: its reflectance where it mirrors the lamp "
                    "to the eye",
                    flake.binder.name()),
                .conditions = conditions,
                .values = thickness_nm,
                .geometries = geometries};
    atlas.lab.resize(thickness_nm.size() * geometries.size());
    const Cosines angles = cosines(geometries, flake.binder, wavelengths_nm);
    for (std::size_t t = 0; t < thickness_nm.size(); ++t) {
        go_on(progress, t, thickness_nm.size());
        const optics::FilmPopulation film{flake.film, thickness_nm[t], flake.film_spread};
        optics::Platelet platelet{flake.core.value_or(film), {}};
        if (flake.core) platelet.coats.push_back(film);
        platelet.coats.insert(platelet.coats.end(), flake.outer.begin(), flake.outer.end());
        const auto values = reflectance(platelet, flake.binder, angles, wavelengths_nm);
        for (std::size_t g = 0; g < geometries.size(); ++g) {
            const auto first =
                values.begin() + static_cast<std::ptrdiff_t>(g * wavelengths_nm.size());
            atlas.lab[g * thickness_nm.size() + t] =
                measure::coloured(
                    geometries[g], wavelengths_nm,
                    {first, first + static_cast<std::ptrdiff_t>(wavelengths_nm.size())}, conditions)
                    .lab;
        }
    }
    go_on(progress, 1, 1);
    return atlas;
}

Atlas recipe_atlas(const layers::Recipe& recipe, const std::string& key,
                   const std::vector<double>& values,
                   const std::vector<measure::Geometry>& geometries,
                   const std::vector<double>& wavelengths_nm, const measure::Conditions& conditions,
                   const Progress& progress) {
    require_cells(values.size(), geometries.size());
    // All values are checked before the first is solved.
    for (const double value : values) {
        layers::Recipe changed = recipe;
        layers::set_parameter(changed, key, value);
        layers::validate(changed, wavelengths_nm);
    }
    Atlas atlas{
        .title = recipe.name.empty() ? "Paint" : recipe.name,
        .quantity = key,
        .column = key,
        .caption = "The whole paint, solved for each value, without the gloss of its surface",
        .conditions = conditions,
        .values = values,
        .geometries = geometries};
    atlas.lab.resize(values.size() * geometries.size());
    for (std::size_t v = 0; v < values.size(); ++v) {
        go_on(progress, v, values.size());
        layers::Recipe changed = recipe;
        layers::set_parameter(changed, key, values[v]);
        const layers::SolvedPaint paint = layers::solve(changed, wavelengths_nm);
        const measure::Measurement readings = measure::measure(
            changed.name,
            [&](double theta_i, double theta_o, double phi) {
                return paint.brdf(theta_i, theta_o, phi);
            },
            wavelengths_nm, geometries, conditions);
        for (std::size_t g = 0; g < geometries.size(); ++g) {
            atlas.lab[g * values.size() + v] = readings.readings[g].lab;
        }
    }
    go_on(progress, 1, 1);
    return atlas;
}

}  // namespace nacre::panel
