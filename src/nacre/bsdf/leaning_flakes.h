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

/// A paint whose flakes lean, computed from the paint whose flakes lie flat. In the frame of the flakes'
/// mean normal m the flakes lie flat, and coat and layers are tilted. The flat paint is therefore evaluated
/// for the directions that have, below a flat coat, the refracted directions in the frame of the flakes.
///                                                                              [docs/flakes.md]
/// Symbols: mu is the cosine of a refracted direction to the layers' normal, c' that to m; i and o are the
/// two directions; primes mark the flat paint. tau = sigma(c') d is the optical depth of the layers,
/// extinction times thickness; E(x) = (1 - e^-x) / x; T is the transmittance of the interface.
///
/// Single scattering by flakes. Flakes block a path by sigma(c'), and light crosses the layers by 1/mu, where
/// the flat paint has 1/c':
///
///     single(wi, wo) = flat_single(wi', wo') T_i / T'_i  T_o / T'_o
///             c'_i c'_o / (mu_i mu_o)  E(tau_i / mu_i + tau_o / mu_o) / E(tau_i / c'_i + tau_o / c'_o)
///
/// and the clear coat absorbs along 1/mu in place of 1/c'.
///
/// Multiple scattering that leaves when it first meets the interface is the flat paint's in the same
/// directions, with the factors of interface and coat alone. Light that the interface has reflected back
/// has met flakes before and after. Reflections at m, at the coat's normal n and at m again are, to first
/// order in the tilt, one reflection at 2 m - n, so this light is the flat paint's in the frame of flakes
/// that lean by twice the angle.
///
/// Light from the ground crosses the flakes downwards and upwards, attenuated by all of them, scattered
/// light included. Two streams that the flakes exchange [kubelka-munk-1931] obey, with rho = mu / c' of the
/// stream down and rho* that of its mirror image at m, which goes up,
///
///     rho dI/dz = -s I + r I*,     rho* dI*/dz = s I* - r I,
///
/// s extinction by flakes and absorption by pigments, r what flakes reflect. The solution is e^(kappa z) times that of flakes that lie
/// flat, kappa = s (1/rho* - 1/rho) / 2, with s (1/rho* + 1/rho) / 2 in place of s and r / sqrt(rho rho*) of r;
/// the transmittance is
///
///     t = e^kappa / (cosh gamma + s sinh(gamma) / gamma),     gamma^2 = s^2 - r^2.
///
/// from_ground() is the flat paint's times t of the leaning over t of the flat flakes, in and out. The
/// interface is met by light that flakes reflect upwards, hence in the frame of twice the lean. What it
/// reflects down again makes the ground brighter by a factor B >= 1: from_ground() there over that along
/// the normal, both with their transmittances t. Flakes reflect sqrt(rho* / rho) as much towards it as flat
/// ones do, so that here the factor is 1 / (1 - (1 - 1/B) sqrt(rho* / rho)): from_ground() is divided by
/// B - (B - 1) sqrt(rho* / rho).
///
/// Refracted directions beyond the critical angle of a flat coat over flat flakes do leave where flakes
/// lean. The flat paint has none such; single and multiple scattering are then those of the pair with the
/// same half vector that is just as far apart as can leave: the same flakes, lit and seen less obliquely.
/// What the interface reflects of a lobe is odd about the critical angle: light from the ground is twice that at
/// the critical angle less that of the direction as far on its other side.
///
/// Derived here, from single scattering in a layer [chandrasekhar-1960] and the two streams. f is as
/// reciprocal as the flat paint's. It is right to first order in the tilt, but for the amount of light scattered
/// more than once, which is the flat paint's. Errors against walks and discs: docs/flakes.md.
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
    /// @param fixed_direction  a direction of many calls: what values need of it is computed once
    LeaningFlakes(const BoundBsdf& flat, const Lean& lean,
                  std::optional<Vec3f> fixed_direction = std::nullopt);
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
    /// Least cosine outside of a direction for which the flat paint is evaluated.
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
    /// A direction as a weighted sum of one or two of the flat paint's, in the frame of twice the lean.
    struct GroundRays {
        int count = 0;
        std::array<Vec3f, 2> w;
        std::array<FloatLanes, 2> factor;
    };
    /// With what values need of this direction alone.
    struct Path : Ray {
        Vec3f double_lean;         ///< as `flat`, in the frame of twice the lean
        FloatLanes transmittance;  ///< T of the interface
        /// Optical depth of flakes and pigments along the path: by 1/mu and, of the flat paint, by 1/c'.
        FloatLanes depth, flat_depth;
        /// Interface and coat over those of the flat paint at `flat` and at `double_lean`.
        FloatLanes multiple_factor, returned_factor;
        std::optional<GroundRays> ground;  ///< of the fixed direction
    };
    Path path_of(const Ray& ray) const;
    /// The path of the fixed direction, or one written to `storage`; null below the horizon.
    const Path* path_of(Vec3f w, std::optional<Path>& storage) const;
    Vec3f outside_flat_coat(const Lean& lean, Vec3f inside) const;
    FloatLanes transmittance(float cosine_outside) const;

    // Light from the ground: leaning_ground.cpp.

    /// Transmittance of flakes, coat and interface: factor e^exponent.
    struct Passage {
        FloatLanes exponent, factor;
    };
    static Passage passage(const FloatLanes& s, const FloatLanes& r, const FloatLanes& kappa,
                           const FloatLanes& transmittance);
    /// Through the flat paint, by its cosines inside and outside.
    Passage flat_passage(float inside, float outside) const;
    /// The direction, at the opposite azimuth, for which B is computed.
    static Vec3f direction_away_from(Vec2f azimuth);
    bool over_ground() const { return lane_max(ground_) > 0; }
    GroundRays ground_rays(const Path& path) const;
    FloatLanes from_ground(const Path& i, const Path& o, const FloatLanes& flat_from_ground) const;

    /// Directions outside the flat paint in place of a pair beyond its critical angle, with the factors of
    /// multiple and of single scattering. No flakes are so steep that they reflect along the critical angle
    /// or beyond: single_factor is 0 there.
    struct SubstitutePair {
        Vec3f wi, wo;
        FloatLanes multiple_factor{}, single_factor{};
    };
    SubstitutePair substitute_pair(const Path& i, const Path& o) const;
    /// Whether the flat paint has no such pair of directions.
    static bool beyond_critical(const Ray& i, const Ray& o) {
        return i.jacobian == 0 || o.jacobian == 0;
    }
    /// c'_i c'_o / (mu_i mu_o) E() / E() of single scattering, as above.
    FloatLanes attenuation_ratio(const Path& i, const Path& o) const;
    /// Single scattering over the flat paint's.
    FloatLanes single_factor(const Path& i, const Path& o) const {
        return i.multiple_factor * o.multiple_factor * attenuation_ratio(i, o);
    }

    /// @param evaluate_flat    evaluate(wi, wo) of the flat paint
    /// @param eval_substitute  f(wi, wo) of the flat paint for a substitute pair
    template <class Evaluate, class F>
    BsdfValue evaluate_by(Vec3f wi, Vec3f wo, const Evaluate& evaluate_flat,
                          const F& eval_substitute) const;
    template <class Sample, class Evaluate, class F>
    std::optional<BsdfSample> sample_by(Vec3f wi, float u_select, Vec2f u,
                                        const Sample& sample_flat, const Evaluate& evaluate_flat,
                                        const F& eval_substitute) const;
    /// @param f  of the flat paint at Ray::flat, within the critical angle
    template <class F>
    FloatLanes value(const Path& i, const Path& o, const FloatLanes& f,
                     const F& eval_substitute) const;
    /// Whether a substitute pair has the mean of its flakes on a patch, not their sparkle.
    static bool is_substitute_mean(const Patch& patch);
    FloatLanes eval_substitute_on(const Patch& patch, Vec3f wi, Vec3f wo) const;
    /// Per solid angle here, of samples that the flat paint draws with the density `flat`.
    static float mixed_pdf(float flat, const Ray& o);

    std::unique_ptr<const BoundBsdf> owned_;
    const BoundBsdf& flat_;
    Lean lean_, double_lean_;
    BinderIndex index_;
    FloatLanes coat_depth_;
    bool coat_absorbs_;
    float critical_cosine_;  ///< inside, of the critical angle
    FloatLanes ground_;  ///< the flat paint's light from the ground along its normal; 0 over black
    Passage along_normal_{{}, splat(1.0f)};  ///< there, if not over black
    std::optional<Path> kept_path_;
};

/// A surface as its values are told: flakes that lean do so along x and y of the frame.
std::unique_ptr<const BoundBsdf> bind_with_lean(const Bsdf& surface,
                                                const Wavelengths& wavelengths_nm);

}  // namespace nacre::bsdf
