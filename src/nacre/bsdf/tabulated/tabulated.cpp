#include "nacre/bsdf/tabulated/tabulated.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <variant>
#include <vector>

#include "nacre/bsdf/flake_lobe.h"
#include "nacre/bsdf/models/bound_microflake.h"
#include "nacre/bsdf/warp.h"
#include "nacre/bsdf/wavelength_lanes.h"
#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/quadrature.h"
#include "nacre/optics/fresnel.h"

// What the tabulated model computes once per table, before any wavelength is chosen.

namespace nacre::bsdf {

/// One direction, and what a lookup needs of it.
struct TableRay {
    Vec3f outside, inside;  ///< inside: refracted with the mean index
    float sine;             ///< outside
    float side_cosine;      ///< on the side on which the grid measures half vectors
    float transmittance;    ///< of a smooth interface over n; 1 for a rough one
};

/// Of the lobes at one incident direction; they sum to 1.
struct LobeProbabilities {
    float interface = 0, flakes = 0, wide = 0, diffuse = 0;
};

struct Tabulated::Tables {
    using Data = std::variant<std::shared_ptr<const RawBrdfTable>,
                              std::shared_ptr<const CompressedBrdfTable>,
                              std::shared_ptr<const FourierBrdfTable>>;

    explicit Tables(Data table);

    Data data;
    BrdfGrid grid;
    float ior, inverse_ior;
    /// Lobes that samples come from, inside the coat; under a rough interface, its own outside.
    FlakeLobe flakes, wide;
    std::optional<FlakeLobe> interface;
    std::vector<LobeProbabilities> probability;  ///< by direction row
    std::vector<spectra::Rgb> albedo;            ///< by direction row, the specular lobe left out

    TableRay make_ray(Vec3f w) const;
    /// The BRDF in linear Rec. 709.
    spectra::Rgb rgb(const TableRay& i, const TableRay& o) const;
    const LobeProbabilities& probabilities_at(Vec3f wi) const;
    /// Density of sampling o given i, the specular lobe left out.
    float density(const LobeProbabilities& probability, const TableRay& i, const TableRay& o) const;
    /// Densities of the lobes apart: interface, flakes, wide, diffuse.
    std::array<float, 4> densities(const TableRay& i, const TableRay& o) const;

