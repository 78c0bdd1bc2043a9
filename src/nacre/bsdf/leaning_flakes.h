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
/// in the same directions, without the last factor. f is as reciprocal as the paint that is asked, and
/// holds to first order in the tilt.
class LeaningFlakes final : public BoundBsdf {
 public:
    /// The flakes' mean normal and the frame around it, into which it is the shortest turn.
    struct Lean {
        /// @param tangents  m_x/m_z and m_y/m_z of the mean normal m, in the frame of the surface
        explicit Lean(Vec2f tangents);

        Vec3f to_flakes(Vec3f w) const { return {dot(w, s), dot(w, t), dot(w, n)}; }
        Vec3f from_flakes(Vec3f w) const { return w.x * s + w.y * t + w.z * n; }

        Vec3f s, t, n;  ///< of the flakes, in the frame of the surface
    };

    /// @param flat  whose flakes lie flat; must outlive this
    LeaningFlakes(const BoundBsdf& flat, const Lean& lean)
        : lean_(lean),
          index_(flat.binder_index()),
          coat_depth_(flat.coat_depth()),
          again_(flat),
          coat_(flat, lean.to_flakes({0, 0, 1})),
          coat_again_(again_, lean.to_flakes({0, 0, 1})) {}
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
    /// Of flat_, the light that was scattered again, as a surface.
    class Again final : public BoundBsdf {
     public:
        explicit Again(const BoundBsdf& flat) : flat_(flat) {}
        FloatLanes eval(Vec3f wi, Vec3f wo) const override { return flat_.scattered_again(wi, wo); }
        float pdf(Vec3f, Vec3f) const override { return 0; }
        std::optional<BsdfSample> sample(Vec3f, float, Vec2f) const override {
            return std::nullopt;
        }
        FloatLanes albedo(Vec3f) const override { return FloatLanes{}; }
        BinderIndex binder_index() const override { return flat_.binder_index(); }

     private:
        const BoundBsdf& flat_;
    };

    /// f here, of that of the tilted coat.
    FloatLanes righted(const FloatLanes& tilted, Vec3f wi, Vec3f wo) const;
    /// By which light differs from that of the tilted coat: what met one flake, and the rest.
    struct Factors {
        FloatLanes once{}, again{};
    };
    Factors factors(Vec3f wi, Vec3f wo) const;
    std::optional<BsdfSample> turned(std::optional<BsdfSample> sample, Vec3f wi) const;

    std::unique_ptr<const BoundBsdf> owned_;
    Lean lean_;
    BinderIndex index_;
    FloatLanes coat_depth_;
    Again again_;
    TiltedCoat coat_, coat_again_;
};

/// A surface as its values are told: flakes that lean do so along x and y of the frame.
std::unique_ptr<const BoundBsdf> bind_with_lean(const Bsdf& surface,
                                                const Wavelengths& wavelengths_nm);

}  // namespace nacre::bsdf
