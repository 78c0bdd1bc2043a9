#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <type_traits>
#include <vector>

#include "nacre/bsdf/flake_lobe.h"
#include "nacre/bsdf/models/coat_spread.h"
#include "nacre/bsdf/models/direction_tables.h"
#include "nacre/bsdf/models/interface_lobe.h"
#include "nacre/bsdf/models/leaning_tables.h"
#include "nacre/bsdf/models/microflake.h"
#include "nacre/bsdf/paint_interface.h"
#include "nacre/bsdf/reflection_warp.h"
#include "nacre/bsdf/smooth_table.h"
#include "nacre/bsdf/wavelength_lanes.h"
#include "nacre/core/lane_math.h"
#include "nacre/sparkle/coat_tilt.h"

namespace nacre::bsdf {

class BoundMicroflake;

// What the micro-flake model works out once a paint, before any wavelength is chosen.

/// Probability of the ways to draw a direction, by incident direction; they sum to 1.
struct SamplingProbabilities {
    float interface = 0;  ///< its lobe, or its specular reflection
    float table = 0;      ///< ReflectionWarp
    float diffuse = 0;
    /// Of what the table stands for, the fraction that is scattered once, roughly.
    float single = 0;
};

struct Microflake::Tables {
    explicit Tables(std::shared_ptr<const solver::SolvedPaint> solved);
    /// @param extinction_per_um  extinction_by_direction() of its medium, where that is known
    Tables(std::shared_ptr<const solver::SolvedPaint> solved,
           std::vector<std::vector<float>> extinction_per_um);

    std::shared_ptr<const solver::SolvedPaint> paint;
    float mean_ior;  ///< of the binder over the paint's wavelengths
    bool rough;      ///< the interface: its lobe takes the place of the specular one
    SmoothTable smooth;
    std::vector<std::vector<float>> extinction;  ///< extinction_by_direction()
    std::optional<CoatSpread> coat_spread;       ///< none where the coat is even
    std::optional<LeaningTables> leaning;        ///< none where no flakes lean
    // Filled by tabulate_sampling(), which needs the model itself.
    std::shared_ptr<const ReflectionWarp> warp;      ///< all but the interface
    std::vector<SamplingProbabilities> probability;  ///< by direction
    std::vector<float> albedo;  ///< [direction][wavelength]: directional-hemispherical reflectance

    int wavelength_count() const { return paint->medium.wavelength_count(); }
};

/// Fills the tables by which the surface that `bind` makes of them is sampled, and its albedo.
void tabulate_sampling(
    Microflake::Tables& tables,
    const std::function<std::unique_ptr<const BoundMicroflake>(const Wavelengths&)>& bind);

/// Of a specimen of the paint; none where its coat is flat.
std::optional<sparkle::CoatWaves> coat_waves(const solver::SolvedPaint& paint,
                                             std::uint64_t specimen);

/// Tangents of the flakes' mean normal; none where they do not lean.
std::optional<Vec2f> flake_lean(const solver::SolvedPaint& paint);

/// Of a specimen of the paint; none where its coat is even, or where nothing is seen of its thickness.
std::optional<sparkle::CoatThickness> coat_thickness(const solver::SolvedPaint& paint,
                                                     std::uint64_t specimen);

/// mean_index() in single precision.
float mean_ior(const solver::PaintMedium& medium);

// The micro-flake model at eight wavelengths: what depends on wavelength is gathered once, what a
// renderer calls depends on direction alone, and the templates below serve models whose flakes are
// not those of the mean as well.

struct BoundFlake {
    float half_density, inverse_alpha2, norm;  // c/2; 1/alpha^2; 1/(2 pi alpha^2)
    int intervals;                             // 0: reflectance does not depend on angle
    std::vector<FloatLanes> reflectance;
};

struct BoundPigment {
    float g;
    FloatLanes scattering;
    const optics::PhaseFunction* phase;  ///< of the paint; null: Henyey and Greenstein's of g

