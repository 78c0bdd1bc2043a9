#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "nacre/bsdf/bsdf.h"

namespace nacre::bsdf {

/// A paint seen through an interface that is tilted, at one point of a coat that is not flat. Below
/// it the flakes and layers lie as they do under a flat one.               [docs/orange-peel.md]
///
/// Snell's law for vectors refracts the direction w into (w + (n cos t' - cos t) m) / n, t and t' the
/// angles to the tilted normal m outside and inside. A flat coat refracts w' into the same direction
/// if
///
///     w'_xy = w_xy + (n cos t' - cos t) m_xy,
///
/// and is evaluated for it, in and out. Its value holds the flat coat's transmittances, which are
/// replaced by those at t, and its irradiance: for light from wo
///
///     f(wi, wo) = flat(wi', wo') T(t_i) / T'_i  T(t_o) / T'_o  (w_z cos t) / (cos t' wo_z),
///
/// w_z the cosine inside. The specular direction is mirrored at m; where it would point into the
/// surface, close to grazing, the next wave turns it up again. Inside, directions beyond the flat
/// coat's critical angle leave where m faces them; there the paint is taken as it is at that angle.
///
/// Of a rough interface (InterfaceLobe), whose facets lie about the tilted normal, t and t' are the angles
/// of the light that it lets through in the mean, and T is what all facets let through. Its lobe is treated
/// apart from the layers, and is that of the frame of the tilted normal,
///
///     f(wi, wo) = (flat - lobe)(wi', wo') ... + lobe(M wi, M wo) (wo . m) / wo_z,
///
/// with what it sends below the surface turned up again as the specular direction is. How facets spread
/// light inside is taken at the flat coat's angle, which is off by the slope times the square of the
/// roughness.
///
/// Flat coats' samples do not reach what leaves beyond their critical angle, a lune between two cones of
/// that angle inside, about the two normals; it is sampled apart.
///
/// All of it is first order in the slope s: light that the interface returns into the paint finds a
/// flat one. f is reciprocal up to the last factor, by which plane waves spread over the layers
/// below, within s tan(37 deg) at n = 1.5; it gives light back within the bound of the test. What a
/// wave casts a shadow on or hides is neglected: slopes well below the elevation of eye and light.
class TiltedCoat final : public BoundBsdf {
 public:
    /// @param flat   must outlive this
    /// @param slope  of the height over the surface, along x and y of the local frame
    /// @param seen_from  a point whose slope faces away from it is taken as just seen
    TiltedCoat(const BoundBsdf& flat, Vec2f slope, Vec3f seen_from);

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

    /// Of the flat coat.
    FloatLanes albedo(Vec3f wi) const override { return flat_.albedo(wi); }
    BinderIndex binder_index() const override { return index_; }

    /// Of the interface.
    Vec3f normal() const { return normal_; }

 private:
    // A direction in front of the interface.
    struct Ray {
        Vec3f flat;        // outside a flat coat, of the same direction inside
        float cosine;      // to the tilted normal
        float jacobian;    // solid angle of `flat` over that of the direction; 0 if none has it
        float irradiance;  // the same times the cosines to the mean surface
        float beyond;      // density of the samples beyond the flat coat's critical angle
    };
    std::optional<Ray> ray_of(Vec3f w) const;
    /// Of the interface, over that of a flat coat at Ray::flat.
    FloatLanes transmittance(const Ray& ray) const;
    /// The probability with which the flat coat draws a rough interface's lobe; 0 with a smooth one.
    float chosen(const Patch* patch, const Ray& i) const;
    /// Refracts a direction inside, times n; empty where it does not leave.
    std::optional<Vec3f> refract_out(Vec3f inside) const;
    /// The direction whose Ray::flat is this; empty where it does not leave.
    std::optional<Vec3f> leave(Vec3f flat) const;
    /// One that leaves beyond the flat coat's critical angle.
    std::optional<Vec3f> sample_beyond(Vec2f u) const;
    /// Its density, of a direction inside times n and its cosines to the tilted normal.
    float beyond_pdf(Vec3f inside, float cosine, float cosine_inside) const;
    /// Of light inside, at the flat coat.
    float critical_angle() const;

    /// In the frame of the interface, what goes to wo at once and what is turned up into it.
    std::array<Vec3f, 2> turned_up(Vec3f wo) const;
    /// From the flat coat's in the same direction inside.
    FloatLanes value(Vec3f wi, const Ray& i, Vec3f wo, const Ray& o, const FloatLanes& flat) const;
    float density(Vec3f wi, const Ray& i, Vec3f wo, const Ray& o, float flat, float chosen) const;
    /// Of sample(), from that of the flat coat's samples.
    float mixed_pdf(float pdf, const Ray& o) const;
    /// Fraction of the samples that are the flat coat's.
    float as_flat() const;

    template <class Evaluate>
    BsdfValue evaluate_by(const Patch* patch, Vec3f wi, Vec3f wo, const Evaluate& evaluate) const;
    template <class Sample, class Evaluate>
    std::optional<BsdfSample> sample_by(const Patch* patch, Vec3f wi, float u_select, Vec2f u,
                                        const Sample& sample, const Evaluate& evaluate) const;

    const BoundBsdf& flat_;
    const InterfaceLobe* lobe_;  // null: the interface is smooth
    BinderIndex index_;
    Vec3f normal_;
    float tilt_;     // its angle from the mean one
    float beyond_;   // fraction of the samples beyond the flat coat's critical angle
    Frame frame_{};  // around the normal, of a rough interface
};

}  // namespace nacre::bsdf
