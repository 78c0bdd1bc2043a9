#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "nacre/core/lanes.h"
#include "nacre/core/vec.h"
#include "nacre/sparkle/footprint.h"

// What the renderer sees of a surface. Local frame: z is the outward normal; both directions point
// away from the surface; a BRDF is in 1/sr, without the cosine (docs/conventions.md). Paints are
// opaque: a direction below the horizon gives zero; glass alone transmits() there.

namespace nacre::sparkle {
class CoatThickness;
class CoatWaves;
}  // namespace nacre::sparkle

namespace nacre::bsdf {

class InterfaceLobe;

using Wavelengths = std::array<double, kLanes>;  // nm

/// What is known of how a sampled direction was drawn. It decides whether a renderer may weigh the
/// sample against others, and whether ray differentials can be followed further.
enum class SampleKind {
    density,          ///< from a density per solid angle, which pdf() gives as well
    specular,         ///< the reflection or refraction of a smooth interface: a delta distribution
    unknown_density,  ///< by a random walk, whose density has no closed form
    null              ///< passes straight through, attenuated (BoundBsdf::null_transmission)
};

/// One direction drawn by BoundBsdf::sample().
struct BsdfSample {
    Vec3f wo;
    /// What the mean of L(wo) weight over all samples needs to be the reflected radiance of
    /// incident light L: f |cos| / pdf for `density`, reflectance (or transmittance) / pdf for
    /// `specular` and `null`, and for
    /// `unknown_density` the part of the walk's light that leaves.
    FloatLanes weight;
    /// For `density` per solid angle in 1/sr, for `specular` and `null` the probability of
    /// choosing that, for `unknown_density` without meaning and 1.
    float pdf = 0;
    SampleKind kind = SampleKind::density;
    /// Where the light leaves, from where it came in, in the local frame, in mm: other than zero
    /// only for surfaces that follow it through their volume (montecarlo/).
    Vec3f exit_mm{};
};

struct BsdfValue {
    FloatLanes f{};  ///< as eval() gives it
    float pdf = 0;   ///< as pdf() gives it
};

/// Weight of a way to sample with density `own` where another has density `other`: the power
/// heuristic with exponent 2.                                          [veach-1997, eq. 9.13]
template <class T>
T power_heuristic(const T& own, const T& other) {
    // By the ratio: the squares of densities of a small sun and a sharp lobe could overflow.
    const T ratio = other / own;
    return 1.0f / (1.0f + ratio * ratio);
}

/// A direction from which a flake of a patch may reflect light (BoundBsdf::sample_flakes).
struct FlakeSample {
    Vec3f wo;       ///< a direction out of its lobe
    float pdf = 0;  ///< directions of this flake in all, per solid angle at wo
    /// Selection weight: about the luminance of flake_weight().
    float strength = 0;
    int species = 0, flake = 0;
    FloatLanes colour{};  ///< nearly flake_weight() over `strength`
};

/// Eight of one species; those whose strength is 0 send no light.
struct FlakeSamples {
    Vec3Lanes wo;
    FloatLanes pdf, strength;
    std::array<FloatLanes, kLanes> colour;  ///< by flake
    IntLanes number;                        ///< FlakeSample::flake
    int species;

    FlakeSamples() {}  // no value: all of it is written before it is read
    FlakeSample flake(int lane) const {
        return {nacre::lane(wo, lane), pdf[lane],   strength[lane], species,
                number[lane],          colour[lane]};
    }
};

/// Has turn(wo, pdf) change both of each flake; one for which it is false sends no light.
template <class Turn>
void for_each_sample(std::vector<FlakeSamples>& list, Turn&& turn) {
    for (FlakeSamples& flakes : list) {
        for (int i = 0; i < kLanes; ++i) {
            if (flakes.strength[i] == 0) continue;
            Vec3f wo = lane(flakes.wo, i);
            float pdf = flakes.pdf[i];
            if (!turn(wo, pdf)) {
                flakes.strength[i] = 0;
                continue;
            }
            flakes.wo.x[i] = wo.x;
            flakes.wo.y[i] = wo.y;
            flakes.wo.z[i] = wo.z;
            flakes.pdf[i] = pdf;
        }
    }
}

/// A cache of what a surface has computed for a patch, so that it need not be computed again for
/// the next pair of directions. Owned by the caller, one per thread.
class PatchMemory {
 public:
    /// @param bytes  BoundBsdf::patch_memory_bytes() of the surfaces that it will serve
    explicit PatchMemory(std::size_t bytes = 0)
        : blocks_((bytes + sizeof(Block) - 1) / sizeof(Block)) {}

