#include "nacre/paint/recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "nacre/core/error.h"

namespace nacre::paint {

namespace {

using spectra::Spectrum;

constexpr double kNmPerUm = 1000;

[[noreturn]] void refuse(const std::string& key, double value, const std::string& allowed) {
    throw DomainError(fmt::format("{} = {}: must be {}", key, value, allowed));
}

void check(const std::string& key, double value, const Range& range) {
    if (!range.contains(value)) refuse(key, value, "in " + range.text());
}

void check(const std::string& key, const Spectrum& spectrum, const Range& range) {
    check(key, spectrum.min(), range);
    check(key, spectrum.max(), range);
    if (spectrum.values().size() > limits::kSpectrumSamples) {
        throw DomainError(fmt::format("{}: has {} samples; at most {} are allowed", key,
                                      spectrum.values().size(), limits::kSpectrumSamples));
    }
}

void check_count(const std::string& key, std::size_t count, std::size_t most) {
    if (count > most) {
        throw DomainError(
            fmt::format("{}: has {} entries; at most {} are allowed", key, count, most));
    }
}

void check_coverage(const std::string& key, const optics::Material& material,
                    const std::vector<double>& wavelengths_nm) {
    for (double wavelength : wavelengths_nm) {
        if (wavelength < material.first_wavelength_nm() ||
            wavelength > material.last_wavelength_nm()) {
            throw DomainError(
                fmt::format("{} = {}: its refractive index is known in [{}, {}] nm, not at {} nm",
                            key, material.name(), material.first_wavelength_nm(),
                            material.last_wavelength_nm(), wavelength));
        }
    }
}

void check_binder(const optics::Material& binder, const std::vector<double>& wavelengths_nm) {
    for (const optics::ComplexIndex& index : binder.samples()) {
        check("ior", index.real(), limits::kBinderIndex);
        if (index.imag() != 0) {
            throw DomainError(fmt::format(
                "ior = {}: must be real, but has k = {}; what the binder absorbs is written as "
                "absorption_per_mm of the clearcoat or of a pigment",
                binder.name(), index.imag()));
        }
    }
    check_coverage("ior", binder, wavelengths_nm);
}

void check_film(const std::string& key, const optics::FilmPopulation& film,
                const std::vector<double>& wavelengths_nm) {
    check(key + ".thickness_nm", film.thickness_nm, limits::kFilmThickness);
    check(key + ".spread_nm", film.spread.standard_deviation_nm, limits::kFilmSpread);
    check_coverage(key + ".material", film.material, wavelengths_nm);
}

void check_body(const std::string& key, const optics::Platelet& platelet,
                const std::vector<double>& wavelengths_nm) {
    check_count(key + ".coats", platelet.coats.size(), limits::kCoats);
    check_film(key + ".core", platelet.core, wavelengths_nm);
    for (std::size_t i = 0; i < platelet.coats.size(); ++i) {
        check_film(fmt::format("{}.coats[{}]", key, i), platelet.coats[i], wavelengths_nm);
    }
}

void check_body(const std::string& key, const PrescribedFlake& flake, const std::vector<double>&) {
    check(key + ".reflectance", flake.reflectance, limits::kFraction);
    check(key + ".transmittance", flake.transmittance, limits::kFraction);
    check(key + ".thickness_um", flake.thickness_um, limits::kPlateletThickness);
    if (const auto wavelength = limits::wavelength_of_excess(flake)) {
        throw DomainError(fmt::format(
            "{}.transmittance = {}: reflectance + transmittance = {} at {} nm; must be at most 1",
            key, flake.transmittance(*wavelength),
            flake.reflectance(*wavelength) + flake.transmittance(*wavelength), *wavelength));
    }
}

void check_flakes(const std::string& key, const FlakeSpecies& species,
                  const std::vector<double>& wavelengths_nm) {
    if (const auto* fraction = std::get_if<VolumeFraction>(&species.amount)) {
        check(key + ".volume_fraction", fraction->value, limits::kVolumeFraction);
    } else {
        check(key + ".area_density_per_um", std::get<AreaDensity>(species.amount).per_um,
              limits::kAreaDensity);
    }
    check(key + ".diameter_um", species.diameter_um, limits::kDiameter);
    check(key + ".diameter_spread_um", species.diameter_spread_um, limits::kDiameterSpread);
    check(key + ".orientation.alpha", species.orientation.beckmann_alpha, limits::kBeckmannAlpha);
    std::visit([&](const auto& body) { check_body(key, body, wavelengths_nm); }, species.body);
}

void check_layer(const std::string& key, const Layer& layer,
                 const std::vector<double>& wavelengths_nm) {
    check(key + ".thickness_um", layer.thickness_um, limits::kLayerThickness);
    check_count(key + ".flakes", layer.flakes.size(), limits::kSpeciesPerLayer);
    check_count(key + ".pigment", layer.pigments.size(), limits::kSpeciesPerLayer);
    double filled = 0;
    for (std::size_t i = 0; i < layer.flakes.size(); ++i) {
        const std::string flakes_key = fmt::format("{}.flakes[{}]", key, i);
        check_flakes(flakes_key, layer.flakes[i], wavelengths_nm);
        if (const auto* fraction = std::get_if<VolumeFraction>(&layer.flakes[i].amount)) {
            filled += fraction->value;
            if (filled > 1) {
                throw DomainError(fmt::format(
                    "{}.volume_fraction = {}: with the species before it the flakes fill {} of the "
                    "layer; must be at most 1",
                    flakes_key, fraction->value, filled));
            }
        }
    }
    for (std::size_t i = 0; i < layer.pigments.size(); ++i) {
        const std::string pigment_key = fmt::format("{}.pigment[{}]", key, i);
        const Pigment& pigment = layer.pigments[i];
        check(pigment_key + ".scattering_per_mm", pigment.scattering_per_mm,
              limits::kPerMillimetre);
        check(pigment_key + ".absorption_per_mm", pigment.absorption_per_mm,
              limits::kPerMillimetre);
        check(pigment_key + ".anisotropy", pigment.anisotropy, limits::kAnisotropy);
    }
}

void check_microfacet(const Microfacet& m) {
    check("microfacet.alpha", m.alpha, limits::kMicrofacetAlpha);
    check("microfacet.film_ior", m.film_ior, limits::kMicrofacetIndex);
    check("microfacet.film_thickness_nm", m.film_thickness_nm, limits::kMicrofacetFilmThickness);
    check("microfacet.base_ior", m.base_ior, limits::kMicrofacetIndex);
    check("microfacet.base_extinction", m.base_extinction, limits::kMicrofacetExtinction);
    if (!m.facets) return;
    check("microfacet.facets.count", m.facets->count, limits::kFacetCount);
    check("microfacet.facets.cone_deg", m.facets->cone_deg, limits::kConeHalfAngle);
    check("microfacet.facets.thickness_spread_nm", m.facets->thickness_spread_nm,
          limits::kFilmSpread);
}

}  // namespace

std::optional<double> limits::wavelength_of_excess(const PrescribedFlake& flake) {
    std::vector<double> samples;
    for (const Spectrum* spectrum : {&flake.reflectance, &flake.transmittance}) {
        if (spectrum->is_constant()) continue;
        samples.insert(samples.end(), spectrum->wavelengths_nm().begin(),
                       spectrum->wavelengths_nm().end());
    }
    if (samples.empty()) samples.push_back(550);  // both constant: any wavelength will do
    std::sort(samples.begin(), samples.end());
    const auto excess = std::find_if(samples.begin(), samples.end(), [&](double wavelength) {
        return flake.reflectance(wavelength) + flake.transmittance(wavelength) > 1 + kEnergySlack;
    });
    if (excess == samples.end()) return std::nullopt;
    return *excess;
}

double FlakeSpecies::thickness_um() const {
    if (const auto* prescribed = std::get_if<PrescribedFlake>(&body)) {
        return prescribed->thickness_um;
    }
    const auto& platelet = std::get<optics::Platelet>(body);
    double thickness_nm = platelet.core.thickness_nm;
    for (const optics::FilmPopulation& coat : platelet.coats) thickness_nm += 2 * coat.thickness_nm;
    return thickness_nm / kNmPerUm;
}

double FlakeSpecies::area_density_per_um() const {
    if (const auto* density = std::get_if<AreaDensity>(&amount)) return density->per_um;
    return std::get<VolumeFraction>(amount).value / thickness_um();
}

void validate(const Recipe& recipe, const std::vector<double>& wavelengths_nm) {
    for (double wavelength : wavelengths_nm) check("wavelength", wavelength, limits::kWavelength);
    check_binder(recipe.binder, wavelengths_nm);
    if (recipe.clearcoat) {
        check("clearcoat.thickness_um", recipe.clearcoat->thickness_um,
              limits::kClearcoatThickness);
        check("clearcoat.absorption_per_mm", recipe.clearcoat->absorption_per_mm,
              limits::kPerMillimetre);
        check("clearcoat.roughness", recipe.clearcoat->roughness, limits::kRoughness);
        if (recipe.clearcoat->roughness > 0) {
            check("clearcoat.roughness (if not 0, a smooth interface)", recipe.clearcoat->roughness,
                  limits::kRoughInterface);
        }
    }
    if (recipe.layers.empty() && !recipe.microfacet) {
        throw DomainError("layer: a paint needs at least one layer (or a microfacet table)");
    }
    check_count("layer", recipe.layers.size(), limits::kLayers);
    for (std::size_t i = 0; i < recipe.layers.size(); ++i) {
        check_layer(fmt::format("layer[{}]", i), recipe.layers[i], wavelengths_nm);
    }
    check("substrate.reflectance", recipe.substrate_reflectance, limits::kFraction);
    if (recipe.microfacet) check_microfacet(*recipe.microfacet);
}

}  // namespace nacre::paint
