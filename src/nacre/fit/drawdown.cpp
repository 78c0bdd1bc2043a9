#include "nacre/fit/drawdown.h"

#include <ceres/ceres.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/quadrature.h"
#include "nacre/core/quiet_ceres.h"
#include "nacre/core/text.h"
#include "nacre/optics/fresnel.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/lab.h"
#include "nacre/spectra/xyz.h"

namespace nacre::fit {

namespace {

using spectra::Spectrum;

constexpr double kPi = std::numbers::pi;
constexpr double kSphere_rad = 8 * kPi / 180;
constexpr double kLamp_rad = 45 * kPi / 180;
/// Nodes over the polar angle, and over half a turn: the error of a hemispherical reflectance is
/// below 1e-6 (a test compares with twice as many).
constexpr int kPolarNodes = 24;
constexpr int kAzimuths = 8;

void require_in(double value, const Range& range, const char* what) {
    if (!range.contains(value)) {
        throw DomainError(fmt::format("{} = {}: must be in {}", what, value, range.text()));
    }
}

double surface_reflectance(double ior, double theta) {
    return optics::fresnel_dielectric(ior, std::cos(theta));
}

/// Fraction of diffuse light inside the binder that its surface sends back: Int R(mu) 2 mu dmu.
double internal_reflectance(double ior) {
    const double critical = ior > 1 ? std::sqrt(1 - 1 / (ior * ior)) : 0.0;
    // Beyond the critical angle all of it; up to there an integral in the angle outside, where it
    // is smooth: mu_i dmu_i = mu_o dmu_o / n^2.
    const Quadrature rule = gauss_legendre(64, 0, kPi / 2);
    double sum = critical * critical;
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
        const double theta = rule.nodes[k];
        sum += rule.weights[k] * 2 * std::sin(theta) * std::cos(theta) *
               surface_reflectance(ior, theta) / (ior * ior);
    }
    return sum;
}

/// Of a Lambertian ground of reflectance R under a smooth surface an instrument reads
/// gloss + gain R / (1 - back R).
struct SurfaceOverGround {
    double gloss, gain, back;

