#include "nacre/paint/expansion.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "nacre/paint/orientation.h"

namespace nacre::paint {
namespace {

bool has_one_coated_side(const FlakeSpecies& species) {
    const auto* platelet = std::get_if<optics::Platelet>(&species.body);
    return platelet && platelet->coated_sides == optics::Platelet::CoatedSides::one &&
           platelet->face == optics::Platelet::Face::any;
}

bool is_plain(const FlakeSpecies& species) {
    return species.orientation.law == Orientation::Law::beckmann &&
           species.orientation.alpha_bottom == 0 && !species.quantiles && species.edge_um == 0 &&
           !has_one_coated_side(species);
}

bool is_plain(const Layer& layer) {
    return std::all_of(layer.flakes.begin(), layer.flakes.end(),
                       [](const FlakeSpecies& species) { return is_plain(species); });
}

/// Alpha at a depth, as a fraction of the layer.
double alpha_at(const Orientation& orientation, double depth) {
    const double top = orientation.beckmann_alpha, bottom = orientation.alpha_bottom;
    return bottom > 0 ? top + depth * (bottom - top) : top;
}

/// Depths, as fractions of the layer, between which every alpha changes by a factor of up to
/// 1 + kSublayerError: equal steps of ln alpha of each species.
std::vector<double> sublayer_ends(const Layer& layer) {
    std::vector<double> ends = {0, 1};
    for (const FlakeSpecies& species : layer.flakes) {
        const double top = species.orientation.beckmann_alpha;
        const double bottom = species.orientation.alpha_bottom;
        if (bottom == 0 || bottom == top) continue;
        const double ratio = std::log(bottom / top);
        const int count =
            static_cast<int>(std::ceil(std::abs(ratio) / std::log1p(kSublayerError) - 1e-9));
        for (int i = 1; i < count; ++i) {
            ends.push_back(top * std::expm1(ratio * i / count) / (bottom - top));
        }
    }
    std::sort(ends.begin(), ends.end());
    constexpr double kSame = 1e-9;
    ends.erase(
        std::unique(ends.begin(), ends.end(), [](double a, double b) { return b - a < kSame; }),
        ends.end());
    ends.back() = 1;
    return ends;
}

std::vector<FlakeSpecies> faces_of(const FlakeSpecies& species) {
    if (!has_one_coated_side(species)) return {species};
    std::vector<FlakeSpecies> faces(2, species);
    std::get<optics::Platelet>(faces[0].body).face = optics::Platelet::Face::coated;
    std::get<optics::Platelet>(faces[1].body).face = optics::Platelet::Face::bare;
    return faces;
}

/// A species whose law of slopes is the same at all depths.
void add_species(const FlakeSpecies& species, Layer& out) {
    if (is_plain(species)) {
        out.flakes.push_back(species);
        return;
    }
    std::vector<SizePart> parts;
    if (species.quantiles) {
        parts = size_parts(quantiles_of(*species.quantiles));
    } else {
        parts.push_back({1, FlakeSizes(species.diameter_um, species.diameter_spread_um)});
    }
    const double all = species.area_density_per_um();
    double rims = 0;
    if (species.edge_um > 0) {
        for (SizePart& part : parts) {
            // Fines below twice the width are all rim.
            if (part.sizes.largest_um() <= 2 * species.edge_um + 2e-3) {
                rims += std::exchange(part.area_fraction, 0);
                continue;
            }
            const SizePart discs = without_rim(part.sizes, species.edge_um);
            rims += part.area_fraction * (1 - discs.area_fraction);
            part = {part.area_fraction * discs.area_fraction, discs.sizes};
        }
        constexpr double kPerMm = 1000;
        out.pigments.push_back(
            {PigmentCoefficients{kPerMm * all * rims, 0.0, 0},
             species.name.empty() ? "edges of flakes" : "edges of " + species.name});
    }
    const bool sized = species.quantiles || species.edge_um > 0;
    const std::vector<SlopeComponent> slopes = beckmann_mixture(species.orientation);
    const std::vector<FlakeSpecies> faces = faces_of(species);
    for (const FlakeSpecies& face : faces) {
        for (const SizePart& part : parts) {
            if (part.area_fraction <= 0) continue;
            for (const SlopeComponent& component : slopes) {
                FlakeSpecies& one = out.flakes.emplace_back(face);
                one.amount = AreaDensity{all * part.area_fraction * component.fraction /
                                         static_cast<double>(faces.size())};
                one.orientation = Orientation{component.alpha};
                if (!sized) continue;
                one.part = part.sizes;
                one.quantiles.reset();
                one.edge_um = 0;
                one.diameter_um = part.sizes.area_weighted_mean_um();
                one.diameter_spread_um = 0;
            }
        }
    }
}

void add_layers(const Layer& layer, std::vector<Layer>& out) {
    if (is_plain(layer)) {
        out.push_back(layer);
        return;
    }
    const std::vector<double> ends = sublayer_ends(layer);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        Layer& sublayer = out.emplace_back();
        sublayer.thickness_um = layer.thickness_um * (ends[i + 1] - ends[i]);
        sublayer.pigments = layer.pigments;
        for (FlakeSpecies species : layer.flakes) {
            Orientation& orientation = species.orientation;
            if (orientation.alpha_bottom > 0) {
                // So that the mean of 1 / alpha^2 over the sublayer is exact.
                orientation.beckmann_alpha =
                    std::sqrt(alpha_at(orientation, ends[i]) * alpha_at(orientation, ends[i + 1]));
                orientation.alpha_bottom = 0;
            }
            add_species(species, sublayer);
        }
    }
}

}  // namespace

bool is_plain(const Recipe& recipe) {
    return std::all_of(recipe.layers.begin(), recipe.layers.end(),
                       [](const Layer& layer) { return is_plain(layer); });
}

Recipe expanded(const Recipe& recipe) {
    if (is_plain(recipe)) return recipe;
    Recipe out = recipe;
    out.layers.clear();
    for (const Layer& layer : recipe.layers) add_layers(layer, out.layers);
    return out;
}

}  // namespace nacre::paint
