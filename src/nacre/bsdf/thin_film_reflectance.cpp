#include "nacre/bsdf/thin_film_reflectance.h"

#include <algorithm>

#include "nacre/optics/antialiased.h"
#include "nacre/spectra/rgb_basis.h"

namespace nacre::bsdf {

FilmColours::FilmColours(const optics::AiryFilm& film, double thickness_nm, ThinFilmColour colour) {
    optics::Antialiasing how;
    if (colour == ThinFilmColour::paper) how.transform = optics::ObserverTransform::paper;
    for (int i = 0; i <= kIntervals; ++i) {
        const auto rgb =
            optics::antialiased_rgb(film, static_cast<double>(i) / kIntervals, thickness_nm, how);
        rgb_.push_back(
            {static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])});
    }
}

std::array<float, 3> FilmColours::at(float cosine) const {
    const float x = std::clamp(cosine, 0.0f, 1.0f) * kIntervals;
    const int row = std::min(static_cast<int>(x), kIntervals - 1);
    const float t = x - static_cast<float>(row);
    std::array<float, 3> rgb;
    for (int c = 0; c < 3; ++c) rgb[c] = rgb_[row][c] + t * (rgb_[row + 1][c] - rgb_[row][c]);
    return rgb;
}

FilmReflectance::FilmReflectance(const optics::AiryFilm& film, double thickness_nm,
                                 const FilmColours* colours, const Wavelengths& wavelengths_nm)
    : film_(film), colours_(colours), basis_{} {
    thickness_over_wavelength_ =
        make_lanes([&](int i) { return static_cast<float>(thickness_nm / wavelengths_nm[i]); });
    if (!colours) return;
    const auto& basis = spectra::linear_rec709_basis();
    for (int c = 0; c < 3; ++c) {
        basis_[c] =
            make_lanes([&](int i) { return static_cast<float>(basis[c](wavelengths_nm[i])); });
    }
}

}  // namespace nacre::bsdf
