#include "nacre/paint/recipe_parameter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <variant>

#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/paint/recipe.h"

namespace nacre::paint {

namespace {

using optics::Material;
using spectra::Spectrum;

/// Keys that a message lists at most.
constexpr std::size_t kMaxListed = 12;

/// Where a number of a recipe is kept.
struct Slot {
    std::string key;
    Range range;
    std::variant<double*, Spectrum*, Material*> place;

    double get() const {
        if (const auto* number = std::get_if<double*>(&place)) return **number;
        if (const auto* spectrum = std::get_if<Spectrum*>(&place)) return (*spectrum)->max();
        return std::get<Material*>(place)->samples()[0].real();
    }

    void set(double value) const {
        if (const auto* number = std::get_if<double*>(&place)) {
            **number = value;
        } else if (const auto* material = std::get_if<Material*>(&place)) {
            **material = Material(value);
        } else {
            Spectrum& spectrum = *std::get<Spectrum*>(place);
            if (spectrum == Spectrum(spectrum.values()[0])) {
                spectrum = Spectrum(value);
                return;
            }
            const double largest = spectrum.max();
            std::vector<double> values = spectrum.values();
            // The largest sample itself gets the value, to the last bit.
            for (double& x : values) x = x == largest ? value : value * (x / largest);
            spectrum = Spectrum(spectrum.wavelengths_nm(), std::move(values));
        }
    }
};

/// Walks through a recipe in the order of a recipe file.
class SlotList {
 public:
    explicit SlotList(Recipe& recipe) {
        if (is_number(recipe.binder))
            slots_.push_back({"ior", limits::kBinderIndex, &recipe.binder});
        if (recipe.clearcoat) add(*recipe.clearcoat);
        for (std::size_t i = 0; i < recipe.layers.size(); ++i) {
            add(fmt::format("layer[{}].", i), recipe.layers[i]);
        }
        add("substrate.reflectance", recipe.substrate_reflectance, limits::kFraction);
        if (recipe.microfacet) add(*recipe.microfacet);
    }

    std::vector<Slot> take() && { return std::move(slots_); }

 private:
    /// Whether a recipe states the material as a plain number.
    static bool is_number(const Material& material) {
        return !material.is_dispersive() && material == Material(material.samples()[0].real());
    }

    void add(std::string key, double& number, const Range& range) {
        slots_.push_back({std::move(key), range, &number});
    }

    void add(std::string key, Spectrum& spectrum, Range range) {
        if (spectrum != Spectrum(spectrum.values()[0])) {
            if (!(spectrum.max() > 0)) return;
            key += ".max";
            range.lo_open = true;  // at zero the shape of the spectrum would be lost
        }
        slots_.push_back({std::move(key), range, &spectrum});
    }

    void add(Clearcoat& coat) {
        add("clearcoat.thickness_um", coat.thickness_um, limits::kClearcoatThickness);
        add("clearcoat.absorption_per_mm", coat.absorption_per_mm, limits::kPerMillimetre);
        if (coat.roughness > 0) {
            add("clearcoat.roughness", coat.roughness, limits::kRoughInterface);
        }
    }

    void add(const std::string& path, Layer& layer) {
        add(path + "thickness_um", layer.thickness_um, limits::kLayerThickness);
        for (std::size_t i = 0; i < layer.flakes.size(); ++i) {
            add(fmt::format("{}flakes[{}].", path, i), layer.flakes[i]);
        }
        for (std::size_t i = 0; i < layer.pigments.size(); ++i) {
            const std::string at = fmt::format("{}pigment[{}].", path, i);
            Pigment& pigment = layer.pigments[i];
            add(at + "scattering_per_mm", pigment.scattering_per_mm, limits::kPerMillimetre);
            add(at + "absorption_per_mm", pigment.absorption_per_mm, limits::kPerMillimetre);
            add(at + "anisotropy", pigment.anisotropy, limits::kAnisotropy);
        }
    }

    void add(const std::string& path, FlakeSpecies& species) {
        if (auto* fraction = std::get_if<VolumeFraction>(&species.amount)) {
            add(path + "volume_fraction", fraction->value, limits::kVolumeFraction);
        } else {
            add(path + "area_density_per_um", std::get<AreaDensity>(species.amount).per_um,
                limits::kAreaDensity);
        }
        add(path + "diameter_um", species.diameter_um, limits::kDiameter);
        add(path + "diameter_spread_um", species.diameter_spread_um, limits::kDiameterSpread);
        add(path + "orientation.alpha", species.orientation.beckmann_alpha, limits::kBeckmannAlpha);
        std::visit([&](auto& body) { add(path, body); }, species.body);
    }

    void add(const std::string& path, optics::FilmPopulation& film) {
        add(path + "thickness_nm", film.thickness_nm, limits::kFilmThickness);
        add(path + "spread_nm", film.spread.standard_deviation_nm, limits::kFilmSpread);
    }

    void add(const std::string& path, optics::Platelet& platelet) {
        add(path + "core.", platelet.core);
        for (std::size_t i = 0; i < platelet.coats.size(); ++i) {
            add(fmt::format("{}coats[{}].", path, i), platelet.coats[i]);
        }
    }

    void add(const std::string& path, PrescribedFlake& flake) {
        add(path + "reflectance", flake.reflectance, limits::kFraction);
        add(path + "transmittance", flake.transmittance, limits::kFraction);
        add(path + "thickness_um", flake.thickness_um, limits::kPlateletThickness);
    }

