#include "nacre/paint/recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/optics/thickness_rule.h"
#include "nacre/paint/orientation.h"
#include "nacre/paint/recipe_description.h"

namespace nacre::paint {

namespace {

using spectra::Spectrum;

constexpr double kNmPerUm = 1000;

/// Ranges, and whether the data of materials suffice.
class RecipeCheck final : public RangeCheck {
 public:
    explicit RecipeCheck(const std::vector<double>& wavelengths_nm)
        : wavelengths_nm_(wavelengths_nm) {}

    void material(const Field& field, optics::Material& material) override {
        if (field.real) check_real(field, material);
        for (double wavelength : wavelengths_nm_) {
            if (wavelength < material.first_wavelength_nm() ||
                wavelength > material.last_wavelength_nm()) {
                throw DomainError(fmt::format(
                    "{} = {}: its refractive index is known in [{}, {}] nm, not at {} nm",
                    path_of(field), material.name(), material.first_wavelength_nm(),
                    material.last_wavelength_nm(), wavelength));
            }
        }
    }

 private:
    void check_real(const Field& field, const optics::Material& material) {
        for (const optics::ComplexIndex& index : material.samples()) {
            double n = index.real();
            number(field, n);
            if (index.imag() != 0) {
                throw DomainError(fmt::format(
                    "{} = {}: must be real, but has k = {}; what the binder absorbs is written as "
                    "absorption_per_mm of the clearcoat or of a pigment",
                    path_of(field), material.name(), index.imag()));
            }
        }
    }

