#include "nacre/io/recipe_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <string>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/sha256.h"
#include "nacre/io/table_reader.h"
#include "nacre/paint/recipe.h"

namespace nacre::io {

namespace {

namespace limits = paint::limits;
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

paint::PrescribedFlake read_prescribed(const TableReader& flakes) {
    if (flakes.has("coats")) flakes.fail("coats", "go with a core; this flake has a reflectance");
    paint::PrescribedFlake flake;
    flake.reflectance = read_reflectance(flakes, "reflectance");
    flake.transmittance = flakes.has("transmittance") ? read_reflectance(flakes, "transmittance")
                                                      : spectra::Spectrum(0.0);
    if (flakes.has("volume_fraction") || flakes.has("thickness_um")) {
        flake.thickness_um = flakes.number("thickness_um", limits::kPlateletThickness);
    }
    return flake;
}

paint::FlakeSpecies read_flakes(const TableReader& flakes) {
    paint::FlakeSpecies species;
    species.name = flakes.text_or("name", "", limits::kNameLength);
    const bool by_area = flakes.has("area_density_per_um");
    if (by_area && flakes.has("volume_fraction")) {
        flakes.fail("area_density_per_um",
                    "how many flakes there are is said twice; give volume_fraction or "
                    "area_density_per_um, not both");
    }
    if (by_area) {
        species.amount =
            paint::AreaDensity{flakes.number("area_density_per_um", limits::kAreaDensity)};
    } else {
        if (!flakes.has("volume_fraction")) {
            flakes.fail("volume_fraction",
                        "is missing; it must be a number in " + limits::kVolumeFraction.text() +
                            ", or area_density_per_um in " + limits::kAreaDensity.text());
        }
        species.amount =
            paint::VolumeFraction{flakes.number("volume_fraction", limits::kVolumeFraction)};
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

paint::Layer read_layer(const TableReader& table) {
    paint::Layer layer;
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

paint::Microfacet read_microfacet(const TableReader& table) {
    paint::Microfacet m;
    m.alpha = table.number("alpha", limits::kMicrofacetAlpha);
    if (table.has("distribution")) {
        m.distribution = table.choice("distribution", {"beckmann", "ggx"}) == 0
                             ? paint::FacetDistribution::beckmann
                             : paint::FacetDistribution::ggx;
    }
    m.film_ior = table.number("film_ior", limits::kMicrofacetIndex);
    m.film_thickness_nm = table.number("film_thickness_nm", limits::kMicrofacetFilmThickness);
    m.base_ior = table.number("base_ior", limits::kMicrofacetIndex);
    m.base_extinction = table.number_or("base_extinction", 0, limits::kMicrofacetExtinction);
    if (const auto facets =
            table.table_if_present("facets", {"count", "cone_deg", "thickness_spread_nm"})) {
        m.facets = paint::MicrofacetFacets{
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

paint::Recipe read_recipe_table(const TableReader& table) {
    paint::Recipe recipe;
    recipe.name = table.text_or("name", "", limits::kNameLength);
    recipe.binder = read_binder(table);
    if (const auto coat = table.table_if_present(
            "clearcoat", {"thickness_um", "absorption_per_mm", "roughness"})) {
        recipe.clearcoat = paint::Clearcoat{
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
std::vector<paint::ParameterBounds> read_bounds(const TableReader& table,
                                                const paint::Recipe& recipe) {
    std::vector<paint::ParameterBounds> bounds;
    const auto fit = table.table_if_present("fit", {});
    if (!fit) return bounds;
    std::map<std::string, paint::ParameterBounds> by_key;
    for (const std::string& key : fit->keys()) {
        if (!is_plain(key)) fit->fail("has a key that is not the name of a number of this recipe");
        const std::string place = table.document().location(fit->path_of(key));
        try {
            paint::find_parameter(recipe, key);
            const std::vector<double> ends = fit->numbers(key, {}, 2, 2);
            paint::check_bounds(recipe, {key, ends[0], ends[1]});
            by_key[key] = {key, ends[0], ends[1]};
        } catch (const DomainError& error) {
            throw InputError(place + "fit." + error.what());
        }
    }
    for (const paint::RecipeParameter& parameter : paint::recipe_parameters(recipe)) {
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
    const paint::Recipe recipe = read_recipe_table(table);
    try {
        validate(recipe, {});  // what concerns several keys at once, as R + T <= 1
    } catch (const DomainError& error) {
        rethrow_with_location(document, error.what());
    }
    return {recipe, read_bounds(table, recipe)};
}

RecipeFile read_recipe_file(const std::filesystem::path& path) {
    return parse_recipe_file(read_file(path, kMaxTextBytes), path.string(), path.parent_path());
}

paint::Recipe parse_recipe(std::string_view text, const std::string& filename,
                           const std::filesystem::path& base_directory) {
    return parse_recipe_file(text, filename, base_directory).recipe;
}

paint::Recipe read_recipe(const std::filesystem::path& path) {
    return read_recipe_file(path).recipe;
}

namespace {

using optics::Material;
using spectra::Spectrum;

/// Shortest text that reads back to the same double; TOML spells it so too.
std::string number(double x) { return fmt::format("{}", x); }

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            out += fmt::format("\\u{:04x}", static_cast<unsigned char>(c));
        } else {
            out += c;
        }
    }
    return out + "\"";
}

std::string list(const std::vector<double>& values) {
    std::string out = "[";
    for (double value : values) out += (out.size() > 1 ? ", " : "") + number(value);
    return out + "]";
}

std::string spectrum(const Spectrum& s) {
    // A single sample at a wavelength is constant too, but another value: it is written in full.
    if (s == Spectrum(s.values()[0])) return number(s.values()[0]);
    return fmt::format("{{ wavelengths_nm = {}, values = {} }}", list(s.wavelengths_nm()),
                       list(s.values()));
}

/// Whether a recipe that only names the material, in any folder, gets this one.
bool is_shipped(const Material& material) {
    if (material.name().empty()) return false;
    try {
        for (const std::string& name : optics::material_names()) {
            if (name == material.name()) return optics::find_material(name) == material;
        }
    } catch (const Error&) {  // the shipped data cannot be found: write the samples out
    }
    return false;
}

std::string material_text(const Material& material) {
    if (!material.is_dispersive() && material == Material(material.samples()[0].real())) {
        return number(material.samples()[0].real());
    }
    if (is_shipped(material)) return quoted(material.name());
    std::vector<double> n, k;
    for (const optics::ComplexIndex& index : material.samples()) {
        n.push_back(index.real());
        k.push_back(index.imag());
    }
    std::string out = fmt::format("{{ name = {}, source = {}, ", quoted(material.name()),
                                  quoted(material.source()));
    if (!material.wavelengths_nm().empty()) {
        out += fmt::format("wavelengths_nm = {}, ", list(material.wavelengths_nm()));
    }
    return out + fmt::format("n = {}, k = {} }}", list(n), list(k));
}

std::string film_text(const optics::FilmPopulation& film) {
    const bool uniform = film.spread.law == optics::ThicknessSpread::Law::uniform;
    return fmt::format(
        "{{ material = {}, thickness_nm = {}, spread_nm = {}, distribution = \"{}\" }}",
        material_text(film.material), number(film.thickness_nm),
        number(film.spread.standard_deviation_nm), uniform ? "uniform" : "normal");
}

std::string body_text(const optics::Platelet& platelet) {
    std::string out = fmt::format("core = {}\n", film_text(platelet.core));
    if (platelet.coats.empty()) return out;
    out += "coats = [\n";
    for (const optics::FilmPopulation& coat : platelet.coats) {
        out += fmt::format("    {},\n", film_text(coat));
    }
    return out + "]\n";
}

std::string body_text(const paint::PrescribedFlake& flake) {
    return fmt::format("reflectance = {}\ntransmittance = {}\nthickness_um = {}\n",
                       spectrum(flake.reflectance), spectrum(flake.transmittance),
                       number(flake.thickness_um));
}

std::string flakes_text(const paint::FlakeSpecies& species) {
    std::string out = fmt::format("\n[[layer.flakes]]\nname = {}\n", quoted(species.name));
    if (const auto* fraction = std::get_if<paint::VolumeFraction>(&species.amount)) {
        out += fmt::format("volume_fraction = {}\n", number(fraction->value));
    } else {
        out += fmt::format("area_density_per_um = {}\n",
                           number(std::get<paint::AreaDensity>(species.amount).per_um));
    }
    out += fmt::format(
        "diameter_um = {}\ndiameter_spread_um = {}\n"
        "orientation = {{ distribution = \"beckmann\", alpha = {} }}\n",
        number(species.diameter_um), number(species.diameter_spread_um),
        number(species.orientation.beckmann_alpha));
    return out + std::visit([](const auto& body) { return body_text(body); }, species.body);
}

std::string layer_text(const paint::Layer& layer) {
    std::string out = fmt::format("\n[[layer]]\nthickness_um = {}\n", number(layer.thickness_um));
    for (const paint::FlakeSpecies& species : layer.flakes) out += flakes_text(species);
    for (const paint::Pigment& pigment : layer.pigments) {
        out += fmt::format(
            "\n[[layer.pigment]]\nscattering_per_mm = {}\nabsorption_per_mm = {}\n"
            "anisotropy = {}\n",
            spectrum(pigment.scattering_per_mm), spectrum(pigment.absorption_per_mm),
            number(pigment.anisotropy));
    }
    return out;
}

std::string microfacet_text(const paint::Microfacet& m) {
    std::string out = fmt::format(
        "\n[microfacet]\nalpha = {}\ndistribution = {}\nfilm_ior = {}\nfilm_thickness_nm = {}\n"
        "base_ior = {}\nbase_extinction = {}\n",
        number(m.alpha),
        quoted(m.distribution == paint::FacetDistribution::ggx ? "ggx" : "beckmann"),
        number(m.film_ior), number(m.film_thickness_nm), number(m.base_ior),
        number(m.base_extinction));
    if (m.facets) {
        out += fmt::format(
            "\n[microfacet.facets]\ncount = {}\ncone_deg = {}\nthickness_spread_nm = {}\n",
            number(m.facets->count), number(m.facets->cone_deg),
            number(m.facets->thickness_spread_nm));
    }
    return out;
}

}  // namespace

std::string write_recipe(const paint::Recipe& recipe,
                         const std::vector<paint::ParameterBounds>& bounds) {
    std::string out =
        fmt::format("name = {}\nior = {}\n", quoted(recipe.name), material_text(recipe.binder));
    if (recipe.clearcoat) {
        out += fmt::format(
            "\n[clearcoat]\nthickness_um = {}\nabsorption_per_mm = {}\n"
            "roughness = {}\n",
            number(recipe.clearcoat->thickness_um), spectrum(recipe.clearcoat->absorption_per_mm),
            number(recipe.clearcoat->roughness));
    }
    for (const paint::Layer& layer : recipe.layers) out += layer_text(layer);
    out += fmt::format("\n[substrate]\nreflectance = {}\n", spectrum(recipe.substrate_reflectance));
    if (recipe.microfacet) out += microfacet_text(*recipe.microfacet);
    if (!bounds.empty()) out += "\n[fit]\n";
    for (const paint::ParameterBounds& b : bounds) {
        out += fmt::format("{} = {}\n", quoted(b.key), list({b.lo, b.hi}));
    }
    return out;
}

std::string recipe_hash(const paint::Recipe& recipe) { return sha256_hex(write_recipe(recipe)); }

}  // namespace nacre::io