    void add(Microfacet& m) {
        add("microfacet.alpha", m.alpha, limits::kMicrofacetAlpha);
        add("microfacet.film_ior", m.film_ior, limits::kMicrofacetIndex);
        add("microfacet.film_thickness_nm", m.film_thickness_nm, limits::kMicrofacetFilmThickness);
        add("microfacet.base_ior", m.base_ior, limits::kMicrofacetIndex);
        add("microfacet.base_extinction", m.base_extinction, limits::kMicrofacetExtinction);
        if (!m.facets) return;
        add("microfacet.facets.count", m.facets->count, limits::kFacetCount);
        add("microfacet.facets.cone_deg", m.facets->cone_deg, limits::kConeHalfAngle);
        add("microfacet.facets.thickness_spread_nm", m.facets->thickness_spread_nm,
            limits::kFilmSpread);
    }

    std::vector<Slot> slots_;
};

std::vector<Slot> slots_of(Recipe& recipe) { return SlotList(recipe).take(); }

template <class Entries>
std::vector<std::string> keys_of(const Entries& entries) {
    std::vector<std::string> keys;
    for (const auto& entry : entries) keys.push_back(entry.key);
    return keys;
}

std::string listed(const std::vector<std::string>& keys) {
    std::string text;
    for (std::size_t i = 0; i < keys.size() && i < kMaxListed; ++i) {
        text += (i > 0 ? ", " : "") + keys[i];
    }
    if (keys.size() > kMaxListed) {
        text += fmt::format(" and {} more", keys.size() - kMaxListed);
    }
    return text;
}

[[noreturn]] void refuse_unknown(std::string_view key, const std::vector<std::string>& keys) {
    const std::string suggestion = did_you_mean(key, keys);
    throw DomainError(
        fmt::format("{}: is not a number of this recipe{}", key,
                    suggestion.empty() ? "; its numbers are " + listed(keys) : suggestion));
}

const Slot& find(const std::vector<Slot>& slots, std::string_view key) {
    for (const Slot& slot : slots) {
        if (slot.key == key) return slot;
    }
    refuse_unknown(key, keys_of(slots));
}

/// Whether the pattern, in which `*` stands for any text, describes all of `text`. Goes back only
/// to the last `*`, so that its cost is the product of the lengths at most.
bool matches(std::string_view pattern, std::string_view text) {
    std::size_t p = 0, t = 0, star = std::string_view::npos, resume = 0;
    while (t < text.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            resume = t;
        } else if (p < pattern.size() && pattern[p] == text[t]) {
            ++p;
            ++t;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            t = ++resume;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

bool matches_end(std::string_view pattern, const std::string& key) {
    if (matches(pattern, key)) return true;
    for (std::size_t dot = key.find('.'); dot != std::string::npos; dot = key.find('.', dot + 1)) {
        if (matches(pattern, std::string_view(key).substr(dot + 1))) return true;
    }
    return false;
}

}  // namespace

std::vector<RecipeParameter> recipe_parameters(const Recipe& recipe) {
    Recipe copy = recipe;
    std::vector<RecipeParameter> parameters;
    for (const Slot& slot : slots_of(copy)) {
        parameters.push_back({slot.key, slot.get(), slot.range});
    }
    return parameters;
}

RecipeParameter find_parameter(const Recipe& recipe, std::string_view key) {
    Recipe copy = recipe;
    const std::vector<Slot> slots = slots_of(copy);
    const Slot& slot = find(slots, key);
    return {slot.key, slot.get(), slot.range};
}

void set_parameter(Recipe& recipe, std::string_view key, double value) {
    const std::vector<Slot> slots = slots_of(recipe);
    const Slot& slot = find(slots, key);
    if (!slot.range.contains(value)) {
        throw DomainError(fmt::format("{} = {}: must be in {}", key, value, slot.range.text()));
    }
    slot.set(value);
}

std::vector<std::string> matching_parameters(const Recipe& recipe, std::string_view pattern) {
    const std::vector<std::string> keys = keys_of(recipe_parameters(recipe));
    std::vector<std::string> found;
    for (const std::string& key : keys) {
        if (key == pattern) return {key};
        if (!pattern.empty() && matches_end(pattern, key)) found.push_back(key);
    }
    if (found.empty()) refuse_unknown(pattern, keys);
    if (found.size() > 1 && pattern.find('*') == std::string_view::npos) {
        throw DomainError(
            fmt::format("{}: may mean {}; write more of the key, or *{} for all of "
                        "them",
                        pattern, listed(found), pattern));
    }
    return found;
}

void check_bounds(const Recipe& recipe, const ParameterBounds& bounds) {
    const RecipeParameter parameter = find_parameter(recipe, bounds.key);
    for (double end : {bounds.lo, bounds.hi}) {
        if (!parameter.range.contains(end)) {
            throw DomainError(fmt::format("{} = [{}, {}]: both ends must be in {}", bounds.key,
                                          bounds.lo, bounds.hi, parameter.range.text()));
        }
    }
    if (!(bounds.lo < bounds.hi)) {
        throw DomainError(fmt::format("{} = [{}, {}]: the first end must be below the second",
                                      bounds.key, bounds.lo, bounds.hi));
    }
    if (!(parameter.value >= bounds.lo && parameter.value <= bounds.hi)) {
        throw DomainError(fmt::format("{} = [{}, {}]: the recipe's own {} is not between them",
                                      bounds.key, bounds.lo, bounds.hi, parameter.value));
    }
}

}  // namespace nacre::paint
