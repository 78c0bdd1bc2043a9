#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/model.h"
#include "nacre/bsdf/wavelength_lanes.h"
#include "nacre/core/lanes.h"
#include "nacre/montecarlo/discs/disc.h"
#include "nacre/montecarlo/discs/disc_scene.h"
#include "nacre/montecarlo/plane_walk.h"
#include "nacre/montecarlo/walker.h"
#include "nacre/paint/recipe.h"
#include "nacre/spectra/spectrum.h"

// Diffraction at a flat disc that mirrors light.

namespace nacre::montecarlo {

/// The Airy pattern in x = pi d |q| / lambda', where d is the diameter, q the part parallel to the
/// disc by which the direction differs from that of the mirror, and lambda' the wavelength in the
/// binder: power is spread over q with a density proportional to (2 J_1(x) / x)^2.
///                                                   [born-wolf-1999, section 8.5.2, eq. 14 and 18]
/// The disc is lit uniformly; transmitted light, and light that passes beside it, go straight on.
/// In q the pattern is round at any angle of incidence, and it is reciprocal.
class AiryDisc {
 public:
    /// The x within which this fraction of the power lies. fraction in [0, 1); error in the
    /// fraction below kAiryDiscError min(fraction, 1 - fraction).
    static double radius_of_fraction(double fraction);
};

/// Of radius_of_fraction(), against the encircled power.
inline constexpr double kAiryDiscError = 3e-3;

/// Fraction of the power within x: 1 - J_0(x)^2 - J_1(x)^2.
///                                                          [born-wolf-1999, section 8.5.2, eq. 18]
double encircled_power(double x);

// R and T of single flakes, each of its own film thicknesses.

/// Where eight wavelengths lie between those of the tables: bsdf::locate_wavelengths().
using WavelengthPlaces = std::array<bsdf::WavelengthPosition, kLanes>;

/// A set of flakes of one species. Their films are drawn from the recipe's laws, evenly: each film
/// thickness takes one value from each of so many equally probable intervals, and thicknesses are
/// combined at random.                                                    [mckay-1979, section 2.3]
class DiscFilms {
 public:
    /// @param wavelengths_nm  within the data of all materials, increasing
    /// @throws DomainError, Stopped as optics::platelet_table()
    DiscFilms(const paint::FlakeSpecies& species, const optics::Material& binder,
              const std::vector<double>& wavelengths_nm, std::uint64_t seed,
              SharedProgress* work = nullptr);

    /// How many different flakes there are: one where no film varies.
    int count() const { return count_; }

    struct Optics {
        DoubleLanes reflectance, transmittance;
    };
    /// Linear in cosine and wavelength between the nodes of the tables.
    /// @param film    in [0, count())
    /// @param cosine  of incidence on the flake, in [0, 1]; rounding above 1 is taken as 1
    Optics at(int film, double cosine, const WavelengthPlaces& places) const;

    static constexpr int kFilms = 256;
    static constexpr int kCosineIntervals = 256;

 private:
    void fill(const paint::FlakeSpecies& species, const optics::Material& binder,
              const std::vector<double>& wavelengths_nm, std::uint64_t seed, SharedProgress* work);

    int count_ = 1, intervals_ = 0;
    std::size_t stride_ = 0;
    std::vector<float> reflectance_, transmittance_;  // [film][cosine][wavelength]
};

/// What all walks at eight wavelengths share.
struct DiscPaint {
    const DiscScene& discs;
    const std::vector<DiscFilms>& films;  ///< by species
    const Medium& medium;                 ///< all but the flakes
    WavelengthPlaces places;
    bool diffraction = true;
    double wavelength_um = 0.55;        ///< mean of the eight, in vacuum
    std::vector<double> waviness = {};  ///< by species, as a recipe's
};

/// One walk through a paint of discs, in the frame of the tile: x and y within it, z = 0 at the
/// interface and z > 0 outwards.
class DiscWalker : private Walker {
 public:
    DiscWalker(const DiscPaint& paint, const AirInterface& interface, double index,
               RandomStream& random)
        : Walker(paint.medium, random), paint_(paint), interface_(interface), index_(index) {}

