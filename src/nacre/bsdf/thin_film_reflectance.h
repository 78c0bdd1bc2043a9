#pragma once

#include <array>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/thin_film.h"
#include "nacre/optics/airy.h"

// F of the thin-film model.

namespace nacre::bsdf {

/// Linear Rec. 709 colour of the film by the cosine of incidence, by spectral antialiasing.
class FilmColours {
 public:
    FilmColours(const optics::AiryFilm& film, double thickness_nm, ThinFilmColour colour);

    /// Linear between kIntervals + 1 equally spaced cosines.
    std::array<float, 3> at(float cosine) const;

    static constexpr int kIntervals = 1024;

 private:
    std::vector<std::array<float, 3>> rgb_;
};

/// The film at eight wavelengths: a function of the cosine of incidence.
class FilmReflectance {
 public:
    /// @param colours  null for the spectral mode; kept by reference
    FilmReflectance(const optics::AiryFilm& film, double thickness_nm, const FilmColours* colours,
                    const Wavelengths& wavelengths_nm);

    FloatLanes operator()(float cosine) const {
        if (!colours_) [[likely]] {
            return film_.at(cosine).reflectance(thickness_over_wavelength_);
        }
        const auto rgb = colours_->at(cosine);
        const FloatLanes sum = rgb[0] * basis_[0] + rgb[1] * basis_[1] + rgb[2] * basis_[2];
        return min_lanes(max_lanes(sum, FloatLanes{}), splat(1.0f));
    }

 private:
    optics::AiryFilm film_;
    const FilmColours* colours_;
    FloatLanes thickness_over_wavelength_;
    std::array<FloatLanes, 3> basis_;
};

}  // namespace nacre::bsdf
