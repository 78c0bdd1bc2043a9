#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/bsdf/models/hot_spot.h"
#include "nacre/core/half.h"
#include "nacre/core/lane_math.h"
#include "nacre/exchange/webgl_layout.h"

// The arithmetic of webgl_shader.glsl, in double precision and from the same textures.

namespace nacre::exchange {

namespace {

using BandSums = std::array<double, kWebglBands>;

Vec3d refracted(Vec3d w, double ior) {
    const Vec3d in = {w.x / ior, w.y / ior, 0};
    return {in.x, in.y, std::sqrt(std::max(0.0, 1 - in.x * in.x - in.y * in.y))};
}

double fresnel(double cosine, double ior) {
    const double inside = std::sqrt(std::max(0.0, 1 - (1 - cosine * cosine) / (ior * ior)));
    const double s = (cosine - ior * inside) / (cosine + ior * inside);
    const double p = (inside - ior * cosine) / (inside + ior * cosine);
    return 0.5 * (s * s + p * p);
}

double bounded_exp(double gain) { return std::exp(std::min<double>(gain, bsdf::kMaxGain)); }

/// What two directions together determine: NacrePair.
struct Pair {
    Vec3d wi, wo, i, o;
    double xi, xo, slope2, cosine, turned, spread;

    Pair(Vec3d in, Vec3d out, double ior)
        : wi(in), wo(out), i(refracted(in, ior)), o(refracted(out, ior)) {
        xi = std::hypot(wi.x, wi.y) / (1 + wi.z);
        xo = std::hypot(wo.x, wo.y) / (1 + wo.z);
        const Vec3d h = i + o;
        slope2 = (h.x * h.x + h.y * h.y) / (h.z * h.z);
        cosine = std::min(0.5 * h.z * std::sqrt(1 + slope2), 1.0);
        turned = dot(i, o);
        spread = std::clamp(std::hypot(i.x / i.z - o.x / o.z, i.y / i.z - o.y / o.z), 1e-4, 1e6);
    }
};

class Mean {
 public:
    explicit Mean(const WebglShader& shader)
        : layout_(*shader.layout), table_(shader.textures[0]), smooth_(shader.textures[1]) {}

    Vec3d brdf(Vec3d wi, Vec3d wo) const {
        const Pair pair(wi, wo, layout_.ior);
        Vec3d value = multiple(pair) / (pair.i.z + pair.o.z);
        if (layout_.roughness > 0) return value + interface(pair);
        if (layout_.compensation) {
            const BandSums compensation = both(*layout_.compensation, pair);
            value = value * rgb(compensation) + ground(pair, compensation);
        }
        const double through = (1 - fresnel(wi.z, layout_.ior)) * (1 - fresnel(wo.z, layout_.ior));
        return through / (layout_.ior * layout_.ior) * (value + once(pair));
    }

 private:
    BandSums row(int channel, double place) const {
        const double y = std::clamp(place, 0.0, 1.0) * (kWebglRows - 1);
        const int low = std::min(static_cast<int>(y), kWebglRows - 2);
        const auto at = [&](int r, int b) {
            const std::size_t texel = static_cast<std::size_t>(r) * table_.size[0] + 4 * channel;
            return double{half_value(table_.rgba[4 * texel + b])};
        };
        BandSums out;
        for (int b = 0; b < kWebglBands; ++b) {
            out[b] = at(low, b) + (y - low) * (at(low + 1, b) - at(low, b));
        }
        return out;
    }
    BandSums both(int channel, const Pair& pair) const {
        BandSums out = row(channel, pair.xi);
        const BandSums o = row(channel, pair.xo);
        for (int b = 0; b < kWebglBands; ++b) out[b] *= o[b];
        return out;
    }
    Vec3d rgb(const BandSums& bands) const {
        Vec3d out;
        for (int c = 0; c < 3; ++c) {
            for (int b = 0; b < kWebglBands; ++b) out[c] += layout_.rgb[c][b] * bands[b];
        }
        return out;
    }

    Vec3d multiple(const Pair& p) const {
        const double a = std::min(std::max(p.xi, p.xo), 1.0);
        const double b = std::abs(p.xi - p.xo) / std::max(a, 1e-12);
        const double si = std::hypot(p.wi.x, p.wi.y), so = std::hypot(p.wo.x, p.wo.y);
        const double scale = 4 * si * si * so * so;
        const double ux = si * p.wo.x + so * p.wi.x, uy = si * p.wo.y + so * p.wi.y;
        const double q2 = scale > 1e-14 ? std::min((ux * ux + uy * uy) / scale, 1.0) : 0;
        const double at[3] = {std::sqrt(std::sqrt(q2)), std::sqrt(b), std::sqrt(a)};
        int low[3];
        double part[3];
        for (int axis = 0; axis < 3; ++axis) {
            const double place = at[axis] * (smooth_.size[axis] - 1);
            low[axis] = std::min(static_cast<int>(place), smooth_.size[axis] - 2);
            part[axis] = place - low[axis];
        }
        Vec3d sum;
        for (int corner = 0; corner < 8; ++corner) {
            double weight = 1;
            std::size_t texel = 0;
            for (int axis = 2; axis >= 0; --axis) {
                const int step = corner >> axis & 1;
                weight *= step ? part[axis] : 1 - part[axis];
                texel = texel * smooth_.size[axis] + low[axis] + step;
            }
            for (int c = 0; c < 3; ++c) sum[c] += weight * half_value(smooth_.rgba[4 * texel + c]);
        }
        return sum;
    }

