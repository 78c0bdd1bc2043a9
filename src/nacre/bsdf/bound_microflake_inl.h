#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/bsdf/bound_microflake.h"
#include "nacre/core/lane_math.h"

// The BRDF of a paint whose flakes are those of any class in the place of MeanFlakes.

namespace nacre::bsdf {

// Single scattering without the interface: layers::single_scattering at eight wavelengths.
template <class Flakes>
FloatLanes BoundMicroflake::single(Vec3f inside_i, Vec3f inside_o, const Ray& i, const Ray& o,
                                   const Flakes& flakes) const {
    const Vec3f h = inside_i + inside_o;
    const float inverse_mu_i = 1 / inside_i.z, inverse_mu_o = 1 / inside_o.z;
    const float tan2 = (h.x * h.x + h.y * h.y) / (h.z * h.z);
    const float sec2 = 1 + tan2, sec = std::sqrt(sec2);
    const float cosine = std::min(1.0f, 0.5f * h.z * sec);

    FloatLanes sum{};
    FloatLanes depth = clearcoat_depth_ * (inverse_mu_i + inverse_mu_o);
    std::size_t at_layer = 0;
    for (const BoundLayer& layer : layers_) {
        const FloatLanes rate =
            i.look_up(layer.extinction) * inverse_mu_i + o.look_up(layer.extinction) * inverse_mu_o;
        const FloatLanes here = layer.thickness_um * rate;

        FloatLanes kernel{};
        bool any = !layer.pigments.empty();
        std::size_t at_flake = 0;
        for (const BoundFlake& flake : layer.flakes) {
            const std::size_t f = at_flake++;
            const float exponent = tan2 * flake.inverse_alpha2;
            if (exponent > 60) continue;  // e^-60: outside the lobe
            any = true;
            const float density =
                flake.half_density * flake.norm * sec2 * sec * std::exp(-exponent);
            const float x = cosine * flake.intervals;
            const int at = std::min(static_cast<int>(x), std::max(flake.intervals - 1, 0));
            FloatLanes reflectance = flake.reflectance[at];
            if (flake.intervals) {
                reflectance += (x - at) * (flake.reflectance[at + 1] - reflectance);
            }
            kernel += density * reflectance * flakes.factor(at_layer, f, here);
        }
        for (const BoundPigment& pigment : layer.pigments) {
            const float g = pigment.g, turn = 1 + g * g + 2 * g * dot(inside_i, inside_o);
            const float phase =
                (1 - g * g) * 0.25f * std::numbers::inv_pi_v<float> / (turn * std::sqrt(turn));
            kernel += phase * pigment.scattering;
        }
        if (any) {
            FloatLanes escape;
            if (layer.thick) {
                escape = (1.0f - exp_lanes(-here)) / rate;
            } else {
                // (1 - e^-x)/x stays finite for a layer without any extinction.
                const FloatLanes safe = max_lanes(here, splat(1e-20f));
                escape = layer.thickness_um * one_minus_exp_lanes(safe) / safe;
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
    const SmoothCell cell = locate(grid_, i.outside, o.outside, i.sine, o.sine, i.x, o.x);
    // The truncated Fourier series may dip below zero by its own error.
    const FloatLanes smooth = max_lanes(interpolate(grid_, smooth_.data(), cell), FloatLanes{}) *
                              (1 / (i.inside.z + o.inside.z));
    if (rough_) return smooth + rough_lobe(i, o);
    FloatLanes once;
    if (!dispersive_) {
        once = single(i.inside, o.inside, i, o, flakes);
    } else {
        // Each wavelength refracts its own way: rare, and eight times the work.
        for (int lane = 0; lane < kLanes; ++lane) {
            const float inverse = 1 / ior_[lane];
            once[lane] = single(refract_in(i.outside, inverse), refract_in(o.outside, inverse), i,
                                o, flakes)[lane];
        }
    }
    const FloatLanes interface = i.look_up(transmittance_over_cosine_) *
                                 o.look_up(transmittance_over_cosine_) * inverse_ior2_;
    return (once + smooth) * interface * (i.outside.z * o.outside.z);
}

// Made once, in bound_microflake_eval.cpp.
extern template FloatLanes BoundMicroflake::value(const Ray&, const Ray&, const MeanFlakes&) const;
extern template FloatLanes BoundMicroflake::single(Vec3f, Vec3f, const Ray&, const Ray&,
                                                   const MeanFlakes&) const;

}  // namespace nacre::bsdf
