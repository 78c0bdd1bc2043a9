#include "nacre/solver/medium.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <variant>

#include "nacre/core/error.h"
#include "nacre/core/lru_cache.h"
#include "nacre/paint/beckmann.h"
#include "nacre/paint/expansion.h"
#include "nacre/paint/normal_weights.h"

namespace nacre::solver {

namespace {

std::vector<double> sampled(const spectra::Spectrum& spectrum, std::span<const double> wavelengths,
                            double scale = 1.0) {
    std::vector<double> values;
    for (double w : wavelengths) values.push_back(scale * spectrum(w));
    return values;
}

paint::FlakeTable make_table(const paint::FlakeSpecies& species, const optics::Material& binder,
                             const std::vector<double>& wavelengths, FilmCache* films,
                             SharedProgress* work) {
    if (const auto* platelet = std::get_if<optics::Platelet>(&species.body)) {
        if (films) return *films->table(*platelet, binder, wavelengths, work);
        return paint::FlakeTable::of_platelet(*platelet, binder, wavelengths,
                                              paint::FlakeTable::kMaxCosines, work);
    }
    const auto& flake = std::get<paint::PrescribedFlake>(species.body);
    return paint::FlakeTable::constant(sampled(flake.reflectance, wavelengths),
                                       sampled(flake.transmittance, wavelengths));
}

constexpr double kUmPerMm = 1000.0;

/// optics::particle_optics(), kept for the next solve with the same particles: whoever seeks another
/// number of the paint solves it hundreds of times, of which the series would take two thirds.
std::shared_ptr<const optics::ParticleOptics> recent_particle_optics(
    const optics::Spheres& spheres, double volume_fraction, const optics::Material& binder,
    const std::vector<double>& wavelengths) {
    struct Particles {
        optics::Spheres spheres;
        double volume_fraction;
        optics::Material binder;
        std::vector<double> wavelengths;
        bool operator==(const Particles&) const = default;
    };
    // Of one wavelength there are some 10 kB.
    constexpr std::size_t kMaxWavelengths = 4096;
    static LruCache<Particles, optics::ParticleOptics> recent(
        kMaxWavelengths,
        [](const optics::ParticleOptics& optics) { return optics.scattering_per_um.size(); });
    return recent.get({spheres, volume_fraction, binder, wavelengths}, [&] {
        return optics::particle_optics(spheres, volume_fraction, binder, wavelengths);
    });
}

PigmentMedium make_pigment(const paint::Pigment& pigment, const optics::Material& binder,
                           const std::vector<double>& wavelengths) {
    if (const auto* particles = std::get_if<paint::PigmentParticles>(&pigment.body)) {
        const auto optics = recent_particle_optics(
            particles->spheres, volume_fraction(particles->amount), binder, wavelengths);
        return {optics->scattering_per_um, optics->absorption_per_um, 0, optics->phase};
    }
    const paint::PigmentCoefficients given = *pigment.layer_coefficients();
    return {sampled(given.scattering_per_mm, wavelengths, 1 / kUmPerMm),
            sampled(given.absorption_per_mm, wavelengths, 1 / kUmPerMm), given.anisotropy};
}

/// Before all that takes longer.
void require_resolvable(const paint::Recipe& recipe, const std::vector<double>& wavelengths) {
    for (std::size_t i = 0; i < recipe.layers.size(); ++i) {
        for (std::size_t j = 0; j < recipe.layers[i].pigments.size(); ++j) {
            const paint::Pigment& given = recipe.layers[i].pigments[j];
            const PigmentMedium pigment = make_pigment(given, recipe.binder, wavelengths);
            if (pigment.sharpness() <= kSharpestPigment) continue;
            const std::string key = fmt::format("layer[{}].pigment[{}]", i, j);
            if (const auto* particles = std::get_if<paint::PigmentParticles>(&given.body)) {
                throw DomainError(fmt::format(
                    "{}.diameter_nm = {}: particles this large scatter as sharply forwards as an "
                    "anisotropy of {:.3f}, and what is solved must have one in [{}, {}]; use "
                    "smaller "
                    "ones, or less spread",
                    key, particles->spheres.diameter_nm, pigment.sharpness(), -kSharpestPigment,
                    kSharpestPigment));
            }
            throw DomainError(fmt::format(
                "{}.anisotropy = {}: must be in [{}, {}] to be solved (the models walk and volume "
                "take any); for a sharper one use similarity, scattering x (1 - anisotropy) with "
                "anisotropy = 0",
                key, pigment.anisotropy, -kSharpestPigment, kSharpestPigment));
        }
    }
}

}  // namespace

DoubleLanes block_lanes(std::span<const double> values, int block) {
    return make_lanes<DoubleLanes>([&](int i) {
        return values[std::min<std::size_t>(block * kLanes + i, values.size() - 1)];
    });
}

DoubleLanes PigmentMedium::phase_value(double cosine, int block) const {
    if (phase) return phase->value(cosine, block);
    const double g = anisotropy;
    return splat((1 - g * g) / (4 * std::numbers::pi * std::pow(1 + g * g - 2 * g * cosine, 1.5)));
}

double PigmentMedium::sharpness() const {
    return phase ? phase->sharpness() : std::abs(anisotropy);
}

PaintMedium make_medium(const paint::Recipe& recipe, const std::vector<double>& wavelengths_nm,
                        FilmCache* films, SharedProgress* work) {
    validate(recipe, wavelengths_nm);
    require_resolvable(recipe, wavelengths_nm);
    PaintMedium medium;
    medium.wavelengths_nm = wavelengths_nm;
    for (double w : wavelengths_nm) medium.ior.push_back(recipe.binder.index(w).real());
    medium.clearcoat_depth.assign(wavelengths_nm.size(), 0.0);
    if (recipe.clearcoat) {
        medium.clearcoat_depth = sampled(recipe.clearcoat->absorption_per_mm, wavelengths_nm,
                                         recipe.clearcoat->thickness_um / kUmPerMm);
        medium.roughness = recipe.clearcoat->roughness;
    }
    const paint::Recipe whole = paint::expanded(recipe);
    // Species of one kind of flake share their table, which takes longer than all else.
    struct Known {
        const paint::FlakeSpecies* species;
        std::size_t layer, flake;
    };
    std::vector<Known> known;
    for (const paint::Layer& layer : whole.layers) {
        LayerMedium& out = medium.layers.emplace_back();
        out.thickness_um = layer.thickness_um;
        for (const paint::FlakeSpecies& species : layer.flakes) {
            const auto same = std::find_if(known.begin(), known.end(), [&](const Known& k) {
                return k.species->body == species.body;
            });
            paint::FlakeTable table =
                same != known.end()
                    ? medium.layers[same->layer].flakes[same->flake].table
                    : make_table(species, recipe.binder, wavelengths_nm, films, work);
            if (same == known.end()) {
                known.push_back({&species, medium.layers.size() - 1, out.flakes.size()});
            }
            out.flakes.push_back(
                {species.area_density_per_um(), species.surface_alpha(), std::move(table)});
        }
        for (const paint::Pigment& pigment : layer.pigments) {
            out.pigments.push_back(make_pigment(pigment, recipe.binder, wavelengths_nm));
        }
    }
    medium.substrate_reflectance = sampled(recipe.substrate_reflectance, wavelengths_nm);
    return medium;
}

namespace {

void add_extinction(const LayerMedium& layer, double mu, int first, std::span<DoubleLanes> sum) {
    const int count = static_cast<int>(sum.size());
    for (const FlakeMedium& flake : layer.flakes) {
        const double density = flake.area_density_per_um;
        if (flake.table.is_opaque()) {
            const DoubleLanes area = splat(paint::projected_area(mu, flake.alpha));
            for (int b = 0; b < count; ++b) sum[b] += density * area;
        } else {
            const paint::NormalWeights normals = flake.normals(mu);
            for (int b = 0; b < count; ++b) {
                sum[b] += density * normals.sum([&](int node) {
                    return 1.0 - flake.table.transmittance_at(node, first + b);
                });
            }
        }
    }
    for (const PigmentMedium& pigment : layer.pigments) {
        for (int b = 0; b < count; ++b) {
            sum[b] += block_lanes(pigment.scattering_per_um, first + b) +
                      block_lanes(pigment.absorption_per_um, first + b);
        }
    }
}

}  // namespace

DoubleLanes extinction(const LayerMedium& layer, double mu, int block) {
    DoubleLanes sum{};
    add_extinction(layer, mu, block, {&sum, 1});
    return sum;
}

std::vector<DoubleLanes> extinctions(const LayerMedium& layer, double mu, int first, int count) {
    std::vector<DoubleLanes> sum(count, DoubleLanes{});
    add_extinction(layer, mu, first, sum);
    return sum;
}

Losses losses(const LayerMedium& layer, double mu, int first, int count) {
    const std::vector<DoubleLanes> zero(count, DoubleLanes{});
    Losses out{zero, zero};
    for (const FlakeMedium& flake : layer.flakes) {
        const paint::NormalWeights normals = flake.normals(mu);
        const bool opaque = flake.table.is_opaque();
        const DoubleLanes area = splat(opaque ? paint::projected_area(mu, flake.alpha) : 0.0);
        for (int b = 0; b < count; ++b) {
            const auto taken_at = [&](int node) {
                return 1.0 - flake.table.transmittance_at(node, first + b);
            };
            const DoubleLanes absorbed = normals.sum([&](int node) {
                return taken_at(node) - flake.table.reflectance_at(node, first + b);
            });
            out.extinction[b] +=
                flake.area_density_per_um * (opaque ? area : normals.sum(taken_at));
            // R + T = 1 leaves rounding of either sign.
            out.absorption[b] += flake.area_density_per_um * max_lanes(absorbed, DoubleLanes{});
        }
    }
    for (const PigmentMedium& pigment : layer.pigments) {
        for (int b = 0; b < count; ++b) {
            const DoubleLanes absorbed = block_lanes(pigment.absorption_per_um, first + b);
            out.extinction[b] += block_lanes(pigment.scattering_per_um, first + b) + absorbed;
            out.absorption[b] += absorbed;
        }
    }
    return out;
}

DoubleLanes backscattering(const LayerMedium& layer, double mu_i, double mu_o, double phi,
                           int block, double added_alpha2) {
    const double s_i = std::sqrt(std::max(0.0, 1 - mu_i * mu_i));
    const double s_o = std::sqrt(std::max(0.0, 1 - mu_o * mu_o));
    // Without cancellation at the mirror direction.        [mir-2022, eq. 3-6, repaired]
    const double delta = mu_i + mu_o;
    const double half = std::sin(0.5 * (phi - std::numbers::pi));
    const double across = (mu_i - mu_o) / std::max(s_i + s_o, 1e-300);
    const double tan2 = across * across + 4 * s_i * s_o / (delta * delta) * half * half;
    const double cosine = std::min(1.0, 0.5 * delta * std::sqrt(1 + tan2));
    DoubleLanes sum{};
    for (const FlakeMedium& flake : layer.flakes) {
        const double density =
            paint::flake_density(tan2, std::sqrt(flake.alpha * flake.alpha + added_alpha2));
        sum += 0.5 * flake.area_density_per_um * density * flake.table.reflectance(cosine, block);
    }
    for (const PigmentMedium& pigment : layer.pigments) {
        // cos of the angle between the directions of travel.
        const double turn = -mu_i * mu_o - s_i * s_o * std::cos(phi);
        sum += pigment.phase_value(turn, block) * block_lanes(pigment.scattering_per_um, block);
    }
    return sum;
}

}  // namespace nacre::solver
