#pragma once

#include <array>
#include <memory>
#include <optional>

#include "nacre/core/lanes.h"
#include "nacre/core/vec.h"

// What the renderer sees of a surface. Local frame: z is the outward normal; both directions point
// away from the surface; a BRDF is in 1/sr, without the cosine (docs/conventions.md). All of
// Nacre's surfaces are opaque: a direction below the horizon gives zero.

namespace nacre::bsdf {

using Wavelengths = std::array<double, kLanes>;  // nm

struct BsdfSample {
    Vec3f wo;
    FloatLanes weight;  ///< f |cos| / pdf; for the mirror, its reflectance over its probability
    float pdf = 0;      ///< per solid angle; for the mirror, the probability of choosing it
    bool mirror = false;
    /// Where the light leaves, from where it came in, in the local frame, in mm: other than zero
    /// only for surfaces that follow it through their volume (volume/).
    Vec3f exit_mm{};
};

struct BsdfValue {
    FloatLanes f{};  ///< as eval() gives it
    float pdf = 0;   ///< as pdf() gives it
};

/// The piece of a surface that one sample of a picture looks at: a parallelogram about (u, v) in
/// the unit square over which the shape is laid out (render/compiled_scene.h), spanned by two
/// edges. Without edges it is a point. Surfaces that show single flakes depend on it.
struct Patch {
    double u = 0, v = 0;
    Vec2f edge_1, edge_2;
};

/// A surface at eight wavelengths: all that depends on wavelength alone has been worked out, so
/// that the calls below touch only what depends on direction. Immutable, shared between threads.
class BoundBsdf {
 public:
    virtual ~BoundBsdf() = default;

    /// BRDF without the mirror of a smooth interface. Reciprocal and never negative.
    virtual FloatLanes eval(Vec3f wi, Vec3f wo) const = 0;
    /// Draws wo given wi from a mixture that includes the mirror. u_lobe and u in [0, 1).
    /// Empty where no light can leave (wi below the horizon, or a sample below it).
    virtual std::optional<BsdfSample> sample(Vec3f wi, float u_lobe, Vec2f u) const = 0;
    /// Density per solid angle with which sample() draws wo other than by the mirror.
    virtual float pdf(Vec3f wi, Vec3f wo) const = 0;
    /// Both at once, for light sampling with multiple importance: they share most of the work.
    virtual BsdfValue evaluate(Vec3f wi, Vec3f wo) const { return {eval(wi, wo), pdf(wi, wo)}; }
    /// The same on one patch of the surface. A surface that is alike everywhere has only the above;
    /// one that shows single flakes has their mean above, and here those of the patch.
    virtual BsdfValue evaluate_on(const Patch&, Vec3f wi, Vec3f wo) const {
        return evaluate(wi, wo);
    }
    virtual std::optional<BsdfSample> sample_on(const Patch&, Vec3f wi, float u_lobe,
                                                Vec2f u) const {
        return sample(wi, u_lobe, u);
    }

    /// Directional-hemispherical reflectance, mirror included.
    virtual FloatLanes albedo(Vec3f wi) const = 0;
};

class Bsdf {
 public:
    virtual ~Bsdf() = default;
    virtual std::unique_ptr<const BoundBsdf> bind(const Wavelengths& wavelengths_nm) const = 0;
    /// Whether evaluate_on() and sample_on() differ from patch to patch. Such a surface needs a
    /// shape that is laid out over the unit square.
    virtual bool varies_over_surface() const { return false; }
};

}  // namespace nacre::bsdf
