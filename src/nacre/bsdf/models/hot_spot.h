#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "nacre/bsdf/models/bound_microflake.h"
#include "nacre/bsdf/wavelength_lanes.h"
#include "nacre/core/lanes.h"
#include "nacre/solver/solved_paint.h"
#include "nacre/sparkle/coat_tilt.h"

namespace nacre::bsdf {

// The hot spot of large flakes: attenuation on the way in and on the way out is correlated.
//
// Opaque discs of diameter d block a ray with the rate sigma_b / mu where their centres lie within d/2
// of it. Two rays that leave one flake, of tangents t_i and t_o, are delta dz apart after a step dz in
// height, delta = |t_i - t_o|; discs that block both count once:
//
//     V(z) = exp(-kappa z + sqrt(sigma_b(w_i) sigma_b(w_o) / (mu_i mu_o)) Int_0^z O(delta z'/d) dz'),
//     sigma_b(w) = c Int (1 - T)^2 |w.m| D(m) dm,
//     O(xi) = (2/pi) (acos xi - xi sqrt(1 - xi^2))     for xi < 1, the overlap of two discs,
//
// as in the theory of leaf canopies [kuusk-1985]. A disc with transmittance T blocks neither ray
// wholly: both together pass T^2, so that 1 - T enters squared. Each layer and species above the
// flake adds its part. With delta -> 0 (towards the light) or d -> infinity a flake that is lit is
// seen; with d -> 0 the transfer equation holds again. The same holds for light that a pigment or
// the ground scatters once.
//
// Light that leaves after it was scattered once is missing from what is scattered again, which is
// dimmed by C(i) C(o) (hot_spot_compensation.h).
//
// A rough clearcoat turns each ray on its own: delta is then the mean over its facets
// (CoatTilt::separation), and the compensation is that of rough_hot_spot.h.

/// What does not depend on the wavelengths that are bound.
class HotSpotTables {
 public:
    /// @throws Error as compensation_factors()
    explicit HotSpotTables(const solver::SolvedPaint& paint);

    struct Species {
        std::size_t layer;
        float diameter_um;            ///< mean, weighted by area
        std::vector<float> coupling;  ///< [direction][wavelength]: sqrt(sigma_b / mu)
    };
    const std::vector<Species>& species() const { return species_; }
    /// [direction][wavelength]. The product of two directions: of ground(), the light that the
    /// ground alone has scattered, without Fresnel factors; of compensation(), what multiple scattering
    /// is multiplied by. Empty where that is 0, or 1, and under a rough clearcoat.
    const std::vector<float>& ground() const { return ground_; }
    const std::vector<float>& compensation() const { return compensation_; }
    /// Likewise what light gains that the interface had sent back: internal_reflection_gains(). Empty where no
    /// flakes lean, the only case in which it is stored by itself.
    const std::vector<float>& returned() const { return returned_; }

    const std::vector<std::vector<float>>& extinction() const { return extinction_; }
    /// How the rays are spread; not at all by a smooth clearcoat.
    const sparkle::CoatTilt& coat() const { return coat_; }

 private:
    friend class HotSpot;
    void tabulate_ground(const solver::PaintMedium& medium);

    std::vector<Species> species_;
    std::vector<float> top_um_, thickness_um_;  // by layer
    int wavelength_count_;
    std::vector<std::vector<float>> extinction_;  // extinction_by_direction()
    std::vector<float> ground_, compensation_, returned_;
    sparkle::CoatTilt coat_;
};

/// Int_0^x O(xi) dxi; 4 / (3 pi) for x >= 1.
double disc_overlap_integral(double x);

/// Bound of what is exponentiated, as single precision ends at exp(88). The gain, ln V + kappa z, is
/// at most half of kappa z: beyond this bound less than exp(-40) of light is left.
inline constexpr float kMaxGain = 40;

class HotSpot {
 public:
    HotSpot(const HotSpotTables& tables, const std::array<WavelengthPosition, kLanes>& where);

    /// A pair of directions.
    class Pair {
     public:
        Pair(const HotSpot& hot_spot, const Ray& i, const Ray& o);
        /// ln V + kappa z, at the fraction u = z / H of the layer's thickness.
        FloatLanes gain(std::size_t layer, float u) const;
        /// Adds it to sums[lane], at the fraction u[lane] each.
        void add_gains(std::size_t layer, const FloatLanes& u,
                       std::array<FloatLanes, kLanes>& sums) const;
        /// The mean of V over that of exp(-kappa z), for a layer whose optical depth
        /// along both directions is `depth`.
        FloatLanes mean(std::size_t layer, const FloatLanes& depth) const;
        /// All light that was not scattered once in a layer, without Fresnel factors.
        /// @param transfer  the same by the equation of transfer
        FloatLanes multiple(const FloatLanes& transfer) const {
            return multiple(transfer, compensation());
        }
        /// @param compensation  compensation(), where it is known
        FloatLanes multiple(const FloatLanes& transfer, const FloatLanes& compensation) const;
        /// The factor of what was scattered more than once.
        FloatLanes compensation() const;
        /// The factor of what the interface had sent back; the rest then has as much less.
        FloatLanes internal_reflection_gain() const;
        /// Of it, what the ground alone has scattered, by the equation of transfer; and the factor
        /// of the hot spot.
        FloatLanes ground() const;
        FloatLanes ground_gain() const;

     private:
        // Calls add(coupling, length_um(u) as a function) for the species that lie over the layer.
        template <class Add>
        void for_each_species(std::size_t layer, Add&& add) const;

        const HotSpot* hot_spot_;
        const Ray *i_, *o_;
        float spread_;  // delta
        // What mean() gave last: all that lies in a layer asks for the same.
        mutable std::size_t mean_layer_ = ~std::size_t{0};
        mutable FloatLanes mean_depth_, mean_;
    };

 private:
    struct Species {
        std::size_t layer;
        float diameter_um;
        std::vector<FloatLanes> coupling;  // by direction
    };
    // disc_overlap_integral() to 1e-6.
    template <class T>
    T overlap(const T& x) const;

    std::vector<Species> species_;
    std::vector<float> top_um_, thickness_um_;
    std::vector<FloatLanes> ground_, compensation_, returned_;  // by direction, or empty
    sparkle::CoatTilt coat_;
    std::span<const float> overlap_;  // disc_overlap_integral() at even x, 0 to 1 and once more
};

}  // namespace nacre::bsdf
