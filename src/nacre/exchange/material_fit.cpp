#include "nacre/exchange/material_fit.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "nacre/core/angles.h"
#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/quiet_ceres.h"
#include "nacre/core/random.h"
#include "nacre/spectra/colour.h"

namespace nacre::exchange {

namespace {

constexpr measure::Conditions kRendererConditions{
    spectra::Illuminant::D65, spectra::Observer::cie1931_2deg, {}};

/// From the unit cube, in which the fit moves.
std::vector<double> values_at(const FormatModel& model, const double* x) {
    std::vector<double> values(model.parameters.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const FormatParameter& p = model.parameters[i];
        values[i] = p.lo + (p.hi - p.lo) * std::pow(std::clamp(x[i], 0.0, 1.0), p.power);
    }
    return values;
}

Vec3d lab_of(const FormatModel& model, const std::vector<double>& values,
             const measure::Geometry& g) {
    const Vec3d factor =
        std::numbers::pi *
        model.brdf(values, g.theta_i_deg * kDegree, g.theta_o_deg * kDegree, g.phi_deg * kDegree);
    return spectra::xyz_to_lab(spectra::linear_rec709_to_xyz(factor),
                               spectra::linear_rec709_to_xyz({1, 1, 1}));
}

/// The differences of all angles, three numbers each.
struct ColourResiduals {
    const FormatModel& model;
    const measure::Measurement& standard;

