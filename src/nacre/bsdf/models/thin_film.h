#pragma once

#include <memory>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/model.h"
#include "nacre/paint/recipe.h"

namespace nacre::bsdf {

/// How the reflectance of the film becomes light at a wavelength.
enum class ThinFilmColour {
    spectral,  ///< exact at each wavelength
    table,     ///< an RGB colour by spectral antialiasing with the observer's tabulated transform
    paper,     ///< the same with the Gaussians of the paper
};

/// Chooses the model ThinFilm.
struct ThinFilmModel {
    ThinFilmColour colour = ThinFilmColour::spectral;

    static const ModelInfo info;
    std::shared_ptr<const Bsdf> make(const ModelInput& input, const Progress& progress) const;
    std::string text() const;

    friend bool operator==(const ThinFilmModel&, const ThinFilmModel&) = default;
};

/// Microfacets under a smooth film: the model of Belcour & Barla 2017 in the form
///   f = D(h) G2(w_i, w_o) F(w_i.h) / (4 cos_i cos_o),
/// F the Airy reflectance of outside | film | base, facets visible after Smith with correlated
/// heights.                                              [belcour-barla-2017; docs/thin-film.md]
///
/// In air, or under a smooth clearcoat, where the facets lie in the binder and
///   f = specular + t_i t_o / n^2 A f_inner(refracted directions).
/// Light that facets send to other facets, or back to them by the coat, is lost.
///
/// In the modes `table` and `paper` the colour (linear Rec. 709 under D65) becomes a spectrum by
/// spectra::linear_rec709_basis(), cut to [0, 1] at each wavelength: colours outside the gamut of
/// reflectances lose what would be negative or more than all light there.
class ThinFilm final : public Bsdf {
 public:
    /// Reads recipe.microfacet (without `facets`), recipe.clearcoat and, under a clearcoat, the
    /// binder's index at 550 nm; layers and substrate play no part.
    /// @throws DomainError if there is no [microfacet], a number is out of range, or the clearcoat
    ///         is rough
    explicit ThinFilm(const paint::Recipe& recipe,
                      ThinFilmColour colour = ThinFilmColour::spectral);
    ~ThinFilm() override;

    std::unique_ptr<const BoundBsdf> bind(const Wavelengths& wavelengths_nm) const override;

    struct Tables;

 private:
    std::shared_ptr<const Tables> tables_;
};

/// Error of albedo() of a bound thin film: by 256 samples at each of 17 angles.
inline constexpr double kThinFilmAlbedoError = 5e-3;

}  // namespace nacre::bsdf