    /// Per sr, of light that is turned by the angle of this cosine.
    FloatLanes phase_value(float cosine,
                           const std::array<WavelengthPosition, kLanes>& where) const {
        if (phase) {
            const auto [node, fraction] = optics::PhaseFunction::locate(cosine);
            const double *a = phase->row(node), *b = phase->row(node + 1);
            return at_wavelengths(where,
                                  [&, f = fraction](int w) { return a[w] + f * (b[w] - a[w]); });
        }
        const float turn = 1 + g * g - 2 * g * cosine;
        return splat((1 - g * g) * 0.25f * std::numbers::inv_pi_v<float> /
                     (turn * std::sqrt(turn)));
    }
};

struct BoundLayer {
    float thickness_um;
    bool thick;   ///< 1 - e^-x needs no care: optical depth above 0.1 along every direction
    bool buried;  ///< under a layer or an absorbing clearcoat
    std::vector<FloatLanes> extinction;  // by direction
    std::vector<BoundFlake> flakes;
    std::vector<BoundPigment> pigments;
};

/// Which flakes scatter once: all of them, as their mean.
///
/// Any class with this function may take its place: the factor by which the single scattering of a
/// species differs from its mean, for the `flake`-th species of a layer whose optical depth along
/// both directions together is `depth`, at eight wavelengths.
///
/// A class may change the rest too: pigments by pigment_factor(layer, depth), which is like
/// factor(), and multiple scattering without Fresnel factors by multiple(by the equation of
/// transfer). Under a rough clearcoat, where a table holds the mean of all flakes, mean() is the
/// class of that mean; without it that is MeanFlakes. A class with kFlakesAlone set leaves out
/// everything but flakes.
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
    std::optional<BsdfSample> sample(Vec3f wi, float u_select, Vec2f u) const override;
    float pdf(Vec3f wi, Vec3f wo) const override;
    FloatLanes pdf_lanes(Vec3f wi, const Vec3Lanes& wo) const override;
    float specular_probability(Vec3f wi) const override;
    BsdfValue evaluate(Vec3f wi, Vec3f wo) const override;
    FloatLanes albedo(Vec3f wi) const override;
    BinderIndex binder_index() const override { return {mean_ior_, ior_}; }
    FloatLanes coat_depth() const override { return clearcoat_depth_; }
    MultiplyScattered multiply_scattered(Vec3f wi, Vec3f wo) const override;
    OpticalDepths optical_depths(float cosine) const override;
    CoatChange coat_change(Vec3f wi, Vec3f wo, float deviation) const override;
    FloatLanes coat_factor(Vec3f wi, Vec3f wo, float deviation) const override;
    const InterfaceLobe* interface_lobe() const override {
        return rough_ ? &rough_->interface : nullptr;
    }
    UnitRange interface_lobe_range(const Patch* patch, Vec3f wi) const override;

 protected:
    // For models that keep the smooth part and the ways to sample it, and change the flakes.

    Ray make_ray(Vec3f w) const { return bsdf::make_ray(w, inverse_mean_ior_); }
    /// BRDF without the specular lobe.
    template <class Flakes>
    FloatLanes value(const Ray& i, const Ray& o, const Flakes& flakes) const;
    /// Of it, the single scattering alone.
    template <class Flakes>
    FloatLanes single_value(const Ray& i, const Ray& o, const Flakes& flakes) const;

    /// Of value() under a smooth interface, all but the single scattering.
    template <class Flakes>
    MultiplyScattered multiple_value(const Ray& i, const Ray& o, const Flakes& flakes) const;

    const SamplingProbabilities& probabilities_at(const Ray& i) const;
    /// Per solid angle outside, of draw() with these probabilities.
    float density(const SamplingProbabilities& probability, const Ray& i, const Ray& o) const {
        return density(probability, i, o.outside, o.inside);
    }
    /// Whether u_select, in [0, sum of the probabilities), selects the specular lobe of a smooth
    /// interface.
    bool draws_specular(const SamplingProbabilities& probability, float u_select) const {
        return u_select < probability.interface && !rough_;
    }
    /// Draws w_o from the lobe that u_select selects, not the specular one; z <= 0 where no light leaves.
    Vec3f draw(const SamplingProbabilities& probability, const Ray& i, float u_select,
               Vec2f u) const;
    /// As sample(), of a surface whose value towards a ray is value_to(ray).
    template <class Value>
    std::optional<BsdfSample> sample_by(const Ray& i, float u_select, Vec2f u,
                                        const Value& value_to) const;
    /// Optical, of one layer along a direction.
    FloatLanes depth_there_and_back(std::size_t layer, const Ray& i) const {
        return 2 * layers_[layer].thickness_um / i.inside.z * i.look_up(layers_[layer].extinction);
    }
    /// The specular reflection of a smooth interface, chosen with this probability.
    BsdfSample specular_sample(Vec3f wi, float probability) const;
    /// The direction outside of one inside; empty where light cannot leave.
    std::optional<Vec3f> leave(Vec3f inside) const {
        if (inside.z <= 0) return std::nullopt;
        return refract_out(inside, mean_ior_);
    }
    float mean_ior() const { return mean_ior_; }
    /// Solid angles inside over those outside.
    float solid_angle_ratio(const Ray& o) const {
        return solid_angle_ratio(o.outside.z, o.inside.z);
    }

