#include "nacre/io/recipe_file.h"

#include <algorithm>
#include <map>

#include "nacre/core/atomic_file.h"
#include "nacre/core/error.h"
#include "nacre/io/spectrum_reader.h"
#include "nacre/io/table_reader.h"
#include "nacre/layers/recipe_limits.h"

namespace nacre::io {

namespace {

namespace limits = layers::limits;
using optics::Material;

// Ranges of n and k of a material written out in a recipe: as wide as Material allows.
constexpr Range kIndexN{0, 100, "", true};
constexpr Range kIndexK{0, 1000};

Material find_named_material(const TableReader& table, std::string_view key,
                             const std::string& text) {
    try {
        return optics::find_material(text, table.document().base_directory());
    } catch (const Error& error) {
        table.fail(key, error.what());
    }
}

/// { name = "...", wavelengths_nm = [...], n = [...], k = [...] }: a material by its samples, or
/// without wavelengths_nm a constant.
Material read_sampled_material(const TableReader& table) {
    const std::string name = table.text_or("name", "", limits::kNameLength);
    const std::string source = table.text_or("source", "", 10 * limits::kNameLength);
    const bool constant = !table.has("wavelengths_nm");
    const std::vector<double> wavelengths =
        constant ? std::vector<double>{} : read_wavelengths(table, "wavelengths_nm");
    const std::size_t samples = constant ? 1 : wavelengths.size();
    const std::vector<double> n = table.numbers("n", kIndexN, samples, samples);
    const std::vector<double> k = table.has("k") ? table.numbers("k", kIndexK, samples, samples)
                                                 : std::vector<double>(samples, 0.0);
    std::vector<optics::ComplexIndex> index(samples);
    for (std::size_t i = 0; i < samples; ++i) index[i] = {n[i], k[i]};
    try {
        if (constant) return Material(name, index[0], source);
        return Material(name, wavelengths, index, source);
    } catch (const DomainError& error) {
        table.fail(error.what());
    }
}

Material read_material(const TableReader& table, std::string_view key) {
    if (table.is_text(key)) {
        return find_named_material(table, key, table.text(key, 10 * limits::kNameLength));
    }
    if (table.is_table(key)) {
        return read_sampled_material(
            table.table(key, {"name", "source", "wavelengths_nm", "n", "k"}));
    }
    if (!table.has(key)) table.fail(key, "is missing; it must be an index or a material's name");
    return Material(table.number(key, kIndexN));
}

Material read_binder(const TableReader& recipe) {
    if (recipe.has("ior") && !recipe.is_text("ior") && !recipe.is_table("ior")) {
        return Material(recipe.number("ior", limits::kBinderIndex));
    }
    return read_material(recipe, "ior");
}

optics::ThicknessSpread read_spread(const TableReader& film) {
    optics::ThicknessSpread spread;
    spread.standard_deviation_nm = film.number_or("spread_nm", 0, limits::kFilmSpread);
    if (film.has("distribution")) {
        spread.law = film.choice("distribution", {"normal", "uniform"}) == 1
                         ? optics::ThicknessSpread::Law::uniform
                         : optics::ThicknessSpread::Law::normal;
    }
    return spread;
}

const TableReader::Keys kFilmKeys = {"material", "thickness_nm", "spread_nm", "distribution"};

optics::FilmPopulation read_film(const TableReader& film) {
    return {read_material(film, "material"), film.number("thickness_nm", limits::kFilmThickness),
            read_spread(film)};
}

optics::Platelet read_platelet(const TableReader& flakes) {
    for (std::string_view key : {"transmittance", "thickness_um"}) {
        if (flakes.has(key)) {
            flakes.fail(key, "goes with reflectance; a flake with a core gets it from its films");
        }
    }
    optics::Platelet platelet;
    platelet.core = read_film(flakes.table("core", kFilmKeys));
    for (const TableReader& coat : flakes.tables("coats", limits::kCoats, kFilmKeys)) {
        platelet.coats.push_back(read_film(coat));
    }
    return platelet;
}

layers::PrescribedFlake read_prescribed(const TableReader& flakes) {
    if (flakes.has("coats")) flakes.fail("coats", "go with a core; this flake has a reflectance");
    layers::PrescribedFlake flake;
    flake.reflectance = read_reflectance(flakes, "reflectance");
    flake.transmittance = flakes.has("transmittance") ? read_reflectance(flakes, "transmittance")
                                                      : spectra::Spectrum(0.0);
    if (flakes.has("volume_fraction") || flakes.has("thickness_um")) {
        flake.thickness_um = flakes.number("thickness_um", limits::kPlateletThickness);
    }
    return flake;
}

layers::FlakeSpecies read_flakes(const TableReader& flakes) {
    layers::FlakeSpecies species;
    species.name = flakes.text_or("name", "", limits::kNameLength);
    const bool by_area = flakes.has("area_density_per_um");
    if (by_area && flakes.has("volume_fraction")) {
        flakes.fail("area_density_per_um",
                    "how many flakes there are is said twice; give volume_fraction or "
                    "area_density_per_um, not both");
    }
    if (by_area) {
        species.amount =
            layers::AreaDensity{flakes.number("area_density_per_um", limits::kAreaDensity)};
    } else {
        if (!flakes.has("volume_fraction")) {
            flakes.fail("volume_fraction",
                        "is missing; it must be a number in " + limits::kVolumeFraction.text() +
                            ", or area_density_per_um in " + limits::kAreaDensity.text());
        }
        species.amount =
            layers::VolumeFraction{flakes.number("volume_fraction", limits::kVolumeFraction)};
    }
    species.diameter_um = flakes.number_or("diameter_um", species.diameter_um, limits::kDiameter);
    species.diameter_spread_um = flakes.number_or("diameter_spread_um", 0, limits::kDiameterSpread);
    const TableReader orientation = flakes.table("orientation", {"distribution", "alpha"});
    orientation.choice("distribution", {"beckmann"});
    species.orientation.beckmann_alpha = orientation.number("alpha", limits::kBeckmannAlpha);

    if (flakes.has("core") && flakes.has("reflectance")) {
        flakes.fail("reflectance", "a flake has either a reflectance or a core, not both");
    }
    if (flakes.has("reflectance")) {
        species.body = read_prescribed(flakes);
    } else {
        species.body = read_platelet(flakes);
    }
    return species;
}

layers::Layer read_layer(const TableReader& table) {
    layers::Layer layer;
    layer.thickness_um = table.number("thickness_um", limits::kLayerThickness);
    for (const TableReader& flakes : table.tables(
             "flakes", limits::kSpeciesPerLayer,
             {"name", "volume_fraction", "area_density_per_um", "diameter_um", "diameter_spread_um",
              "orientation", "core", "coats", "reflectance", "transmittance", "thickness_um"})) {
        layer.flakes.push_back(read_flakes(flakes));
    }
    for (const TableReader& pigment :
         table.tables("pigment", limits::kSpeciesPerLayer,
                      {"scattering_per_mm", "absorption_per_mm", "anisotropy"})) {
        layer.pigments.push_back(
            {read_spectrum_or(pigment, "scattering_per_mm", 0.0, limits::kPerMillimetre),
             read_spectrum_or(pigment, "absorption_per_mm", 0.0, limits::kPerMillimetre),
             pigment.number_or("anisotropy", 0, limits::kAnisotropy)});
    }
    return layer;
}

layers::Microfacet read_microfacet(const TableReader& table) {
    layers::Microfacet m;
    m.alpha = table.number("alpha", limits::kMicrofacetAlpha);
    if (table.has("distribution")) {
        m.distribution = table.choice("distribution", {"beckmann", "ggx"}) == 0
                             ? layers::FacetDistribution::beckmann
                             : layers::FacetDistribution::ggx;
    }
    m.film_ior = table.number("film_ior", limits::kMicrofacetIndex);
    m.film_thickness_nm = table.number("film_thickness_nm", limits::kMicrofacetFilmThickness);
    m.base_ior = table.number("base_ior", limits::kMicrofacetIndex);
    m.base_extinction = table.number_or("base_extinction", 0, limits::kMicrofacetExtinction);
    if (const auto facets =
            table.table_if_present("facets", {"count", "cone_deg", "thickness_spread_nm"})) {
        m.facets = layers::MicrofacetFacets{
            facets->number("count", limits::kFacetCount),
            facets->number("cone_deg", limits::kConeHalfAngle),
            facets->number_or("thickness_spread_nm", 0, limits::kFilmSpread)};
    }
    return m;
}

/// 0, a smooth interface, or a roughness that is solved as one.
double read_roughness(const TableReader& coat) {
    const double roughness = coat.number_or("roughness", 0, {});
    if (roughness != 0 && !limits::kRoughInterface.contains(roughness)) {
        coat.fail("roughness", "must be 0, a smooth interface, or a number in " +
                                   limits::kRoughInterface.text());
    }
    return roughness;
}

layers::Recipe read_recipe_table(const TableReader& table) {
    layers::Recipe recipe;
    recipe.name = table.text_or("name", "", limits::kNameLength);
    recipe.binder = read_binder(table);
    if (const auto coat = table.table_if_present(
            "clearcoat", {"thickness_um", "absorption_per_mm", "roughness"})) {
        recipe.clearcoat = layers::Clearcoat{
            coat->number("thickness_um", limits::kClearcoatThickness),
            read_spectrum_or(*coat, "absorption_per_mm", 0.0, limits::kPerMillimetre),
            read_roughness(*coat)};
    }
    for (const TableReader& layer :
         table.tables("layer", limits::kLayers, {"thickness_um", "flakes", "pigment"})) {
        recipe.layers.push_back(read_layer(layer));
    }
    if (const auto substrate = table.table_if_present("substrate", {"reflectance"})) {
        recipe.substrate_reflectance = read_reflectance(*substrate, "reflectance");
    }
    if (const auto microfacet = table.table_if_present(
            "microfacet", {"alpha", "distribution", "film_ior", "film_thickness_nm", "base_ior",
                           "base_extinction", "facets"})) {
        recipe.microfacet = read_microfacet(*microfacet);
    }
    if (recipe.layers.empty() && !recipe.microfacet) {
        table.fail("layer", "is missing; a paint needs 1 to 64 tables [[layer]], or [microfacet]");
    }
    return recipe;
}

/// Whether a key of [fit] can stand in a message as it is.
bool is_plain(const std::string& key) {
    return !key.empty() && key.size() <= limits::kNameLength &&
           std::all_of(key.begin(), key.end(), [](char c) { return c >= 0x20 && c < 0x7f; });
}

/// [fit]: keys of the recipe's numbers, each with a list of two ends.
std::vector<layers::ParameterBounds> read_bounds(const TableReader& table,
                                                 const layers::Recipe& recipe) {
    std::vector<layers::ParameterBounds> bounds;
    const auto fit = table.table_if_present("fit", {});
    if (!fit) return bounds;
    std::map<std::string, layers::ParameterBounds> by_key;
    for (const std::string& key : fit->keys()) {
        if (!is_plain(key)) fit->fail("has a key that is not the name of a number of this recipe");
        const std::string place = table.document().location(fit->path_of(key));
        try {
            layers::find_parameter(recipe, key);
            const std::vector<double> ends = fit->numbers(key, {}, 2, 2);
            layers::check_bounds(recipe, {key, ends[0], ends[1]});
            by_key[key] = {key, ends[0], ends[1]};
        } catch (const DomainError& error) {
            throw InputError(place + "fit." + error.what());
        }
    }
    for (const layers::RecipeParameter& parameter : layers::recipe_parameters(recipe)) {
        const auto found = by_key.find(parameter.key);
        if (found != by_key.end()) bounds.push_back(found->second);
    }
    return bounds;
}

}  // namespace

RecipeFile parse_recipe_file(std::string_view text, const std::string& filename,
                             const std::filesystem::path& base_directory) {
    TomlDocument document(text, filename, base_directory);
    const TableReader table(
        document, {"name", "ior", "clearcoat", "layer", "substrate", "microfacet", "fit"});
    const layers::Recipe recipe = read_recipe_table(table);
    try {
        validate(recipe, {});  // what concerns several keys at once, as R + T <= 1
    } catch (const DomainError& error) {
        rethrow_with_location(document, error.what());
    }
    return {recipe, read_bounds(table, recipe)};
}

RecipeFile read_recipe_file(const std::filesystem::path& path) {
    return parse_recipe_file(read_file(path, kMostTextBytes), path.string(), path.parent_path());
}

layers::Recipe parse_recipe(std::string_view text, const std::string& filename,
                            const std::filesystem::path& base_directory) {
    return parse_recipe_file(text, filename, base_directory).recipe;
}

layers::Recipe read_recipe(const std::filesystem::path& path) {
    return read_recipe_file(path).recipe;
}

}  // namespace nacre::io
