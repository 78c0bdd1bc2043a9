#include <fmt/format.h>

#include <iterator>
#include <string>

#include "nacre/core/error.h"
#include "nacre/core/sha256.h"
#include "nacre/io/recipe_file.h"

namespace nacre::io {

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

std::string body_text(const layers::PrescribedFlake& flake) {
    return fmt::format("reflectance = {}\ntransmittance = {}\nthickness_um = {}\n",
                       spectrum(flake.reflectance), spectrum(flake.transmittance),
                       number(flake.thickness_um));
}

std::string flakes_text(const layers::FlakeSpecies& species) {
    std::string out = fmt::format("\n[[layer.flakes]]\nname = {}\n", quoted(species.name));
    if (const auto* fraction = std::get_if<layers::VolumeFraction>(&species.amount)) {
        out += fmt::format("volume_fraction = {}\n", number(fraction->value));
    } else {
        out += fmt::format("area_density_per_um = {}\n",
                           number(std::get<layers::AreaDensity>(species.amount).per_um));
    }
    out += fmt::format(
        "diameter_um = {}\ndiameter_spread_um = {}\n"
        "orientation = {{ distribution = \"beckmann\", alpha = {} }}\n",
        number(species.diameter_um), number(species.diameter_spread_um),
        number(species.orientation.beckmann_alpha));
    return out + std::visit([](const auto& body) { return body_text(body); }, species.body);
}

std::string layer_text(const layers::Layer& layer) {
    std::string out = fmt::format("\n[[layer]]\nthickness_um = {}\n", number(layer.thickness_um));
    for (const layers::FlakeSpecies& species : layer.flakes) out += flakes_text(species);
    for (const layers::Pigment& pigment : layer.pigments) {
        out += fmt::format(
            "\n[[layer.pigment]]\nscattering_per_mm = {}\nabsorption_per_mm = {}\n"
            "anisotropy = {}\n",
            spectrum(pigment.scattering_per_mm), spectrum(pigment.absorption_per_mm),
            number(pigment.anisotropy));
    }
    return out;
}

std::string microfacet_text(const layers::Microfacet& m) {
    std::string out = fmt::format(
        "\n[microfacet]\nalpha = {}\ndistribution = {}\nfilm_ior = {}\nfilm_thickness_nm = {}\n"
        "base_ior = {}\nbase_extinction = {}\n",
        number(m.alpha),
        quoted(m.distribution == layers::FacetDistribution::ggx ? "ggx" : "beckmann"),
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

std::string write_recipe(const layers::Recipe& recipe,
                         const std::vector<layers::ParameterBounds>& bounds) {
    std::string out =
        fmt::format("name = {}\nior = {}\n", quoted(recipe.name), material_text(recipe.binder));
    if (recipe.clearcoat) {
        out += fmt::format(
            "\n[clearcoat]\nthickness_um = {}\nabsorption_per_mm = {}\n"
            "roughness = {}\n",
            number(recipe.clearcoat->thickness_um), spectrum(recipe.clearcoat->absorption_per_mm),
            number(recipe.clearcoat->roughness));
    }
    for (const layers::Layer& layer : recipe.layers) out += layer_text(layer);
    out += fmt::format("\n[substrate]\nreflectance = {}\n", spectrum(recipe.substrate_reflectance));
    if (recipe.microfacet) out += microfacet_text(*recipe.microfacet);
    if (!bounds.empty()) out += "\n[fit]\n";
    for (const layers::ParameterBounds& b : bounds) {
        out += fmt::format("{} = {}\n", quoted(b.key), list({b.lo, b.hi}));
    }
    return out;
}

std::string recipe_hash(const layers::Recipe& recipe) { return sha256_hex(write_recipe(recipe)); }

}  // namespace nacre::io
