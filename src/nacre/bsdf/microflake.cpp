#include "nacre/bsdf/microflake.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/bsdf/flake_lobe.h"
#include "nacre/bsdf/microflake_tables.h"
#include "nacre/bsdf/warp.h"
#include "nacre/core/lane_math.h"
#include "nacre/core/parallel.h"
#include "nacre/layers/rough_interface.h"
#include "nacre/optics/dielectric.h"

namespace nacre::bsdf {

namespace {

// Where a wavelength falls between those of the paint.
struct Between {
    int lower = 0;
    float fraction = 0;
};

std::array<Between, kLanes> locate_wavelengths(const std::vector<double>& grid,
                                               const Wavelengths& wavelengths) {
    std::array<Between, kLanes> out;
    for (int i = 0; i < kLanes; ++i) {
        const auto above = std::upper_bound(grid.begin(), grid.end(), wavelengths[i]);
        if (above == grid.begin()) continue;
        const int lower = static_cast<int>(above - grid.begin()) - 1;
        out[i].lower = lower;
        if (above != grid.end()) {
            out[i].fraction =
                static_cast<float>((wavelengths[i] - grid[lower]) / (*above - grid[lower]));
        }
    }
    return out;
}

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
    std::vector<FloatLanes> extinction;  // by direction
    std::vector<BoundFlake> flakes;
    std::vector<BoundPigment> pigments;
};

// One incident or outgoing direction: what both single scattering and the interface need of it.
struct Ray {
    Vec3f inside;
    float row_fraction, transmittance;
    int row;
};

class BoundMicroflake final : public BoundBsdf {
 public:
    BoundMicroflake(std::shared_ptr<const Microflake::Tables> tables,
                    const Wavelengths& wavelengths);

    FloatLanes eval(Vec3f wi, Vec3f wo) const override;
    std::optional<BsdfSample> sample(Vec3f wi, float u_lobe, Vec2f u) const override;
    float pdf(Vec3f wi, Vec3f wo) const override;
    FloatLanes albedo(Vec3f wi) const override;

 private:
    void bind_layers();
    void bind_rough_interface();
    Ray make_ray(Vec3f w, float ior) const;
    FloatLanes eval_at(Vec3f wi, Vec3f wo, float ior) const;
    FloatLanes single(const Ray& i, const Ray& o) const;
    FloatLanes interface_lobe(Vec3f wi, Vec3f wo) const;
    LobeOdds odds_at(Vec3f wi) const;
    float pdf_of(const LobeOdds& odds, Vec3f wi, Vec3f wo) const;

    std::shared_ptr<const Microflake::Tables> tables_;
    std::array<Between, kLanes> where_;
    SmoothGrid grid_;
    std::vector<FloatLanes> smooth_;
    std::vector<BoundLayer> layers_;
    FloatLanes clearcoat_depth_, ior_;
    bool dispersive_;
    float mean_ior_, inverse_mean_ior_;
    FlakeLobe flake_lobe_, wide_lobe_;
    // A rough interface only: its facets, and by direction the masking over the cosine and what is
    // masked and given back diffusely.
    struct Rough {
        FlakeLobe lobe;
        float inverse_alpha2;
        std::vector<float> masking;
        std::vector<FloatLanes> masked;
        FloatLanes diffuse_scale;
    };
    std::optional<Rough> rough_;
};

// A function of direction between its rows.
template <class T>
T at_direction(const std::vector<T>& table, Vec3f w) {
    const float x = std::sqrt(w.x * w.x + w.y * w.y) / (1 + w.z) * kDirectionIntervals;
    const int row = std::min(static_cast<int>(x), kDirectionIntervals - 1);
    return table[row] + (x - row) * (table[row + 1] - table[row]);
}

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
    dispersive_ = false;
    for (int i = 1; i < kLanes; ++i) dispersive_ = dispersive_ || ior_[i] != ior_[0];
    mean_ior_ = tables_->mean_ior;
    inverse_mean_ior_ = 1 / mean_ior_;

