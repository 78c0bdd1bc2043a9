#include "nacre/bsdf/bound_microflake.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/layers/rough_interface.h"
#include "nacre/optics/dielectric.h"

namespace nacre::bsdf {

BoundMicroflake::BoundMicroflake(std::shared_ptr<const Microflake::Tables> tables,
                                 const Wavelengths& wavelengths)
    : tables_(std::move(tables)),
      where_(locate_wavelengths(tables_->paint->wavelengths_nm(), wavelengths)),
      grid_(tables_->smooth.grid()),
      smooth_(grid_.cells(), FloatLanes{}),
      flake_lobe_(tables_->flake_alpha),
      wide_lobe_(tables_->wide_alpha) {
    const layers::SolvedPaint& paint = *tables_->paint;
    const int count = tables_->wavelength_count();

    std::vector<FloatLanes> basis;
    for (const layers::Remainder* tensor : tables_->tensors()) {
        for (int k = 0; k < tensor->rank(); ++k) {
            basis.push_back(
                at_wavelengths(where_, [&](int w) { return tensor->basis[k * count + w]; }));
        }
    }
    tables_->smooth.bind(basis, smooth_.data());

    clearcoat_depth_ =
        at_wavelengths(where_, [&](int w) { return paint.medium.clearcoat_depth[w]; });
    ior_ = at_wavelengths(where_, [&](int w) { return paint.medium.ior[w]; });
    inverse_ior2_ = 1.0f / (ior_ * ior_);
    mean_ior_ = tables_->mean_ior;
    for (int i = 0; i < kLanes; ++i) dispersive_ = dispersive_ || ior_[i] != mean_ior_;
    inverse_mean_ior_ = 1 / mean_ior_;

    if (tables_->rough) {
        bind_rough_interface();
    } else {
        bind_smooth_interface();
        bind_layers();
    }
}

void BoundMicroflake::bind_smooth_interface() {
    for (int row = 0; row <= kDirectionIntervals; ++row) {
        const float cosine = static_cast<float>(std::cos(direction_angle(row)));
        transmittance_over_cosine_.push_back(
            (1.0f - optics::dielectric_reflectance(splat(1.0f), ior_, splat(cosine))) / cosine);
    }
}

// Single scattering of a smooth paint.
void BoundMicroflake::bind_layers() {
    const layers::SolvedPaint& paint = *tables_->paint;
    const int count = tables_->wavelength_count();
    for (std::size_t n = 0; n < paint.medium.layers.size(); ++n) {
        const layers::LayerMedium& medium = paint.medium.layers[n];
        BoundLayer& layer = layers_.emplace_back();
        layer.thickness_um = static_cast<float>(medium.thickness_um);
        for (int row = 0; row <= kDirectionIntervals; ++row) {
            layer.extinction.push_back(at_wavelengths(
                where_, [&](int w) { return tables_->extinction[n][row * count + w]; }));
        }
        float thinnest = INFINITY;
        for (const FloatLanes& extinction : layer.extinction) {
            thinnest = std::min(thinnest, -lane_max(-extinction) * layer.thickness_um);
        }
        layer.thick = thinnest > 0.1f;  // cosines only make it deeper
        layer.buried = n > 0 || lane_max(clearcoat_depth_) > 0;
        for (const layers::FlakeMedium& flake : medium.flakes) {
            const float alpha2 = static_cast<float>(flake.alpha * flake.alpha);
            BoundFlake& out = layer.flakes.emplace_back();
            out.half_density = static_cast<float>(0.5 * flake.area_density_per_um);
            out.inverse_alpha2 = 1 / alpha2;
            out.norm = 0.5f * std::numbers::inv_pi_v<float> / alpha2;
            out.intervals = flake.table.cosine_count() > 1 ? flakes::FlakeTable::kFineIntervals : 0;
            for (int c = 0; c <= out.intervals; ++c) {
                const double* row = flake.table.fine_reflectance(c);
                out.reflectance.push_back(at_wavelengths(where_, [&](int w) { return row[w]; }));
            }
        }
        for (const layers::PigmentMedium& pigment : medium.pigments) {
            layer.pigments.push_back(
                {static_cast<float>(pigment.anisotropy),
                 at_wavelengths(where_, [&](int w) { return pigment.scattering_per_um[w]; })});
        }
    }
}

void BoundMicroflake::bind_rough_interface() {
    const double alpha = tables_->paint->medium.roughness;
    const float a = static_cast<float>(alpha);
    Rough rough{FlakeLobe(a), 1 / (a * a), {}, {}, {}};
    std::array<std::shared_ptr<const layers::RoughInterface>, kLanes> by_lane;
    for (int lane = 0; lane < kLanes; ++lane) {
        by_lane[lane] = lane > 0 && ior_[lane] == ior_[lane - 1]
                            ? by_lane[lane - 1]
                            : layers::rough_interface(ior_[lane], alpha);
    }
    rough.diffuse_scale =
        make_lanes([&](int lane) { return static_cast<float>(by_lane[lane]->diffuse_scale()); });
    for (int row = 0; row <= kDirectionIntervals; ++row) {
        const double theta = direction_angle(row);
        rough.masking.push_back(static_cast<float>(
            layers::smith_beckmann_over_cosine(std::cos(theta), std::sin(theta), alpha)));
        FloatLanes masked{};
        for (int lane = 0; lane < kLanes; ++lane) {
            masked[lane] = lane > 0 && by_lane[lane] == by_lane[lane - 1]
                               ? masked[lane - 1]
                               : static_cast<float>(by_lane[lane]->masked(theta));
        }
        rough.masked.push_back(masked);
    }
    rough_ = std::move(rough);
}

}  // namespace nacre::bsdf