    /// The table where the thickness of the coat varies.
    CoatNodes coat_nodes(const Ray& i, const Ray& o) const;
    /// @param table  what the model makes of it, without Fresnel factors
    CoatChange coat_change(const Ray& i, const Ray& o, float deviation,
                           const CoatNodes& table) const;

    const std::array<WavelengthPosition, kLanes>& where() const { return where_; }

    /// Under a rough clearcoat, for models that change the flakes: must be called before value() or
    /// single_value() of other flakes than the mean.
    void bind_rough_single();
    bool under_rough_coat() const { return rough_.has_value(); }
    /// How a rough clearcoat spreads half vectors; nothing under a smooth one.
    const sparkle::CoatTilt& coat() const { return coat_; }

 private:
    template <class T>
    T solid_angle_ratio(const T& outside_z, const T& inside_z) const {
        return outside_z * (inverse_mean_ior_ * inverse_mean_ior_) / inside_z;
    }
    /// density() of one direction or of eight.
    template <class T>
    T density(const SamplingProbabilities& probability, const Ray& i, const Vec3<T>& outside,
              const Vec3<T>& inside) const;
    void bind_smooth_interface();
    void bind_layers();

    template <class Flakes>
    FloatLanes once(const Ray& i, const Ray& o, const Flakes& flakes) const;
    /// Of the single scattering under a rough clearcoat, which a table holds as a whole, that of
    /// some flakes over that of all: by the closed form under a smooth one, with the slopes of all
    /// flakes spread as half vectors are.
    template <class Flakes>
    FloatLanes rough_ratio(const Ray& i, const Ray& o, const Flakes& flakes) const;
    /// Values of a table that is bound to the wavelengths; a truncated Fourier series may dip below
    /// zero by its own error.
    FloatLanes tabulated(const BoundSmoothTable& table, const Ray& i, const Ray& o) const {
        return tabulated(table, i, o, cell_of(i, o));
    }
    FloatLanes tabulated(const BoundSmoothTable& table, const Ray& i, const Ray& o,
                         const SmoothCell& cell) const {
        return max_lanes(interpolate(grid_, table.get(), cell), FloatLanes{}) *
               (1 / (i.inside.z + o.inside.z));
    }
    SmoothCell cell_of(const Ray& i, const Ray& o) const {
        return locate(grid_, i.outside, o.outside, i.sine, o.sine, i.x, o.x);
    }
    /// Of the coat, along both directions together, of one standard deviation of its thickness.
    FloatLanes coat_depth_of_deviation(const Ray& i, const Ray& o) const;
    FloatLanes interface_factor(const Ray& i, const Ray& o) const {
        return i.look_up(scaled_transmittance_) * o.look_up(scaled_transmittance_) * inverse_ior2_ *
               (transmittance_scale(i) * transmittance_scale(o));
    }
    /// Of what a smooth interface lets through: it vanishes at grazing incidence as the transmittance
    /// does, and is 1/4 where the index is 1.
    static float transmittance_scale(const Ray& i) {
        const float sum = i.outside.z + i.inside.z;
        return i.outside.z * i.inside.z / (sum * sum);
    }
    template <class Flakes>
    FloatLanes single(Vec3f inside_i, Vec3f inside_o, const Ray& i, const Ray& o,
                      const Flakes& flakes) const;

    std::shared_ptr<const Microflake::Tables> tables_;
    std::array<WavelengthPosition, kLanes> where_;
    SmoothGrid grid_;
    BoundSmoothTable smooth_;
    std::optional<BoundLeaningTables> leaning_;  // none where no flakes lean
    BoundCoatSpread coat_spread_;
    std::vector<BoundLayer> layers_;
    FloatLanes clearcoat_depth_, ior_, inverse_ior2_;
    bool dispersive_ = false;
    float mean_ior_, inverse_mean_ior_;
    /// By direction: transmittance of a smooth interface over transmittance_scale(). Interpolated
    /// linearly it errs by at most 3e-4 of the transmittance, for any index up to 2.5 and at any angle.
    std::vector<FloatLanes> scaled_transmittance_;
    struct Rough {
        InterfaceLobe interface;
        BoundSmoothTable single;  // single scattering alone: bind_rough_single()
    };
    std::optional<Rough> rough_;
    sparkle::CoatTilt coat_;
};

