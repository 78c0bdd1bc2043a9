#include "nacre/reference/medium_grid.h"

#include <fmt/format.h>

#include <algorithm>

#include "nacre/core/error.h"

namespace nacre::reference {

/// Between grid wavelengths `lower` and `upper`.
struct MediumGrid::Place {
    std::size_t lower, upper;
    double fraction;
};

MediumGrid::MediumGrid(const layers::Recipe& recipe, std::vector<double> wavelengths_nm)
    : wavelengths_nm_(std::move(wavelengths_nm)) {
    if (wavelengths_nm_.empty()) throw DomainError("a grid of wavelengths is empty");
    for (std::size_t i = 1; i < wavelengths_nm_.size(); ++i) {
        if (!(wavelengths_nm_[i] > wavelengths_nm_[i - 1])) {
            throw DomainError(fmt::format("wavelengths do not increase: {} nm after {} nm",
                                          wavelengths_nm_[i], wavelengths_nm_[i - 1]));
        }
    }
    layers::validate(recipe, wavelengths_nm_);
    for (double wavelength : wavelengths_nm_)
        index_.push_back(recipe.binder.index(wavelength).real());
    for (std::size_t first = 0; first < wavelengths_nm_.size(); first += kLanes) {
        const std::size_t count = std::min<std::size_t>(kLanes, wavelengths_nm_.size() - first);
        media_.emplace_back(recipe, std::span(wavelengths_nm_).subspan(first, count));
    }
}

MediumGrid::Place MediumGrid::locate(double wavelength_nm) const {
    const auto above =
        std::upper_bound(wavelengths_nm_.begin(), wavelengths_nm_.end(), wavelength_nm);
    if (above == wavelengths_nm_.begin()) return {0, 0, 0};
    const auto upper = static_cast<std::size_t>(above - wavelengths_nm_.begin());
    if (above == wavelengths_nm_.end()) return {upper - 1, upper - 1, 0};
    return {upper - 1, upper, (wavelength_nm - *(above - 1)) / (*above - *(above - 1))};
}

double MediumGrid::index(double wavelength_nm) const {
    const Place place = locate(wavelength_nm);
    // Exact where the index is the same at both: equal lanes share walks.
    return index_[place.lower] + place.fraction * (index_[place.upper] - index_[place.lower]);
}

Medium MediumGrid::at(std::span<const double> wavelengths_nm) const {
    std::vector<Place> places;
    for (double wavelength : wavelengths_nm) places.push_back(locate(wavelength));

    // What the media keep in lanes is reached by get(medium), and gathered into the result's lanes.
    const auto interpolate = [&](auto&& get) {
        Lanes result{};
        for (std::size_t lane = 0; lane < places.size(); ++lane) {
            const auto [lower, upper, fraction] = places[lane];
            const double a = get(media_[lower / kLanes])[lower % kLanes];
            const double b = get(media_[upper / kLanes])[upper % kLanes];
            result[lane] = a + fraction * (b - a);
        }
        return result;
    };

    Medium medium = media_.front();
    medium.lane_count = static_cast<int>(places.size());
    medium.index = index(wavelengths_nm.front());
    medium.substrate_reflectance =
        interpolate([](const Medium& m) -> const Lanes& { return m.substrate_reflectance; });
    for (std::size_t s = 0; s < medium.slabs.size(); ++s) {
        Slab& slab = medium.slabs[s];
        slab.absorption_per_um = interpolate(
            [&](const Medium& m) -> const Lanes& { return m.slabs[s].absorption_per_um; });
        for (std::size_t f = 0; f < slab.flakes.size(); ++f) {
            const auto table = [&](auto of) {
                std::vector<Lanes> nodes(of(slab.flakes[f].optics).size());
                for (std::size_t i = 0; i < nodes.size(); ++i) {
                    nodes[i] = interpolate([&](const Medium& m) -> const Lanes& {
                        return of(m.slabs[s].flakes[f].optics)[i];
                    });
                }
                return nodes;
            };
            slab.flakes[f].optics = FlakeOptics(
                table([](const FlakeOptics& o) -> auto& { return o.reflectances(); }),
                table([](const FlakeOptics& o) -> auto& { return o.transmittances(); }));
        }
        for (std::size_t p = 0; p < slab.pigments.size(); ++p) {
            slab.pigments[p].scattering_per_um = interpolate([&](const Medium& m) -> const Lanes& {
                return m.slabs[s].pigments[p].scattering_per_um;
            });
        }
        slab.sum_pigments();
    }
    return medium;
}

}  // namespace nacre::reference
