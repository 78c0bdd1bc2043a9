#include "nacre/fit/drawdown.h"

#include <ceres/ceres.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/quiet_ceres.h"
#include "nacre/core/text.h"
#include "nacre/spectra/lab.h"
#include "nacre/spectra/xyz.h"

namespace nacre::fit {

namespace {

using spectra::Spectrum;

void require_in(double value, const Range& range, const char* what) {
    if (!range.contains(value)) {
        throw DomainError(fmt::format("{} = {}: must be in {}", what, value, range.text()));
    }
}

Spectrum spectrum_of(const std::vector<double>& wavelengths_nm, const std::vector<double>& values) {
    return values.size() == 1 ? Spectrum(values[0]) : Spectrum(wavelengths_nm, values);
}

/// The pigment, so much of it.
paint::Pigment of_volume(paint::Pigment pigment, double volume_fraction) {
    std::visit([&](auto& body) { body.amount = paint::PigmentVolume{volume_fraction}; },
               pigment.body);
    return pigment;
}

/// A paint of nothing but the pigment and perhaps white, and the ground.
paint::Recipe recipe_of(const DrawdownReading& reading, const DrawdownSettings& settings,
                        Spectrum scattering_per_mm, Spectrum absorption_per_mm, Spectrum ground) {
    paint::Recipe recipe;
    recipe.binder = settings.binder;
    paint::Layer& layer = recipe.layers.emplace_back();
    layer.thickness_um = reading.opaque ? kOpaqueThickness_um : reading.thickness_um;
    if (reading.volume_fraction > 0) {
        layer.pigments.push_back({paint::PigmentCoefficients{
            std::move(scattering_per_mm), std::move(absorption_per_mm), settings.anisotropy,
            paint::PigmentVolume{reading.volume_fraction}}});
    }
    if (reading.white_volume_fraction > 0) {
        layer.pigments.push_back(of_volume(*settings.white, reading.white_volume_fraction));
    }
    recipe.substrate_reflectance = std::move(ground);
    return recipe;
}

/// An application with its ground inside the binder.
struct Application {
    const DrawdownReading* reading;
    std::vector<double> ground;
};

std::vector<Application> applications_of(const Drawdown& drawdown,
                                         const DrawdownSettings& settings) {
    std::vector<Application> applications;
    for (const DrawdownReading& reading : drawdown.readings) {
        if (reading.is_bare()) continue;
        if (reading.opaque) {
            applications.push_back(
                {&reading, std::vector<double>(drawdown.wavelengths_nm.size(), 0.0)});
            continue;
        }
        const auto bare = std::find_if(drawdown.readings.begin(), drawdown.readings.end(),
                                       [&](const DrawdownReading& other) {
                                           return other.is_bare() && other.ground == reading.ground;
                                       });
        if (bare == drawdown.readings.end()) {
            throw DomainError(
                fmt::format("ground = {}: there is no reading of it bare, with thickness_um = 0",
                            reading.ground));
        }
        applications.push_back(
            {&reading, settings.matt_ground
                           ? bare->reflectance
                           : ground_inside(bare->reflectance, drawdown.wavelengths_nm,
                                           settings.binder, settings.geometry)});
    }
    return applications;
}

/// Whether two readings can tell scattering from absorption. What hides its ground shows one ratio:
/// (K_w w + K v)/(S_w w + S v) of the pigment's volume v in the white's w.
bool tell_apart(const DrawdownReading& a, const DrawdownReading& b) {
    // Compared to what rounding leaves of products.
    const auto differ = [](double x, double y) {
        return std::abs(x - y) > 1e-9 * std::max(std::abs(x), std::abs(y));
    };
    const double v = a.volume_fraction, w = a.white_volume_fraction;
    if (a.opaque != b.opaque) return true;
    if (differ(v * b.white_volume_fraction, b.volume_fraction * w)) return true;
    if (a.opaque) return false;
    return a.ground != b.ground || differ(a.thickness_um * v, b.thickness_um * b.volume_fraction);
}

bool tell_apart(const std::vector<Application>& applications) {
    for (const Application& a : applications) {
        if (a.reading->volume_fraction == 0) continue;  // white alone says nothing of the pigment
        for (const Application& b : applications) {
            if (b.reading->volume_fraction > 0 && tell_apart(*a.reading, *b.reading)) return true;
        }
    }
    return false;
}

/// Whether absorption alone can be told: from tints.
bool tell_absorption(const std::vector<Application>& applications) {
    return std::any_of(applications.begin(), applications.end(), [](const Application& a) {
        return a.reading->volume_fraction > 0 && a.reading->white_volume_fraction > 0;
    });
}

void check(const Drawdown& drawdown, const DrawdownSettings& settings) {
    if (drawdown.wavelengths_nm.empty()) throw DomainError("drawdown: has no wavelengths");
    if (drawdown.readings.size() > measure::kMaxDrawdownReadings) {
        throw DomainError(fmt::format("drawdown: has {} readings; at most {} are allowed",
                                      drawdown.readings.size(), measure::kMaxDrawdownReadings));
    }
    bool any_white = false;
    for (const DrawdownReading& reading : drawdown.readings) {
        require_in(reading.thickness_um, measure::kDrawdownThickness, "thickness_um");
        const double white = reading.white_volume_fraction;
        if (white != 0) {
            require_in(white, optics::kParticleVolumeRange, "white_volume_fraction");
            any_white = true;
        }
        if (!reading.is_bare() && (white == 0 || reading.volume_fraction != 0)) {
            require_in(reading.volume_fraction, optics::kParticleVolumeRange, "volume_fraction");
        }
        if (reading.reflectance.size() != drawdown.wavelengths_nm.size()) {
            throw DomainError(fmt::format("drawdown: a reading has {} values at {} wavelengths",
                                          reading.reflectance.size(),
                                          drawdown.wavelengths_nm.size()));
        }
        for (const double value : reading.reflectance) {
            require_in(value, measure::kDrawdownReflectance, "reflectance");
        }
    }
    if (any_white && !settings.white) {
        throw DomainError(
            "white_volume_fraction: there are tints in white, but nothing says which white: its "
            "coefficients must be known");
    }
    if (!any_white && settings.white) {
        throw DomainError(
            "white_volume_fraction: a white is given, but no reading is a tint: its volume "
            "fraction must be in (0, 0.5] in at least one");
    }
    require_in(settings.anisotropy, {-1, 1, "", true, true}, "anisotropy");
    if (settings.noise) require_in(*settings.noise, {0, 1, "", true}, "noise");
}

/// The applications at one wavelength, as a function of the two coefficients, each times the
/// thickest application's pigment: optical depths, of which 1 is a typical size.
class OneWavelength {
 public:
    OneWavelength(const std::vector<Application>& applications, const DrawdownSettings& settings,
                  std::size_t index, double wavelength_nm, double scale_mm)
        : applications_(applications),
          settings_(settings),
          index_(index),
          wavelengths_nm_{wavelength_nm},
          scale_mm_(scale_mm) {}