 private:
    float solid_angle_ratio(const TableRay& o) const;
    void fit_row(int row);
};

/// Row of the direction tables and the fraction to the next.
struct DirectionRow {
    int row;
    float fraction;
};
DirectionRow direction_row(Vec3f w);

namespace {

constexpr int kStride = 8;  // rows that are fitted; between them everything is interpolated

void require_size(std::size_t found, std::size_t wanted, const char* what) {
    if (found != wanted) {
        throw DomainError(fmt::format("a BRDF table has {} {}, not {}", found, what, wanted));
    }
}

void check(const RawBrdfTable& table) {
    validate(table.grid);
    require_size(table.values.size(), 3 * table.grid.values(), "values");
}

void check(const CompressedBrdfTable& table) {
    validate(table.grid);
    for (int k : table.rank) {
        require_in_range(k, 0, CompressedBrdfTable::kMaxTerms, "terms of a compressed BRDF table");
    }
    require_size(table.left.size(), table.grid.pairs() * table.terms(), "left factors");
    require_size(table.right.size(), static_cast<std::size_t>(table.grid.azimuths) * table.terms(),
                 "right factors");
}

void check(const FourierBrdfTable& table) {
    std::visit([](const auto& coefficients) { check(coefficients); }, table.coefficients);
    require_size(table.reflectance.size(), FourierBrdfTable::kReflectanceIntervals + 1,
                 "values of the flakes' reflectance");
}

// The lookup of each kind of table, in a cell between two directions.
template <class Table>
spectra::Rgb look_up(const Table& table, const BrdfCell& cell, const TableRay&, const TableRay&) {
    return table.interpolate(cell);
}

spectra::Rgb look_up(const FourierBrdfTable& table, const BrdfCell& cell, const TableRay& i,
                     const TableRay& o) {
    const float sines = i.sine * o.sine;
    const float cos_phi =
        sines > 0 ? (i.outside.x * o.outside.x + i.outside.y * o.outside.y) / sines : 1.0f;
    const float cos_d = std::sqrt(std::max(0.0f, 0.5f * (1 + dot(i.inside, o.inside))));
    return table.interpolate(cell, std::clamp(cos_phi, -1.0f, 1.0f), cos_d);
}

BrdfGrid checked_grid(const Tabulated::Tables::Data& data) {
    return std::visit(
        [](const auto& table) {
            check(*table);
            return table->grid;
        },
        data);
}

// Roughness of the flakes' lobe inside the coat; the grid knows the narrowest lobe only. A facet of
// a rough interface of slope m turns refracted light by about half as much as a flake of that slope
// turns reflected light.
float flake_roughness(const BrdfGrid& grid) {
    return static_cast<float>(std::min(1.0, std::hypot(grid.lobe_alpha, 0.5 * grid.roughness)));
}

double brightness(const spectra::Rgb& rgb) {
    return std::max(0.0, (static_cast<double>(rgb[0]) + rgb[1] + rgb[2]) / 3);
}

}  // namespace

DirectionRow direction_row(Vec3f w) {
    const float sine = std::sqrt(w.x * w.x + w.y * w.y);
    const float at = sine / (1 + w.z) * kDirectionIntervals;
    const int row = std::min(static_cast<int>(at), kDirectionIntervals - 1);
    return {row, at - row};
}

Tabulated::Tables::Tables(Data table)
    : data(std::move(table)),
      grid(checked_grid(data)),
      ior(static_cast<float>(grid.ior)),
      inverse_ior(1 / ior),
      flakes(flake_roughness(grid)),
      wide(2 * flake_roughness(grid)),
      probability(kDirectionIntervals + 1),
      albedo(kDirectionIntervals + 1) {
    if (grid.roughness > 0) interface.emplace(static_cast<float>(grid.roughness));
    parallel_for(0, kDirectionIntervals / kStride + 1,
                 [&](std::size_t step) { fit_row(static_cast<int>(step) * kStride); });
    for (int row = 0; row < kDirectionIntervals; ++row) {
        const int from = row / kStride * kStride;
        const float f = static_cast<float>(row - from) / kStride;
        if (row == from) continue;
        const LobeProbabilities &a = probability[from], &b = probability[from + kStride];
        const auto mix = [&](float LobeProbabilities::*m) { return a.*m + f * (b.*m - a.*m); };
        probability[row] = {mix(&LobeProbabilities::interface), mix(&LobeProbabilities::flakes),
                            mix(&LobeProbabilities::wide), mix(&LobeProbabilities::diffuse)};
        for (int c = 0; c < 3; ++c) {
            albedo[row][c] = albedo[from][c] + f * (albedo[from + kStride][c] - albedo[from][c]);
        }
    }
}

TableRay Tabulated::Tables::make_ray(Vec3f w) const {
    TableRay ray;
    ray.outside = w;
    ray.inside = refract_in(w, inverse_ior);
    ray.sine = std::sqrt(w.x * w.x + w.y * w.y);
    ray.side_cosine = interface ? w.z : ray.inside.z;
    ray.transmittance =
        interface ? 1.0f : (1 - optics::dielectric_reflectance(1.0f, ior, w.z)) * inverse_ior;
    return ray;
}

spectra::Rgb Tabulated::Tables::rgb(const TableRay& i, const TableRay& o) const {
    const BrdfCell cell =
        locate(grid, i.outside, o.outside, i.sine, o.sine, i.side_cosine, o.side_cosine);
    spectra::Rgb g =
        std::visit([&](const auto& table) { return look_up(*table, cell, i, o); }, data);
    const float cosines = std::max(i.side_cosine + o.side_cosine, kMinCosines);
    const float factor = i.transmittance * o.transmittance / cosines;
    return factor * g;
}

const LobeProbabilities& Tabulated::Tables::probabilities_at(Vec3f wi) const {
    const DirectionRow at = direction_row(wi);
    return probability[at.row + (at.fraction > 0.5f)];
}

// Solid angle inside over solid angle outside.
float Tabulated::Tables::solid_angle_ratio(const TableRay& o) const {
    return o.outside.z / o.inside.z * (inverse_ior * inverse_ior);
}

std::array<float, 4> Tabulated::Tables::densities(const TableRay& i, const TableRay& o) const {
    return {interface ? interface->pdf(i.outside, o.outside) : 0.0f,
            solid_angle_ratio(o) * flakes.mixed_pdf(i.inside, o.inside, 1, 0),
            solid_angle_ratio(o) * flakes.mixed_pdf(i.inside, o.inside, 0, 1),
            o.outside.z * std::numbers::inv_pi_v<float>};
}

float Tabulated::Tables::density(const LobeProbabilities& p, const TableRay& i,
                                 const TableRay& o) const {
    const float facets = interface ? p.interface * interface->pdf(i.outside, o.outside) : 0.0f;
    return facets + solid_angle_ratio(o) * flakes.mixed_pdf(i.inside, o.inside, p.flakes, p.wide) +
           o.outside.z * (p.diffuse * std::numbers::inv_pi_v<float>);
}

// Albedo by quadrature, and the probability of the lobes from the same points.
void Tabulated::Tables::fit_row(int row) {
    constexpr int kPolar = 96, kAzimuths = 96;
    const double theta_i = direction_angle(row);
    const TableRay i =
        make_ray({static_cast<float>(std::sin(theta_i)), 0, static_cast<float>(std::cos(theta_i))});
    const Quadrature& unit_polar = unit_gauss_legendre(kPolar);
    const Quadrature& unit_azimuth = unit_gauss_legendre(kAzimuths);
    std::vector<FluxPoint<4>> points;
    points.reserve(kPolar * kAzimuths);
    double energy = 0;
    Vec3d sum;
    for (int t = 0; t < kPolar; ++t) {
        const double theta = unit_polar.nodes[t] * std::numbers::pi / 2;
        const double sine = std::sin(theta), cosine = std::cos(theta);
        for (int a = 0; a < kAzimuths; ++a) {
            // phi' = pi x^2 from the mirror direction packs points into the lobe.
            const double x = unit_azimuth.nodes[a], phi = std::numbers::pi * (1 - x * x);
            const TableRay o =
                make_ray({static_cast<float>(sine * std::cos(phi)),
                          static_cast<float>(sine * std::sin(phi)), static_cast<float>(cosine)});
            const spectra::Rgb f = rgb(i, o);
            const double weight = unit_polar.weights[t] * std::numbers::pi / 2 * sine * cosine *
                                  unit_azimuth.weights[a] * 4 * std::numbers::pi * x;
            sum += weight * to_double(f);
            const double flux = weight * brightness(f);
            energy += flux;
            points.push_back({flux, densities(i, o)});
        }
    }
    albedo[row] = to_float(sum);

    std::array<double, 4> fraction =
        fit_mixture(points, std::array<double, 4>{interface ? 0.25 : 0.0, 0.25, 0.25, 0.25});
    // The specular lobe by its energy; of the others, the cosine lobe has at least a fiftieth, and
    // so has the wide lobe: that bounds the weights.
    const double specular =
        interface ? 0.0 : optics::dielectric_reflectance(1.0, grid.ior, std::cos(theta_i));
    const double p_specular = specular > 0 ? specular / (specular + energy + 1e-6) : 0.0;
    constexpr double kMin = 0.02;
    fraction[2] = std::max(fraction[2], kMin);
    fraction[3] = std::max(fraction[3], kMin);
    double all = 0;
    for (double x : fraction) all += x;
    for (double& x : fraction) x *= (1 - p_specular) / all;
    probability[row] = {static_cast<float>(p_specular + fraction[0]),
                        static_cast<float>(fraction[1]), static_cast<float>(fraction[2]),
                        static_cast<float>(fraction[3])};
}

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
        return tables_->density(tables_->probabilities_at(wi), tables_->make_ray(wi),
                                tables_->make_ray(wo));
    }

    BsdfValue evaluate(Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return {};
        const TableRay i = tables_->make_ray(wi), o = tables_->make_ray(wo);
        return {value(i, o), tables_->density(tables_->probabilities_at(wi), i, o)};
    }

    std::optional<BsdfSample> sample(Vec3f wi, float u_select, Vec2f u) const override {
        if (wi.z <= 0) return std::nullopt;
        const LobeProbabilities& probability = tables_->probabilities_at(wi);
        if (u_select < probability.interface && !tables_->interface) {
            BsdfSample s;
            s.wo = {-wi.x, -wi.y, wi.z};
            s.weight = splat(optics::dielectric_reflectance(1.0f, tables_->ior, wi.z) /
                             probability.interface);
            s.pdf = probability.interface;
            s.kind = SampleKind::specular;
            return s;
        }
        const TableRay i = tables_->make_ray(wi);
        const std::optional<Vec3f> wo = draw(i, probability, u_select, u);
        if (!wo || wo->z <= 0) return std::nullopt;
        const TableRay o = tables_->make_ray(*wo);
        BsdfSample s;
        s.wo = *wo;
        s.pdf = tables_->density(probability, i, o);
        if (!(s.pdf > 0)) return std::nullopt;
        s.weight = value(i, o) * (wo->z / s.pdf);
        return s;
    }

    FloatLanes albedo(Vec3f wi) const override {
        if (wi.z <= 0) return FloatLanes{};
        const DirectionRow at = direction_row(wi);
        const spectra::Rgb &a = tables_->albedo[at.row], &b = tables_->albedo[at.row + 1];
        const spectra::Rgb rgb = a + at.fraction * (b - a);
        const float specular =
            tables_->interface ? 0.0f : optics::dielectric_reflectance(1.0f, tables_->ior, wi.z);
        return spectrum_(rgb) + specular;
    }

 private:
    FloatLanes value(const TableRay& i, const TableRay& o) const {
        return spectrum_(tables_->rgb(i, o));
    }

    std::optional<Vec3f> draw(const TableRay& i, const LobeProbabilities& probability,
                              float u_select, Vec2f u) const {
        if (u_select < probability.interface) {
            return tables_->interface->sample(i.outside, u_select / probability.interface, u);
        }
        u_select -= probability.interface;
        if (u_select >= probability.flakes + probability.wide) return cosine_hemisphere(u);
        const bool narrow = u_select < probability.flakes;
        const float u_sign = narrow ? u_select / probability.flakes
                                    : (u_select - probability.flakes) / probability.wide;
        const Vec3f inside = (narrow ? tables_->flakes : tables_->wide).sample(i.inside, u_sign, u);
        if (inside.z <= 0) return std::nullopt;
        return refract_out(inside, tables_->ior);
    }

    std::shared_ptr<const Tabulated::Tables> tables_;
    RgbLanes spectrum_;
};

}  // namespace

