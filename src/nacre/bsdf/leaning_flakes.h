#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/core/vec.h"

namespace nacre::bsdf {

/// A paint whose flakes lean, by one whose flakes lie flat: seen from the frame of the leaning flakes,
/// theirs lie flat and it is coat and layers that are tilted. The flat paint is asked with what a flat coat
/// over it refracts into the directions that light has inside.                [docs/flakes.md]
///
/// What that does to the layers is put right for light that meets one flake. Flakes block a path by
/// sigma(c'), c' its cosine to their normal, and light crosses the layer by 1/mu, mu its cosine to the
/// layer's, which of the flat paint's own is c' as well:
///
///     single(wi, wo) = flat_single(wi', wo') T(t_i) / T'_i  T(t_o) / T'_o
///                      c'_i c'_o / (mu_i mu_o)  E(s_i / mu_i + s_o / mu_o) / E(s_i / c'_i + s_o / c'_o)
///
/// with wi', wo' outside a flat coat over flat flakes, s the optical depth sigma(c') times the thickness,
/// E(x) = (1 - e^-x) / x, and what the clear coat absorbs along mu in place of c'. Light that was scattered
/// again by flakes and pigments is the flat paint's in the same directions, without the last line, if it
/// left when it first met the interface. Light that the interface had sent back met flakes before
/// and after that. Mirrors of the flakes' mean normal m, the coat's n and m again act as one of
/// normal 2 m - n, to first order: such light is the flat paint's in the frame of flakes that lean
/// twice as much.
///
/// Light that has met the ground passes flakes on its way in and on its way out, each by the transmittance
/// of all flakes for light of that direction, scattered or not. With rho = mu / c' of light on its way down
/// and rho* that of its mirror image at m on its way up, light among mirrors obeys
///
///     rho dI/dz = -s I + r I*,     rho* dI*/dz = s I* - r I,
///
/// r what s reflects, and is e^(kappa z) times a solution of flakes that lie flat, with
/// kappa = s (1/rho* - 1/rho) / 2, s (1/rho* + 1/rho) / 2 in place of s and r / sqrt(rho rho*) of r. Of
/// light that passes
///
///     t = e^kappa / (cosh g + s sinh(g) / g),     g^2 = s^2 - r^2,
///
/// and from_ground() is the flat paint's times t here over t there, in and out. The interface is met by what
/// flakes mirror upwards: it is asked in the frame of flakes that lean twice as much. What it sends down
/// again makes the ground brighter by A, told by from_ground() there over that along the normal. Flakes
/// mirror sqrt(rho* / rho) as much up to it as flat ones do, so that A is 1 / (1 - (1 - 1/A) sqrt(rho* / rho))
/// here: both are divided by A - (A - 1) sqrt(rho* / rho).
///
/// Inside, directions beyond the critical angle of flakes that lie flat leave where the flakes lean. The flat
/// paint has no such direction and is asked, for all that left when it first met the interface, with the pair
/// of the same half vector that is just as far apart as it can leave: the same flakes, lit and seen less
/// obliquely. What the interface returns of a lobe is odd about the critical angle: light from the ground is
/// asked there, twice, less that of the direction as far on its other side.
///
/// All of it is derived here, from single scattering in a layer [chandrasekhar-1960] and from two
/// streams as Kubelka and Munk have them [kubelka-munk-1931], along directions that mirrors exchange; errors
/// against walks and discs stand in docs/flakes.md. f is as reciprocal as the paint that is asked, and
/// holds to first order in the tilt but for how much light flakes and pigments scattered again, which is
/// of the flat paint.
class LeaningFlakes final : public BoundBsdf {
 public:
    /// The flakes' mean normal and the frame around it, into which it is the shortest turn.
    struct Lean {
        /// @param tangents  m_x/m_z and m_y/m_z of the mean normal m, in the frame of the surface
        explicit Lean(Vec2f tangents);

