#include "nacre/bsdf/nacre.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "nacre/bsdf/bound_nacre.h"
#include "nacre/bsdf/nacre_tables.h"
#include "nacre/core/error.h"
#include "nacre/core/rng.h"

namespace nacre::bsdf {
namespace {

sparkle::FlakePopulation population_of(const layers::FlakeSpecies& species,
                                       const layers::Layer& layer, double ior) {
    sparkle::FlakePopulation out;
    out.diameter_um = species.diameter_um;
    out.diameter_spread_um = species.diameter_spread_um;
    out.alpha = species.orientation.beckmann_alpha;
    out.ior = ior;
    constexpr double kSquareUmPerMm2 = 1e6;
    const double area_um2 =
        sparkle::FlakeSizes(species.diameter_um, species.diameter_spread_um).mean_area_um2();
    out.density_per_mm2 =
        species.area_density_per_um() * layer.thickness_um / area_um2 * kSquareUmPerMm2;
    return out;
}

// cos(w_i.h) of any two directions that the interface lets through, each within the critical angle.
double least_half_cosine(double ior) { return std::sqrt(std::max(0.0, 1 - 1 / (ior * ior))); }

// Light sent back at perpendicular incidence, in the mean over the wavelengths, by each species.
std::vector<double> returned_light(const Microflake::Tables& tables) {
    const layers::PaintMedium& medium = tables.paint->medium;
    const int count = medium.wavelength_count();
    std::vector<double> returned;
    std::vector<double> depth(count, 0.0);
    for (std::size_t l = 0; l < medium.layers.size(); ++l) {
        const layers::LayerMedium& layer = medium.layers[l];
        std::vector<double> seen(count);  // depth that is seen, in um
        for (int w = 0; w < count; ++w) {
            const double here = 2 * tables.extinction[l][w] * layer.thickness_um;
            seen[w] = layer.thickness_um * std::exp(-depth[w]) *
                      (here > 1e-9 ? -std::expm1(-here) / here : 1.0);
            depth[w] += here;
        }
        for (const layers::FlakeMedium& flake : layer.flakes) {
            double sum = 1e-30;
            for (int w = 0; w < count; ++w) {
                sum += seen[w] * flake.area_density_per_um *
                       flake.table.reflectance(1, w / kLanes)[w % kLanes];
            }
            returned.push_back(sum);
        }
    }
    return returned;
}

}  // namespace

Nacre::Tables::Tables(std::shared_ptr<const layers::SolvedPaint> paint, std::uint64_t seed,
                      const NacreSettings& settings)
    : smooth(std::make_shared<Microflake::Tables>(paint)) {
    const layers::Recipe& recipe = paint->recipe;
    const std::vector<double> returned = returned_light(*smooth);
    double all = 0;
    for (const double r : returned) all += r;
    for (std::size_t l = 0; l < recipe.layers.size(); ++l) {
        first_species.push_back(species.size());
        for (std::size_t f = 0; f < recipe.layers[l].flakes.size(); ++f) {
            const layers::FlakeSpecies& flake = recipe.layers[l].flakes[f];
            std::optional<FlakeFilms> films;
            if (const auto* platelet = std::get_if<optics::Platelet>(&flake.body);
                platelet && FlakeFilms::vary(*platelet)) {
                films.emplace(*platelet, recipe.binder, paint->wavelengths_nm(),
                              least_half_cosine(smooth->mean_ior));
            }
            const float share = static_cast<float>(returned[species.size()] / all);
            species.push_back(
                {sparkle::FlakeField(population_of(flake, recipe.layers[l], smooth->mean_ior),
                                     hash_of(seed, l, f)),
                 std::move(films), share});
        }
    }
    if (settings.hot_spot) hot_spot.emplace(*paint);
}

Nacre::Nacre(std::shared_ptr<const layers::SolvedPaint> paint, std::uint64_t seed,
             const NacreSettings& settings) {
    if (paint->medium.roughness > 0) {
        throw DomainError(
            fmt::format("clearcoat.roughness = {}: the model nacre needs a smooth clearcoat, with "
                        "roughness = 0",
                        paint->medium.roughness));
    }
    auto tables = std::make_shared<Tables>(std::move(paint), seed, settings);
    tabulate_albedo(*tables->smooth, [&](const Wavelengths& wavelengths_nm) {
        return std::make_unique<const BoundNacre>(tables, wavelengths_nm);
    });
    tables_ = std::move(tables);
}

Nacre::~Nacre() = default;

double Nacre::exact_patch_mm() const {
    double side = std::numeric_limits<double>::infinity();
    for (const NacreSpecies& species : tables_->species) {
        side = std::min(side, species.field.exact_side_mm());
    }
    return side;
}

std::unique_ptr<const BoundBsdf> Nacre::bind(const Wavelengths& wavelengths_nm) const {
    return std::make_unique<const BoundNacre>(tables_, wavelengths_nm);
}

}  // namespace nacre::bsdf
