#include "nacre/fit/target.h"

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/spectra/lab.h"
#include "nacre/spectra/spectrum.h"

namespace nacre::fit {

namespace {

constexpr double kStep_nm[] = {40, 20};  // screening, coarse
// Colours given as L*a*b* alone cannot be summed over as few wavelengths as those of the paint: at
// 40 nm that would shift them by several Delta E, at 20 nm by 1 at most.
constexpr double kStepWithoutSpectra_nm = 20;

bool has_all_spectra(const measure::Measurement& m) {
    return std::all_of(m.readings.begin(), m.readings.end(),
                       [](const auto& reading) { return !reading.reflectance_factor.empty(); });
}

/// Every n-th of the wavelengths, n such that their step is about that wanted; eight at least.
std::size_t stride_of(const std::vector<double>& wavelengths_nm, double wanted_nm) {
    const std::size_t count = wavelengths_nm.size();
    if (count < 2) return 1;
    const double step =
        (wavelengths_nm.back() - wavelengths_nm.front()) / static_cast<double>(count - 1);
    const auto stride = static_cast<std::size_t>(std::max(1.0, std::round(wanted_nm / step)));
    return (count - 1) / stride + 1 >= 8 ? stride : 1;
}

std::vector<double> every(const std::vector<double>& values, std::size_t stride) {
    std::vector<double> chosen;
    for (std::size_t i = 0; i < values.size(); i += stride) chosen.push_back(values[i]);
    return chosen;
}

/// The colours by the same sums over fewer wavelengths, so that a paint that agrees at all of them
/// agrees at those.
measure::Measurement seen_coarsely(measure::Measurement standard, std::size_t stride) {
    standard.conditions.aperture = {};
    if (stride == 1 || !has_all_spectra(standard)) return standard;
    standard.wavelengths_nm = every(standard.wavelengths_nm, stride);
    for (measure::Reading& reading : standard.readings) {
        reading = measure::coloured(reading.geometry, standard.wavelengths_nm,
                                    every(reading.reflectance_factor, stride), standard.conditions);
    }
    return standard;
}

}  // namespace

measure::Measurement restated(const measure::Measurement& measurement,
                              const measure::Conditions& conditions) {
    measure::Measurement out = measurement;
    const bool same = measurement.conditions.illuminant == conditions.illuminant &&
                      measurement.conditions.observer == conditions.observer;
    out.conditions = conditions;
    if (same) return out;
    if (!has_all_spectra(measurement)) {
        throw DomainError(
            "the standard has no spectra at all its angles: its colours are known under its own "
            "illuminant and observer only");
    }
    for (measure::Reading& reading : out.readings) {
        reading = measure::coloured(reading.geometry, out.wavelengths_nm,
                                    reading.reflectance_factor, conditions);
    }
    return out;
}

Target::Target(const measure::Measurement& standard, const TargetOptions& options) {
    if (standard.readings.empty()) throw DomainError("the standard has no reading at any angle");
    measure::difference(standard, standard, options.weights);  // checks the weights
    has_spectra_ = has_all_spectra(standard);
    hot_spot_ = options.hot_spot;
    weights_ = options.weights;

    double sum = 0;
    for (const measure::Reading& reading : standard.readings) {
        geometries_.push_back(reading.geometry);
        const auto found = options.weights.find(reading.geometry.name);
        root_weight_.push_back(found == options.weights.end() ? 1.0 : found->second);
        sum += root_weight_.back();
        if (root_weight_.back() > 0) ++geometry_count_;
    }
    std::vector<spectra::Illuminant> illuminants = options.illuminants;
    if (illuminants.empty()) illuminants = {standard.conditions.illuminant};
    const double mean = sum / static_cast<double>(geometry_count_);
    for (double& weight : root_weight_) {
        weight = std::sqrt(weight / mean / static_cast<double>(illuminants.size()));
    }

    const std::vector<double> all =
        has_spectra_ ? standard.wavelengths_nm : spectra::default_wavelengths_nm();
    for (Detail detail : {Detail::screening, Detail::coarse, Detail::fine}) {
        const auto d = static_cast<std::size_t>(detail);
        const bool fine = detail == Detail::fine;
        const std::size_t stride =
            fine ? 1 : stride_of(all, has_spectra_ ? kStep_nm[d] : kStepWithoutSpectra_nm);
        wavelengths_nm_[d] = every(all, stride);
        for (spectra::Illuminant illuminant : illuminants) {
            measure::Conditions conditions = standard.conditions;
            conditions.illuminant = illuminant;
            measure::Measurement wanted = restated(standard, conditions);
            if (!fine) wanted = seen_coarsely(std::move(wanted), stride);
            standards_[d].push_back(std::move(wanted));
        }
    }
}

const std::vector<double>& Target::wavelengths_nm(Detail detail) const {
    return wavelengths_nm_[static_cast<std::size_t>(detail)];
}

std::size_t Target::residual_count() const {
    return 3 * geometries_.size() * standards(Detail::fine).size();
}

measure::Measurement Target::read(const solver::SolvedPaint& paint, Detail detail) const {
    return read_solution(paint, hot_spot_, geometries_, standards(detail)[0].conditions);
}

std::vector<double> Target::residuals(const solver::SolvedPaint& paint, Detail detail) const {
    const measure::Measurement sample = read(paint, detail);
    std::vector<double> out;
    out.reserve(residual_count());
    for (const measure::Measurement& wanted : standards(detail)) {
        const measure::Measurement seen = restated(sample, wanted.conditions);
        for (std::size_t i = 0; i < geometries_.size(); ++i) {
            const Vec3d difference =
                spectra::delta_e_2000_vector(wanted.readings[i].lab, seen.readings[i].lab);
            for (int c = 0; c < 3; ++c) out.push_back(root_weight_[i] * difference[c]);
        }
    }
    return out;
}

double Target::rms_delta_e(const std::vector<double>& residuals) const {
    double sum = 0;
    for (double r : residuals) sum += r * r;
    return std::sqrt(sum / static_cast<double>(geometry_count_));
}

double Target::rms_delta_e(const measure::Measurement& a, const measure::Measurement& b) const {
    double sum = 0;
    for (const measure::Measurement& wanted : standards(Detail::fine)) {
        const measure::Measurement seen_a = restated(a, wanted.conditions),
                                   seen_b = restated(b, wanted.conditions);
        for (std::size_t i = 0; i < geometries_.size(); ++i) {
            const double difference =
                spectra::delta_e_2000(seen_a.readings[i].lab, seen_b.readings[i].lab);
            sum += std::pow(root_weight_[i] * difference, 2);
        }
    }
    return std::sqrt(sum / static_cast<double>(geometry_count_));
}

namespace {

/// Step of the differences, in the unit cube. The function is smooth over a hundredth (a hue turns
/// over a tenth), and the solver's own error is below 1e-4 Delta E: the error of a derivative is
/// 0.05 Delta E over the cube's width, while derivatives are of order 1 to 100.
constexpr double kStep = 2e-3;

// By detail. The tolerance is relative to the BRDF's peak, so that colours far from it err by more;
// fewer cosines miss resonances of films at grazing incidence, which contribute little:
// docs/fit.md.
constexpr double kTolerance[] = {1e-4, 1e-5, kFineTolerance};
constexpr int kCosines[] = {33, 65, kFineCosines};

constexpr std::size_t kFilmsKept = 64;

}  // namespace

ColourModel::ColourModel(const FreeNumbers& numbers, const Target& target, SharedProgress& work)
    : numbers_(numbers),
      target_(target),
      work_(work),
      films_{solver::FilmCache{kFilmsKept, kCosines[0]}, solver::FilmCache{kFilmsKept, kCosines[1]},
             solver::FilmCache{kFilmsKept, kCosines[2]}} {}

std::size_t ColourModel::films() const {
    std::size_t sum = 0;
    for (const solver::FilmCache& films : films_) sum += films.computed();
    return sum;
}

std::string ColourModel::first_failure() const {
    const std::lock_guard lock(mutex_);
    return first_failure_;
}

template <class Read>
auto ColourModel::solved(std::span<const double> x, Detail detail,
                         const solver::SolverSettings* settings, const Read& read) const
    -> std::optional<decltype(read(std::declval<Solution>()))> {
    if (stopped()) return std::nullopt;
    try {
        ++solves_;
        return read(solve_alike(numbers_.at(x), target_.wavelengths_nm(detail),
                                kTolerance[static_cast<int>(detail)], settings,
                                films_[static_cast<int>(detail)], work_));
    } catch (const Error& error) {
        const std::lock_guard lock(mutex_);
        if (first_failure_.empty()) first_failure_ = error.what();
        return std::nullopt;
    }
}

std::optional<Evaluation> ColourModel::evaluate(std::span<const double> x, Detail detail,
                                                const solver::SolverSettings* settings) const {
    return solved(x, detail, settings, [&](const Solution& solution) {
        return Evaluation{target_.residuals(solution.paint, detail), solution.settings};
    });
}

std::optional<measure::Measurement> ColourModel::colours(std::span<const double> x) const {
    return solved(x, Detail::fine, nullptr, [&](const Solution& solution) {
        return target_.read(solution.paint, Detail::fine);
    });
}

std::optional<std::vector<double>> ColourModel::derivatives(std::span<const double> x,
                                                            const Evaluation& at_x, Detail detail,
                                                            bool central) const {
    std::vector<StepAlong> steps;
    for (const double here : x) steps.push_back({kStep, here, 1 - here});
    return differences(
        [&](std::span<const double> point, const solver::SolverSettings* like) {
            return evaluate(point, detail, like);
        },
        x, at_x, steps, central);
}

std::optional<std::vector<double>> ColourModel::jacobian(std::span<const double> x,
                                                         const Evaluation& at_x,
                                                         Detail detail) const {
    return derivatives(x, at_x, detail, false);
}

std::optional<std::vector<double>> ColourModel::central_jacobian(std::span<const double> x,
                                                                 const Evaluation& at_x,
                                                                 Detail detail) const {
    return derivatives(x, at_x, detail, true);
}

}  // namespace nacre::fit