template <class Value>
std::optional<BsdfSample> BoundMicroflake::sample_by(const Ray& i, float u_select, Vec2f u,
                                                     const Value& value_to) const {
    const SamplingProbabilities& probability = probabilities_at(i);
    if (draws_specular(probability, u_select)) {
        return specular_sample(i.outside, probability.interface);
    }
    BsdfSample s;
    s.wo = draw(probability, i, u_select, u);
    if (s.wo.z <= 0) return std::nullopt;
    const Ray o = make_ray(s.wo);
    // The table is larger than the caches near the processor: it comes while the density is found.
    prefetch(grid_, smooth_.get(), cell_of(i, o));
    s.pdf = density(probability, i, o);
    if (!(s.pdf > 0)) return std::nullopt;
    s.weight = value_to(o) * (s.wo.z / s.pdf);
    return s;
}

// The BRDF of a paint whose flakes are those of any class in the place of MeanFlakes.

// Single scattering without the interface: solver::single_scattering at eight wavelengths.
template <class Flakes>
FloatLanes BoundMicroflake::single(Vec3f inside_i, Vec3f inside_o, const Ray& i, const Ray& o,
                                   const Flakes& flakes) const {
    const Vec3f h = inside_i + inside_o;
    const float inverse_mu_i = 1 / inside_i.z, inverse_mu_o = 1 / inside_o.z;
    const float tan2 = (h.x * h.x + h.y * h.y) / (h.z * h.z);
    const float sec2 = 1 + tan2, sec = std::sqrt(sec2);
    const float cosine = std::min(1.0f, 0.5f * h.z * sec);
    const float spread2 = coat_.spread2(inside_i.z, inside_o.z);

    FloatLanes sum{};
    FloatLanes depth = clearcoat_depth_ * (inverse_mu_i + inverse_mu_o);
    std::size_t at_layer = 0;
    for (const BoundLayer& layer : layers_) {
        const FloatLanes rate =
            i.look_up(layer.extinction) * inverse_mu_i + o.look_up(layer.extinction) * inverse_mu_o;
        const FloatLanes here = layer.thickness_um * rate;

        FloatLanes kernel{};
        constexpr bool kFlakesAlone = requires { Flakes::kFlakesAlone; };
        bool any = !kFlakesAlone && !layer.pigments.empty();
        std::size_t at_flake = 0;
        for (const BoundFlake& flake : layer.flakes) {
            const std::size_t f = at_flake++;
            const float narrower = spread2 > 0 ? 1 / (1 + spread2 * flake.inverse_alpha2) : 1.0f;
            const float exponent = tan2 * flake.inverse_alpha2 * narrower;
            if (exponent > 60) continue;  // e^-60: outside the lobe
            if constexpr (kFlakesAlone) {
                if (!flakes.reflects(at_layer, f)) continue;
            }
            any = true;
            const float density =
                flake.half_density * flake.norm * narrower * sec2 * sec * std::exp(-exponent);
            const float x = cosine * flake.intervals;
            const int at = std::min(static_cast<int>(x), std::max(flake.intervals - 1, 0));
            FloatLanes reflectance = flake.reflectance[at];
            if (flake.intervals) {
                reflectance += (x - at) * (flake.reflectance[at + 1] - reflectance);
            }
            kernel += density * reflectance * flakes.factor(at_layer, f, here);
        }
        for (const BoundPigment& pigment : layer.pigments) {
            if (kFlakesAlone) break;
            const FloatLanes phase = pigment.phase_value(-dot(inside_i, inside_o), where_);
            if constexpr (requires { flakes.pigment_factor(at_layer, here); }) {
                kernel += phase * pigment.scattering * flakes.pigment_factor(at_layer, here);
            } else {
                kernel += phase * pigment.scattering;
            }
        }
        if (any) {
            FloatLanes escape;
            if (layer.thick) {
                escape = (1.0f - exp_lanes(-here)) / rate;
            } else {
                escape = layer.thickness_um * mean_attenuation(here);
            }
            sum += layer.buried ? kernel * exp_lanes(-depth) * escape : kernel * escape;
        }
        depth += here;
        ++at_layer;
    }
    return sum * (inverse_mu_i * inverse_mu_o);
}

