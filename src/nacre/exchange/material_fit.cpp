#include "nacre/exchange/material_fit.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/core/parallel.h"
#include "nacre/core/quiet_ceres.h"
#include "nacre/core/random.h"
#include "nacre/spectra/colour.h"

namespace nacre::exchange {

namespace {

constexpr measure::Conditions kRendererConditions{
    spectra::Illuminant::D65, spectra::Observer::cie1931_2deg, {}};

/// From the unit cube, in which the fit moves.
double value_at(const FormatParameter& p, double x) {
    return p.lo + (p.hi - p.lo) * std::pow(std::clamp(x, 0.0, 1.0), p.power);
}

std::vector<double> values_at(const FormatModel& model, const double* x) {
    std::vector<double> values(model.parameters.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = value_at(model.parameters[i], x[i]);
    return values;
}

std::vector<ShadingDirections> directions_of(const std::vector<measure::Geometry>& geometries) {
    std::vector<ShadingDirections> directions;
    for (const measure::Geometry& g : geometries) {
        directions.push_back(shading_directions(g.theta_i_deg * kDegree, g.theta_o_deg * kDegree,
                                                g.phi_deg * kDegree));
    }
    return directions;
}

Vec3d lab_of(const Vec3d& brdf) { return spectra::linear_rec709_to_lab(std::numbers::pi * brdf); }

/// Half the distance over which the slope at a number is taken.
double step_at(double x) { return std::max(1e-4 * std::abs(x), 1.5e-8); }

/// The differences of all angles, three numbers each, and their slopes.
class ColourCost : public ceres::CostFunction {
 public:
    ColourCost(const FormatModel& model, const measure::Measurement& standard)
        : model_(model), values_(model.parameters.size()) {
        std::vector<measure::Geometry> geometries;
        for (const measure::Reading& reading : standard.readings) {
            wanted_.push_back(reading.lab);
            geometries.push_back(reading.geometry);
        }
        brdfs_ = model.brdfs(directions_of(geometries));
        for (auto* found : {&found_, &above_, &below_}) found->resize(wanted_.size());
        mutable_parameter_block_sizes()->push_back(static_cast<int>(values_.size()));
        set_num_residuals(static_cast<int>(3 * wanted_.size()));
    }

    bool Evaluate(double const* const* x, double* residuals, double** jacobians) const override;

 private:
    Vec3d difference(std::size_t angle, const Vec3d& brdf) const {
        return spectra::delta_e_2000_vector(wanted_[angle], lab_of(brdf));
    }

    const FormatModel& model_;
    std::vector<Vec3d> wanted_;  ///< L*a*b*
    // What an evaluation fills; only one runs at a time.
    mutable FormatBrdfs brdfs_;
    mutable std::vector<double> values_;
    mutable std::vector<Vec3d> found_, above_, below_;
};

bool ColourCost::Evaluate(double const* const* x, double* residuals, double** jacobians) const {
    const auto all_finite = [](const double* numbers, std::size_t count) {
        return std::all_of(numbers, numbers + count, [](double r) { return std::isfinite(r); });
    };
    const std::size_t angles = wanted_.size(), parameters = values_.size();
    values_ = values_at(model_, x[0]);
    brdfs_(values_, found_);
    for (std::size_t i = 0; i < angles; ++i) {
        const Vec3d delta = difference(i, found_[i]);
        for (int c = 0; c < 3; ++c) residuals[3 * i + c] = delta[c];
    }
    if (!all_finite(residuals, 3 * angles)) return false;
    if (!jacobians || !jacobians[0]) return true;

    // Of a difference by the BRDF's three numbers, once for all parameters.
    std::vector<std::array<Vec3d, 3>> by_brdf(angles);
    for (std::size_t i = 0; i < angles; ++i) {
        for (int c = 0; c < 3; ++c) {
            const double step = step_at(found_[i][c]);
            Vec3d above = found_[i], below = found_[i];
            above[c] += step;
            below[c] -= step;
            by_brdf[i][c] = (difference(i, above) - difference(i, below)) / (2 * step);
        }
    }
    for (std::size_t k = 0; k < parameters; ++k) {
        const double value = values_[k], step = step_at(x[0][k]);
        values_[k] = value_at(model_.parameters[k], x[0][k] + step);
        brdfs_(values_, above_);
        values_[k] = value_at(model_.parameters[k], x[0][k] - step);
        brdfs_(values_, below_);
        values_[k] = value;
        for (std::size_t i = 0; i < angles; ++i) {
            const Vec3d change = (above_[i] - below_[i]) / (2 * step);
            const Vec3d delta =
                change[0] * by_brdf[i][0] + change[1] * by_brdf[i][1] + change[2] * by_brdf[i][2];
            for (int c = 0; c < 3; ++c) jacobians[0][(3 * i + c) * parameters + k] = delta[c];
        }
    }
    return all_finite(jacobians[0], 3 * angles * parameters);
}

double sum_of_squares(const ColourCost& cost, const std::vector<double>& x) {
    std::vector<double> r(static_cast<std::size_t>(cost.num_residuals()));
    const double* at = x.data();
    if (!cost.Evaluate(&at, r.data(), nullptr)) return std::numeric_limits<double>::infinity();
    return std::inner_product(r.begin(), r.end(), r.begin(), 0.0);
}

/// Levenberg and Marquardt within the cube, by differences.
void improve(ColourCost& cost, std::vector<double>& x, int max_steps) {
    ceres::Problem::Options owner;
    owner.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::Problem problem(owner);
    problem.AddResidualBlock(&cost, nullptr, x.data());
    for (int i = 0; i < static_cast<int>(x.size()); ++i) {
        problem.SetParameterLowerBound(x.data(), i, 0.0);
        problem.SetParameterUpperBound(x.data(), i, 1.0);
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.num_threads = 1;
    options.logging_type = ceres::SILENT;
    options.max_num_iterations = max_steps;
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
    std::vector<Vec3d> brdfs(geometries.size());
    model.brdfs(directions_of(geometries))(values, brdfs);
    for (std::size_t i = 0; i < geometries.size(); ++i) {
        measure::Reading reading;
        reading.geometry = geometries[i];
        reading.lab = lab_of(brdfs[i]);
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
        candidates[i] = {sum_of_squares(ColourCost(model, fitted), points[i]), points[i]};
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
            ColourCost cost(model, fitted);
            improve(cost, candidates[i].second, steps);
            candidates[i].first = sum_of_squares(cost, candidates[i].second);
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
