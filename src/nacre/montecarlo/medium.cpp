#include "nacre/montecarlo/medium.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/quadrature.h"
#include "nacre/paint/expansion.h"

namespace nacre::montecarlo {
namespace {

constexpr double kPerMmToPerUm = 1e-3;

Lanes sample_spectrum(const spectra::Spectrum& spectrum, std::span<const double> wavelengths_nm) {
    Lanes values{};
    for (std::size_t i = 0; i < wavelengths_nm.size(); ++i) values[i] = spectrum(wavelengths_nm[i]);
    return values;
}

/// Linear in the cosine between equal steps from 0 to 1; a single entry is a constant.
Lanes interpolate(const std::vector<Lanes>& table, double cosine) {
    if (table.size() == 1) return table[0];
    const std::size_t last_interval = table.size() - 2;
    const double x = std::min(cosine, 1.0) * static_cast<double>(table.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(x), last_interval);
    return table[i] + (x - static_cast<double>(i)) * (table[i + 1] - table[i]);
}

Lanes to_lanes(std::span<const double> values) {
    Lanes lanes{};
    for (std::size_t i = 0; i < values.size(); ++i) lanes[i] = values[i];
    return lanes;
}

void add_pigment(const paint::Pigment& pigment, const optics::Material& binder,
                 std::span<const double> wavelengths_nm, Slab& slab) {
    if (const auto* particles = std::get_if<paint::PigmentParticles>(&pigment.body)) {
        const optics::ParticleOptics optics = optics::particle_optics(
            particles->spheres, volume_fraction(particles->amount), binder, wavelengths_nm);
        std::vector<Lanes> density;
        for (int node = 0; node <= optics::PhaseFunction::kIntervals; ++node) {
            density.push_back(to_lanes({optics.phase.row(node), wavelengths_nm.size()}));
        }
        slab.pigments.push_back({to_lanes(optics.scattering_per_um), 0,
                                 std::make_shared<PhaseTable>(std::move(density))});
        slab.absorption_per_um += to_lanes(optics.absorption_per_um);
        return;
    }
    const paint::PigmentCoefficients given = *pigment.layer_coefficients();
    slab.pigments.push_back(
        {kPerMmToPerUm * sample_spectrum(given.scattering_per_mm, wavelengths_nm),
         given.anisotropy});
    slab.absorption_per_um +=
        kPerMmToPerUm * sample_spectrum(given.absorption_per_mm, wavelengths_nm);
}

}  // namespace

FlakeOptics::FlakeOptics(const paint::FlakeSpecies& species, const optics::Material& binder,
                         std::span<const double> wavelengths_nm, SharedProgress* work) {
    if (const auto* given = std::get_if<paint::PrescribedFlake>(&species.body)) {
        reflectance_ = {sample_spectrum(given->reflectance, wavelengths_nm)};
        transmittance_ = {sample_spectrum(given->transmittance, wavelengths_nm)};
        return;
    }
    std::vector<double> cosines;
    for (int i = 0; i <= kPlateletTableIntervals; ++i)
        cosines.push_back(static_cast<double>(i) / kPlateletTableIntervals);
    const optics::PlateletTable table = optics::platelet_table(
        std::get<optics::Platelet>(species.body), binder, cosines, wavelengths_nm, work);
    const std::size_t count = wavelengths_nm.size();
    for (std::size_t i = 0; i < cosines.size(); ++i) {
        Lanes r{}, t{};
        for (std::size_t j = 0; j < count; ++j) {
            r[j] = table.reflectance[i * count + j];
            t[j] = table.transmittance[i * count + j];
        }
        reflectance_.push_back(r);
        transmittance_.push_back(t);
    }
}

Lanes FlakeOptics::reflectance(double cosine) const { return interpolate(reflectance_, cosine); }

Lanes FlakeOptics::transmittance(double cosine) const {
    return interpolate(transmittance_, cosine);
}

FlakeFrame::FlakeFrame(const std::array<double, 2>& tangents)
    : n(normalize(Vec3d{tangents[0], tangents[1], 1})) {
    // What the shortest turn of z into n makes of x and y.
    const double along = 1 / (1 + n.z);
    s = {1 - n.x * n.x * along, -n.x * n.y * along, -n.x};
    t = {-n.x * n.y * along, 1 - n.y * n.y * along, -n.y};
}

Lanes Flakes::scattering(const Vec3d& in, const Vec3d& out) const {
    const Vec3d along_normal = lean ? lean->to_flakes(out - in) : out - in;
    const double vertical_sq = along_normal.z * along_normal.z;
    const double length_sq = dot(along_normal, along_normal);
    const double slope_sq = (length_sq - vertical_sq) / vertical_sq;  // inf or NaN if vertical = 0
    const double exponent = slope_sq / (alpha * alpha);
    constexpr double kNegligible = 700;  // exp(-700) = 1e-304
    if (!(exponent < kNegligible)) return Lanes{};
    const double secant_sq = length_sq / vertical_sq;
    const double density = std::exp(-exponent) / (std::numbers::pi * alpha * alpha);
    const double cosine = std::sqrt(length_sq) / 2;  // |in.m|, as |out - in|^2 = 2 - 2 in.out
    return (area_density_per_um * density * secant_sq * std::sqrt(secant_sq) / 4) *
           optics.reflectance(cosine);
}

double Flakes::cosine_to_mean_normal(const Vec3d& w) const {
    return lean ? std::min(1.0, std::abs(dot(w, lean->n))) : w.z;
}

Lanes Flakes::extinction(const Vec3d& w) const { return extinction(cosine_to_mean_normal(w)); }

Lanes Flakes::extinction(double mu) const {
    // w = (s, 0, mu), m = (-x, -y, 1)/sqrt(1 + x^2 + y^2): w.m has a kink at x = mu / s, so x gets
    // a panel on each side of it. In y the integrand is Gaussian times a smooth function, for which
    // equal steps converge exponentially.
    constexpr double kReach = 6;  // in units of alpha: the tail beyond holds exp(-36) = 2e-16
    constexpr int kNodesPerPanel = 96, kStepsPerSide = 32;
    const double s = std::sqrt(std::max(0.0, 1 - mu * mu));
    const double limit = kReach * alpha;
    const double step = limit / kStepsPerSide;
    static const Quadrature unit = gauss_legendre(kNodesPerPanel, 0, 1);
    std::array<double, kStepsPerSide + 1> weight_y;  // y and -y together
    for (int k = 0; k <= kStepsPerSide; ++k)
        weight_y[k] = (k == 0 ? 1 : 2) * step * std::exp(-k * step * k * step / (alpha * alpha));
    Lanes sum{};
    const auto add_panel = [&](double from, double to) {
        for (int i = 0; i < kNodesPerPanel; ++i) {
            const double x = from + (to - from) * unit.nodes[i];
            const double projected = std::abs(mu - s * x);
            const double weight_x =
                (to - from) * unit.weights[i] * projected * std::exp(-x * x / (alpha * alpha));
            for (int k = 0; k <= kStepsPerSide; ++k) {
                const double shrink = 1 / std::sqrt(1 + x * x + k * step * k * step);
                sum += (weight_x * weight_y[k] * shrink) *
                       (1 - optics.transmittance(projected * shrink));
            }
        }
    };
    const double kink = s > 0 ? mu / s : limit;
    if (kink < limit) {
        add_panel(-limit, kink);
        add_panel(kink, limit);
    } else {
        add_panel(-limit, 0);
        add_panel(0, limit);
    }
    return (area_density_per_um / (std::numbers::pi * alpha * alpha)) * sum;
}

PhaseTable::PhaseTable(std::vector<Lanes> density) : density_(std::move(density)) {
    Lanes sum{};
    for (int i = 0; i <= optics::PhaseFunction::kIntervals; ++i) {
        if (i > 0) {
            const double reach =
                optics::PhaseFunction::node_cosine(i - 1) - optics::PhaseFunction::node_cosine(i);
            sum += std::numbers::pi * reach * (density_[i - 1] + density_[i]);
        }
        below_.push_back(sum);
    }
}

Lanes PhaseTable::value(double cosine) const {
    const auto [node, fraction] = optics::PhaseFunction::locate(cosine);
    return density_[node] + fraction * (density_[node + 1] - density_[node]);
}

double PhaseTable::cosine(int lane, double fraction) const {
    const double sought = fraction * below_.back()[lane];
    const auto above =
        std::upper_bound(below_.begin() + 1, below_.end() - 1, sought,
                         [lane](double x, const Lanes& sum) { return x < sum[lane]; });
    const auto i = static_cast<int>(above - below_.begin()) - 1;
    const double from = optics::PhaseFunction::node_cosine(i);
    const double reach = from - optics::PhaseFunction::node_cosine(i + 1);
    const double a = density_[i][lane], b = density_[i + 1][lane];
    // a t + (b - a) t^2/2 = rest, for t in [0, 1], without cancellation.
    const double rest = std::max(0.0, (sought - below_[i][lane]) / (2 * std::numbers::pi * reach));
    const double root = std::sqrt(std::max(0.0, a * a + 2 * (b - a) * rest));
    const double t = a + root > 0 ? 2 * rest / (a + root) : 0.0;
    return from - std::min(t, 1.0) * reach;
}

Lanes Pigment::phase_value(double cosine) const {
    if (phase) return phase->value(cosine);
    const double g = anisotropy;
    const double d = 1 + g * g - 2 * g * cosine;
    return splat((1 - g * g) / (4 * std::numbers::pi * d * std::sqrt(d)));
}

Lanes Pigment::scattering(const Vec3d& in, const Vec3d& out) const {
    return phase_value(dot(in, out)) * scattering_per_um;
}

Lanes Slab::scattering(const Vec3d& in, const Vec3d& out) const {
    Lanes sum{};
    for (const Flakes& species : flakes) sum += species.scattering(in, out);
    for (const Pigment& pigment : pigments) sum += pigment.scattering(in, out);
    return sum;
}

Lanes Slab::extinction(const Vec3d& w) const {
    return extinction(flakes.empty() ? w.z : flakes.front().cosine_to_mean_normal(w));
}

Lanes Slab::extinction(double cosine) const {
    if (!extinction_table.empty()) return interpolate(extinction_table, cosine);
    Lanes sum = absorption_per_um + pigment_scattering_per_um;
    for (const Flakes& species : flakes) sum += species.extinction(cosine);
    return sum;
}

void Slab::tabulate_extinction() {
    std::vector<Lanes> table(flakes.empty() ? 1 : kExtinctionTableIntervals + 1);
    parallel_for(0, table.size(), [&](std::size_t i) {
        table[i] = extinction(static_cast<double>(i) / kExtinctionTableIntervals);
    });
    extinction_table = std::move(table);
}

void Slab::sum_pigments() {
    pigment_scattering_per_um = Lanes{};
    for (const Pigment& pigment : pigments) pigment_scattering_per_um += pigment.scattering_per_um;
    pigment_rate_per_um = lane_max(pigment_scattering_per_um);
}

Medium::Medium(const paint::Recipe& recipe, std::span<const double> wavelengths_nm,
               SharedProgress* work)
    : lane_count(static_cast<int>(wavelengths_nm.size())),
      index(recipe.binder.index(wavelengths_nm.front()).real()),
      substrate_reflectance(sample_spectrum(recipe.substrate_reflectance, wavelengths_nm)) {
    if (recipe.clearcoat) {
        Slab slab;
        slab.thickness_um = recipe.clearcoat->thickness_um;
        slab.absorption_per_um =
            kPerMmToPerUm * sample_spectrum(recipe.clearcoat->absorption_per_mm, wavelengths_nm);
        slabs.push_back(std::move(slab));
    }
    const paint::Recipe whole = paint::expanded(recipe);
    const auto tilted = recipe.flake_lean();
    const auto lean = tilted ? std::optional<FlakeFrame>(tilted->tangents()) : std::nullopt;
    // Species of one kind of flake share their tables, which take longer than all else.
    std::vector<std::pair<const paint::FlakeSpecies*, FlakeOptics>> known;
    const auto optics_of = [&](const paint::FlakeSpecies& species) {
        for (const auto& [other, optics] : known) {
            if (other->body == species.body) return optics;
        }
        known.emplace_back(&species, FlakeOptics(species, recipe.binder, wavelengths_nm, work));
        return known.back().second;
    };
    for (const paint::Layer& layer : whole.layers) {
        Slab slab;
        slab.thickness_um = layer.thickness_um;
        for (const paint::FlakeSpecies& species : layer.flakes) {
            slab.flakes.push_back(
                {species.area_density_per_um(), species.surface_alpha(), optics_of(species), lean});
            slab.flake_rate_per_um += slab.flakes.back().area_density_per_um;
        }
        for (const paint::Pigment& pigment : layer.pigments) {
            add_pigment(pigment, recipe.binder, wavelengths_nm, slab);
        }
        slab.sum_pigments();
        slabs.push_back(std::move(slab));
    }
}

/// Between grid wavelengths `lower` and `upper`.
struct MediumGrid::Place {
    std::size_t lower, upper;
    double fraction;
};

MediumGrid::MediumGrid(const paint::Recipe& recipe, std::vector<double> wavelengths_nm,
                       const Progress& progress)
    : wavelengths_nm_(std::move(wavelengths_nm)) {
    if (wavelengths_nm_.empty()) throw DomainError("a grid of wavelengths is empty");
    for (std::size_t i = 1; i < wavelengths_nm_.size(); ++i) {
        if (!(wavelengths_nm_[i] > wavelengths_nm_[i - 1])) {
            throw DomainError(fmt::format("wavelengths do not increase: {} nm after {} nm",
                                          wavelengths_nm_[i], wavelengths_nm_[i - 1]));
        }
    }
    paint::validate(recipe, wavelengths_nm_);
    for (double wavelength : wavelengths_nm_)
        index_.push_back(recipe.binder.index(wavelength).real());
    SharedProgress work(progress, static_cast<double>(wavelengths_nm_.size()));
    for (std::size_t first = 0; first < wavelengths_nm_.size(); first += kLanes) {
        const std::size_t count = std::min<std::size_t>(kLanes, wavelengths_nm_.size() - first);
        media_.emplace_back(recipe, std::span(wavelengths_nm_).subspan(first, count), &work);
        work.add(static_cast<double>(count));
        work.throw_if_stopped("computing the films of a flake");
    }
}

MediumGrid::Place MediumGrid::locate(double wavelength_nm) const {
    const auto above =
        std::upper_bound(wavelengths_nm_.begin(), wavelengths_nm_.end(), wavelength_nm);
    if (above == wavelengths_nm_.begin()) return {0, 0, 0};
    const auto upper = static_cast<std::size_t>(above - wavelengths_nm_.begin());
    if (above == wavelengths_nm_.end()) return {upper - 1, upper - 1, 0};
    return {upper - 1, upper, (wavelength_nm - *(above - 1)) / (*above - *(above - 1))};
}

double MediumGrid::index(double wavelength_nm) const {
    const Place place = locate(wavelength_nm);
    // Exact where the index is the same at both: equal lanes share walks.
    return index_[place.lower] + place.fraction * (index_[place.upper] - index_[place.lower]);
}

Medium MediumGrid::at(std::span<const double> wavelengths_nm) const {
    std::vector<Place> places;
    for (double wavelength : wavelengths_nm) places.push_back(locate(wavelength));

    // Interpolates the lanes that get(medium) returns, into the result's lanes.
    const auto interpolate = [&](auto&& get) {
        Lanes result{};
        for (std::size_t lane = 0; lane < places.size(); ++lane) {
            const auto [lower, upper, fraction] = places[lane];
            const double a = get(media_[lower / kLanes])[lower % kLanes];
            const double b = get(media_[upper / kLanes])[upper % kLanes];
            result[lane] = a + fraction * (b - a);
        }
        return result;
    };

    Medium medium = media_.front();
    medium.lane_count = static_cast<int>(places.size());
    medium.index = index(wavelengths_nm.front());
    medium.substrate_reflectance =
        interpolate([](const Medium& m) -> const Lanes& { return m.substrate_reflectance; });
    for (std::size_t s = 0; s < medium.slabs.size(); ++s) {
        Slab& slab = medium.slabs[s];
        slab.absorption_per_um = interpolate(
            [&](const Medium& m) -> const Lanes& { return m.slabs[s].absorption_per_um; });
        for (std::size_t f = 0; f < slab.flakes.size(); ++f) {
            const auto table = [&](auto of) {
                std::vector<Lanes> nodes(of(slab.flakes[f].optics).size());
                for (std::size_t i = 0; i < nodes.size(); ++i) {
                    nodes[i] = interpolate([&](const Medium& m) -> const Lanes& {
                        return of(m.slabs[s].flakes[f].optics)[i];
                    });
                }
                return nodes;
            };
            slab.flakes[f].optics = FlakeOptics(
                table([](const FlakeOptics& o) -> auto& { return o.reflectances(); }),
                table([](const FlakeOptics& o) -> auto& { return o.transmittances(); }));
        }
        for (std::size_t p = 0; p < slab.pigments.size(); ++p) {
            slab.pigments[p].scattering_per_um = interpolate([&](const Medium& m) -> const Lanes& {
                return m.slabs[s].pigments[p].scattering_per_um;
            });
            if (!slab.pigments[p].phase) continue;
            std::vector<Lanes> density(optics::PhaseFunction::kIntervals + 1);
            for (std::size_t node = 0; node < density.size(); ++node) {
                density[node] = interpolate([&](const Medium& m) -> const Lanes& {
                    return m.slabs[s].pigments[p].phase->density()[node];
                });
            }
            slab.pigments[p].phase = std::make_shared<PhaseTable>(std::move(density));
        }
        slab.sum_pigments();
    }
    return medium;
}

}  // namespace nacre::montecarlo
