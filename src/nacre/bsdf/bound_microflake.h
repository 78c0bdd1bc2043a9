#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "nacre/bsdf/flake_lobe.h"
#include "nacre/bsdf/microflake_tables.h"
#include "nacre/bsdf/wavelength_lanes.h"

// The micro-flake model at eight wavelengths. bound_microflake.cpp gathers what depends on
// wavelength; bound_microflake_eval.cpp is what a renderer calls; bound_microflake_inl.h is what
// models share whose flakes are not those of the mean.

namespace nacre::bsdf {

struct BoundFlake {
    float half_density, inverse_alpha2, norm;  // c/2; 1/alpha^2; 1/(2 pi alpha^2)
    int intervals;                             // 0: reflectance does not depend on angle
    std::vector<FloatLanes> reflectance;
};

struct BoundPigment {
    float g;
    FloatLanes scattering;
};

struct BoundLayer {
    float thickness_um;
    bool thick;   ///< 1 - e^-x needs no care: optical depth above 0.1 along every direction
    bool buried;  ///< under a layer or an absorbing clearcoat
    std::vector<FloatLanes> extinction;  // by direction
    std::vector<BoundFlake> flakes;
    std::vector<BoundPigment> pigments;
};

// One direction, and what evaluation and sampling both need of it.
struct Ray {
    Vec3f outside, inside;  ///< inside: refracted with the mean index
    float sine, x;          ///< outside: sin theta, tan(theta/2)
    int row;                ///< of the direction tables
    float fraction;

    /// A function of direction between its rows.
    template <class T>
    T look_up(const std::vector<T>& table) const {
        return table[row] + fraction * (table[row + 1] - table[row]);
    }
};

/// Which flakes scatter once: all of them, as their mean.
///
/// Stands for any class with this function: the factor by which the single scattering of a species
/// differs from its mean, for the `flake`-th species of a layer whose optical depth along both
/// directions together is `depth`, at eight wavelengths.
struct MeanFlakes {
    FloatLanes factor(std::size_t /*layer*/, std::size_t /*flake*/,
                      const FloatLanes& /*depth*/) const {
        return splat(1.0f);
    }
};

class BoundMicroflake : public BoundBsdf {
 public:
    BoundMicroflake(std::shared_ptr<const Microflake::Tables> tables,
                    const Wavelengths& wavelengths);

    FloatLanes eval(Vec3f wi, Vec3f wo) const override;
    std::optional<BsdfSample> sample(Vec3f wi, float u_lobe, Vec2f u) const override;
    float pdf(Vec3f wi, Vec3f wo) const override;
    BsdfValue evaluate(Vec3f wi, Vec3f wo) const override;
    FloatLanes albedo(Vec3f wi) const override;

 protected:
    // For models that keep the smooth part and the ways to sample it, and change the flakes.

    Ray make_ray(Vec3f w) const;
    /// BRDF without the mirror.
    template <class Flakes>
    FloatLanes value(const Ray& i, const Ray& o, const Flakes& flakes) const;

    const LobeOdds& odds_at(const Ray& i) const;
    /// Per solid angle outside, of draw() with these odds.
    float density(const LobeOdds& odds, const Ray& i, const Ray& o) const;
    /// Whether u_lobe, in [0, sum of the odds), stands for the mirror of a smooth interface.
    bool draws_mirror(const LobeOdds& odds, float u_lobe) const {
        return u_lobe < odds.interface && !rough_;
    }
    /// By the lobe that u_lobe stands for, not the mirror; not upwards where nothing leaves.
    Vec3f draw(const LobeOdds& odds, const Ray& i, float u_lobe, Vec2f u) const;
    /// The mirror of a smooth interface, chosen with this probability.
    BsdfSample mirror_sample(Vec3f wi, float probability) const;
    /// The direction outside of one inside; empty where light cannot leave.
    std::optional<Vec3f> leave(Vec3f inside) const {
        if (inside.z <= 0) return std::nullopt;
        return refract_out(inside, mean_ior_);
    }
    /// Solid angles inside over those outside.
    float solid_angle_ratio(const Ray& o) const {
        return o.outside.z * inverse_mean_ior_ * inverse_mean_ior_ / o.inside.z;
    }

    const std::array<Between, kLanes>& where() const { return where_; }

 private:
    void bind_smooth_interface();
    void bind_rough_interface();
    void bind_layers();

    template <class Flakes>
    FloatLanes single(Vec3f inside_i, Vec3f inside_o, const Ray& i, const Ray& o,
                      const Flakes& flakes) const;
    FloatLanes rough_lobe(const Ray& i, const Ray& o) const;

    std::shared_ptr<const Microflake::Tables> tables_;
    std::array<Between, kLanes> where_;
    SmoothGrid grid_;
    std::vector<FloatLanes> smooth_;
    std::vector<BoundLayer> layers_;
    FloatLanes clearcoat_depth_, ior_, inverse_ior2_;
    bool dispersive_ = false;
    float mean_ior_, inverse_mean_ior_;
    FlakeLobe flake_lobe_, wide_lobe_;  // the second twice as rough
    /// By direction: transmittance of a smooth interface over the cosine, finite at grazing.
    std::vector<FloatLanes> transmittance_over_cosine_;
    /// A rough interface: its facets, and by direction the masking over the cosine and what is
    /// masked and given back diffusely.
    struct Rough {
        FlakeLobe lobe;
        float inverse_alpha2;
        std::vector<float> masking;
        std::vector<FloatLanes> masked;
        FloatLanes diffuse_scale;
    };
    std::optional<Rough> rough_;
};

}  // namespace nacre::bsdf

#include "nacre/bsdf/bound_microflake_inl.h"  // IWYU pragma: export