    const std::vector<double>& wavelengths_nm_;
};

/// Whether the parts of a law by quantiles are flakes that FlakeSizes knows.
void check_range(const std::string& path, const DiameterQuantiles& quantiles) {
    const auto [min_um, max_um] = size_ends_um(quantiles);
    if (kFlakeSize_um.contains(min_um) && kFlakeSize_um.contains(max_um)) return;
    try {
        size_parts(quantiles);  // whose parts are of means, within the ends
    } catch (const DomainError&) {
        throw DomainError(fmt::format(
            "{}d50_um = {}: with d10_um = {} and d90_um = {} flakes are of {:.3g} to {:.3g} um; "
            "must be in {}",
            path, quantiles.d50_um, quantiles.d10_um, quantiles.d90_um, min_um, max_um,
            kFlakeSize_um.text()));
    }
}

void check_sizes(const std::string& path, const FlakeSpecies& species) {
    double middle_um = species.diameter_um;
    const char* middle_key = "diameter_um";
    if (species.quantiles) {
        const auto& [d10, d50, d90] = quantiles_of(*species.quantiles);
        if (!(d10 < d50 && d50 < d90)) {
            throw DomainError(
                fmt::format("{}d50_um = {}: must be above d10_um = {} and below d90_um = {}", path,
                            d50, d10, d90));
        }
        middle_um = d50;
        middle_key = "d50_um";
        check_range(path, quantiles_of(*species.quantiles));
    } else if (!(species.diameter_spread_um <= species.diameter_um)) {
        throw DomainError(fmt::format("{}diameter_spread_um = {}: must be at most diameter_um = {}",
                                      path, species.diameter_spread_um, species.diameter_um));
    }
    if (!(2 * species.edge_um < middle_um)) {
        throw DomainError(fmt::format("{}edge_um = {}: must be below half of {} = {}", path,
                                      species.edge_um, middle_key, middle_um));
    }
}

void check_tilts(const std::string& path, const Orientation& orientation) {
    const std::vector<TiltDensity>& tilts = orientation.table->tilts;
    if (tilts.size() < 2) {
        throw DomainError(
            fmt::format("{}tilts: has {} entries; at least 2 are needed", path, tilts.size()));
    }
    bool any = false;
    for (std::size_t i = 0; i < tilts.size(); ++i) {
        any = any || tilts[i].density > 0;
        if (i > 0 && !(tilts[i].tilt_deg > tilts[i - 1].tilt_deg)) {
            throw DomainError(
                fmt::format("{}tilts[{}].tilt_deg = {}: must be above the one before it, {}", path,
                            i, tilts[i].tilt_deg, tilts[i - 1].tilt_deg));
        }
    }
    if (!any) throw DomainError(path + "tilts: must have a density above 0");
    try {
        beckmann_mixture(orientation);
    } catch (const DomainError& error) {
        throw DomainError(fmt::format("{}tilts: {}", path, error.what()));
    }
}

void check_orientation(const std::string& path, const Orientation& orientation) {
    const bool tabulated = orientation.law == Orientation::Law::tabulated;
    if (tabulated != orientation.table.has_value()) {
        throw DomainError(fmt::format(
            "{}distribution: tabulated needs tilts in place of alpha, and others alpha", path));
    }
    if (tabulated) return check_tilts(path, orientation);
    if (orientation.law != Orientation::Law::ggx) return;
    const auto require = [&](const char* name, double alpha) {
        if (limits::kGgxAlpha.contains(alpha)) return;
        throw DomainError(fmt::format("{}{} = {}: with ggx must be in {}", path, name, alpha,
                                      limits::kGgxAlpha.text()));
    };
    require("alpha", orientation.beckmann_alpha);
    if (orientation.alpha_bottom > 0) require("alpha_bottom", orientation.alpha_bottom);
}

void check_waviness(const std::string& path, const FlakeSpecies& species) {
    if (species.waviness == 0) return;
    Orientation orientation = species.orientation;
    if (orientation.alpha_bottom > 0) {
        orientation.beckmann_alpha = std::min(orientation.beckmann_alpha, orientation.alpha_bottom);
    }
    double alpha = INFINITY;
    for (const SlopeComponent& component : beckmann_mixture(orientation)) {
        alpha = std::min(alpha, component.alpha);
    }
    if (species.waviness > limits::kMaxRelativeWaviness * alpha) {
        throw DomainError(fmt::format(
            "{}waviness = {}: must be at most {:.4g}, {} times the alpha of the flattest flakes",
            path, species.waviness, limits::kMaxRelativeWaviness * alpha,
            limits::kMaxRelativeWaviness));
    }
}

/// What concerns several numbers at once: the energy that a flake reflects and transmits, and the
/// volume that all flakes fill.
void check_flakes(const std::string& key, const Layer& layer) {
    double filled = 0;
    for (std::size_t i = 0; i < layer.flakes.size(); ++i) {
        const FlakeSpecies& species = layer.flakes[i];
        check_sizes(fmt::format("{}.flakes[{}].", key, i), species);
        check_orientation(fmt::format("{}.flakes[{}].orientation.", key, i), species.orientation);
        check_waviness(fmt::format("{}.flakes[{}].", key, i), species);
        if (const auto* flake = std::get_if<PrescribedFlake>(&species.body)) {
            if (const auto wavelength = limits::wavelength_of_excess(*flake)) {
                throw DomainError(fmt::format(
                    "{}.flakes[{}].transmittance = {}: reflectance + transmittance = {} at {} nm; "
                    "must be at most 1",
                    key, i, flake->transmittance(*wavelength),
                    flake->reflectance(*wavelength) + flake->transmittance(*wavelength),
                    *wavelength));
            }
        }
        if (const auto* fraction = std::get_if<VolumeFraction>(&species.amount)) {
            filled += fraction->value;
            if (filled > 1) {
                throw DomainError(fmt::format(
                    "{}.flakes[{}].volume_fraction = {}: with the species before it the flakes "
                    "fill {} of the layer; must be at most 1",
                    key, i, fraction->value, filled));
            }
        }
    }
}

/// The volume that all pigments fill, and what a mass fraction comes to.
void check_pigments(const std::string& key, const Layer& layer) {
    double filled = 0;
    for (std::size_t i = 0; i < layer.pigments.size(); ++i) {
        const std::optional<PigmentAmount> amount = layer.pigments[i].amount();
        if (!amount) continue;
        const auto* mass = std::get_if<PigmentMass>(&*amount);
        filled += volume_fraction(*amount);
        if (filled > optics::kParticleVolumeRange.hi) {
            throw DomainError(fmt::format(
                "{}.pigment[{}].{} = {}: {} the particles fill {} of the layer; must be at most {}",
                key, i, mass ? "mass_fraction" : "volume_fraction",
                mass ? mass->fraction : volume_fraction(*amount),
                i > 0 ? "with the pigments before it" : "with these densities", filled,
                optics::kParticleVolumeRange.hi));
        }
    }
}

void check_spread(const Clearcoat& coat) {
    const double max_um = coat.thickness_um * limits::kMaxCoatSpread;
    // Rounded up, so that a third as a file spells it is allowed.
    if (coat.thickness_spread_um <= max_um * (1 + 1e-9)) return;
    throw DomainError(fmt::format(
        "clearcoat.thickness_spread_um = {}: must be in [0, {:.6g}] um, at most a third "
        "of thickness_um = {}",
        coat.thickness_spread_um, max_um, coat.thickness_um));
}

Spectrum scaled(const Spectrum& spectrum, double factor) {
    std::vector<double> values = spectrum.values();
    for (double& value : values) value *= factor;
    if (spectrum.is_constant()) return Spectrum(values[0]);
    return Spectrum(spectrum.wavelengths_nm(), std::move(values));
}

std::optional<PigmentAmount> stated(const OptionalPigmentAmount& amount) {
    if (const auto* volume = std::get_if<PigmentVolume>(&amount)) return *volume;
    if (const auto* mass = std::get_if<PigmentMass>(&amount)) return *mass;
    return std::nullopt;
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
    const auto mean_of = [](const optics::FilmPopulation& film) {
        return optics::mean_thickness_nm(film.thickness_nm, film.spread);
    };
    double thickness_nm = mean_of(platelet.core);
    const int sides = platelet.coated_sides == optics::Platelet::CoatedSides::both ? 2 : 1;
    for (const optics::FilmPopulation& coat : platelet.coats) {
        thickness_nm += sides * mean_of(coat);
    }
    return thickness_nm / kNmPerUm;
}

FlakeSizes FlakeSpecies::sizes() const {
    if (part) return *part;
    if (quantiles || edge_um > 0) {
        throw std::logic_error("flakes of several sizes were not expanded");
    }
    return {diameter_um, diameter_spread_um};
}

double FlakeSpecies::surface_alpha() const {
    const double alpha = orientation.beckmann_alpha;
    return waviness > 0 ? std::hypot(alpha, waviness) : alpha;
}

double FlakeSpecies::area_density_per_um() const {
    if (const auto* density = std::get_if<AreaDensity>(&amount)) return density->per_um;
    return std::get<VolumeFraction>(amount).value / thickness_um();
}

double PigmentMass::volume_fraction() const {
    const double pigment = fraction / density_g_per_cm3;
    return pigment / (pigment + (1 - fraction) / binder_density_g_per_cm3);
}

double volume_fraction(const PigmentAmount& amount) {
    if (const auto* mass = std::get_if<PigmentMass>(&amount)) return mass->volume_fraction();
    return std::get<PigmentVolume>(amount).fraction;
}

// K is that of diffuse light, which goes twice as far as its layer is thick [kubelka-munk-1931]. S makes two
// fluxes decay with depth as in the diffusion limit of the equation of transfer, derived here: K (K + 2 S) there
// is 3 sigma_a (1 - g) sigma_s where K << S. The error is of the order of K / S.
PigmentCoefficients PigmentKubelkaMunk::coefficients() const {
    return {scaled(constants.scattering_per_mm, 4.0 / 3 / (1 - anisotropy)),
            scaled(constants.absorption_per_mm, 0.5), anisotropy, amount};
}

std::optional<PigmentAmount> Pigment::amount() const {
    if (const auto* particles = std::get_if<PigmentParticles>(&body)) return particles->amount;
    if (const auto* given = std::get_if<PigmentCoefficients>(&body)) return stated(given->amount);
    return stated(std::get<PigmentKubelkaMunk>(body).amount);
}

std::optional<PigmentCoefficients> Pigment::layer_coefficients() const {
    if (std::holds_alternative<PigmentParticles>(body)) return std::nullopt;
    const auto* two_flux = std::get_if<PigmentKubelkaMunk>(&body);
    PigmentCoefficients coefficients =
        two_flux ? two_flux->coefficients() : std::get<PigmentCoefficients>(body);
    if (const auto filled = amount()) {
        const double fraction = volume_fraction(*filled);
        coefficients.scattering_per_mm = scaled(coefficients.scattering_per_mm, fraction);
        coefficients.absorption_per_mm = scaled(coefficients.absorption_per_mm, fraction);
        coefficients.amount = PigmentUnstated{};
    }
    return coefficients;
}

double Recipe::thickness_um() const {
    double sum = clearcoat ? clearcoat->thickness_um : 0;
    for (const Layer& layer : layers) sum += layer.thickness_um;
    return sum;
}

double OrangePeel::slope() const {
    double squares = 0;
    for (const WaveBand& band : kWaveBands) squares += this->*band.slope * this->*band.slope;
    return std::sqrt(squares);
}

std::array<double, 2> FlakeLean::tangents() const {
    const double tangent = std::tan(tilt_deg * kDegree);
    return {tangent * std::cos(azimuth_deg * kDegree), tangent * std::sin(azimuth_deg * kDegree)};
}

std::optional<FlakeLean> Recipe::flake_lean() const {
    const bool has_flakes = std::any_of(layers.begin(), layers.end(),
                                        [](const Layer& layer) { return !layer.flakes.empty(); });
    return lean && lean->tilt_deg > 0 && has_flakes ? lean : std::nullopt;
}

std::optional<OrangePeel> Recipe::orange_peel() const {
    if (!clearcoat || !clearcoat->orange_peel || clearcoat->orange_peel->slope() == 0) {
        return std::nullopt;
    }
    return clearcoat->orange_peel;
}

double Recipe::coat_spread() const {
    if (!clearcoat || clearcoat->thickness_spread_um == 0) return 0;
    if (clearcoat->absorption_per_mm.max() == 0) return 0;
    return clearcoat->thickness_spread_um / clearcoat->thickness_um;
}

void validate(const Recipe& recipe, const std::vector<double>& wavelengths_nm) {
    for (double wavelength : wavelengths_nm) {
        if (!limits::kWavelength.contains(wavelength)) {
            throw DomainError(fmt::format("wavelength = {}: must be in {}", wavelength,
                                          limits::kWavelength.text()));
        }
    }
    RecipeCheck check(wavelengths_nm);
    Described::to_inspect(recipe).accept(check);
    if (recipe.clearcoat) check_spread(*recipe.clearcoat);
    if (recipe.layers.empty() && !recipe.microfacet) {
        throw DomainError("layer: a paint needs at least one layer (or a microfacet table)");
    }
    for (std::size_t i = 0; i < recipe.layers.size(); ++i) {
        const std::string key = fmt::format("layer[{}]", i);
        check_flakes(key, recipe.layers[i]);
        check_pigments(key, recipe.layers[i]);
    }
}

void require_no_lean(const Recipe& recipe, std::string_view what) {
    if (!recipe.flake_lean()) return;
    throw DomainError(fmt::format(
        "lean.tilt_deg = {}: {} the same in all azimuths, which a paint whose flakes lean is not; "
        "must be 0",
        recipe.lean->tilt_deg, what));
}

}  // namespace nacre::paint