        Vec3f to_flakes(Vec3f w) const { return {dot(w, s), dot(w, t), dot(w, n)}; }
        Vec3f from_flakes(Vec3f w) const { return w.x * s + w.y * t + w.z * n; }
        /// Towards the same side by twice the angle.
        Lean twice() const;

        Vec3f s, t, n;  ///< of the flakes, in the frame of the surface
    };

    /// @param flat  whose flakes lie flat; must outlive this
    /// @param seen_from  a direction that is asked again and again: what it needs is kept
    LeaningFlakes(const BoundBsdf& flat, const Lean& lean,
                  std::optional<Vec3f> seen_from = std::nullopt);
    LeaningFlakes(const LeaningFlakes&) = delete;
    LeaningFlakes& operator=(const LeaningFlakes&) = delete;
    /// The same, which keeps `flat`.
    LeaningFlakes(std::unique_ptr<const BoundBsdf> flat, const Lean& lean)
        : LeaningFlakes(*flat, lean) {
        owned_ = std::move(flat);
    }

    FloatLanes eval(Vec3f wi, Vec3f wo) const override { return evaluate(wi, wo).f; }
    float pdf(Vec3f wi, Vec3f wo) const override;
    FloatLanes pdf_lanes(Vec3f wi, const Vec3Lanes& wo) const override;
    float specular_probability(Vec3f wi) const override;
    std::optional<BsdfSample> sample(Vec3f wi, float u_select, Vec2f u) const override;
    BsdfValue evaluate(Vec3f wi, Vec3f wo) const override;
    BsdfValue evaluate_on(const Patch& patch, Vec3f wi, Vec3f wo) const override;
    std::optional<BsdfSample> sample_on(const Patch& patch, Vec3f wi, float u_select,
                                        Vec2f u) const override;

    bool samples_flakes() const override { return flat_.samples_flakes(); }
    float narrow_light_pdf(Vec3f wi) const override;
    void sample_flakes(const Patch& patch, Vec3f wi, std::uint32_t random,
                       std::vector<FlakeSamples>& list) const override;
    FloatLanes flake_weight(const Patch& patch, Vec3f wi, const FlakeSample& flake) const override;
    FloatLanes flakes_at(const Patch& patch, Vec3f wi, Vec3f wo, float pdf) const override;
    std::size_t patch_memory_bytes() const override { return flat_.patch_memory_bytes(); }

    /// Of flakes that lie flat.
    FloatLanes albedo(Vec3f wi) const override { return flat_.albedo(wi); }
    BinderIndex binder_index() const override { return index_; }

 private:
    /// Cosine outside of the flattest direction with which a flat paint is asked.
    static constexpr float kMinFlatCosine = 1e-3f;

    /// A direction above the horizon.
    struct Ray {
        Vec3f outside, inside;
        float cosine;  ///< inside, to the flakes' mean normal
        Vec3f flat;    ///< outside a flat coat over flat flakes, of the same direction inside
        /// Solid angle of `flat` over that of the direction; 0 beyond its critical angle.
        float jacobian;
    };
    /// None where the direction is not above the horizon.
    std::optional<Ray> ray_of(Vec3f w) const;
    /// A direction by one or two of the flat paint's, weighted, in the frame that leans twice as much.
    struct GroundRays {
        int count = 0;
        std::array<Vec3f, 2> w;
        std::array<FloatLanes, 2> factor;
    };
    /// With what values need of the direction, whatever the other.
    struct Seen : Ray {
        Vec3f twice;             ///< as `flat`, in the frame that leans twice as much
        FloatLanes transmitted;  ///< by the interface
        /// Of flakes and pigments, over the cosine to the layers and over that to the flakes.
        FloatLanes depth, asked;
        /// By which light that was scattered again differs from the flat paint's at `flat` and `twice`.
        FloatLanes again, again_twice;
        std::optional<GroundRays> ground;  ///< where it is kept
    };
    Seen see(const Ray& ray) const;
    /// Of a direction above the horizon, what is kept or else what is put into `room`; or null.
    const Seen* see(Vec3f w, std::optional<Seen>& room) const;
    Vec3f flat_of(const Lean& lean, Vec3f inside) const;
    FloatLanes transmittance(float cosine_outside) const;