    SurfaceOverGround(double ior, DrawdownGeometry geometry) : back(internal_reflectance(ior)) {
        const double lamp = geometry == DrawdownGeometry::angle_45_0 ? kLamp_rad : kSphere_rad;
        const double in = 1 - surface_reflectance(ior, lamp);
        gloss = geometry == DrawdownGeometry::diffuse_8_included ? 1 - in : 0;
        gain = geometry == DrawdownGeometry::angle_45_0
                   ? in * (1 - surface_reflectance(ior, 0)) / (ior * ior)
                   : in * (1 - back);
    }
    double inside(double measured) const {
        const double x = (measured - gloss) / gain;
        return x / (1 + back * x);
    }
};

Spectrum spectrum_of(const std::vector<double>& wavelengths_nm, const std::vector<double>& values) {
    return values.size() == 1 ? Spectrum(values[0]) : Spectrum(wavelengths_nm, values);
}

/// A paint of nothing but the pigment, and the ground.
paint::Recipe recipe_of(const DrawdownReading& reading, const DrawdownSettings& settings,
                        Spectrum scattering_per_mm, Spectrum absorption_per_mm, Spectrum ground) {
    paint::Recipe recipe;
    recipe.binder = settings.binder;
    paint::Layer& layer = recipe.layers.emplace_back();
    layer.thickness_um = reading.thickness_um;
    layer.pigments.push_back({paint::PigmentCoefficients{
        std::move(scattering_per_mm), std::move(absorption_per_mm), settings.anisotropy,
        paint::PigmentVolume{reading.volume_fraction}}});
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
        if (reading.thickness_um == 0) continue;
        const auto bare = std::find_if(
            drawdown.readings.begin(), drawdown.readings.end(), [&](const DrawdownReading& other) {
                return other.thickness_um == 0 && other.ground == reading.ground;
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

/// Whether two readings can tell scattering from absorption.
bool tell_apart(const std::vector<Application>& applications) {
    for (const Application& a : applications) {
        for (const Application& b : applications) {
            if (a.reading->ground != b.reading->ground ||
                a.reading->thickness_um * a.reading->volume_fraction !=
                    b.reading->thickness_um * b.reading->volume_fraction) {
                return true;
            }
        }
    }
    return false;
}

void check(const Drawdown& drawdown, const DrawdownSettings& settings) {
    if (drawdown.wavelengths_nm.empty()) throw DomainError("drawdown: has no wavelengths");
    if (drawdown.readings.size() > measure::kMaxDrawdownReadings) {
        throw DomainError(fmt::format("drawdown: has {} readings; at most {} are allowed",
                                      drawdown.readings.size(), measure::kMaxDrawdownReadings));
    }
    for (const DrawdownReading& reading : drawdown.readings) {
        require_in(reading.thickness_um, measure::kDrawdownThickness, "thickness_um");
        if (reading.thickness_um > 0) {
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
            const double step = 1e-5 + 1e-4 * depth[i];
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

class DrawdownResiduals final : public ceres::CostFunction {
 public:
    explicit DrawdownResiduals(const OneWavelength& readings) : readings_(readings) {
        mutable_parameter_block_sizes()->push_back(2);
        set_num_residuals(static_cast<int>(readings.size()));
    }
    bool Evaluate(double const* const* parameters, double* residuals,
                  double** jacobians) const override {
        const std::array<double, 2> depth = {parameters[0][0], parameters[0][1]};
        const std::vector<double> reflectances = readings_.reflectances(depth);
        const std::vector<double> r = readings_.residuals(reflectances);
        std::copy(r.begin(), r.end(), residuals);
        if (!jacobians || !jacobians[0]) return true;
        double* entry = jacobians[0];
        for (const std::array<double, 2>& row : readings_.jacobian(depth, reflectances)) {
            for (const double value : row) *entry++ = value;
        }
        return true;
    }

 private:
    const OneWavelength& readings_;
};

constexpr double kMaxDepth = 1e4;

/// For each wavelength the best of a grid of depths, from clear to opaque, all wavelengths at once.
std::vector<std::array<double, 2>> screened(const std::vector<Application>& applications,
                                            const DrawdownSettings& settings,
                                            const std::vector<double>& wavelengths_nm,
                                            double scale_mm, SharedProgress& work) {
    const std::size_t count = wavelengths_nm.size();
    std::vector<std::array<double, 2>> best(count);
    std::vector<double> least(count, std::numeric_limits<double>::infinity());
    for (const double scattering : {0.03, 0.3, 1.0, 3.0, 15.0}) {
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
                work.require_going("the estimate of the pigment");
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

FoundDepths found_depths(const OneWavelength& readings, std::array<double, 2> start) {
    FoundDepths found{start, {}, {}};
    DrawdownResiduals function(readings);
    ceres::Problem::Options ownership;
    ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::Problem problem(ownership);
    problem.AddResidualBlock(&function, nullptr, found.depth.data());
    for (int i = 0; i < 2; ++i) {
        problem.SetParameterLowerBound(found.depth.data(), i, 0.0);
        problem.SetParameterUpperBound(found.depth.data(), i, kMaxDepth);
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

std::vector<double> ground_inside(const std::vector<double>& measured,
                                  const std::vector<double>& wavelengths_nm,
                                  const optics::Material& binder, DrawdownGeometry geometry) {
    std::vector<double> inside;
    for (std::size_t i = 0; i < measured.size(); ++i) {
        const SurfaceOverGround surface(binder.index(wavelengths_nm[i]).real(), geometry);
        const double value = surface.inside(measured[i]);
        // A glossy black below the gloss of its own surface by less than an instrument's error is
        // black.
        constexpr double kInstrumentError = 0.01;
        if (value < -kInstrumentError || value > 1 + kInstrumentError) {
            throw DomainError(fmt::format(
                "reflectance = {} of the bare ground at {} nm: under a surface of the binder's "
                "index {:.4g} it would take a ground of {:.4g}, which must be in [0, 1]; was the "
                "ground read without a surface (matt), or by another geometry?",
                measured[i], wavelengths_nm[i], binder.index(wavelengths_nm[i]).real(), value));
        }
        inside.push_back(std::clamp(value, 0.0, 1.0));
    }
    return inside;
}

std::vector<double> drawdown_reflectance(const paint::Recipe& recipe,
                                         const std::vector<double>& wavelengths_nm,
                                         DrawdownGeometry geometry, const Progress& progress) {
    const solver::SolvedPaint paint = solver::solve(recipe, wavelengths_nm, {}, nullptr, progress);
    std::vector<double> factor(wavelengths_nm.size(), 0.0);
    if (geometry == DrawdownGeometry::angle_45_0) {
        factor = paint.brdf(kLamp_rad, 0, kPi);
        for (double& value : factor) value *= kPi;
        return factor;
    }
    // What a lamp at 8 deg sends into all directions: by reciprocity what a sphere sends to 8 deg.
    static const Quadrature rule = gauss_legendre(kPolarNodes, 0, kPi / 2);
    const bool round = paint.report.orders <= 1;
    const int azimuths = round ? 1 : kAzimuths;
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
        const double theta = rule.nodes[k];
        const double weight =
            rule.weights[k] * 2 * kPi * std::sin(theta) * std::cos(theta) / azimuths;
        for (int j = 0; j < azimuths; ++j) {
            const std::vector<double> f =
                paint.brdf(kSphere_rad, theta, kPi * (j + 0.5) / azimuths);
            for (std::size_t i = 0; i < factor.size(); ++i) factor[i] += weight * f[i];
        }
    }
    if (geometry == DrawdownGeometry::diffuse_8_included) {
        for (std::size_t i = 0; i < factor.size(); ++i) {
            factor[i] +=
                surface_reflectance(recipe.binder.index(wavelengths_nm[i]).real(), kSphere_rad);
        }
    }
    return factor;
}

PigmentEstimate estimate_pigment(const Drawdown& drawdown, const DrawdownSettings& settings,
                                 const Progress& progress) {
    check(drawdown, settings);
    const std::vector<Application> applications = applications_of(drawdown, settings);
    if (!tell_apart(applications)) {
        throw DomainError(
            "drawdown: needs the paint over two grounds (such as black and white), or in two "
            "thicknesses or amounts; what is there cannot tell scattering from absorption");
    }
    double scale_mm = 0;
    for (const Application& a : applications) {
        constexpr double kMmPerUm = 1e-3;
        scale_mm =
            std::max(scale_mm, a.reading->volume_fraction * a.reading->thickness_um * kMmPerUm);
    }

    const std::size_t count = drawdown.wavelengths_nm.size();
    std::vector<FoundDepths> found(count);
    SharedProgress work(progress, static_cast<double>(count));
    const std::vector<std::array<double, 2>> start =
        screened(applications, settings, drawdown.wavelengths_nm, scale_mm, work);
    parallel_for(0, count, [&](std::size_t i) {
        if (work.stopped()) return;
        found[i] = found_depths({applications, settings, i, drawdown.wavelengths_nm[i], scale_mm},
                                start[i]);
        work.add();
    });
    work.require_going("the estimate of the pigment");

    PigmentEstimate out;
    out.wavelengths_nm = drawdown.wavelengths_nm;
    double squares = 0;
    for (const Application& a : applications) {
        DrawdownResidual& residual = out.residuals.emplace_back();
        residual.ground = a.reading->ground;
        residual.thickness_um = a.reading->thickness_um;
        residual.volume_fraction = a.reading->volume_fraction;
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
    const double freedom = values - 2 * static_cast<double>(count);
    out.rms_residual = std::sqrt(squares / values);
    out.noise = settings.noise;
    if (!out.noise && freedom > 0) out.noise = std::sqrt(squares / freedom);
    for (std::size_t i = 0; i < count; ++i) {
        const auto error = [&](int j) -> std::optional<double> {
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
        if (spread > found[i].depth[0] / 2 && spread > 0.1) {
            out.hidden_nm.push_back(out.wavelengths_nm[i]);
        }
    }
    return out;
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
