#include "nacre/bsdf/microflake.h"

#include <algorithm>
#include <cmath>

#include "nacre/bsdf/bound_microflake.h"
#include "nacre/core/parallel.h"

namespace nacre::bsdf {

// Directional-hemispherical reflectance by the model's own sampling, at the points of a Hammersley
// set: deterministic, and within 1e-3 as weights hardly vary.
void tabulate_albedo(
    Microflake::Tables& tables,
    const std::function<std::unique_ptr<const BoundBsdf>(const Wavelengths&)>& bind) {
    constexpr int kStride = 8, kPoints = 512;
    const int count = tables.wavelength_count();
    tables.albedo.assign(static_cast<std::size_t>(kDirectionIntervals + 1) * count, 0.0f);
    const std::vector<double>& grid = tables.paint->wavelengths_nm();
    for (int block = 0; block < flakes::block_count(count); ++block) {
        Wavelengths wavelengths;
        for (int i = 0; i < kLanes; ++i) {
            wavelengths[i] = grid[std::min(block * kLanes + i, count - 1)];
        }
        const auto bound = bind(wavelengths);
        const int lanes = std::min(kLanes, count - block * kLanes);
        parallel_for(0, kDirectionIntervals / kStride + 1, [&](std::size_t step) {
            const int row = static_cast<int>(step) * kStride;
            const double theta = direction_angle(row);
            const Vec3f wi = {static_cast<float>(std::sin(theta)), 0,
                              static_cast<float>(std::cos(theta))};
            FloatLanes sum{};
            for (unsigned p = 0; p < kPoints; ++p) {
                unsigned bits = p * 0x9E3779B9u;  // Weyl sequence for the third coordinate
                float radical = 0, base = 0.5f;
                for (unsigned q = p; q; q >>= 1, base *= 0.5f) radical += (q & 1) * base;
                const float lobe = static_cast<float>(bits >> 8) * 0x1p-24f;
                if (const auto s = bound->sample(wi, lobe, {(p + 0.5f) / kPoints, radical})) {
                    sum += s->weight;
                }
            }
            for (int lane = 0; lane < lanes; ++lane) {
                tables.albedo[static_cast<std::size_t>(row) * count + block * kLanes + lane] =
                    std::min(1.0f, sum[lane] / kPoints);
            }
        });
    }
    for (int row = 0; row < kDirectionIntervals; ++row) {
        const int from = row / kStride * kStride;
        const float f = static_cast<float>(row - from) / kStride;
        for (int w = 0; w < count; ++w) {
            const float a = tables.albedo[from * count + w];
            tables.albedo[row * count + w] =
                a + f * (tables.albedo[(from + kStride) * count + w] - a);
        }
    }
}

Microflake::Microflake(std::shared_ptr<const layers::SolvedPaint> paint) {
    auto tables = std::make_shared<Tables>(std::move(paint));
    tabulate_albedo(*tables, [&](const Wavelengths& wavelengths_nm) {
        return std::make_unique<const BoundMicroflake>(tables, wavelengths_nm);
    });
    tables_ = std::move(tables);
}

Microflake::~Microflake() = default;

std::unique_ptr<const BoundBsdf> Microflake::bind(const Wavelengths& wavelengths_nm) const {
    return std::make_unique<const BoundMicroflake>(tables_, wavelengths_nm);
}

}  // namespace nacre::bsdf