    /// To be called before another patch or another surface is evaluated.
    void forget() { filled = 0; }

    std::byte* data() { return blocks_.empty() ? nullptr : blocks_[0].bytes; }
    /// Bits set by the surface once parts of data() tell about the patch.
    unsigned filled = 0;
    /// Room for the flakes of a patch that are sampled, and two numbers for each; kept from patch to
    /// patch, so that nothing is allocated once the largest has been seen.
    std::vector<FlakeSamples> flake_samples;
    std::vector<FloatLanes> brightness, strength;

 private:
    struct Block {  // no value: whole vectors are written before they are read
        Block() {}
        alignas(64) std::byte bytes[64];
    };
    std::vector<Block> blocks_;
};

/// Refractive index of the binder under a smooth interface: at each of the wavelengths, and the one
/// by which directions are refracted. 1 of a surface without.
struct BinderIndex {
    float mean = 1;
    FloatLanes each = splat(1.0f);
};

/// Optical depths of layers of flakes, along the layers' normal: extinction for one direction times the
/// thickness. Divided by the direction's cosine they are those along it.
struct OpticalDepths {
    FloatLanes flake_extinction{};    ///< light that meets a flake and does not pass straight on
    FloatLanes flake_scattering{};    ///< of it, what flakes reflect
    FloatLanes pigment_extinction{};  ///< scattered or absorbed by pigments
    FloatLanes pigment_absorption{};  ///< of it, absorbed
};

/// What was scattered more than once, or by the ground.
struct MultiplyScattered {
    FloatLanes all{};
    /// Of it, what has met the ground: all that lies below the lowest flakes.
    FloatLanes from_ground{};
    /// Of the rest, what left the coat when it first met the interface from inside.
    FloatLanes no_internal_reflection{};
};

/// The piece of a surface that one sample of a picture looks at, in the terms that the surface
/// needs (SurfaceCoordinates). Surfaces that show single flakes depend on it.
struct Patch {
    /// A parallelogram about (u, v) in the unit square over which the shape is laid out
    /// (render/compiled_scene.h), spanned by two edges. Without edges it is a point.
    double u = 0, v = 0;
    Vec2f edge_1, edge_2;
    /// The same in the millimetres of object space.
    sparkle::ObjectSpaceFootprint footprint{};
    /// Null: nothing is kept after a call.
    PatchMemory* memory = nullptr;
    /// What evaluate_on() and sample_on() show of single flakes.
    enum class Flakes {
        shown,    ///< all that there is
        sampled,  ///< none: they are sampled one by one, by sample_flakes() and flakes_at()
        left_out  ///< none: another sample of the pixel has those of this patch
    };
    Flakes flakes = Flakes::shown;
    /// Where flakes are sampled or left out: the density of directions over a light narrower than
    /// their lobes (BoundBsdf::narrow_light_pdf()), the inverse of its solid angle; 0 for other light.
    /// Of such light the flakes that stand for others show as many flashes as there are.
    float narrow_light_pdf = 0;
};

/// What becomes of a BRDF f where the coat is thinner or thicker: factor f + added.
struct CoatChange {
    FloatLanes factor = splat(1.0f);  ///< of light that crosses the coat once in and once out
    FloatLanes added{};               ///< for all other light
};

/// Numbers in [0, 1), from the first to before the second.
struct UnitRange {
    float from = 0, to = 0;
};

/// The coordinates by which a surface varies.
enum class SurfaceCoordinates {
    none,                 ///< it does not vary
    unit_square,          ///< by fractions of the unit square over which the shape is laid out
    object_space,         ///< by millimetres of the shape before it is turned and moved
    place_in_unit_square  ///< as unit_square, by the place alone: a patch without edges will do
};

/// A surface at eight wavelengths: all that depends on wavelength alone has been worked out, so
/// that the calls below touch only what depends on direction. Immutable, shared between threads.
class BoundBsdf {
 public:
    virtual ~BoundBsdf() = default;

