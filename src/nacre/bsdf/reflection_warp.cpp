#include "nacre/bsdf/reflection_warp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "nacre/bsdf/flake_lobe.h"
#include "nacre/core/parallel.h"

namespace nacre::bsdf {
namespace {

// Incident directions over tan(theta/2); slopes; azimuths of half the circle. With half as many slopes
// and azimuths pictures in even light have a third to a half more variance at 64 samples; twice as
// many incident directions would take 5 % off.
constexpr int kSlices = 33, kColumns = 65, kRows = 33;

// The azimuth's half circle over [0, 1], without trigonometry: the point walks along the sides of the
// square |x| + |y| = 1.
struct Azimuth {
    float cosine, sine;
    float rate;  // d phi / d y
};
Azimuth azimuth_at(float y) {
    const bool back = y >= 0.5f;
    const float t = 2 * y - (back ? 1.0f : 0.0f);
    const float a = 1 - t, square = a * a + t * t, inverse = 1 / std::sqrt(square);
    return {(back ? -t : a) * inverse, (back ? a : t) * inverse, 2 / square};
}
// The steepest half vector of two directions that the interface lets through.
float largest_slope(float ior) {
    constexpr float kUnbounded = 50;  // without a coat, where light grazes on both sides
    return ior > 1 ? std::min(kUnbounded, 1 / std::sqrt(ior * ior - 1)) : kUnbounded;
}

std::vector<float> tabulate(float ior, float alpha, const ReflectionWarp::Flux& flux) {
    const float reach = largest_slope(ior), end = reach / (reach + alpha);
    std::vector<float> values(static_cast<std::size_t>(kSlices) * kRows * kColumns);
    parallel_for(0, kSlices, [&](std::size_t slice) {
        const float x = std::min(static_cast<float>(slice) / (kSlices - 1), 0.9999f);
        const float inverse = 1 / (1 + x * x);
        const Vec3f wi = {2 * x * inverse, 0, (1 - x * x) * inverse};
        const Vec3f inside = refract_in(wi, 1 / ior);
        // Where a point of the unit square takes light, and the solid angle there per unit square.
        struct Place {
            Vec3f wo;
            float solid_angle;
        };
        const auto place_of = [&](float u, float v) -> std::optional<Place> {
            const float scaled = end * u, slope = alpha * scaled / (1 - scaled);
            const Azimuth azimuth = azimuth_at(v);
            const Vec3f m = normalize(Vec3f{-slope * azimuth.cosine, slope * azimuth.sine, 1.0f});
            const Vec3f out = 2 * dot(inside, m) * m - inside;
            if (out.z <= 0) return std::nullopt;
            const auto wo = refract_out(out, ior);
            if (!wo || wo->z < 1e-4f) return std::nullopt;
            const float slopes = slope * alpha * end / ((1 - scaled) * (1 - scaled)) * azimuth.rate;
            // Solid angles outside per area of slopes: see ReflectionWarp::slope_pdf.
            const float z = inside.z + out.z, sec2 = 1 + slope * slope;
            const float angles = ior * ior * out.z / wo->z * 2 * z / sec2;
            return Place{*wo, 2 * slopes * angles};
        };
        for (int r = 0; r < kRows; ++r) {
            for (int c = 1; c < kColumns; ++c) {  // the density of slopes vanishes at the first
                const auto at = [&](float dc, float dr) {
                    return place_of((c + dc) / (kColumns - 1), (r + dr) / (kRows - 1));
                };
                std::array<std::optional<Place>, 4> corners;
                int within = 0, leave = 0;
                for (const float dr : {-0.3f, 0.3f}) {
                    for (const float dc : {-0.3f, 0.3f}) {
                        if (c + dc >= kColumns - 1 || r + dr < 0 || r + dr >= kRows - 1) continue;
                        if ((corners[within++] = at(dc, dr))) ++leave;
                    }
                }
                float sum = 0;
                const auto add = [&](const Place& place) {
                    sum += flux(wi, place.wo) * place.solid_angle;
                };
                // The mean about the node where light leaves in part, so that cells at the edge of
                // total reflection are not missed.
                if (leave == 4) {
                    within = 1;
                    add(*at(0, 0));
                } else {
                    for (int k = 0; k < within; ++k)
                        if (corners[k]) add(*corners[k]);
                }
                values[(slice * kRows + r) * kColumns + c] = std::max(0.0f, sum / within);
            }
        }
    });
    return values;
}

}  // namespace

ReflectionWarp::ReflectionWarp(float ior, float alpha, const Flux& flux)
    : ior_(ior), alpha_(alpha), end_(largest_slope(ior) / (largest_slope(ior) + alpha)), warp_([&] {
          const std::vector<float> values = tabulate(ior, alpha, flux);
          for (int slice = 0; slice < kSlices; ++slice) {
              double sum = 0;
              for (int r = 0; r < kRows; ++r) {
                  for (int c = 0; c < kColumns; ++c) {
                      const double edge = (r == 0 || r == kRows - 1 ? 0.5 : 1.0) *
                                          (c == 0 || c == kColumns - 1 ? 0.5 : 1.0);
                      sum += edge * values[(slice * kRows + r) * kColumns + c];
                  }
              }
              albedo_.push_back(static_cast<float>(sum / ((kRows - 1) * (kColumns - 1))));
          }
          return SquareWarp(values, kSlices, kRows, kColumns);
      }()) {}

SliceMix ReflectionWarp::slices(float x) const {
    const float at = std::min(x, 1.0f) * (kSlices - 1);
    const int slice = std::min(static_cast<int>(at), kSlices - 2);
    SliceMix mix;
    mix.slice = {slice, slice + 1};
    mix.weight = {slice + 1 - at, at - slice};
    mix.count = 2;
    return mix;
}

float ReflectionWarp::albedo(float x) const {
    const SliceMix mix = slices(x);
    return mix.weight[0] * albedo_[mix.slice[0]] + mix.weight[1] * albedo_[mix.slice[1]];
}

Vec2f ReflectionWarp::direction_of(const Incident& i) const {
    const float sine2 = i.outside.x * i.outside.x + i.outside.y * i.outside.y;
    if (!(sine2 > 0)) return {1, 0};
    const float inverse = 1 / std::sqrt(sine2);
    return {i.outside.x * inverse, i.outside.y * inverse};
}

std::optional<Vec3f> ReflectionWarp::sample(const Incident& i, Vec2f u) const {
    const bool left = u.y >= 0.5f;
    const auto at = warp_.sample(slices(i.x), {u.x, left ? 2 - 2 * u.y : 2 * u.y}).at;
    const float slope = radius(end_ * at.x);
    const Azimuth azimuth = azimuth_at(at.y);
    const Vec2f e = direction_of(i);
    const float along = -slope * azimuth.cosine, across = (left ? -slope : slope) * azimuth.sine;
    const Vec3f m = normalize(Vec3f{along * e.x - across * e.y, along * e.y + across * e.x, 1.0f});
    const Vec3f out = 2 * dot(i.inside, m) * m - i.inside;
    if (out.z <= 0) return std::nullopt;
    return refract_out(out, ior_);
}

}  // namespace nacre::bsdf
