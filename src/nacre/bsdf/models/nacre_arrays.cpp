#include "nacre/bsdf/models/nacre_arrays.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/bsdf/models/paint_table.h"
#include "nacre/bsdf/models/rough_hot_spot.h"
#include "nacre/core/error.h"
#include "nacre/solver/rough_interface.h"

namespace nacre::bsdf {
namespace {

void add_smooth(const Microflake::Tables& tables, NacreArrays& out) {
    out.grid = tables.smooth.grid();
    out.rank = tables.smooth.rank();
    const auto coefficients = tables.smooth.coefficients();
    out.smooth.assign(coefficients.begin(), coefficients.end());
    for (const solver::MultipleScattering* tensor : tabulated_tensors(*tables.paint)) {
        if (tensor == &tables.paint->rough_single) out.single_rank = tensor->table_rank;
        const auto size = static_cast<std::size_t>(tensor->table_rank) * tables.wavelength_count();
        out.smooth_basis.insert(out.smooth_basis.end(), tensor->basis.begin(),
                                tensor->basis.begin() + static_cast<std::ptrdiff_t>(size));
    }
}

NacreArrays::Layer layer_arrays(const solver::LayerMedium& medium,
                                const std::vector<float>& extinction, int wavelengths) {
    NacreArrays::Layer layer;
    layer.thickness_um = medium.thickness_um;
    layer.extinction_per_um = extinction;
    for (const solver::FlakeMedium& flake : medium.flakes) {
        NacreArrays::Flake& to = layer.flakes.emplace_back();
        to.area_density_per_um = flake.area_density_per_um;
        to.alpha = flake.alpha;
        to.cosines = flake.table.cosine_count() > 1 ? paint::FlakeTable::kFineIntervals + 1 : 1;
        for (int c = 0; c < to.cosines; ++c) {
            const double* row = flake.table.fine_reflectance(c);
            to.reflectance.insert(to.reflectance.end(), row, row + wavelengths);
        }
    }
    for (const solver::PigmentMedium& pigment : medium.pigments) {
        NacreArrays::Pigment& to = layer.pigments.emplace_back();
        to.anisotropy = pigment.anisotropy;
        to.scattering_per_um.assign(pigment.scattering_per_um.begin(),
                                    pigment.scattering_per_um.begin() + wavelengths);
        if (!pigment.phase) continue;
        for (int node = 0; node <= optics::PhaseFunction::kIntervals; ++node) {
            const double* row = pigment.phase->row(node);
            to.phase.insert(to.phase.end(), row, row + wavelengths);
        }
    }
    return layer;
}

void add_rough_interface(const Microflake::Tables& tables, NacreArrays& out) {
    const double alpha = tables.paint->medium.roughness;
    const std::vector<double>& ior = tables.paint->medium.ior;
    out.coat_roughness = alpha;
    out.masked.resize(static_cast<std::size_t>(kDirectionIntervals + 1) * ior.size());
    std::shared_ptr<const solver::RoughInterface> interface;
    for (std::size_t w = 0; w < ior.size(); ++w) {
        const bool known = w > 0 && ior[w] == ior[w - 1];
        if (!known) interface = solver::rough_interface(ior[w], alpha);
        out.diffuse_scale.push_back(interface->diffuse_scale());
        for (int row = 0; row <= kDirectionIntervals; ++row) {
            double* const to = &out.masked[static_cast<std::size_t>(row) * ior.size() + w];
            *to = known ? to[-1] : interface->masked(direction_angle(row));
        }
    }
    for (int row = 0; row <= kDirectionIntervals; ++row) {
        const double theta = direction_angle(row);
        out.masking_over_cosine.push_back(
            solver::smith_beckmann_over_cosine(std::cos(theta), std::sin(theta), alpha));
    }
}

NacreArrays arrays_of(const Microflake::Tables& tables) {
    const solver::SolvedPaint& paint = *tables.paint;
    NacreArrays out;
    out.wavelengths_nm = paint.wavelengths_nm();
    out.mean_ior = tables.mean_ior;
    for (int w = 0; w < tables.wavelength_count(); ++w) {
        out.ior.push_back(paint.medium.ior[w]);
        out.clearcoat_depth.push_back(paint.medium.clearcoat_depth[w]);
    }
    add_smooth(tables, out);
    for (std::size_t l = 0; l < paint.medium.layers.size(); ++l) {
        out.layers.push_back(
            layer_arrays(paint.medium.layers[l], tables.extinction[l], tables.wavelength_count()));
    }
    for (const SamplingProbabilities& p : tables.probability) {
        out.probability.insert(out.probability.end(), {p.interface, p.table, p.diffuse, p.single});
    }
    out.albedo = tables.albedo;
    if (tables.rough) add_rough_interface(tables, out);
    return out;
}

void require_even_coat(const solver::SolvedPaint& paint) {
    paint::require_no_lean(paint.recipe, "these arrays are");
    if (paint.recipe.orange_peel()) {
        throw DomainError(
            "clearcoat.orange_peel: these arrays describe a flat coat; only Nacre's own renderer "
            "shows its waves");
    }
    if (paint.recipe.coat_spread() > 0) {
        throw DomainError(fmt::format(
            "clearcoat.thickness_spread_um = {}: these arrays describe an even coat, of spread 0; "
            "only Nacre's own renderer shows where it is thicker",
            paint.recipe.clearcoat->thickness_spread_um));
    }
}

NacreArrays::HotSpotArrays hot_spot_arrays(const HotSpotTables& tables) {
    NacreArrays::HotSpotArrays out;
    for (const HotSpotTables::Species& s : tables.species()) {
        out.species.push_back({s.layer, s.diameter_um, s.coupling});
    }
    out.ground = tables.ground();
    out.compensation = tables.compensation();
    return out;
}

NacreArrays::Species species_arrays(const NacreSpecies& species) {
    const sparkle::FlakeField& field = species.field;
    NacreArrays::Species out;
    out.fraction = species.fraction;
    out.field = field.constants();
    out.density_per_mm2 = field.population().density_per_mm2;
    out.alpha = field.population().alpha;
    out.waviness = field.population().waviness;
    out.radius_um = field.lobe().radius(1.0);
    const float* sizes = field.sizes().diameters_um();
    out.diameter_um.assign(sizes, sizes + paint::FlakeSizes::kSizes);
    if (species.films) {
        const FlakeFilms& films = *species.films;
        out.film_sets = static_cast<int>(films.sets());
        out.film_min_cosine = films.min_cosine();
        const std::size_t rows =
            films.sets() * static_cast<std::size_t>(films.cosine_intervals() + 1);
        const std::size_t stride = films.ratios().size() / rows;
        out.film_ratio.reserve(rows * (stride - 1));
        for (std::size_t row = 0; row < rows; ++row) {
            const float* from = films.ratios().data() + row * stride;
            out.film_ratio.insert(out.film_ratio.end(), from, from + stride - 1);
        }
    }
    return out;
}

NacreArrays arrays_of(const Microflake::Tables& smooth, const HotSpotTables* hot_spot,
                      const std::vector<NacreSpecies>& all_species) {
    NacreArrays out = arrays_of(smooth);
    if (hot_spot) out.hot_spot = hot_spot_arrays(*hot_spot);
    for (const NacreSpecies& species : all_species) out.species.push_back(species_arrays(species));
    return out;
}

NacreArrays mean_arrays(const std::shared_ptr<const solver::SolvedPaint>& paint,
                        const NacreModel& settings) {
    std::optional<HotSpotTables> hot_spot;
    if (settings.hot_spot) hot_spot.emplace(*paint);
    const Microflake::Tables smooth =
        hot_spot ? Microflake::Tables(with_rough_hot_spot(paint, *hot_spot), hot_spot->extinction())
                 : Microflake::Tables(paint);
    const SpeciesFilms alike(flake_fractions(smooth).size());
    return arrays_of(smooth, hot_spot ? &*hot_spot : nullptr,
                     nacre_species(smooth, settings.specimen, alike));
}

}  // namespace

NacreArrays microflake_arrays(const std::shared_ptr<const solver::SolvedPaint>& paint,
                              ArrayParts parts) {
    require_even_coat(*paint);
    if (parts == ArrayParts::mean) return arrays_of(Microflake::Tables(paint));
    const Microflake surface(paint);
    return arrays_of(surface.tables());
}

NacreArrays nacre_live_arrays(const std::shared_ptr<const solver::SolvedPaint>& paint,
                              std::uint64_t specimen) {
    return mean_arrays(paint, {.specimen = specimen});
}

NacreArrays nacre_arrays(const std::shared_ptr<const solver::SolvedPaint>& paint,
                         const NacreModel& settings, ArrayParts parts, const Progress& progress) {
    require_even_coat(*paint);
    if (parts == ArrayParts::mean) return mean_arrays(paint, settings);
    const Nacre surface(paint, settings, progress);
    const Nacre::Tables& tables = surface.tables();
    return arrays_of(*tables.smooth, tables.hot_spot ? &*tables.hot_spot : nullptr, tables.species);
}

}  // namespace nacre::bsdf