    /// ln of what gaps let through, at the fraction u of a layer's thickness.
    BandSums gain(const Pair& pair, std::size_t layer, double u) const {
        BandSums sum{};
        for (const auto& gaps : layout_.gaps) {
            if (gaps.layer > layer) break;
            const auto &own = layout_.layers[gaps.layer], &here = layout_.layers[layer];
            const double step = pair.spread / gaps.diameter_um;
            const double far = u * here.thickness_um + here.top_um - own.top_um;
            const double near = gaps.layer < layer ? std::max(far - own.thickness_um, 0.0) : 0;
            const double shared = (bsdf::disc_overlap_integral(far * step) -
                                   bsdf::disc_overlap_integral(near * step)) /
                                  step;
            const BandSums coupling = both(gaps.coupling, pair);
            for (int b = 0; b < kWebglBands; ++b) sum[b] += coupling[b] * shared;
        }
        return sum;
    }
    BandSums escape(const Pair& pair, std::size_t layer, const BandSums& depth) const {
        BandSums out{};
        if (layout_.gaps.empty()) {
            for (int b = 0; b < kWebglBands; ++b) {
                out[b] = mean_attenuation(depth[b]);
            }
            return out;
        }
        const double least = *std::min_element(depth.begin(), depth.end());
        const double reach = std::min(1.0, kFarthestDepth / std::max(least, 1e-20));
        for (const WebglNode& node : webgl_nodes()) {
            const double u = reach * node.place;
            const BandSums more = gain(pair, layer, u);
            for (int b = 0; b < kWebglBands; ++b) {
                out[b] += reach * node.weight * bounded_exp(more[b] - depth[b] * u);
            }
        }
        return out;
    }

    Vec3d once(const Pair& pair) const {
        const double ri = 1 / pair.i.z, ro = 1 / pair.o.z;
        BandSums depth, total{};
        for (int b = 0; b < kWebglBands; ++b) depth[b] = layout_.clearcoat_depth[b] * (ri + ro);
        for (std::size_t n = 0; n < layout_.layers.size(); ++n) {
            const auto& layer = layout_.layers[n];
            const BandSums in = row(layer.extinction, pair.xi),
                           out = row(layer.extinction, pair.xo);
            BandSums here;
            for (int b = 0; b < kWebglBands; ++b) {
                here[b] = layer.thickness_um * (in[b] * ri + out[b] * ro);
            }
            const BandSums scattered = kernel(layer, pair), seen = escape(pair, n, here);
            for (int b = 0; b < kWebglBands; ++b) {
                total[b] += scattered[b] * std::exp(-depth[b]) * layer.thickness_um * seen[b];
                depth[b] += here[b];
            }
        }
        return ri * ro * rgb(total);
    }
    BandSums kernel(const WebglShader::Layout::Layer& layer, const Pair& pair) const {
        BandSums sum{};
        for (const auto& flake : layer.flakes) {
            const double sec2 = 1 + pair.slope2;
            const double lobe =
                flake.scale * sec2 * std::sqrt(sec2) *
                std::exp(-std::min(pair.slope2 / (flake.alpha * flake.alpha), 80.0));
            const BandSums reflectance = row(flake.reflectance, pair.cosine);
            for (int b = 0; b < kWebglBands; ++b) sum[b] += lobe * reflectance[b];
        }
        for (const auto& pigment : layer.pigments) {
            const double g = pigment.anisotropy;
            BandSums phase;
            if (pigment.phase) {
                phase = row(*pigment.phase,
                            std::acos(std::clamp(-pair.turned, -1.0, 1.0)) * std::numbers::inv_pi);
            } else {
                const double turn = std::max(1 + g * g + 2 * g * pair.turned, 1e-6);
                phase.fill((1 - g * g) * 0.25 * std::numbers::inv_pi / (turn * std::sqrt(turn)));
            }
            for (int b = 0; b < kWebglBands; ++b) sum[b] += phase[b] * pigment.scattering_per_um[b];
        }
        return sum;
    }

    Vec3d ground(const Pair& pair, const BandSums& compensation) const {
        BandSums light = both(*layout_.ground, pair);
        const BandSums more = gain(pair, layout_.layers.size() - 1, 1);
        for (int b = 0; b < kWebglBands; ++b) light[b] *= bounded_exp(more[b]) - compensation[b];
        return rgb(light);
    }

    Vec3d interface(const Pair& pair) const {
        const Vec3d h = pair.wi + pair.wo;
        const double tan2 = (h.x * h.x + h.y * h.y) / (h.z * h.z), sec2 = 1 + tan2;
        const double a2 = layout_.roughness * layout_.roughness;
        const double facets =
            std::exp(-std::min(tan2 / a2, 60.0)) * std::numbers::inv_pi / a2 * sec2 * sec2;
        const double lobe = 0.25 * facets * both(*layout_.masking, pair)[0] *
                            fresnel(std::min(0.5 * length(h), 1.0), layout_.ior);
        return rgb(both(*layout_.masked, pair)) + Vec3d{lobe, lobe, lobe};
    }

    const WebglShader::Layout& layout_;
    const WebglTexture &table_, &smooth_;
};

}  // namespace

Vec3d WebglShader::brdf(Vec3d wi, Vec3d wo) const { return Mean(*this).brdf(wi, wo); }

}  // namespace nacre::exchange