    /// BRDF without the specular lobe of a smooth interface. Reciprocal and never negative.
    virtual FloatLanes eval(Vec3f wi, Vec3f wo) const = 0;
    /// Draws wo given wi from a mixture that includes the specular lobe. u_select and u in [0, 1).
    /// Empty where no light can leave (wi below the horizon, or a sample below it).
    virtual std::optional<BsdfSample> sample(Vec3f wi, float u_select, Vec2f u) const = 0;
    /// Density per solid angle with which sample() draws wo other than by the specular lobe.
    virtual float pdf(Vec3f wi, Vec3f wo) const = 0;
    /// pdf() of eight directions.
    virtual FloatLanes pdf_lanes(Vec3f wi, const Vec3Lanes& wo) const {
        return make_lanes([&](int k) { return pdf(wi, lane(wo, k)); });
    }
    /// Probability, below 1, with which sample() draws the specular reflection, if just the lower
    /// u_select choose it; then a renderer may trace it besides the rest. 0 where they do not. On a
    /// patch it is the same, unless that shows flakes (Patch::Flakes).
    virtual float specular_probability(Vec3f /*wi*/) const { return 0; }
    /// Both at once, for light sampling with multiple importance: they share most of the work.
    virtual BsdfValue evaluate(Vec3f wi, Vec3f wo) const { return {eval(wi, wo), pdf(wi, wo)}; }
    /// The same on one patch of the surface. A surface that does not vary has only the above;
    /// one that shows single flakes has their mean above, and here those of the patch.
    virtual BsdfValue evaluate_on(const Patch&, Vec3f wi, Vec3f wo) const {
        return evaluate(wi, wo);
    }
    virtual std::optional<BsdfSample> sample_on(const Patch&, Vec3f wi, float u_select,
                                                Vec2f u) const {
        return sample(wi, u_select, u);
    }

    /// Whether single flakes can be sampled one by one (Patch::Flakes).
    virtual bool samples_flakes() const { return false; }
    /// The density of directions over a light, per solid angle, above which it is narrower than the
    /// lobes of single flakes: then it is for light samples alone to find it.
    virtual float narrow_light_pdf(Vec3f /*wi*/) const {
        return std::numeric_limits<float>::infinity();
    }
    /// Samples the flakes of a patch: draws a direction from the lobe of each, or several from a wide
    /// one, with 32 random bits, for a list that is written anew. The sum of flake_weight() times
    /// the light from wo over the list estimates what the flakes reflect.
    virtual void sample_flakes(const Patch&, Vec3f /*wi*/, std::uint32_t /*random*/,
                               std::vector<FlakeSamples>& list) const {
        list.clear();
    }
    /// f |cos| / pdf of the flake alone, at the direction that was drawn.
    virtual FloatLanes flake_weight(const Patch&, Vec3f /*wi*/, const FlakeSample&) const {
        return FloatLanes{};
    }
    /// f of the flakes of a patch for a direction that was drawn otherwise, with this density:
    /// each weighed by power_heuristic() against sample_flakes(). Infinite: not weighed.
    virtual FloatLanes flakes_at(const Patch&, Vec3f /*wi*/, Vec3f /*wo*/, float /*pdf*/) const {
        return FloatLanes{};
    }

    /// The size of PatchMemory that serves evaluate_on() and sample_on().
    virtual std::size_t patch_memory_bytes() const { return 0; }

    /// Directional-hemispherical reflectance, specular lobe included.
    virtual FloatLanes albedo(Vec3f wi) const = 0;

    // Of surfaces whose interface may be tilted (TiltedCoat).

    virtual BinderIndex binder_index() const { return {}; }
    /// Of a rough one, the lobe that is part of eval(); null of a smooth one. Valid as long as the surface.
    virtual const InterfaceLobe* interface_lobe() const { return nullptr; }
    /// The u_select for which sample_on() the patch, or sample() if it is null, draws from that lobe. The
    /// width of the range is the probability of doing so, by which pdf() weighs the density of the lobe.
    virtual UnitRange interface_lobe_range(const Patch* /*patch*/, Vec3f /*wi*/) const {
        return {};
    }