    // Light from the ground: leaning_ground.cpp.

    /// Of light that crosses flakes and coat and leaves: factor e^exponent.
    struct Passage {
        FloatLanes exponent, factor;
    };
    static Passage passage(const FloatLanes& s, const FloatLanes& r, const FloatLanes& kappa,
                           const FloatLanes& transmitted);
    /// Through the flat paint, by its cosines inside and outside.
    Passage flat_passage(float inside, float outside) const;
    /// The direction from which the ground is seen, away from this azimuth.
    static Vec3f far_from(Vec2f azimuth);
    bool over_ground() const { return lane_max(ground_) > 0; }
    GroundRays ground_rays(const Seen& seen) const;
    FloatLanes from_ground(const Seen& i, const Seen& o, const FloatLanes& twice) const;

    /// A pair of directions outside the flat paint that stands for one beyond its critical angle, and by
    /// what light that was scattered again and that met one flake differ from it. No flakes are so steep
    /// that they would mirror along the critical angle or beyond: `once` is zero there.
    struct Nearest {
        Vec3f wi, wo;
        FloatLanes again{}, once{};
    };
    Nearest nearest(const Seen& i, const Seen& o) const;
    /// Whether the flat paint has no such pair.
    static bool beyond_critical(const Ray& i, const Ray& o) {
        return i.jacobian == 0 || o.jacobian == 0;
    }
    /// Of layers of flakes, c'_i c'_o / (mu_i mu_o) E() / E() as above.
    FloatLanes seen_once(const Seen& i, const Seen& o) const;
    /// By which what met one flake differs.
    FloatLanes once_factor(const Seen& i, const Seen& o) const {
        return i.again * o.again * seen_once(i, o);
    }

    /// @param asked   evaluate(wi, wo) of the flat paint
    /// @param beyond  f(wi, wo) of the flat paint, for the nearest pair
    template <class Evaluate, class F>
    BsdfValue evaluate_by(Vec3f wi, Vec3f wo, const Evaluate& asked, const F& beyond) const;
    template <class Sample, class Evaluate, class F>
    std::optional<BsdfSample> sample_by(Vec3f wi, float u_select, Vec2f u, const Sample& sample,
                                        const Evaluate& asked, const F& beyond) const;
    /// @param f  of the flat paint at Ray::flat, within the critical angle
    template <class F>
    FloatLanes value(const Seen& i, const Seen& o, const FloatLanes& f, const F& beyond) const;
    /// Whether a nearest pair shows the mean of its flakes on a patch.
    static bool is_mean_beyond(const Patch& patch);
    FloatLanes beyond_on(const Patch& patch, Vec3f wi, Vec3f wo) const;
    /// Per solid angle here, of samples that the flat paint draws with the density `flat`.
    static float mixed_pdf(float flat, const Ray& o);

    std::unique_ptr<const BoundBsdf> owned_;
    const BoundBsdf& flat_;
    Lean lean_, twice_;
    BinderIndex index_;
    FloatLanes coat_depth_;
    bool coat_absorbs_;
    float least_cosine_;  ///< inside, at which the flat paint's light just leaves
    FloatLanes ground_;   ///< the flat paint's light from the ground along its normal; 0 over black
    Passage along_normal_{{}, splat(1.0f)};  ///< there, if not over black
    std::optional<Seen> seen_from_;
};

/// A surface as its values are told: flakes that lean do so along x and y of the frame.
std::unique_ptr<const BoundBsdf> bind_with_lean(const Bsdf& surface,
                                                const Wavelengths& wavelengths_nm);

}  // namespace nacre::bsdf
