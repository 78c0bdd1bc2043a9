#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/model.h"
#include "nacre/optics/airy.h"
#include "nacre/paint/recipe.h"
#include "nacre/sparkle/facet_field.h"

namespace nacre::bsdf {

/// Chooses the model SpecialEffect.
struct SpecialEffectModel {
    std::uint64_t specimen = 0;  ///< which panel of the batch: the seed of its facets
    /// Shows the mean over all facets everywhere: the model without sparkle, which [mir-2022] time
    /// as "smooth NDF".
    bool smooth_ndf = false;

    static const ModelInfo info;
    std::shared_ptr<const Bsdf> make(const ModelInput& input, const Progress& progress) const;
    std::string text() const;

    friend bool operator==(const SpecialEffectModel&, const SpecialEffectModel&) = default;
};

/// Films of thicknesses uniformly distributed over a range, at eight wavelengths: each, and on
/// average.
class SpreadFilm {
 public:
    SpreadFilm(const optics::AiryFilm& film, double film_ior, optics::ThicknessRange range,
               const Wavelengths& wavelengths_nm);

    /// E_d[R], unpolarised, by Gauss-Legendre quadrature fine enough for the phases in the range:
    /// within kSpreadFilmError of the closed form optics::AiryFilm::moments.
    FloatLanes mean(float cosine) const { return mean(film_.at(cosine)); }

    /// The sum of R over the facets counted. Up to FacetTally::kListed of them: each with its own
    /// thickness. Of more, M = kListed represent all N: with their mean R_M,
    ///   N (E + sqrt(M/N) (R_M - E)),
    /// whose mean N E_d[R] and variance N Var_d[R] are those of the sum, and so are its covariances
    /// between wavelengths, including those between calls; it stays between 0 and N. Guo et al.
    /// draw a Gaussian of that mean and variance at each wavelength, which keeps neither the
    /// covariances nor the bounds.                                             [guo-2018]
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

/// Microfacets under a film, as single facets that can be told apart, each with a film of its own
/// thickness: the model of Guo et al. 2018 on the discrete microfacets of Jakob et al. 2014.
/// [guo-2018; jakob-2014; docs/special-effect.md]
///
///   f = (w_i.h) G2 / (A |Omega| (w_i.n) (w_o.n) (h.n))  (1/K) sum over facets of R(w_i.h, d_k)
///
/// summed over the facets in a patch, A its area as a fraction of the object's, that reflect w_i
/// into the cone of half-angle gamma about w_o, whose solid angle is |Omega| = 2 pi (1 - cos
/// gamma). R is the Airy reflectance, d_k uniform in d0 -+ sqrt(3) thickness_spread_nm. Reciprocal,
/// as the cone holds the same facets when w_i and w_o change places.
///
/// - evaluate_on(), sample_on(): the facets of a patch. A patch without area within the unit
///   square holds no facets to count: it gives the mean, as without a patch. The caller must
///   therefore give a footprint to see facets.
/// - eval(), evaluate(), sample(), albedo(): the mean over all patches. It is the thin-film model
///   with the reflectance averaged over thickness and the distribution averaged over the cone.
///
/// pdf() is the density of both sample() and sample_on(): visible normals, turned within the cone.
/// Under a clearcoat the directions, cone and h are those inside; the rest is as in ThinFilm.
class SpecialEffect final : public Bsdf {
 public:
    /// Reads recipe.microfacet with `facets`, recipe.clearcoat and, under a clearcoat, the binder's
    /// index at 550 nm; layers and substrate play no part.
    /// @param seed  which facets there are
    /// @param smooth_ndf  the mean over all patches on each of them
    /// @throws DomainError if there is no [microfacet] or [microfacet.facets], a number is out of
    ///         range, the clearcoat is rough, the distribution is not Beckmann's, or the spread
    ///         reaches below zero thickness (spread > thickness / sqrt 3)
    SpecialEffect(const paint::Recipe& recipe, std::uint64_t seed, bool smooth_ndf = false);
    ~SpecialEffect() override;

    std::unique_ptr<const BoundBsdf> bind(const Wavelengths& wavelengths_nm) const override;
    SurfaceCoordinates surface_coordinates() const override;

    struct Tables;

 private:
    std::shared_ptr<const Tables> tables_;
};

/// Error of albedo() of a bound special effect: 256 samples at each of 17 angles.
inline constexpr double kSpecialEffectAlbedoError = 1e-2;

}  // namespace nacre::bsdf
