#include "nacre/montecarlo/discs/disc_films.h"

#include <algorithm>
#include <utility>

#include "nacre/bsdf/flake_films.h"
#include "nacre/core/random.h"
#include "nacre/optics/thickness_rule.h"

namespace nacre::montecarlo {

namespace {

/// `count` thicknesses, one from each of `count` equally probable intervals, in random order.
std::vector<double> stratified(const optics::FilmPopulation& film, int count, Rng& rng) {
    std::vector<double> thickness(count);
    for (int i = 0; i < count; ++i)
        thickness[i] = optics::thickness_quantile(film.thickness_nm, film.spread,
                                                  (i + rng.uniform_double()) / count);
    for (int i = count - 1; i > 0; --i)
        std::swap(thickness[i], thickness[static_cast<int>((i + 1) * rng.uniform_double())]);
    return thickness;
}

optics::FilmPopulation exactly(const optics::FilmPopulation& film, double thickness_nm) {
    return {film.material, thickness_nm, {}};
}

std::vector<optics::Platelet> draw(const optics::Platelet& platelet, int count, Rng& rng) {
    std::vector<optics::Platelet> drawn(count, platelet);
    for (optics::Platelet& flake : drawn) flake.coats.clear();
    const auto core = stratified(platelet.core, count, rng);
    for (int i = 0; i < count; ++i) drawn[i].core = exactly(platelet.core, core[i]);
    for (const auto& coat : platelet.coats) {
        const auto thickness = stratified(coat, count, rng);
        for (int i = 0; i < count; ++i) drawn[i].coats.push_back(exactly(coat, thickness[i]));
    }
    return drawn;
}

}  // namespace

DiscFilms::DiscFilms(const paint::FlakeSpecies& species, const optics::Material& binder,
                     const std::vector<double>& wavelengths_nm, std::uint64_t seed,
                     SharedProgress* work) {
    // A node beyond the last wavelength, which is read with weight zero.
    stride_ = wavelengths_nm.size() + 1;
    fill(species, binder, wavelengths_nm, seed, work);
}

void DiscFilms::fill(const paint::FlakeSpecies& species, const optics::Material& binder,
                     const std::vector<double>& wavelengths_nm, std::uint64_t seed,
                     SharedProgress* work) {
    const auto append = [&](std::vector<float>& to, auto&& value) {
        for (std::size_t i = 0; i < stride_; ++i) {
            const std::size_t j = std::min(i, wavelengths_nm.size() - 1);
            to.push_back(static_cast<float>(value(j)));
        }
    };
    if (const auto* given = std::get_if<paint::PrescribedFlake>(&species.body)) {
        append(reflectance_, [&](auto j) { return given->reflectance(wavelengths_nm[j]); });
        append(transmittance_, [&](auto j) { return given->transmittance(wavelengths_nm[j]); });
        return;
    }
    const auto& platelet = std::get<optics::Platelet>(species.body);
    count_ = bsdf::FlakeFilms::vary(platelet) ? kFilms : 1;
    intervals_ = kCosineIntervals;
    std::vector<double> cosines(intervals_ + 1);
    for (int i = 0; i <= intervals_; ++i) cosines[i] = static_cast<double>(i) / intervals_;
    Rng rng(seed);
    const std::size_t wavelengths = wavelengths_nm.size();
    for (const optics::Platelet& flake : draw(platelet, count_, rng)) {
        const auto table = optics::platelet_table(flake, binder, cosines, wavelengths_nm, work);
        for (std::size_t i = 0; i < cosines.size(); ++i) {
            append(reflectance_, [&](auto j) { return table.reflectance[i * wavelengths + j]; });
            append(transmittance_,
                   [&](auto j) { return table.transmittance[i * wavelengths + j]; });
        }
    }
}

DiscFilms::Optics DiscFilms::at(int film, double cosine, const WavelengthPlaces& places) const {
    const double x = std::min(cosine, 1.0) * intervals_;
    const int i = std::min(static_cast<int>(x), std::max(intervals_ - 1, 0));
    const double f = x - i;
    const std::size_t row = (static_cast<std::size_t>(film) * (intervals_ + 1) + i) * stride_;
    const std::size_t next = intervals_ == 0 ? 0 : stride_;
    const auto read = [&](const std::vector<float>& table) {
        const float *a = table.data() + row, *b = a + next;
        return make_lanes<DoubleLanes>([&](int lane) {
            const int j = places[lane].lower;
            const double g = places[lane].fraction;
            const double at_a = a[j] + g * (a[j + 1] - a[j]), at_b = b[j] + g * (b[j + 1] - b[j]);
            return at_a + f * (at_b - at_a);
        });
    };
    return {read(reflectance_), read(transmittance_)};
}

}  // namespace nacre::montecarlo