    /// @param x_um, y_um  where light comes in, anywhere: taken modulo the tile
    /// @param travel      inside the paint, z < 0
    std::optional<Escape> run(double x_um, double y_um, const Vec3d& travel, const Lanes& weight);

 private:
    void fly();
    void collide_with_disc(std::uint32_t disc);
    Vec3d surface_normal(const Vec3d& plane, double waviness);
    Vec3d spread(const Vec3d& specular, const Vec3d& normal, double diameter_um);
    void descend();
    void ascend();

    const DiscPaint& paint_;
    const AirInterface& interface_;
    double index_;

    Vec3d position_ = Vec3d{}, moved_ = Vec3d{};
    std::uint32_t leaving_ = DiscScene::kNone;
    double slab_top_ = 0;  ///< z of the top of the slab
    std::optional<Escape> escape_;
};

// The reference for sparkle: paint with every flake at an explicit position.
// docs/explicit-flakes.md

class DiscScene;
struct DiscWalkTables;

/// A tile's sides are at least this times the thickness of the paint.
inline constexpr double kMinTileFraction = 0.1;

/// Chooses DiscWalk: the model nacre with every flake at an explicit position, its reference.
struct ExplicitFlakesModel {
    /// The piece of paint that repeats itself over the panel, in kTileSide. As large as the panel:
    /// nothing repeats, and only light that crosses the panel's edge within the paint comes back at
    /// the opposite one.
    double tile_width_mm = 10, tile_height_mm = 10;
    std::uint64_t specimen = 0;  ///< which flakes there are
    /// Whether a flake spreads the light that it reflects by the Airy pattern of its disc
    /// (AiryDisc) at the mean of the eight wavelengths; if not, it reflects into one direction.
    bool diffraction = true;

    static const bsdf::ModelInfo info;
    std::shared_ptr<const bsdf::Bsdf> make(const bsdf::ModelInput& input,
                                           const Progress& progress) const;
    std::string text() const;
    void lie_on(const std::string& material, std::span<const bsdf::PaintedShape> shapes);

    friend bool operator==(const ExplicitFlakesModel&, const ExplicitFlakesModel&) = default;
};

/// A flat panel of paint whose flakes are discs, and whose light is followed from disc to disc by
/// ray tracing instead of the equation of transfer. It includes the shadows of single flakes, the
/// correlation between the way in and the way out (the hot spot), and the parallax of flakes at
/// depth.
///
/// Patches are read in object space (bsdf::SurfaceCoordinates::object_space): the panel's plane
/// must be one of z = const, x and y give the position. Without a patch the position is random: the
/// mean over the panel. Only sample() and sample_on() tell what the paint looks like, as with
/// PlaneWalk: eval() and pdf() are zero, and a renderer sees no light source without extent.
///
/// Supports all that a recipe may say. R and T of a flake are those of its own films (DiscFilms);
/// pigments scatter between the flakes; the interface may be rough.
class DiscWalk final : public bsdf::Bsdf {
 public:
    /// @param wavelengths_nm  as for PlaneWalk
    /// @throws DomainError if the recipe is not valid at these wavelengths, naming a setting out of
    ///         range, or as require_discs()
    /// @throws Error as require_discs(); Stopped if `progress` says so
    DiscWalk(const paint::Recipe& recipe, const ExplicitFlakesModel& settings,
             const std::vector<double>& wavelengths_nm = spectra::default_wavelengths_nm(),
             const Progress& progress = {});
    ~DiscWalk() override;

    std::unique_ptr<const bsdf::BoundBsdf> bind(
        const bsdf::Wavelengths& wavelengths_nm) const override;
    bsdf::SurfaceCoordinates surface_coordinates() const override {
        return bsdf::SurfaceCoordinates::object_space;
    }

    const DiscScene& scene() const;

 private:
    std::shared_ptr<const DiscWalkTables> tables_;
};

}  // namespace nacre::montecarlo
