#include "nacre/montecarlo/discs/disc.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "nacre/core/error.h"
#include "nacre/core/memory.h"
#include "nacre/montecarlo/events.h"
#include "nacre/paint/expansion.h"

namespace nacre::montecarlo {
namespace {

double discs_per_um2(const paint::FlakeSpecies& species, double thickness_um) {
    const paint::FlakeSizes sizes = species.sizes();
    return species.area_density_per_um() * thickness_um / sizes.mean_area_um2();
}

/// Calls visit(layer, species, z_top_um) for all species of the expanded paint from the top down.
template <class Visit>
void for_each_species(const paint::Recipe& written, Visit&& visit) {
    const paint::Recipe recipe = paint::expanded(written);
    double z = recipe.clearcoat ? -recipe.clearcoat->thickness_um : 0;
    for (const paint::Layer& layer : recipe.layers) {
        for (const paint::FlakeSpecies& species : layer.flakes) visit(layer, species, z);
        z -= layer.thickness_um;
    }
}

/// Moves a flake of this half height into the paint.
double kept_inside(double z, double half_height, double paint_um) {
    if (2 * half_height >= paint_um) return -0.5 * paint_um;
    return std::clamp(z, half_height - paint_um, -half_height);
}

/// A Poisson number of any mean.
std::uint64_t poisson(double mean, Rng& rng) {
    return std::poisson_distribution<std::uint64_t>(mean)(rng);
}

}  // namespace

double expected_discs(const paint::Recipe& recipe, const Tile& tile) {
    double sum = 0;
    for_each_species(recipe, [&](const auto& layer, const auto& species, double) {
        sum += discs_per_um2(species, layer.thickness_um) * tile.width_um * tile.height_um;
    });
    return sum;
}

double expected_copies(const paint::Recipe& recipe, const Tile& tile) {
    double sum = 0;
    for_each_species(recipe, [&](const auto& layer, const auto& species, double) {
        const paint::FlakeSizes sizes = species.sizes();
        double copies = 0;  // of one flake: those with their centre within its radius of the tile
        for (std::uint32_t i = 0; i < paint::FlakeSizes::kSizes; ++i) {
            const double d = sizes.diameter_um(i);
            copies += (1 + d / tile.width_um) * (1 + d / tile.height_um);
        }
        sum += discs_per_um2(species, layer.thickness_um) * tile.width_um * tile.height_um *
               (copies / paint::FlakeSizes::kSizes);
    });
    return sum;
}

void require_discs(const paint::Recipe& recipe, const Tile& tile) {
    const double expected = expected_discs(recipe, tile);
    if (!(expected <= kMaxDiscs)) {
        throw DomainError(fmt::format(
            "a piece of {} mm x {} mm of this paint holds {:.3g} flakes; explicit flakes are at "
            "most {:.3g}: take a smaller panel",
            1e-3 * tile.width_um, 1e-3 * tile.height_um, expected, kMaxDiscs));
    }
    const double copies = expected_copies(recipe, tile);
    constexpr double kMaxCopies = 2 * kMaxDiscs;
    if (!(copies <= kMaxCopies)) {
        throw DomainError(fmt::format(
            "the flakes in a piece of {} mm x {} mm of this paint reach so far over its edges that "
            "light meets {:.3g} of them; explicit flakes and their repetitions are at most {:.3g}: "
            "take a larger panel, or smaller flakes",
            1e-3 * tile.width_um, 1e-3 * tile.height_um, copies, kMaxCopies));
    }
    require_memory(kBytesPerDisc * copies, fmt::format("laying out {:.3g} flakes", copies),
                   "take a smaller panel");
}

std::vector<Disc> draw_discs(const paint::Recipe& recipe, const Tile& tile,
                             const std::vector<int>& film_counts, std::uint64_t seed,
                             SharedProgress* work) {
    require_discs(recipe, tile);
    const double expected = expected_discs(recipe, tile);
    std::vector<Disc> discs;
    discs.reserve(static_cast<std::size_t>(expected + 6 * std::sqrt(expected) + 16));
    const double paint_um = recipe.thickness_um();
    const auto tilted = recipe.flake_lean();
    const auto lean = tilted ? std::optional<FlakeFrame>(tilted->tangents()) : std::nullopt;
    std::uint16_t index = 0;
    for_each_species(recipe, [&](const auto& layer, const auto& species, double z_top_um) {
        const paint::FlakeSizes sizes = species.sizes();
        Rng count_rng(seed, index);
        const double mean =
            discs_per_um2(species, layer.thickness_um) * tile.width_um * tile.height_um;
        const std::uint64_t count = poisson(mean, count_rng);
        RandomStream random(seed, 1, index);
        for (std::uint64_t i = 0; i < count; ++i) {
            if (work) work->throw_if_stopped("laying out the flakes");
            Disc disc;
            const double x = tile.width_um * random.uniform();
            const double y = tile.height_um * random.uniform();
            const double z = z_top_um - layer.thickness_um * random.uniform();
            const auto [radius, c, s] = random.slope();
            double slope = species.orientation.beckmann_alpha * radius;
            double upright = 1 / std::sqrt(1 + slope * slope);
            Vec3d normal{-slope * c * upright, -slope * s * upright, upright};
            if (lean) {
                normal = lean->from_flakes(normal);
                upright = normal.z;
                slope = std::hypot(normal.x, normal.y) / upright;
            }
            disc.normal = to_float(normal);
            disc.radius_um = 0.5f * sizes.diameter_um(static_cast<std::uint32_t>(
                                        paint::FlakeSizes::kSizes * random.uniform()));
            disc.centre_um = {
                static_cast<float>(x), static_cast<float>(y),
                static_cast<float>(kept_inside(z, disc.radius_um * slope * upright, paint_um))};
            disc.film = static_cast<std::uint16_t>(film_counts[index] * random.uniform());
            disc.species = index;
            discs.push_back(disc);
        }
        ++index;
    });
    return discs;
}

}  // namespace nacre::montecarlo