    // Of surfaces whose flakes may lean (LeaningFlakes).

    /// Optical depth of the clear coat along its normal.
    virtual FloatLanes coat_depth() const { return FloatLanes{}; }
    /// Of eval(), above the horizon.
    virtual MultiplyScattered multiply_scattered(Vec3f /*wi*/, Vec3f /*wo*/) const { return {}; }
    /// Of the layers down to the lowest flakes, for light whose cosine inside to the flakes' mean normal,
    /// above 0, is given.
    virtual OpticalDepths optical_depths(float /*cosine*/) const { return {}; }

    /// Of surfaces whose coat is thicker at some places than at others (VariedCoat): for directions
    /// above the horizon, where the thickness deviates from its mean by so many standard
    /// deviations.
    virtual CoatChange coat_change(Vec3f /*wi*/, Vec3f /*wo*/, float /*deviation*/) const {
        return {};
    }
    /// CoatChange::factor alone, which is that of single flakes.
    virtual FloatLanes coat_factor(Vec3f /*wi*/, Vec3f /*wo*/, float /*deviation*/) const {
        return splat(1.0f);
    }

    // Of glass. wi.z > 0 always: a ray that arrives from behind asks from_behind().

    /// Whether a direction wo.z < 0 has a value, a density and samples.
    virtual bool transmits() const { return false; }
    /// The same face seen from its other side.
    virtual const BoundBsdf& from_behind() const { return *this; }
    /// What is left of light that has gone so far on this side before it arrives.
    virtual FloatLanes transmittance(float /*distance_mm*/) const { return splat(1.0f); }
    /// Transmittance of light that keeps its direction: what `null` samples carry on average.
    virtual FloatLanes null_transmission(Vec3f /*wi*/) const { return FloatLanes{}; }
};

class Bsdf {
 public:
    virtual ~Bsdf() = default;
    virtual std::unique_ptr<const BoundBsdf> bind(const Wavelengths& wavelengths_nm) const = 0;
    /// Which part of a Patch evaluate_on() and sample_on() read.
    virtual SurfaceCoordinates surface_coordinates() const { return SurfaceCoordinates::none; }
    /// Whether shadows of the surface are lit through it (BoundBsdf::null_transmission).
    virtual bool has_null_transmission() const { return false; }
    /// Whether they differ from patch to patch.
    bool varies_over_surface() const { return surface_coordinates() != SurfaceCoordinates::none; }
    /// The waves of its coat, by which a renderer tilts it (TiltedCoat): the calls of BoundBsdf are of
    /// the flat one. Null: it is flat. Not of surfaces whose samples have an unknown density.
    virtual const sparkle::CoatWaves* coat_waves() const { return nullptr; }
    /// By which a renderer varies the thickness of its coat (VariedCoat): the calls of BoundBsdf are of
    /// the mean thickness. Null: it is even, or nothing is seen of it. Not of surfaces whose samples have
    /// an unknown density.
    virtual const sparkle::CoatThickness* coat_thickness() const { return nullptr; }
    /// Tangents of the mean normal of its flakes, along x and y, by which whoever asks lets them lean
    /// (LeaningFlakes): the calls of BoundBsdf are of flakes that lie flat. Empty: they do, or the surface
    /// lets them lean itself.
    virtual std::optional<Vec2f> flake_lean() const { return std::nullopt; }
    /// Whether its flakes lean by themselves, in object space.
    virtual bool leans_by_itself() const { return false; }
};

/// What surfaces have in common that show single flakes on small patches and, on larger ones, some
/// of the flakes, scaled up to the mean of all.
class SingleFlakes {
 public:
    virtual ~SingleFlakes() = default;
    /// Side of the largest square patch of a flat panel on which every flake is resolved, so that
    /// nothing is approximated. 0 if flakes lie too densely for any patch; infinite without flakes.
    virtual double exact_patch_mm() const = 0;
};

}  // namespace nacre::bsdf
