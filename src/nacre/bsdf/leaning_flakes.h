#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/tilted_coat.h"

namespace nacre::bsdf {

/// A paint whose flakes lean, by one whose flakes lie flat: seen from the frame of the leaning flakes,
/// theirs lie flat and it is the coat that is tilted (TiltedCoat).            [docs/flakes.md]
///
/// What that does to the layers is put right for light that meets one flake. Flakes block a path by
/// sigma(c'), c' its cosine to their normal, and light crosses the layer by 1/mu, mu its cosine to the
/// layer's, which of the tilted coat's own is c' as well:
///
///     single(wi, wo) = flat_single(wi', wo') T(t_i) / T'_i  T(t_o) / T'_o
///                      c'_i c'_o / (mu_i mu_o)  E(s_i / mu_i + s_o / mu_o) / E(s_i / c'_i + s_o / c'_o)
///
/// with wi', wo' outside a flat coat over flat flakes, s the optical depth sigma(c') times the thickness,
/// E(x) = (1 - e^-x) / x, and what the clear coat absorbs along mu in place of c'. Light that was scattered
/// again by flakes and pigments is the flat paint's in the same directions, without the last line, if it
/// left when it first met the interface. What the interface had sent back met flakes on both sides of that
/// mirror: mirrored at the flakes' mean m, the coat's n and m again it comes from a normal 2 m - n, and is
/// the flat paint's in the frame of flakes that lean twice as much.
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
/// paint has no such direction and is asked, for what met one flake, with the pair of the same half vector
/// that is just as far apart as it can leave: the same flakes, lit and seen less obliquely. What the
/// interface returns of a lobe is odd about the critical angle: light from the ground is asked there, twice,
/// less that of the direction as far on its other side.
///
/// f is as reciprocal as the paint that is asked, and holds to first order in the tilt but for how much
/// light flakes and pigments scattered again, which is of the flat paint.
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
    LeaningFlakes(const BoundBsdf& flat, const Lean& lean)
        : flat_(flat),
          lean_(lean),
          index_(flat.binder_index()),
          coat_depth_(flat.coat_depth()),
          twice_(lean.twice()),
          again_{flat},
          unreturned_{flat},
          returned_{flat},
          coat_(flat, lean.to_flakes({0, 0, 1})),
          coat_again_(again_, lean.to_flakes({0, 0, 1})),
          coat_unreturned_(unreturned_, lean.to_flakes({0, 0, 1})),
          coat_returned_(returned_, twice_.to_flakes({0, 0, 1})) {}
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

    bool tells_flakes_apart() const override { return coat_.tells_flakes_apart(); }
    float narrow_light(Vec3f wi) const override;
    void ask_flakes(const Patch& patch, Vec3f wi, std::uint32_t random,
                    std::vector<AskedFlake>& list) const override;
    FloatLanes flake_weight(const Patch& patch, Vec3f wi, const AskedFlake& flake) const override;
    FloatLanes flakes_at(const Patch& patch, Vec3f wi, Vec3f wo, float pdf) const override;
    std::size_t patch_memory_bytes() const override { return coat_.patch_memory_bytes(); }

    /// Of flakes that lie flat.
    FloatLanes albedo(Vec3f wi) const override { return coat_.albedo(wi); }
    BinderIndex binder_index() const override { return index_; }

 private:
    /// A part of the flat paint's light, as a surface.
    class PartOf : public BoundBsdf {
     public:
        explicit PartOf(const BoundBsdf& flat) : flat_(flat) {}
        float pdf(Vec3f, Vec3f) const override { return 0; }
        std::optional<BsdfSample> sample(Vec3f, float, Vec2f) const override {
            return std::nullopt;
        }
        FloatLanes albedo(Vec3f) const override { return FloatLanes{}; }
        BinderIndex binder_index() const override { return flat_.binder_index(); }

     protected:
        const BoundBsdf& flat_;
    };
    /// A direction by one or two of the flat paint's, weighted, in the frame that leans twice as much.
    struct GroundRays {
        int count = 0;
        std::array<Vec3f, 2> w;
        std::array<FloatLanes, 2> factor;
    };
    GroundRays ground_rays(Vec3f w) const;
    FloatLanes from_ground_here(Vec3f wi, Vec3f wo) const;

    struct Again final : PartOf {
        using PartOf::PartOf;
        FloatLanes eval(Vec3f wi, Vec3f wo) const override { return flat_.scattered_again(wi, wo); }
    };
    struct Unreturned final : PartOf {
        using PartOf::PartOf;
        FloatLanes eval(Vec3f wi, Vec3f wo) const override { return flat_.unreturned(wi, wo); }
    };
    struct Returned final : PartOf {
        using PartOf::PartOf;
        FloatLanes eval(Vec3f wi, Vec3f wo) const override;
    };

    /// A pair of directions outside the flat paint that stands for one beyond its critical angle, and by
    /// which what met one flake differs from it.
    struct Nearest {
        Vec3f wi, wo;
        FloatLanes factor{};
    };
    /// None where the flat paint has the pair itself.
    std::optional<Nearest> nearest(Vec3f wi, Vec3f wo) const;

    /// f here.
    /// @param tilted  that of the tilted coat
    /// @param flat    (wi, wo): f of the flat paint
    template <class Flat>
    FloatLanes righted(const FloatLanes& tilted, Vec3f wi, Vec3f wo, const Flat& flat) const;
    /// By which light that was scattered again differs from that of the coat in the frame of a lean.
    FloatLanes again_factor(const Lean& lean, Vec3f wi, Vec3f wo) const;
    /// Of light that met one flake, over again_factor().
    FloatLanes once_over_again(Vec3f wi, Vec3f wo) const;
    /// Of layers of flakes, c'_i c'_o / (mu_i mu_o) E() / E() as above.
    /// @param true_i, true_o   inside
    /// @param cosine_i, cosine_o  of the directions that are asked, to the flakes' mean
    FloatLanes seen_once(Vec3f true_i, Vec3f true_o, float cosine_i, float cosine_o) const;
    template <class Flat>
    std::optional<BsdfSample> turned(std::optional<BsdfSample> sample, Vec3f wi,
                                     const Flat& flat) const;

    std::unique_ptr<const BoundBsdf> owned_;
    const BoundBsdf& flat_;
    Lean lean_;
    BinderIndex index_;
    FloatLanes coat_depth_;
    Lean twice_;
    Again again_;
    Unreturned unreturned_;
    Returned returned_;
    TiltedCoat coat_, coat_again_, coat_unreturned_, coat_returned_;
};

/// A surface as its values are told: flakes that lean do so along x and y of the frame.
std::unique_ptr<const BoundBsdf> bind_with_lean(const Bsdf& surface,
                                                const Wavelengths& wavelengths_nm);

}  // namespace nacre::bsdf