Tabulated::Tabulated(std::shared_ptr<const RawBrdfTable> table)
    : tables_(std::make_shared<const Tables>(Tables::Data(std::move(table)))) {}

Tabulated::Tabulated(std::shared_ptr<const CompressedBrdfTable> table)
    : tables_(std::make_shared<const Tables>(Tables::Data(std::move(table)))) {}

Tabulated::Tabulated(const BrdfTable& table)
    : tables_(std::make_shared<const Tables>(
          std::visit([](const auto& t) { return Tables::Data(t); }, table))) {}

Tabulated::Tabulated(std::shared_ptr<const FourierBrdfTable> table)
    : tables_(std::make_shared<const Tables>(Tables::Data(std::move(table)))) {}

Tabulated::~Tabulated() = default;

std::unique_ptr<const BoundBsdf> Tabulated::bind(const Wavelengths& wavelengths_nm) const {
    return std::make_unique<const BoundTabulated>(tables_, wavelengths_nm);
}

BrdfTable shared_brdf_table(std::variant<RawBrdfTable, CompressedBrdfTable> table) {
    return std::visit(
        [](auto&& t) -> BrdfTable {
            using T = std::decay_t<decltype(t)>;
            return std::make_shared<const T>(std::forward<decltype(t)>(t));
        },
        std::move(table));
}

}  // namespace nacre::bsdf
