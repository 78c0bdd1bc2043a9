#include "nacre/bsdf/models/interface_lobe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "nacre/bsdf/models/direction_tables.h"
#include "nacre/optics/fresnel.h"
#include "nacre/solver/rough_interface.h"

namespace nacre::bsdf {

InterfaceLobe::InterfaceLobe(double roughness, const FloatLanes& ior, float mean_ior)
    : lobe_(static_cast<float>(roughness)),
      ior_(ior),
      inverse_mean_ior_(1 / mean_ior),
      inverse_alpha2_(1 / (static_cast<float>(roughness) * static_cast<float>(roughness))) {
    std::array<std::shared_ptr<const solver::RoughInterface>, kLanes> by_lane;
    for (int lane = 0; lane < kLanes; ++lane) {
        by_lane[lane] = lane > 0 && ior_[lane] == ior_[lane - 1]
                            ? by_lane[lane - 1]
                            : solver::rough_interface(ior_[lane], roughness);
    }
    diffuse_scale_ =
        make_lanes([&](int lane) { return static_cast<float>(by_lane[lane]->diffuse_scale()); });
    for (int row = 0; row <= kDirectionIntervals; ++row) {
        const double theta = direction_angle(row);
        masking_.push_back(static_cast<float>(
            solver::smith_beckmann_over_cosine(std::cos(theta), std::sin(theta), roughness)));
        FloatLanes masked{}, transmitted{};
        for (int lane = 0; lane < kLanes; ++lane) {
            const bool known = lane > 0 && by_lane[lane] == by_lane[lane - 1];
            masked[lane] =
                known ? masked[lane - 1] : static_cast<float>(by_lane[lane]->masked(theta));
            transmitted[lane] = known ? transmitted[lane - 1]
                                      : static_cast<float>(1 - by_lane[lane]->albedo(theta));
        }
        masked_.push_back(masked);
        transmittance_.push_back(transmitted);
    }
}

// solver::RoughInterface::brdf at eight wavelengths.
FloatLanes InterfaceLobe::eval(const Ray& i, const Ray& o) const {
    const Vec3f h = i.outside + o.outside;
    const float tan2 = (h.x * h.x + h.y * h.y) / (h.z * h.z), sec2 = 1 + tan2;
    const float exponent = tan2 * inverse_alpha2_;
    FloatLanes f = diffuse_scale_ * i.look_up(masked_) * o.look_up(masked_);
    if (exponent < 60) {
        const float facets =
            std::exp(-exponent) * inverse_alpha2_ * std::numbers::inv_pi_v<float> * sec2 * sec2;
        const float cosine = std::min(1.0f, 0.5f * length(h));
        f += (0.25f * facets * i.look_up(masking_) * o.look_up(masking_)) *
             optics::dielectric_reflectance(splat(1.0f), ior_, splat(cosine));
    }
    return f;
}

FloatLanes InterfaceLobe::eval(Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return FloatLanes{};
    return eval(make_ray(wi, inverse_mean_ior_), make_ray(wo, inverse_mean_ior_));
}

FloatLanes InterfaceLobe::transmittance(float cosine) const {
    const float sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
    return make_ray({sine, 0, cosine}, inverse_mean_ior_).look_up(transmittance_);
}

}  // namespace nacre::bsdf
