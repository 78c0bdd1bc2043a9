#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "nacre/bsdf/models/nacre.h"

namespace nacre::bsdf {

/// The models `microflake` and `nacre` as arrays, for programs that evaluate them themselves:
/// plug-ins of other renderers, shaders. What is done with them is written down where Nacre does it,
/// BoundMicroflake and BoundNacre.
///
/// W: wavelengths of the solved paint. D = kDirectionIntervals + 1: directions, even in
/// tan(theta / 2) outside the coat from 0 to 1.
struct NacreArrays {
    std::vector<double> wavelengths_nm;   ///< (W,)
    std::vector<double> ior;              ///< (W,) of the binder
    std::vector<double> clearcoat_depth;  ///< (W,) optical depth of the clearcoat
    double mean_ior = 1;
    double coat_roughness = 0;  ///< Beckmann alpha of the interface; 0: smooth

    /// What is not closed: SmoothTable. Under a rough coat it holds single scattering as well, as
    /// the last `single_rank` of its terms.
    SmoothGrid grid;
    int rank = 0, single_rank = 0;
    std::vector<float> smooth;         ///< (a, b, q, rank)
    std::vector<double> smooth_basis;  ///< (rank, W)

    struct Flake {
        double area_density_per_um;
        double alpha;
        int cosines;                      ///< 1: the reflectance does not depend on angle
        std::vector<double> reflectance;  ///< (cosines, W), even in w.m from 0 to 1
    };
    struct Pigment {
        double anisotropy;                      ///< g of Henyey and Greenstein's phase function
        std::vector<double> scattering_per_um;  ///< (W,)
        /// Another phase function, in 1/sr: (PhaseFunction::kIntervals + 1, W), even in the angle by
        /// which light is turned, from 0 to 180 deg. Empty: that of g.
        std::vector<double> phase;
    };
    struct Layer {
        double thickness_um;
        std::vector<float> extinction_per_um;  ///< (D, W)
        std::vector<Flake> flakes;
        std::vector<Pigment> pigments;
    };
    std::vector<Layer> layers;

    /// (D, 4): probabilities with which Nacre draws from the interface, from all else by a table,
    /// and evenly, and the fraction of what the table stands for that is scattered once; and (D, W)
    /// directional albedo. Both are empty of ArrayParts::mean.
    std::vector<float> probability, albedo;

    /// A rough interface: masking over the cosine (D,), what is masked (D, W), and the scale of the
    /// light that comes of it (W,). Empty where it is smooth.
    std::vector<double> masking_over_cosine, masked, diffuse_scale;

    struct HotSpotSpecies {
        std::size_t layer;
        float diameter_um;
        std::vector<float> coupling;  ///< (D, W)
    };
    struct HotSpotArrays {
        std::vector<HotSpotSpecies> species;
        std::vector<float> ground, compensation;  ///< (D, W), or empty
    };
    /// Of `nacre`. Under a rough coat `smooth` holds the mean with it, and this is for single flakes.
    std::optional<HotSpotArrays> hot_spot;

    struct Species {
        sparkle::FlakeField::Constants field;
        double density_per_mm2;
        double alpha, waviness;
        double fraction;                 ///< flake_fractions()
        double radius_um;                ///< DiffractionLobe::radius() is this over the diameter
        std::vector<float> diameter_um;  ///< by the last 8 bits of a flake
        int film_sets = 0;               ///< 0: all flakes alike
        double film_min_cosine = 0;
        /// (sets, FlakeFilms::kCosineIntervals + 1, W)
        std::vector<float> film_ratio;
    };
    std::vector<Species> species;  ///< of `nacre`: those of all layers, one after the other
};

/// What of the arrays is made.
enum class ArrayParts {
    all,
    mean  ///< in a fraction of the time: without `probability`, `albedo` and the films of single
          ///< flakes, which are all alike
};

/// @throws Error, DomainError, Stopped as Nacre's constructor; DomainError if the recipe has an
///         orange_peel or a coat_spread(), which the arrays do not hold
NacreArrays nacre_arrays(const std::shared_ptr<const solver::SolvedPaint>& paint,
                         const NacreModel& settings, ArrayParts parts = ArrayParts::all,
                         const Progress& progress = {});
/// ArrayParts::mean of `nacre` for pictures that follow a slider. Waves of the coat (orange_peel) and
/// the spread of its thickness are left out.
/// @throws Error as HotSpotTables; DomainError as FlakeField
NacreArrays nacre_live_arrays(const std::shared_ptr<const solver::SolvedPaint>& paint,
                              std::uint64_t specimen);
/// Without hot spot and species. @throws Error as Microflake's constructor; DomainError as above
NacreArrays microflake_arrays(const std::shared_ptr<const solver::SolvedPaint>& paint,
                              ArrayParts parts = ArrayParts::all);

}  // namespace nacre::bsdf