template <class Flakes>
FloatLanes BoundMicroflake::value(const Ray& i, const Ray& o, const Flakes& flakes) const {
    const SmoothCell cell = cell_of(i, o);
    if (rough_) {
        const FloatLanes smooth = tabulated(smooth_, i, o, cell);
        const FloatLanes mean = smooth + rough_->interface.eval(i, o);
        if constexpr (std::is_same_v<Flakes, MeanFlakes>) {
            return mean;
        } else {
            const FloatLanes single = min_lanes(tabulated(rough_->single, i, o, cell), smooth);
            return mean + single * (rough_ratio(i, o, flakes) - 1.0f);
        }
    }
    // The table comes while single scattering is worked out.
    prefetch(grid_, smooth_.get(), cell);
    const FloatLanes single = once(i, o, flakes);
    FloatLanes smooth = tabulated(smooth_, i, o, cell);
    if constexpr (requires { flakes.multiple(smooth); }) smooth = flakes.multiple(smooth);
    return (single + smooth) * interface_factor(i, o);
}

template <class Flakes>
FloatLanes BoundMicroflake::single_value(const Ray& i, const Ray& o, const Flakes& flakes) const {
    if (rough_) {
        const FloatLanes single =
            min_lanes(tabulated(rough_->single, i, o), tabulated(smooth_, i, o));
        return single * rough_ratio(i, o, flakes);
    }
    return once(i, o, flakes) * interface_factor(i, o);
}

template <class Flakes>
FloatLanes BoundMicroflake::rough_ratio(const Ray& i, const Ray& o, const Flakes& flakes) const {
    constexpr float kDark = 1e-30f;
    // Where nothing is scattered once, nothing is changed.
    constexpr float kNothing = requires { Flakes::kFlakesAlone; }
    ? 0 : 1;
    FloatLanes all;
    if constexpr (requires { flakes.mean(); }) {
        all = once(i, o, flakes.mean());
    } else {
        all = once(i, o, MeanFlakes{});
    }
    const FloatLanes some = once(i, o, flakes);
    return all > kDark ? some / max_lanes(all, splat(kDark)) : splat(kNothing);
}

template <class Flakes>
MultiplyScattered BoundMicroflake::multiple_value(const Ray& i, const Ray& o,
                                                  const Flakes& flakes) const {
    const SmoothCell cell = cell_of(i, o);
    const bool over_ground = leaning_ && leaning_->over_black;
    if (leaning_) prefetch(grid_, leaning_->no_internal_reflection.get(), cell);
    if (over_ground) prefetch(grid_, leaning_->over_black.get(), cell);
    const FloatLanes factor = interface_factor(i, o);
    MultiplyScattered again;
    const FloatLanes smooth = tabulated(smooth_, i, o, cell);
    FloatLanes compensation = splat(1.0f);
    again.all = smooth;
    if constexpr (requires { flakes.multiple(smooth, compensation); }) {
        compensation = flakes.compensation();
        again.all = flakes.multiple(smooth, compensation);
    }
    again.all *= factor;
    again.no_internal_reflection = again.all;
    if (!leaning_) return again;
    compensation *= factor;
    const FloatLanes no_internal_reflection =
        tabulated(leaning_->no_internal_reflection, i, o, cell);
    const FloatLanes no_ground = over_ground ? tabulated(leaning_->over_black, i, o, cell) : smooth;
    again.no_internal_reflection = no_internal_reflection * compensation;
    if constexpr (requires { flakes.internal_reflection_gain(); }) {
        const FloatLanes returned = max_lanes(no_ground - no_internal_reflection, FloatLanes{}) *
                                    flakes.internal_reflection_gain();
        again.no_internal_reflection =
            max_lanes(no_ground * compensation - returned * factor, FloatLanes{});
    }
    if (over_ground) {
        // The difference of two solutions holds no light that is not well above their errors.
        constexpr float kSeen = 1e-3f;
        const FloatLanes ground = again.all - no_ground * compensation;
        again.from_ground = ground > kSeen * again.all ? ground : FloatLanes{};
    }
    return again;
}

template <class Flakes>
FloatLanes BoundMicroflake::once(const Ray& i, const Ray& o, const Flakes& flakes) const {
    if (!dispersive_) return single(i.inside, o.inside, i, o, flakes);
    // Each wavelength refracts its own way: rare, and eight times the work.
    FloatLanes sum;
    for (int lane = 0; lane < kLanes; ++lane) {
        const float inverse = 1 / ior_[lane];
        sum[lane] = single(refract_in(i.outside, inverse), refract_in(o.outside, inverse), i, o,
                           flakes)[lane];
    }
    return sum;
}

// Instantiated once, in microflake.cpp.
extern template FloatLanes BoundMicroflake::value(const Ray&, const Ray&, const MeanFlakes&) const;
extern template FloatLanes BoundMicroflake::single(Vec3f, Vec3f, const Ray&, const Ray&,
                                                   const MeanFlakes&) const;

}  // namespace nacre::bsdf
