#include "nacre/bsdf/tabulated_tables.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/bsdf/mixture_fit.h"
#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/quadrature.h"
#include "nacre/optics/dielectric.h"

namespace nacre::bsdf {

namespace {

constexpr int kStride = 8;  // rows that are fitted; between them everything is interpolated

void require_size(std::size_t found, std::size_t wanted, const char* what) {
    if (found != wanted) {
        throw DomainError(fmt::format("a BRDF table has {} {}, not {}", found, what, wanted));
    }
}

void check(const layers::RawBrdfTable& table) {
    layers::validate(table.grid);
    require_size(table.values.size(), 3 * table.grid.values(), "values");
}

void check(const layers::CompressedBrdfTable& table) {
    layers::validate(table.grid);
    for (int k : table.rank) {
        require_in_range(k, 0, layers::CompressedBrdfTable::kMostTerms,
                         "terms of a compressed BRDF table");
    }
    require_size(table.left.size(), table.grid.pairs() * table.terms(), "left factors");
    require_size(table.right.size(), static_cast<std::size_t>(table.grid.azimuths) * table.terms(),
                 "right factors");
}

layers::BrdfGrid checked_grid(const Tabulated::Tables::Data& data) {
    return std::visit(
        [](const auto& table) {
            check(*table);
            return table->grid;
        },
        data);
}

// Roughness of the flakes' lobe inside the coat. Under a rough interface facets of slope m refract
// as half a flake of that slope reflects, roughly; the grid knows the narrowest lobe only.
float flake_roughness(const layers::BrdfGrid& grid) {
    return static_cast<float>(std::min(1.0, std::hypot(grid.lobe_alpha, 0.5 * grid.roughness)));
}

double brightness(const layers::Rgb& rgb) {
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
      odds(kDirectionIntervals + 1),
      albedo(kDirectionIntervals + 1) {
    if (grid.roughness > 0) interface.emplace(static_cast<float>(grid.roughness));
    parallel_for(0, kDirectionIntervals / kStride + 1,
                 [&](std::size_t step) { fit_row(static_cast<int>(step) * kStride); });
    for (int row = 0; row < kDirectionIntervals; ++row) {
        const int from = row / kStride * kStride;
        const float f = static_cast<float>(row - from) / kStride;
        if (row == from) continue;
        const LobeOdds &a = odds[from], &b = odds[from + kStride];
        const auto mix = [&](float LobeOdds::*m) { return a.*m + f * (b.*m - a.*m); };
        odds[row] = {mix(&LobeOdds::interface), mix(&LobeOdds::flakes), mix(&LobeOdds::wide),
                     mix(&LobeOdds::diffuse)};
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

layers::Rgb Tabulated::Tables::rgb(const TableRay& i, const TableRay& o) const {
    const layers::BrdfCell cell =
        layers::locate(grid, i.outside, o.outside, i.sine, o.sine, i.side_cosine, o.side_cosine);
    layers::Rgb g = std::visit([&](const auto& table) { return table->interpolate(cell); }, data);
    const float cosines = std::max(i.side_cosine + o.side_cosine, layers::kLeastCosines);
    const float factor = i.transmittance * o.transmittance / cosines;
    for (float& x : g) x *= factor;
    return g;
}

const LobeOdds& Tabulated::Tables::odds_at(Vec3f wi) const {
    const DirectionRow at = direction_row(wi);
    return odds[at.row + (at.fraction > 0.5f)];
}

// Solid angle inside over solid angle outside.
float Tabulated::Tables::leave(const TableRay& o) const {
    return o.outside.z / o.inside.z * (inverse_ior * inverse_ior);
}

std::array<float, 4> Tabulated::Tables::densities(const TableRay& i, const TableRay& o) const {
    return {interface ? interface->pdf(i.outside, o.outside) : 0.0f,
            leave(o) * flakes.mixed_pdf(i.inside, o.inside, 1, 0),
            leave(o) * flakes.mixed_pdf(i.inside, o.inside, 0, 1),
            o.outside.z * std::numbers::inv_pi_v<float>};
}

float Tabulated::Tables::density(const LobeOdds& p, const TableRay& i, const TableRay& o) const {
    const float facets = interface ? p.interface * interface->pdf(i.outside, o.outside) : 0.0f;
    return facets + leave(o) * flakes.mixed_pdf(i.inside, o.inside, p.flakes, p.wide) +
           o.outside.z * (p.diffuse * std::numbers::inv_pi_v<float>);
}

// Albedo by quadrature, and the odds of the lobes from the same points.
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
    std::array<double, 3> sum{};
    for (int t = 0; t < kPolar; ++t) {
        const double theta = unit_polar.nodes[t] * std::numbers::pi / 2;
        const double sine = std::sin(theta), cosine = std::cos(theta);
        for (int a = 0; a < kAzimuths; ++a) {
            // phi' = pi x^2 from the mirror direction packs points into the lobe.
            const double x = unit_azimuth.nodes[a], phi = std::numbers::pi * (1 - x * x);
            const TableRay o =
                make_ray({static_cast<float>(sine * std::cos(phi)),
                          static_cast<float>(sine * std::sin(phi)), static_cast<float>(cosine)});
            const layers::Rgb f = rgb(i, o);
            const double weight = unit_polar.weights[t] * std::numbers::pi / 2 * sine * cosine *
                                  unit_azimuth.weights[a] * 4 * std::numbers::pi * x;
            for (int c = 0; c < 3; ++c) sum[c] += weight * f[c];
            const double flux = weight * brightness(f);
            energy += flux;
            points.push_back({flux, densities(i, o)});
        }
    }
    for (int c = 0; c < 3; ++c) albedo[row][c] = static_cast<float>(sum[c]);

    std::array<double, 4> share =
        fit_mixture(points, std::array<double, 4>{interface ? 0.25 : 0.0, 0.25, 0.25, 0.25});
    // The mirror by its energy; a fiftieth of the rest, at least, goes everywhere, and as much to
    // the wide lobe: that bounds the weights.
    const double mirror =
        interface ? 0.0 : optics::dielectric_reflectance(1.0, grid.ior, std::cos(theta_i));
    const double chance = mirror > 0 ? mirror / (mirror + energy + 1e-6) : 0.0;
    constexpr double kLeast = 0.02;
    share[2] = std::max(share[2], kLeast);
    share[3] = std::max(share[3], kLeast);
    double all = 0;
    for (double x : share) all += x;
    for (double& x : share) x *= (1 - chance) / all;
    odds[row] = {static_cast<float>(chance + share[0]), static_cast<float>(share[1]),
                 static_cast<float>(share[2]), static_cast<float>(share[3])};
}

}  // namespace nacre::bsdf
