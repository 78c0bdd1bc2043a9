#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "nacre/bsdf/flake_lobe.h"
#include "nacre/bsdf/microflake_tables.h"

// The micro-flake model at eight wavelengths. bound_microflake.cpp gathers what depends on
// wavelength; bound_microflake_eval.cpp is what a renderer calls.

namespace nacre::bsdf {

// Where a wavelength falls between those of the paint.
struct Between {
    int lower = 0;
    float fraction = 0;
};

std::array<Between, kLanes> locate_wavelengths(const std::vector<double>& grid,
                                               const Wavelengths& wavelengths);

// Lanes of a function of the wavelength index.
template <class F>
FloatLanes at_wavelengths(const std::array<Between, kLanes>& where, F&& f) {
    return make_lanes([&](int i) {
        const float a = static_cast<float>(f(where[i].lower));
        if (where[i].fraction == 0) return a;
        return a + where[i].fraction * (static_cast<float>(f(where[i].lower + 1)) - a);
    });
}

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

class BoundMicroflake final : public BoundBsdf {
 public:
    BoundMicroflake(std::shared_ptr<const Microflake::Tables> tables,
                    const Wavelengths& wavelengths);

    FloatLanes eval(Vec3f wi, Vec3f wo) const override;
    std::optional<BsdfSample> sample(Vec3f wi, float u_lobe, Vec2f u) const override;
    float pdf(Vec3f wi, Vec3f wo) const override;
    BsdfValue evaluate(Vec3f wi, Vec3f wo) const override;
    FloatLanes albedo(Vec3f wi) const override;

 private:
    void bind_smooth_interface();
    void bind_rough_interface();
    void bind_layers();

    Ray make_ray(Vec3f w) const;
    FloatLanes value(const Ray& i, const Ray& o) const;
    FloatLanes single(Vec3f inside_i, Vec3f inside_o, const Ray& i, const Ray& o) const;
    FloatLanes rough_lobe(const Ray& i, const Ray& o) const;
    const LobeOdds& odds_at(const Ray& i) const;
    float density(const LobeOdds& odds, const Ray& i, const Ray& o) const;

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