    std::size_t size() const { return applications_.size(); }

    /// @param depth  of scattering and absorption
    std::vector<double> reflectances(std::array<double, 2> depth) const {
        std::vector<double> out;
        for (const Application& application : applications_) {
            out.push_back(drawdown_reflectance(
                recipe_of(*application.reading, settings_, depth[0] / scale_mm_,
                          depth[1] / scale_mm_, application.ground[index_]),
                wavelengths_nm_, settings_.geometry)[0]);
        }
        return out;
    }

    /// Reflectances less those measured.
    std::vector<double> residuals(std::vector<double> reflectances) const {
        for (std::size_t k = 0; k < size(); ++k) {
            reflectances[k] -= applications_[k].reading->reflectance[index_];
        }
        return reflectances;
    }

    /// Derivatives of the reflectances, which are `here` at these depths, by differences ahead: good
    /// enough for steps, and for standard errors.
    std::vector<std::array<double, 2>> jacobian(std::array<double, 2> depth,
                                                const std::vector<double>& here) const {
        std::vector<std::array<double, 2>> out(size());
        for (int i = 0; i < 2; ++i) {
            // Beside a white a little scattering changes so little that a small step drowns in the
            // error of the solver.
            const bool drowned = i == 0 && settings_.white;
            const double step = drowned ? 1e-2 * (1 + depth[i]) : 1e-5 + 1e-4 * depth[i];
            std::array<double, 2> ahead = depth;
            ahead[i] += step;
            const std::vector<double> there = reflectances(ahead);
            for (std::size_t k = 0; k < size(); ++k) out[k][i] = (there[k] - here[k]) / step;
        }
        return out;
    }

