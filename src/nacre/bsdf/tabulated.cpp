#include "nacre/bsdf/tabulated.h"

#include <algorithm>

#include "nacre/bsdf/rgb_lanes.h"
#include "nacre/bsdf/tabulated_tables.h"
#include "nacre/bsdf/warp.h"
#include "nacre/optics/dielectric.h"

namespace nacre::bsdf {

namespace {

// The model at eight wavelengths.
class BoundTabulated final : public BoundBsdf {
 public:
    BoundTabulated(std::shared_ptr<const Tabulated::Tables> tables, const Wavelengths& wavelengths)
        : tables_(std::move(tables)), spectrum_(wavelengths) {}

    FloatLanes eval(Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return FloatLanes{};
        return value(tables_->make_ray(wi), tables_->make_ray(wo));
    }

    float pdf(Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return 0;
        return tables_->density(tables_->odds_at(wi), tables_->make_ray(wi), tables_->make_ray(wo));
    }

    BsdfValue evaluate(Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return {};
        const TableRay i = tables_->make_ray(wi), o = tables_->make_ray(wo);
        return {value(i, o), tables_->density(tables_->odds_at(wi), i, o)};
    }

    std::optional<BsdfSample> sample(Vec3f wi, float u_lobe, Vec2f u) const override {
        if (wi.z <= 0) return std::nullopt;
        const LobeOdds& odds = tables_->odds_at(wi);
        if (u_lobe < odds.interface && !tables_->interface) {
            BsdfSample s;
            s.wo = {-wi.x, -wi.y, wi.z};
            s.weight =
                splat(optics::dielectric_reflectance(1.0f, tables_->ior, wi.z) / odds.interface);
            s.pdf = odds.interface;
            s.mirror = true;
            return s;
        }
        const TableRay i = tables_->make_ray(wi);
        const std::optional<Vec3f> wo = draw(i, odds, u_lobe, u);
        if (!wo || wo->z <= 0) return std::nullopt;
        const TableRay o = tables_->make_ray(*wo);
        BsdfSample s;
        s.wo = *wo;
        s.pdf = tables_->density(odds, i, o);
        if (!(s.pdf > 0)) return std::nullopt;
        s.weight = value(i, o) * (wo->z / s.pdf);
        return s;
    }

    FloatLanes albedo(Vec3f wi) const override {
        if (wi.z <= 0) return FloatLanes{};
        const DirectionRow at = direction_row(wi);
        const layers::Rgb &a = tables_->albedo[at.row], &b = tables_->albedo[at.row + 1];
        layers::Rgb rgb;
        for (int c = 0; c < 3; ++c) rgb[c] = a[c] + at.fraction * (b[c] - a[c]);
        const float mirror =
            tables_->interface ? 0.0f : optics::dielectric_reflectance(1.0f, tables_->ior, wi.z);
        return spectrum_(rgb) + mirror;
    }

 private:
    FloatLanes value(const TableRay& i, const TableRay& o) const {
        return spectrum_(tables_->rgb(i, o));
    }

    std::optional<Vec3f> draw(const TableRay& i, const LobeOdds& odds, float u_lobe,
                              Vec2f u) const {
        if (u_lobe < odds.interface) {
            return tables_->interface->sample(i.outside, u_lobe / odds.interface, u);
        }
        u_lobe -= odds.interface;
        if (u_lobe >= odds.flakes + odds.wide) return cosine_hemisphere(u);
        const bool narrow = u_lobe < odds.flakes;
        const float u_sign = narrow ? u_lobe / odds.flakes : (u_lobe - odds.flakes) / odds.wide;
        const Vec3f inside = (narrow ? tables_->flakes : tables_->wide).sample(i.inside, u_sign, u);
        if (inside.z <= 0) return std::nullopt;
        return refract_out(inside, tables_->ior);
    }

    std::shared_ptr<const Tabulated::Tables> tables_;
    RgbLanes spectrum_;
};

}  // namespace

Tabulated::Tabulated(std::shared_ptr<const layers::RawBrdfTable> table)
    : tables_(std::make_shared<const Tables>(Tables::Data(std::move(table)))) {}

Tabulated::Tabulated(std::shared_ptr<const layers::CompressedBrdfTable> table)
    : tables_(std::make_shared<const Tables>(Tables::Data(std::move(table)))) {}

Tabulated::~Tabulated() = default;

std::unique_ptr<const BoundBsdf> Tabulated::bind(const Wavelengths& wavelengths_nm) const {
    return std::make_unique<const BoundTabulated>(tables_, wavelengths_nm);
}

}  // namespace nacre::bsdf
