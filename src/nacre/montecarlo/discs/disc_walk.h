#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/model.h"
#include "nacre/montecarlo/discs/disc.h"
#include "nacre/montecarlo/discs/disc_films.h"
#include "nacre/montecarlo/discs/disc_scene.h"
#include "nacre/montecarlo/plane_walk.h"
#include "nacre/montecarlo/walker.h"
#include "nacre/paint/recipe.h"
#include "nacre/spectra/spectrum.h"

// The reference for sparkle: paint with every flake at an explicit position.
// docs/explicit-flakes.md

namespace nacre::montecarlo {

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

    bool leans_by_itself() const override;
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
