#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/model.h"
#include "nacre/core/error.h"
#include "nacre/montecarlo/free_flight.h"
#include "nacre/montecarlo/plane_walk.h"
#include "nacre/montecarlo/walker.h"
#include "nacre/paint/recipe.h"
#include "nacre/spectra/spectrum.h"

// The volumetric path tracer of [mir-2022]. docs/volume.md

namespace nacre::montecarlo {

/// How the next flake along a ray is found in a medium whose extinction varies along it.
enum class Tracking {
    delta,   ///< unbiased: candidates at the largest rate on the ray, thinned    [woodcock-1965]
    simpson  ///< the optical depth by a composite Simpson rule, inverted              [mir-2022]
};

/// Chooses the model ShellWalk.
struct VolumeModel {
    /// Outer radius of the painted sphere; infinity is a flat slab of infinite extent.
    double radius_mm = std::numeric_limits<double>::infinity();
    Tracking tracking = Tracking::delta;
    /// Panels of the Simpson rule per piece of ray within one layer, two intervals each.
    int simpson_panels = 8;

    static const bsdf::ModelInfo info;
    std::shared_ptr<const bsdf::Bsdf> make(const bsdf::ModelInput& input,
                                           const Progress& progress) const;
    std::string text() const;
    void lie_on(const std::string& material, std::span<const bsdf::PaintedShape> shapes);

    friend bool operator==(const VolumeModel&, const VolumeModel&) = default;
};

inline constexpr Range kShellRadius{0, std::numeric_limits<double>::infinity(), "mm", true};
inline constexpr Range kSimpsonPanels{1, 1024};

/// A sphere with concentric layers of paint, walked through in three dimensions: clearcoat, layers
/// and below them a Lambertian sphere, all of true thickness. Normals of flakes are distributed
/// about the radial direction of the place where the flake lies, so that the medium is
/// heterogeneous although each layer is one mixture.
///
/// sample() as in PlaneWalk; besides it sets exit_mm, the place where light leaves, relative to
/// where it came in, in the frame of the entry (the centre is at -radius z). wo is in that frame
/// too, on the outer side of the sphere at the place of exit: its z may be negative. eval() and
/// pdf() are zero. Dispersive binders as in PlaneWalk. Double precision; the depth of a position is
/// never the difference of two radii, so that 15 um on 1 km keep their digits.
class ShellWalk final : public bsdf::Bsdf {
 public:
    /// @param wavelengths_nm  as in PlaneWalk
    /// @throws DomainError if the recipe is not valid at these wavelengths, has a rough clearcoat
    ///         or is thicker than the sphere, or if a setting is out of range
    /// @throws Stopped as PlaneWalk
    ShellWalk(const paint::Recipe& recipe, const VolumeModel& settings,
              const std::vector<double>& wavelengths_nm = spectra::default_wavelengths_nm(),
              const Progress& progress = {});
    ~ShellWalk() override;

    std::unique_ptr<const bsdf::BoundBsdf> bind(
        const bsdf::Wavelengths& wavelengths_nm) const override;

 private:
    std::shared_ptr<const WalkTables> tables_;
    VolumeModel settings_;
};

/// One walk through a shell of paint, in the frame of its entry: the origin lies on the outer
/// sphere, whose centre is at -z / curvature.
class ShellWalker : private Walker {
 public:
    /// @param curvature_per_um  of the outer sphere; 0 is a flat slab
    ShellWalker(const Medium& medium, double index, double curvature_per_um,
                const VolumeModel& settings, RandomStream& random)
        : Walker(medium, random),
          index_(index),
          outer_curvature_(curvature_per_um),
          settings_(settings) {}

    /// @param travel  inside the paint, z < 0
    std::optional<Escape> run(const Vec3d& travel, const Lanes& weight);

 private:
    void fly();
    void collide(const Slab& slab, double choice);
    void collide_with_candidate(const Flakes& species);
    void descend();
    void ascend();
    Vec3d normal() const;

    double index_, outer_curvature_;
    const VolumeModel& settings_;

    // state_.depth_um is kept separately from the position, to all digits.
    Vec3d position_ = Vec3d{};
    double slab_top_um_ = 0;  ///< depth of the slab's top below the outer sphere
    std::optional<Escape> escape_;
};

}  // namespace nacre::montecarlo
