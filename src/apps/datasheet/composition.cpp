#include "apps/datasheet/composition.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <utility>

#include "apps/report/plot_frame.h"
#include "nacre/core/text.h"

namespace nacre::datasheet {

namespace {

std::string plus_minus(double value, double spread, const char* unit) {
    return spread > 0 ? fmt::format("{:.4g} ± {:.3g} {}", value, spread, unit)
                      : fmt::format("{:.4g} {}", value, unit);
}

std::string film_text(const optics::FilmPopulation& film) {
    return material_text(film.material) + ", " +
           plus_minus(film.thickness_nm, film.spread.standard_deviation_nm, "nm");
}

/// "0.05", "0.02 to 0.6" over the wavelengths.
std::string range_text(const spectra::Spectrum& spectrum, double scale = 1) {
    const double lo = scale * spectrum.min(), hi = scale * spectrum.max();
    return lo == hi ? fmt::format("{:.4g}", lo) : fmt::format("{:.3g} to {:.3g}", lo, hi);
}

std::string percent_text(const spectra::Spectrum& fraction) {
    return range_text(fraction, 100) + " %";
}

std::string amount_text(const paint::FlakeSpecies& flakes, const paint::Layer& layer) {
    const double cover = flakes.area_density_per_um() * layer.thickness_um;
    const auto* volume = std::get_if<paint::VolumeFraction>(&flakes.amount);
    const std::string area = fmt::format("flakes of {:.3g} times the area painted", cover);
    return volume ? fmt::format("{:.3g} % by volume, {}", 100 * volume->value, area) : area;
}

/// "mica, 500 nm; on both sides TiO₂ (anatase), 80 nm".
std::string build_text(const paint::FlakeSpecies& flakes) {
    if (const auto* given = std::get_if<paint::PrescribedFlake>(&flakes.body)) {
        return fmt::format("reflects {}, transmits {}", percent_text(given->reflectance),
                           percent_text(given->transmittance));
    }
    const auto& platelet = std::get<optics::Platelet>(flakes.body);
    std::string text = film_text(platelet.core);
    for (std::size_t i = 0; i < platelet.coats.size(); ++i) {
        text += (i == 0 ? "; on both sides " : "; then ") + film_text(platelet.coats[i]);
    }
    return text;
}

std::string size_text(const paint::FlakeSpecies& flakes) {
    return plus_minus(flakes.diameter_um, flakes.diameter_spread_um, "µm") +
           fmt::format(" across, {:.3g} µm thick", flakes.thickness_um());
}

std::string tilt_text(const paint::FlakeSpecies& flakes) {
    return fmt::format("half of them within {:.2g}° of flat", median_tilt_deg(flakes.orientation));
}

std::string name_or(const std::string& name, const char* otherwise) {
    return name.empty() ? otherwise : name;
}

std::string pigment_text(const paint::Pigment& pigment) {
    return fmt::format("scatters {} /mm, absorbs {} /mm, g = {:.3g}",
                       range_text(pigment.scattering_per_mm), range_text(pigment.absorption_per_mm),
                       pigment.anisotropy);
}

std::string tint_text(const paint::Clearcoat& coat) {
    return coat.absorption_per_mm.max() > 0
               ? "absorbs " + range_text(coat.absorption_per_mm) + " /mm"
               : "clear";
}

std::string surface_text(double roughness) {
    return roughness > 0 ? fmt::format("matte surface (roughness {:.3g})", roughness)
                         : "smooth surface";
}

report::Cell cell(std::string text) { return {.text = std::move(text)}; }

}  // namespace

std::string material_text(const optics::Material& material) {
    const std::string& name = material.name();
    std::string_view rest = name;
    if (take_number(rest)) return "n = " + name;
    const auto shipped = optics::material_names();
    if (!std::binary_search(shipped.begin(), shipped.end(), name)) return name;
    static constexpr const char* kSubscripts[] = {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
    std::string words = name;
    std::replace(words.begin(), words.end(), '_', ' ');
    if (!std::isupper(static_cast<unsigned char>(name[0]))) return words;  // "synthetic mica"
    const std::size_t form = std::min(words.find(' '), words.size());
    std::string text;
    for (const char c : words.substr(0, form)) {
        const bool digit = std::isdigit(static_cast<unsigned char>(c)) != 0;
        text += digit ? std::string(kSubscripts[c - '0']) : std::string(1, c);
    }
    if (form < words.size()) text += " (" + words.substr(form + 1) + ")";
    return text;
}

double median_tilt_deg(const paint::Orientation& orientation) {
    return std::atan(orientation.beckmann_alpha * std::sqrt(std::numbers::ln2)) * 180 /
           std::numbers::pi;
}

std::vector<std::string> layers_in_words(const paint::Recipe& recipe) {
    std::vector<std::string> sentences;
    const double roughness = recipe.clearcoat ? recipe.clearcoat->roughness : 0;
    if (recipe.clearcoat) {
        sentences.push_back(fmt::format("On top a clear coat of {:.4g} µm with a {}; it {}.",
                                        recipe.clearcoat->thickness_um, surface_text(roughness),
                                        recipe.clearcoat->absorption_per_mm.max() > 0
                                            ? tint_text(*recipe.clearcoat)
                                            : "is clear"));
    }
    for (const paint::Layer& layer : recipe.layers) {
        std::string text =
            fmt::format("{} a layer of {:.4g} µm", sentences.empty() ? "On top" : "Below it",
                        layer.thickness_um);
        if (layer.flakes.empty() && layer.pigments.empty()) text += " of binder alone";
        const char* joint = " with ";
        for (const paint::FlakeSpecies& flakes : layer.flakes) {
            text += joint + name_or(flakes.name, "flakes") + " (" + build_text(flakes) + "), " +
                    size_text(flakes) + ", " + amount_text(flakes, layer) + ", " +
                    tilt_text(flakes);
            joint = "; with ";
        }
        for (const paint::Pigment& pigment : layer.pigments) {
            text += joint + ("a pigment that " + pigment_text(pigment));
            joint = "; with ";
        }
        sentences.push_back(text + ".");
    }
    sentences.push_back(fmt::format("The ground reflects {}. The binder has {}.",
                                    percent_text(recipe.substrate_reflectance),
                                    material_text(recipe.binder)));
    return sentences;
}

report::Table layers_table(const paint::Recipe& recipe) {
    report::Table table{.columns = {"Layer", "Holds", "Amount", "Size and lie", "Built of"}};
    const auto add = [&](const std::string& layer, const std::string& holds,
                         const std::string& amount, const std::string& size,
                         const std::string& built) {
        table.rows.push_back({cell(layer), cell(holds), cell(amount), cell(size), cell(built)});
    };
    if (recipe.clearcoat) {
        add(fmt::format("Clear coat, {:.4g} µm", recipe.clearcoat->thickness_um),
            tint_text(*recipe.clearcoat), "", surface_text(recipe.clearcoat->roughness),
            "binder, " + material_text(recipe.binder));
    }
    for (std::size_t i = 0; i < recipe.layers.size(); ++i) {
        const paint::Layer& layer = recipe.layers[i];
        std::string name = fmt::format("Layer {}, {:.4g} µm", i + 1, layer.thickness_um);
        const auto named = [&] { return std::exchange(name, std::string()); };
        for (const paint::FlakeSpecies& flakes : layer.flakes) {
            add(named(), name_or(flakes.name, "flakes"), amount_text(flakes, layer),
                size_text(flakes) + "; " + tilt_text(flakes), build_text(flakes));
        }
        for (const paint::Pigment& pigment : layer.pigments) {
            add(named(), "pigment", "", "", pigment_text(pigment));
        }
        if (!name.empty()) add(named(), "binder alone", "", "", material_text(recipe.binder));
    }
    add("Ground", "reflects " + percent_text(recipe.substrate_reflectance), "", "", "");
    return table;
}

std::vector<std::string> facets_in_words(const paint::Microfacet& facets) {
    std::vector<std::string> sentences = {fmt::format(
        "A rough surface of mirror facets ({}, roughness {:.3g}) under a film of {:.4g} nm with n "
        "= "
        "{:.4g}, on a base with n = {:.4g}{}.",
        facets.distribution == paint::FacetDistribution::beckmann ? "Beckmann" : "GGX",
        facets.alpha, facets.film_thickness_nm, facets.film_ior, facets.base_ior,
        facets.base_extinction > 0 ? fmt::format(" and k = {:.4g}", facets.base_extinction) : "")};
    if (facets.facets) {
        sentences.push_back(fmt::format(
            "{} facets over the whole object, their films varying by {:.3g} nm, each seen "
            "within {:.3g}° of its mirror direction.",
            report::tick_text(facets.facets->count, facets.facets->count / 100),
            facets.facets->thickness_spread_nm, facets.facets->cone_deg));
    }
    return sentences;
}

}  // namespace nacre::datasheet
