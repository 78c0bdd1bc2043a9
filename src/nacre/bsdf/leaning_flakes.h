#pragma once

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
/// What that does to the layers is put right for light that meets one flake. Flakes that lie flat block
/// a path by the cosine c' to their normal, so that of semi-infinite flakes f ~ 1 / (c'_i mu_o + c'_o mu_i)
/// with mu the cosines to the layer's normal, where the tilted coat's own are c' as well:
///
///     single(wi, wo) = flat_single(wi', wo') T(t_i) / T'_i  T(t_o) / T'_o  2 / (mu_i / c'_i + mu_o / c'_o)
///
/// with wi', wo' outside a flat coat over flat flakes, and what the clear coat absorbs along mu in place
/// of c'. Light that was scattered again, by flakes in turn, pigments or the ground, is the flat paint's
/// in the same directions, without the last factor, if it left when it first met the interface. What the
/// interface had sent back met flakes on both sides of that mirror: mirrored at the flakes' mean m, the
/// coat's n and m again it comes from a normal 2 m - n, and is the flat paint's in the frame of flakes that
/// lean twice as much.
///
/// Inside, directions beyond the critical angle of flakes that lie flat leave where the flakes lean. The flat
/// paint has no such direction and is asked, for what met one flake, with the pair of the same half vector
/// that is just as far apart as it can leave: the same flakes, lit and seen less obliquely.
///
/// f is as reciprocal as the paint that is asked, and holds to first order in the tilt but for how much
/// light was scattered again, which is of the flat paint.
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
    /// By which light differs from that of the coat in the frame of a lean: what met one flake, and the
    /// rest.
    struct Factors {
        FloatLanes once{}, again{};
    };
    Factors factors(const Lean& lean, Vec3f wi, Vec3f wo) const;
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