    if (tables_->rough) bind_rough_interface();
    if (!tables_->rough) bind_layers();
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

Ray BoundMicroflake::make_ray(Vec3f w, float ior) const {
    Ray ray;
    ray.inside = refract_in(w, 1 / ior);
    ray.transmittance = 1 - optics::dielectric_reflectance(1.0f, ior, w.z);
    const float x = std::sqrt(w.x * w.x + w.y * w.y) / (1 + w.z) * kDirectionIntervals;
    ray.row = std::min(static_cast<int>(x), kDirectionIntervals - 1);
    ray.row_fraction = x - ray.row;
    return ray;
}

// Single scattering without the interface: layers::single_scattering at eight wavelengths.
FloatLanes BoundMicroflake::single(const Ray& i, const Ray& o) const {
    const Vec3f h = i.inside + o.inside;
    const float inverse_mu_i = 1 / i.inside.z, inverse_mu_o = 1 / o.inside.z;
    const float tan2 = (h.x * h.x + h.y * h.y) / (h.z * h.z);
    const float sec2 = 1 + tan2, sec = std::sqrt(sec2);
    const float cosine = std::min(1.0f, 0.5f * h.z * sec);

    FloatLanes sum{};
    FloatLanes depth = clearcoat_depth_ * (inverse_mu_i + inverse_mu_o);
    for (const BoundLayer& layer : layers_) {
        FloatLanes kernel{};
        for (const BoundFlake& flake : layer.flakes) {
            const float exponent = tan2 * flake.inverse_alpha2;
            if (exponent > 60) continue;
            const float density =
                flake.half_density * flake.norm * sec2 * sec * std::exp(-exponent);
            const float x = cosine * flake.intervals;
            const int at = std::min(static_cast<int>(x), std::max(flake.intervals - 1, 0));
            FloatLanes reflectance = flake.reflectance[at];
            if (flake.intervals) {
                reflectance += (x - at) * (flake.reflectance[at + 1] - reflectance);
            }
            kernel += density * reflectance;
        }
        for (const BoundPigment& pigment : layer.pigments) {
            const float g = pigment.g, turn = 1 + g * g + 2 * g * dot(i.inside, o.inside);
            const float phase =
                (1 - g * g) * 0.25f * std::numbers::inv_pi_v<float> / (turn * std::sqrt(turn));
            kernel += phase * pigment.scattering;
        }
        const FloatLanes* e = layer.extinction.data();
        const FloatLanes rate =
            (e[i.row] + i.row_fraction * (e[i.row + 1] - e[i.row])) * inverse_mu_i +
            (e[o.row] + o.row_fraction * (e[o.row + 1] - e[o.row])) * inverse_mu_o;
        const FloatLanes here = layer.thickness_um * rate;
        // (1 - e^-x)/x stays finite for a layer without any extinction.
        const FloatLanes safe = max_lanes(here, splat(1e-20f));
        sum += kernel * exp_lanes(-depth) * (layer.thickness_um * one_minus_exp_lanes(safe) / safe);
        depth += here;
    }
    return sum * (inverse_mu_i * inverse_mu_o);
}

FloatLanes BoundMicroflake::eval_at(Vec3f wi, Vec3f wo, float ior) const {
    const Ray i = make_ray(wi, ior), o = make_ray(wo, ior);
    const FloatLanes smooth = interpolate(grid_, smooth_.data(), locate(grid_, wi, wo));
    // The truncated Fourier series may dip below zero by its own error.
    const float scale = ior == mean_ior_ ? i.inside.z + o.inside.z
                                         : refract_in(wi, inverse_mean_ior_).z +
                                               refract_in(wo, inverse_mean_ior_).z;
    return (single(i, o) + max_lanes(smooth, FloatLanes{}) / scale) *
           (i.transmittance * o.transmittance / (ior * ior));
}

// layers::RoughInterface::brdf at eight wavelengths.
FloatLanes BoundMicroflake::interface_lobe(Vec3f wi, Vec3f wo) const {
    const Vec3f h = wi + wo;
    const float inverse_z2 = 1 / (h.z * h.z);
    const float tan2 = (h.x * h.x + h.y * h.y) * inverse_z2, sec2 = 1 + tan2;
    const float exponent = tan2 * rough_->inverse_alpha2;
    FloatLanes f =
        rough_->diffuse_scale * at_direction(rough_->masked, wi) * at_direction(rough_->masked, wo);
    if (exponent < 60) {
        const float density = std::exp(-exponent) * rough_->inverse_alpha2 *
                              std::numbers::inv_pi_v<float> * sec2 * sec2;
        const float cosine = std::min(1.0f, 0.5f * length(h));
        f += (0.25f * density * at_direction(rough_->masking, wi) *
              at_direction(rough_->masking, wo)) *
             optics::dielectric_reflectance(splat(1.0f), ior_, splat(cosine));
    }
    return f;
}

FloatLanes BoundMicroflake::eval(Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return FloatLanes{};
    if (rough_) {
        const FloatLanes smooth = interpolate(grid_, smooth_.data(), locate(grid_, wi, wo));
        const float scale =
            refract_in(wi, inverse_mean_ior_).z + refract_in(wo, inverse_mean_ior_).z;
        return max_lanes(smooth, FloatLanes{}) / scale + interface_lobe(wi, wo);
    }
    if (!dispersive_) return eval_at(wi, wo, ior_[0]);
    // Each wavelength refracts its own way: rare, and eight times the work.
    FloatLanes f{};
    for (int lane = 0; lane < kLanes; ++lane) f[lane] = eval_at(wi, wo, ior_[lane])[lane];
    return f;
}

LobeOdds BoundMicroflake::odds_at(Vec3f wi) const {
    const float x = std::sqrt(wi.x * wi.x + wi.y * wi.y) / (1 + wi.z) * kDirectionIntervals;
    return tables_->odds[std::min(static_cast<int>(x + 0.5f), kDirectionIntervals)];
}

float BoundMicroflake::pdf_of(const LobeOdds& odds, Vec3f wi, Vec3f wo) const {
    const Vec3f in = refract_in(wi, inverse_mean_ior_), out = refract_in(wo, inverse_mean_ior_);
    const float inside =
        odds.flakes * flake_lobe_.pdf(in, out) + odds.wide * wide_lobe_.pdf(in, out);
    const float interface = rough_ ? odds.interface * rough_->lobe.pdf(wi, wo) : 0.0f;
    return interface + odds.diffuse * std::numbers::inv_pi_v<float> * wo.z +
           inside * wo.z * inverse_mean_ior_ * inverse_mean_ior_ / out.z;
}

float BoundMicroflake::pdf(Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return 0;
    return pdf_of(odds_at(wi), wi, wo);
}

std::optional<BsdfSample> BoundMicroflake::sample(Vec3f wi, float u_lobe, Vec2f u) const {
    if (wi.z <= 0) return std::nullopt;
    const LobeOdds odds = odds_at(wi);
    Vec3f wo;
    if (u_lobe < odds.interface && rough_) {
        wo = rough_->lobe.sample(wi, u_lobe / odds.interface, u);
    } else if (u_lobe < odds.interface) {
        BsdfSample s;
        s.wo = {-wi.x, -wi.y, wi.z};
        s.weight = make_lanes([&](int lane) {
            return optics::dielectric_reflectance(1.0f, ior_[lane], wi.z) / odds.interface;
        });
        s.pdf = odds.interface;
        s.mirror = true;
        return s;
    } else if ((u_lobe -= odds.interface) < odds.flakes + odds.wide) {
        const bool narrow = u_lobe < odds.flakes;
        const float u_sign = narrow ? u_lobe / odds.flakes : (u_lobe - odds.flakes) / odds.wide;
        const Vec3f inside = (narrow ? flake_lobe_ : wide_lobe_)
                                 .sample(refract_in(wi, inverse_mean_ior_), u_sign, u);
        if (inside.z <= 0) return std::nullopt;
        const auto outside = refract_out(inside, mean_ior_);
        if (!outside) return std::nullopt;
        wo = *outside;
    } else {
        wo = cosine_hemisphere(u);
    }
    if (wo.z <= 0) return std::nullopt;
    BsdfSample s;
    s.wo = wo;
    s.pdf = pdf_of(odds, wi, wo);
    if (!(s.pdf > 0)) return std::nullopt;
    s.weight = eval(wi, wo) * (wo.z / s.pdf);
    return s;
}

FloatLanes BoundMicroflake::albedo(Vec3f wi) const {
    if (wi.z <= 0) return FloatLanes{};
    const float x = std::sqrt(wi.x * wi.x + wi.y * wi.y) / (1 + wi.z) * kDirectionIntervals;
    const int row = std::min(static_cast<int>(x), kDirectionIntervals - 1);
    const int count = tables_->wavelength_count();
    const auto at = [&](int r) {
        return at_wavelengths(where_, [&](int w) { return tables_->albedo[r * count + w]; });
    };
    const FloatLanes a = at(row);
    return a + (x - row) * (at(row + 1) - a);
}

// Directional-hemispherical reflectance by the model's own sampling, at the points of a Hammersley
// set: deterministic, and within 1e-3 as weights hardly vary.
void tabulate_albedo(Microflake::Tables& tables,
                     const std::shared_ptr<const Microflake::Tables>& view) {
    constexpr int kStride = 8, kPoints = 512;
    const int count = tables.wavelength_count();
    tables.albedo.assign(static_cast<std::size_t>(kDirectionIntervals + 1) * count, 0.0f);
    const std::vector<double>& grid = tables.paint->wavelengths_nm();
    for (int block = 0; block < flakes::block_count(count); ++block) {
        Wavelengths wavelengths;
        for (int i = 0; i < kLanes; ++i) {
            wavelengths[i] = grid[std::min(block * kLanes + i, count - 1)];
        }
        const BoundMicroflake bound(view, wavelengths);
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
                if (const auto s = bound.sample(wi, lobe, {(p + 0.5f) / kPoints, radical})) {
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

}  // namespace

Microflake::Microflake(std::shared_ptr<const layers::SolvedPaint> paint) {
    auto tables = std::make_shared<Tables>(std::move(paint));
    tabulate_albedo(*tables, tables);
    tables_ = std::move(tables);
}

Microflake::~Microflake() = default;

std::unique_ptr<const BoundBsdf> Microflake::bind(const Wavelengths& wavelengths_nm) const {
    return std::make_unique<const BoundMicroflake>(tables_, wavelengths_nm);
}

}  // namespace nacre::bsdf