 private:
    const std::vector<Application>& applications_;
    const DrawdownSettings& settings_;
    std::size_t index_;
    std::vector<double> wavelengths_nm_;
    double scale_mm_;
};

/// Of both depths, or of that of absorption alone, without scattering.
class DrawdownResiduals final : public ceres::CostFunction {
 public:
    DrawdownResiduals(const OneWavelength& readings, int first)
        : readings_(readings), first_(first) {
        mutable_parameter_block_sizes()->push_back(2 - first);
        set_num_residuals(static_cast<int>(readings.size()));
    }
    bool Evaluate(double const* const* parameters, double* residuals,
                  double** jacobians) const override {
        std::array<double, 2> depth{};
        std::copy_n(parameters[0], 2 - first_, depth.begin() + first_);
        const std::vector<double> reflectances = readings_.reflectances(depth);
        const std::vector<double> r = readings_.residuals(reflectances);
        std::copy(r.begin(), r.end(), residuals);
        if (!jacobians || !jacobians[0]) return true;
        double* entry = jacobians[0];
        for (const std::array<double, 2>& row : readings_.jacobian(depth, reflectances)) {
            entry = std::copy(row.begin() + first_, row.end(), entry);
        }
        return true;
    }

 private:
    const OneWavelength& readings_;
    int first_;
};

constexpr double kMaxDepth = 1e4;
/// How far light goes in an opaque tint, about: some mean free paths in a tenth of rutile.
constexpr double kPathInOpaque_um = 5;

/// For each wavelength the best of a grid of depths, from clear to opaque, all wavelengths at once.
std::vector<std::array<double, 2>> screened(const std::vector<Application>& applications,
                                            const DrawdownSettings& settings,
                                            const std::vector<double>& wavelengths_nm,
                                            double scale_mm, int first, SharedProgress& work) {
    const std::size_t count = wavelengths_nm.size();
    std::vector<std::array<double, 2>> best(count);
    std::vector<double> least(count, std::numeric_limits<double>::infinity());
    const std::vector<double> scatterings =
        first == 0 ? std::vector<double>{0.03, 0.3, 1.0, 3.0, 15.0} : std::vector<double>{0.0};
    for (const double scattering : scatterings) {
        for (const double absorption : {0.003, 0.03, 0.3, 1.0, 5.0}) {
            std::vector<double> error(count, 0.0);
            for (const Application& application : applications) {
                const std::vector<double> reflectance =
                    drawdown_reflectance(recipe_of(*application.reading, settings,
                                                   scattering / scale_mm, absorption / scale_mm,
                                                   spectrum_of(wavelengths_nm, application.ground)),
                                         wavelengths_nm, settings.geometry);
                for (std::size_t i = 0; i < count; ++i) {
                    error[i] += std::pow(reflectance[i] - application.reading->reflectance[i], 2);
                }
                work.throw_if_stopped("the estimate of the pigment");
            }
            for (std::size_t i = 0; i < count; ++i) {
                if (!(error[i] < least[i])) continue;
                least[i] = error[i];
                best[i] = {scattering, absorption};
            }
        }
    }
    return best;
}

struct FoundDepths {
    std::array<double, 2> depth{};
    std::vector<double> reflectance;
    /// (J^T J)^-1 on its diagonal; infinite where a number has no effect of its own.
    std::array<double, 2> variance{};
};

/// @param first  1: there is no scattering
FoundDepths found_depths(const OneWavelength& readings, std::array<double, 2> start, int first) {
    FoundDepths found{start, {}, {}};
    DrawdownResiduals function(readings, first);
    ceres::Problem::Options ownership;
    ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::Problem problem(ownership);
    double* const sought = found.depth.data() + first;
    problem.AddResidualBlock(&function, nullptr, sought);
    for (int i = 0; i < 2 - first; ++i) {
        problem.SetParameterLowerBound(sought, i, 0.0);
        problem.SetParameterUpperBound(sought, i, kMaxDepth);
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.num_threads = 1;
    options.logging_type = ceres::SILENT;
    options.max_num_iterations = 50;
    options.function_tolerance = 1e-7;
    options.parameter_tolerance = 1e-6;
    options.gradient_tolerance = 1e-12;
    ceres::Solver::Summary summary;
    const QuietCeres quiet;
    ceres::Solve(options, &problem, &summary);

    found.reflectance = readings.reflectances(found.depth);
    double aa = 0, ab = 0, bb = 0;
    for (const std::array<double, 2>& row : readings.jacobian(found.depth, found.reflectance)) {
        aa += row[0] * row[0];
        ab += row[0] * row[1];
        bb += row[1] * row[1];
    }
    const double determinant = aa * bb - ab * ab;
    const double infinity = std::numeric_limits<double>::infinity();
    if (first == 1) {
        found.variance = {infinity, bb > 0 ? 1 / bb : infinity};
        return found;
    }
    const bool determined = determinant > 1e-14 * aa * bb;
    found.variance = {determined ? bb / determinant : infinity,
                      determined ? aa / determinant : infinity};
    return found;
}

Vec3d lab_of(const std::vector<double>& wavelengths_nm, const std::vector<double>& reflectance) {
    constexpr auto kLight = spectra::Illuminant::D65;
    constexpr auto kEye = spectra::Observer::cie1964_10deg;
    return spectra::xyz_to_lab(
        spectra::reflectance_to_xyz(Spectrum(wavelengths_nm, reflectance), kLight, kEye),
        spectra::white_point(kLight, kEye));
}

}  // namespace

std::vector<std::string> drawdown_geometry_words() {
    return {"d8-included", "d8-excluded", "45-0"};
}

PigmentEstimate estimate_pigment(const Drawdown& drawdown, const DrawdownSettings& settings,
                                 const Progress& progress) {
    check(drawdown, settings);
    const std::vector<Application> applications = applications_of(drawdown, settings);
    const bool both = tell_apart(applications);
    if (!both && !tell_absorption(applications)) {
        throw DomainError(
            "drawdown: needs the paint over two grounds (such as black and white), in two "
            "thicknesses or amounts, or in tints of white; what is there cannot tell scattering "
            "from absorption");
    }
    const int first = both ? 0 : 1;
    double scale_mm = 0;
    for (const Application& a : applications) {
        constexpr double kMmPerUm = 1e-3;
        const double path_um = a.reading->opaque ? kPathInOpaque_um : a.reading->thickness_um;
        scale_mm = std::max(scale_mm, a.reading->volume_fraction * path_um * kMmPerUm);
    }

    const std::size_t count = drawdown.wavelengths_nm.size();
    std::vector<FoundDepths> found(count);
    SharedProgress work(progress, static_cast<double>(count));
    const std::vector<std::array<double, 2>> start =
        screened(applications, settings, drawdown.wavelengths_nm, scale_mm, first, work);
    parallel_for(0, count, [&](std::size_t i) {
        if (work.stopped()) return;
        found[i] = found_depths({applications, settings, i, drawdown.wavelengths_nm[i], scale_mm},
                                start[i], first);
        work.add();
    });
    work.throw_if_stopped("the estimate of the pigment");

    PigmentEstimate out;
    out.wavelengths_nm = drawdown.wavelengths_nm;
    out.scattering_assumed = !both;
    double squares = 0;
    for (const Application& a : applications) {
        DrawdownResidual& residual = out.residuals.emplace_back();
        residual.ground = a.reading->ground;
        residual.thickness_um = a.reading->thickness_um;
        residual.volume_fraction = a.reading->volume_fraction;
        residual.white_volume_fraction = a.reading->white_volume_fraction;
        residual.opaque = a.reading->opaque;
        residual.measured = a.reading->reflectance;
        const std::size_t k = out.residuals.size() - 1;
        for (std::size_t i = 0; i < count; ++i) {
            residual.modelled.push_back(found[i].reflectance[k]);
            squares += std::pow(residual.modelled[i] - residual.measured[i], 2);
        }
        if (count > 1 && out.wavelengths_nm.front() <= 400 && out.wavelengths_nm.back() >= 700) {
            residual.delta_e_2000 =
                spectra::delta_e_2000(lab_of(out.wavelengths_nm, residual.measured),
                                      lab_of(out.wavelengths_nm, residual.modelled));
        }
    }
    const double values = static_cast<double>(applications.size() * count);
    const double freedom = values - (2 - first) * static_cast<double>(count);
    out.rms_residual = std::sqrt(squares / values);
    out.noise = settings.noise;
    if (!out.noise && freedom > 0) out.noise = std::sqrt(squares / freedom);
    for (std::size_t i = 0; i < count; ++i) {
        const auto error = [&](int j) -> std::optional<double> {
            if (!both && j == 0) return std::numeric_limits<double>::infinity();
            if (!out.noise) return std::nullopt;
            return *out.noise * std::sqrt(found[i].variance[j]) / scale_mm;
        };
        out.scattering_per_mm.push_back(found[i].depth[0] / scale_mm);
        out.absorption_per_mm.push_back(found[i].depth[1] / scale_mm);
        out.scattering_error.push_back(error(0));
        out.absorption_error.push_back(error(1));
        // Where the noise is unknown, a reading is taken to be repeatable to this.
        constexpr double kRepeatable = 1e-3;
        const double spread = out.noise.value_or(kRepeatable) * std::sqrt(found[i].variance[0]);
        if (!(spread > found[i].depth[0] / 2)) continue;
        if (settings.white) {
            out.absorption_only_nm.push_back(out.wavelengths_nm[i]);
        } else if (spread > 0.1) {
            out.hidden_nm.push_back(out.wavelengths_nm[i]);
        }
    }
    return out;
}

std::string DrawdownResidual::thickness_text(const char* unit) const {
    return opaque ? "opaque" : fmt::format("{} {}", thickness_um, unit);
}

std::string DrawdownResidual::place_text() const {
    std::string text;
    if (white_volume_fraction > 0) {
        text += fmt::format(" in {:.4g} % white", 100 * white_volume_fraction);
    }
    if (!opaque) text += " over " + ground;
    return text;
}

paint::Pigment PigmentEstimate::pigment(const std::string& name, double anisotropy) const {
    // Digits that a reading has; it is people who read them.
    const auto spectrum = [&](std::vector<double> values) {
        for (double& value : values) value = *parse_number(fmt::format("{:.5g}", value));
        return spectrum_of(wavelengths_nm, values);
    };
    return {paint::PigmentCoefficients{spectrum(scattering_per_mm), spectrum(absorption_per_mm),
                                       anisotropy},
            name};
}

}  // namespace nacre::fit
