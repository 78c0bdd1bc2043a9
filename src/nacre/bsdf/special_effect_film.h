#pragma once

#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/optics/airy.h"
#include "nacre/sparkle/facet_field.h"

namespace nacre::bsdf {

/// Films of thicknesses spread evenly over a range, at eight wavelengths: each, and on average.
class SpreadFilm {
 public:
    SpreadFilm(const optics::AiryFilm& film, double film_ior, optics::ThicknessRange range,
               const Wavelengths& wavelengths_nm);

    /// E_d[R], unpolarised, by Gauss-Legendre quadrature fine enough for the phases in the range:
    /// within kSpreadFilmError of the closed form optics::AiryFilm::moments.
    FloatLanes mean(float cosine) const { return mean(film_.at(cosine)); }

    /// The sum of R over the facets counted. Up to FacetTally::kListed of them: each with its own
    /// thickness. Of more, M = kListed stand for all N: with their mean R_M,
    ///   N (E + sqrt(M/N) (R_M - E)),
    /// whose mean N E_d[R] and variance N Var_d[R] are those of the sum, and so are its covariances
    /// between wavelengths, including those between calls; it stays between 0 and N. Guo et al.
    /// draw a Gaussian of that mean and variance, which does neither.          [guo-2018]
    FloatLanes sum(float cosine, const sparkle::FacetTally& facets) const;

 private:
    FloatLanes mean(const optics::AiryAngle<float>& angle) const;

    struct Node {
        FloatLanes thickness_over_wavelength;
        float weight;
    };
    optics::AiryFilm film_;
    float lo_nm_, width_nm_;
    FloatLanes inverse_wavelengths_;
    std::vector<Node> nodes_;
};

inline constexpr double kSpreadFilmError = 5e-5;

}  // namespace nacre::bsdf
