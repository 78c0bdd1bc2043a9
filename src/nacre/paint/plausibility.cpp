#include "nacre/paint/plausibility.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "nacre/paint/orientation.h"

namespace nacre::paint {

namespace {

class Findings {
 public:
    template <class... Args>
    void add(const std::string& key, fmt::format_string<Args...> text, Args&&... args) {
        lines_.push_back(key + fmt::format(text, std::forward<Args>(args)...));
    }
    std::vector<std::string> take() { return std::move(lines_); }

 private:
    std::vector<std::string> lines_;
};

void check_film(Findings& found, const std::string& key, double thickness_nm) {
    if (!(thickness_nm < kThinnestFilm_nm)) return;
    found.add(key, " = {:.6g} nm: thinner than {} nm, a few atoms; are these um?", thickness_nm,
              kThinnestFilm_nm);
}

void check_layer_thickness(Findings& found, const std::string& key, double thickness_um) {
    if (!(thickness_um > kThickestLayer_um)) return;
    found.add(key, " = {:.6g} um: thicker than {} um; are these nm?", thickness_um,
              kThickestLayer_um);
}

/// The diameter of the flakes that most of the area is in.
double typical_diameter_um(const FlakeSpecies& flakes) {
    return flakes.quantiles ? quantiles_of(*flakes.quantiles).d50_um : flakes.diameter_um;
}

void check_tilts(Findings& found, const std::string& key, const Orientation& orientation) {
    const double median_deg = median_tilt_deg(orientation);
    const std::string what =
        orientation.law == Orientation::Law::tabulated
            ? key + ".orientation.tilts"
            : fmt::format("{}.orientation.alpha = {:.6g}", key, orientation.beckmann_alpha);
    if (median_deg < kFlattest_deg) {
        found.add(what,
                  ": half of the flakes' area lies within {:.2g} deg, flatter than paints dry "
                  "(alpha 0.05 to 0.25)",
                  median_deg);
    } else if (median_deg > kSteepest_deg) {
        found.add(what,
                  ": half of the flakes' area is tilted by more than {:.3g} deg, steeper than "
                  "any spray gun leaves it (alpha 0.05 to 0.25)",
                  median_deg);
    }
}

void check_flakes(Findings& found, const std::string& key, const FlakeSpecies& flakes,
                  double layer_um) {
    const double diameter_um = typical_diameter_um(flakes), thickness_um = flakes.thickness_um();
    const std::string diameter_key = key + (flakes.quantiles ? ".d50_um" : ".diameter_um");
    if (diameter_um > kLargestFlake_um) {
        found.add(diameter_key, " = {:.6g} um: wider than {} um; are these nm?", diameter_um,
                  kLargestFlake_um);
    } else if (diameter_um < kMinAspectRatio * thickness_um) {
        found.add(diameter_key,
                  " = {:.6g} um: flakes {:.3g} um thick are hardly flat; their diameter is usually "
                  "20 times their thickness or more",
                  diameter_um, thickness_um);
    }
    check_tilts(found, key, flakes.orientation);
    const double height_um =
        thickness_um +
        diameter_um * std::sin(median_tilt_deg(flakes.orientation) * std::numbers::pi / 180);
    if (thickness_um > layer_um) {
        found.add(key, ": flakes {:.3g} um thick do not fit into a layer of {:.6g} um",
                  thickness_um, layer_um);
    } else if (height_um > layer_um) {
        found.add(key,
                  ": flakes of {:.4g} um that are tilted as these reach over {:.3g} um of "
                  "depth and do not fit into a layer of {:.6g} um",
                  diameter_um, height_um, layer_um);
    }
    if (const auto* platelet = std::get_if<optics::Platelet>(&flakes.body)) {
        check_film(found, key + ".core.thickness_nm", platelet->core.thickness_nm);
        for (std::size_t i = 0; i < platelet->coats.size(); ++i) {
            check_film(found, fmt::format("{}.coats[{}].thickness_nm", key, i),
                       platelet->coats[i].thickness_nm);
        }
        if (platelet->coats.empty() &&
            platelet->coated_sides == optics::Platelet::CoatedSides::one) {
            found.add(key, ".coated_sides = \"one\": there are no coats, and both sides are alike");
        }
    }
}

/// Of the dry layer, as far as the recipe says; a pigment by coefficients may not.
double solids_fraction(const Layer& layer) {
    double fraction = 0;
    for (const FlakeSpecies& flakes : layer.flakes) {
        fraction += flakes.area_density_per_um() * flakes.thickness_um();
    }
    for (const Pigment& pigment : layer.pigments) {
        if (const auto amount = pigment.amount()) fraction += volume_fraction(*amount);
    }
    return fraction;
}

}  // namespace

std::vector<std::string> implausible_numbers(const Recipe& recipe) {
    Findings found;
    if (recipe.clearcoat) {
        check_layer_thickness(found, "clearcoat.thickness_um", recipe.clearcoat->thickness_um);
        if (recipe.clearcoat->thickness_spread_um > 0 && recipe.coat_spread() == 0) {
            found.add("clearcoat.thickness_spread_um",
                      " = {:.6g} um: nothing is seen of it, as the coat absorbs nothing; is its "
                      "absorption_per_mm missing?",
                      recipe.clearcoat->thickness_spread_um);
        }
    }
    for (std::size_t i = 0; i < recipe.layers.size(); ++i) {
        const Layer& layer = recipe.layers[i];
        const std::string key = fmt::format("layer[{}]", i);
        check_layer_thickness(found, key + ".thickness_um", layer.thickness_um);
        for (std::size_t j = 0; j < layer.flakes.size(); ++j) {
            check_flakes(found, fmt::format("{}.flakes[{}]", key, j), layer.flakes[j],
                         layer.thickness_um);
        }
        if (const double solids = solids_fraction(layer); solids > kMaxSolids) {
            found.add(key,
                      ": {:.3g} % of its volume is flakes and pigments; paints have less than "
                      "{:.0f} %",
                      100 * solids, 100 * kMaxSolids);
        }
    }
    if (recipe.microfacet && recipe.microfacet->film_thickness_nm > 0) {
        check_film(found, "microfacet.film_thickness_nm", recipe.microfacet->film_thickness_nm);
    }
    return found.take();
}

}  // namespace nacre::paint