    bool operator()(double const* const* x, double* residuals) const {
        const std::vector<double> values = values_at(model, x[0]);
        for (std::size_t i = 0; i < standard.readings.size(); ++i) {
            const measure::Reading& wanted = standard.readings[i];
            const Vec3d delta =
                spectra::delta_e_2000_vector(wanted.lab, lab_of(model, values, wanted.geometry));
            for (int c = 0; c < 3; ++c) residuals[3 * i + c] = delta[c];
        }
        return std::all_of(residuals, residuals + 3 * standard.readings.size(),
                           [](double r) { return std::isfinite(r); });
    }
};

double sum_of_squares(const ColourResiduals& residuals, const std::vector<double>& x) {
    std::vector<double> r(3 * residuals.standard.readings.size());
    const double* at = x.data();
    if (!residuals(&at, r.data())) return std::numeric_limits<double>::infinity();
    return std::inner_product(r.begin(), r.end(), r.begin(), 0.0);
}

/// Levenberg and Marquardt within the cube, by differences.
void improve(const ColourResiduals& residuals, std::vector<double>& x, int steps_at_most) {
    using Cost = ceres::DynamicNumericDiffCostFunction<ColourResiduals, ceres::CENTRAL>;
    ceres::NumericDiffOptions steps;
    steps.relative_step_size = 1e-4;
    auto* cost = new Cost(new ColourResiduals(residuals), ceres::TAKE_OWNERSHIP, steps);
    cost->AddParameterBlock(static_cast<int>(x.size()));
    cost->SetNumResiduals(static_cast<int>(3 * residuals.standard.readings.size()));
    ceres::Problem problem;
    problem.AddResidualBlock(cost, nullptr, x.data());
    for (int i = 0; i < static_cast<int>(x.size()); ++i) {
        problem.SetParameterLowerBound(x.data(), i, 0.0);
        problem.SetParameterUpperBound(x.data(), i, 1.0);
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.num_threads = 1;
    options.logging_type = ceres::SILENT;
    options.max_num_iterations = steps_at_most;
    options.function_tolerance = 1e-7;
    ceres::Solver::Summary summary;
    const QuietCeres quiet;
    ceres::Solve(options, &problem, &summary);
}

}  // namespace

const FitGeometries& fit_geometries(bool across) {
    static const FitGeometries kSets = [] {
        FitGeometries sets;
        sets.fitted = measure::find_geometry_set("byk-mac")->geometries;
        for (const double lamp : {15.0, 60.0, 75.0}) {
            for (const double aspecular : {-10.0, 15.0, 25.0, 45.0, 75.0, 110.0}) {
                if (std::abs(lamp - aspecular) < 86) {
                    sets.fitted.push_back(measure::in_plane(lamp, aspecular));
                }
            }
        }
        sets.fitted.push_back(measure::off_plane(45, 15, 90));
        sets.fitted.push_back(measure::off_plane(45, 25, 125));
        sets.fitted.push_back(measure::off_plane(45, 60, 125));
        for (const double lamp : {30.0, 52.0, 67.0}) {
            for (const double aspecular : {-12.0, 20.0, 35.0, 60.0, 90.0}) {
                sets.tested.push_back(measure::in_plane(lamp, aspecular));
            }
        }
        sets.tested.push_back(measure::off_plane(30, 25, 90));
        sets.tested.push_back(measure::off_plane(60, 25, 90));
        return sets;
    }();
    static const FitGeometries kAcross = [] {
        FitGeometries sets = kSets;
        for (const double lamp : {15.0, 60.0, 75.0}) {
            for (const auto& [aspecular, azimuth] :
                 {std::pair{15.0, 90.0}, {30.0, 90.0}, {45.0, 110.0}, {60.0, 150.0}}) {
                sets.fitted.push_back(measure::off_plane(lamp, aspecular, azimuth));
            }
        }
        sets.fitted.push_back(measure::off_plane(45, 35, 60));
        // Views at grazing angles, which the lobes above leave out.
        for (const double phi : {180.0, 125.0, 50.0}) {
            sets.fitted.push_back(measure::towards(15, 76, phi));
            sets.fitted.push_back(measure::towards(45, 76, phi));
        }
        sets.fitted.push_back(measure::towards(60, 30, 110));
        sets.fitted.push_back(measure::towards(60, 30, 50));
        return sets;
    }();
    return across ? kAcross : kSets;
}

measure::Measurement read_material(const FormatModel& model, const std::vector<double>& values,
                                   const std::vector<measure::Geometry>& geometries) {
    measure::Measurement readings;
    readings.name = model.format;
    readings.conditions = kRendererConditions;
    for (const measure::Geometry& geometry : geometries) {
        measure::Reading reading;
        reading.geometry = geometry;
        reading.lab = lab_of(model, values, geometry);
        reading.xyz =
            spectra::lab_to_xyz(reading.lab, 100.0 * spectra::linear_rec709_to_xyz({1, 1, 1}));
        readings.readings.push_back(reading);
    }
    return readings;
}

MaterialFit fit_material(const FormatModel& model, const measure::Measurement& fitted,
                         const measure::Measurement& tested, const Progress& progress) {
    constexpr std::size_t kScreened = 4096, kDescents = 24, kKept = 4;
    constexpr int kSteps = 200;
    const ColourResiduals residuals{model, fitted};
    const std::size_t n = model.parameters.size();
    std::vector<double> start(n);
    std::vector<std::size_t> screened;
    for (std::size_t i = 0; i < n; ++i) {
        const FormatParameter& p = model.parameters[i];
        start[i] = std::pow((p.start - p.lo) / (p.hi - p.lo), 1 / p.power);
        if (p.screened) screened.push_back(i);
    }
    std::vector<std::vector<double>> points(kScreened, start);
    const auto places = halton_points(kScreened, screened.size(), 1);
    for (std::size_t k = 0; k < kScreened; ++k) {
        for (std::size_t i = 0; i < screened.size(); ++i) points[k][screened[i]] = places[k][i];
    }
    const std::size_t tried = model.trial_steps > 0 ? kKept : 0;
    SharedProgress work(progress, static_cast<double>(kDescents + 2 + tried));
    work.add(0);
    std::vector<std::pair<double, std::vector<double>>> candidates(points.size());
    parallel_for(0, points.size(), [&](std::size_t i) {
        if (work.stopped()) return;
        candidates[i] = {sum_of_squares(residuals, points[i]), points[i]};
    });
    work.throw_if_stopped("fitting a material");
    work.add(1);
    const auto keep_best = [&](std::size_t count) {
        std::stable_sort(candidates.begin(), candidates.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        candidates.resize(count);
    };
    keep_best(kDescents);
    candidates.push_back({0, start});
    const auto descend = [&](int steps) {
        parallel_for(0, candidates.size(), [&](std::size_t i) {
            if (work.stopped()) return;
            improve(residuals, candidates[i].second, steps);
            candidates[i].first = sum_of_squares(residuals, candidates[i].second);
            work.add(1);
        });
        work.throw_if_stopped("fitting a material");
    };
    if (model.trial_steps > 0) {
        descend(model.trial_steps);
        keep_best(kKept);
    }
    descend(kSteps);
    keep_best(1);
    const auto& [least, place] = candidates.front();
    if (!std::isfinite(least)) throw Error("fitting a material: no start has finite colours");

    MaterialFit fit;
    fit.values = values_at(model, place.data());
    const FitGeometries& sets = fit_geometries(model.across);
    fit.fitted = measure::difference(fitted, read_material(model, fit.values, sets.fitted));
    fit.tested = measure::difference(tested, read_material(model, fit.values, sets.tested));
    measure::Measurement few = fitted;
    few.readings.resize(kBykMacAngles);
    fit.instrument = measure::difference(
        few, read_material(model, fit.values, measure::find_geometry_set("byk-mac")->geometries));
    return fit;
}

}  // namespace nacre::exchange
