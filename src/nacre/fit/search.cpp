#include "nacre/fit/search.h"

#include <ceres/ceres.h>
#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/quiet_ceres.h"
#include "nacre/core/random.h"

namespace nacre::fit {

namespace {

/// From half the sum of squares; infinite if that is not finite.
double rms_delta_e(const ColourModel& model, double cost) {
    if (!std::isfinite(cost) || cost < 0) return std::numeric_limits<double>::infinity();
    return std::sqrt(2 * cost / static_cast<double>(model.target().geometry_count()));
}

/// The residuals as Ceres asks for them: first alone at a point that it tries, then with
/// derivatives if it goes there.
class ResidualFunction : public ceres::CostFunction {
 public:
    ResidualFunction(const ColourModel& model, Detail detail) : model_(model), detail_(detail) {
        mutable_parameter_block_sizes()->push_back(static_cast<int>(model.numbers().size()));
        set_num_residuals(static_cast<int>(model.target().residual_count()));
    }

    bool Evaluate(double const* const* parameters, double* residuals,
                  double** jacobians) const override {
        const std::vector<double> x(parameters[0], parameters[0] + model_.numbers().size());
        if (!last_ || last_x_ != x) {
            last_x_ = x;
            last_ = model_.evaluate(x, detail_);
        }
        if (!last_) return false;
        std::copy(last_->values.begin(), last_->values.end(), residuals);
        if (!jacobians || !jacobians[0]) return true;
        const auto jacobian = model_.jacobian(x, *last_, detail_);
        if (!jacobian) return false;
        std::copy(jacobian->begin(), jacobian->end(), jacobians[0]);
        return true;
    }

 private:
    const ColourModel& model_;
    Detail detail_;
    mutable std::vector<double> last_x_;
    mutable std::optional<Evaluation> last_;
};

class AfterStep : public ceres::IterationCallback {
 public:
    AfterStep(const ColourModel& model, double enough_delta_e, const std::function<void()>& tell)
        : model_(model), enough_delta_e_(enough_delta_e), tell_(tell) {}

    ceres::CallbackReturnType operator()(const ceres::IterationSummary& step) override {
        if (tell_) tell_();
        if (model_.stopped()) return ceres::SOLVER_ABORT;
        return rms_delta_e(model_, step.cost) < enough_delta_e_
                   ? ceres::SOLVER_TERMINATE_SUCCESSFULLY
                   : ceres::SOLVER_CONTINUE;
    }

 private:
    const ColourModel& model_;
    double enough_delta_e_;
    const std::function<void()>& tell_;
};

std::string reason(const ceres::Solver::Summary& summary, int max_steps) {
    // Ceres' message holds numbers and file names; its cause is one of these.
    const auto says = [&](const char* words) {
        return summary.message.find(words) != std::string::npos;
    };
    switch (summary.termination_type) {
        case ceres::CONVERGENCE:
            if (says("Gradient")) return "no number's change lessens the difference";
            if (says("Parameter")) return "steps have become too small to matter";
            return "further steps no longer lessen the difference";
        case ceres::NO_CONVERGENCE:
            return fmt::format("not converged after {} steps", max_steps);
        case ceres::USER_SUCCESS:
            return "the colours are alike to within the solver's own error";
        case ceres::USER_FAILURE:
            return "stopped";
        default:
            return "not converged: no step from here leads to a paint that can be solved";
    }
}

}  // namespace

Descent descend(const ColourModel& model, std::vector<double> x, Detail detail,
                const DescentLimits& limits, const std::function<void()>& after_step) {
    Descent descent;
    ResidualFunction function(model, detail);
    ceres::Problem::Options ownership;
    ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::Problem problem(ownership);
    problem.AddResidualBlock(&function, nullptr, x.data());
    for (int i = 0; i < static_cast<int>(x.size()); ++i) {
        problem.SetParameterLowerBound(x.data(), i, 0.0);
        problem.SetParameterUpperBound(x.data(), i, 1.0);
    }
    ceres::Solver::Options options;
    options.minimizer_type = ceres::TRUST_REGION;
    options.trust_region_strategy_type = ceres::LEVENBERG_MARQUARDT;
    options.linear_solver_type = ceres::DENSE_QR;
    options.num_threads = 1;  // threads are inside the function
    options.logging_type = ceres::SILENT;
    options.max_num_iterations = limits.max_steps;
    options.function_tolerance = limits.function_tolerance;
    options.parameter_tolerance = limits.parameter_tolerance;
    options.gradient_tolerance = 1e-8;
    AfterStep callback(model, limits.enough_delta_e, after_step);
    options.callbacks.push_back(&callback);

    ceres::Solver::Summary summary;
    const QuietCeres quiet;
    ceres::Solve(options, &problem, &summary);
    descent.x = x;
    descent.steps = static_cast<int>(summary.iterations.size());
    descent.converged = summary.termination_type == ceres::CONVERGENCE ||
                        summary.termination_type == ceres::USER_SUCCESS;
    descent.ended = reason(summary, limits.max_steps);
    descent.rms_delta_e = summary.iterations.empty() ? std::numeric_limits<double>::infinity()
                                                     : rms_delta_e(model, summary.final_cost);
    return descent;
}

namespace {

/// A few steps tell which points are worth a coarse descent.
constexpr DescentLimits kShortLimits{3, 1e-2, 1e-3, 0.1};
constexpr DescentLimits kCoarseLimits{20, 1e-3, 1e-4, 1e-2};
constexpr DescentLimits kFineLimits{50, 1e-4, 1e-5, 2e-3};

/// Short descents for each coarse one.
constexpr int kShortDescentsPerStart = 3;

/// Points screened for each descent: more in more dimensions.
constexpr std::size_t points_per_start(std::size_t numbers) {
    return std::min<std::size_t>(16, 4 + 4 * numbers);
}
/// Points nearer than this in every coordinate are taken to belong to the same minimum.
constexpr double kMinStartDistance = 0.05;
/// Ends of descents nearer than this are the same minimum.
constexpr double kSameMinimum = 0.02;
/// Lowest start of a number whose lower bound is 0: at a spread of 0 the derivative by it vanishes.
constexpr double kMinStart = 0.05;
/// Coarse descents are continued with fine ones if their rms Delta E is within this of the best
/// one's. Without spectra coarse colours are off by up to 1.
constexpr double kFineStartDelta_e = 0.5, kFineStartWithoutSpectra_delta_e = 1.5;
constexpr std::size_t kMaxFineStarts = 3;

// Fractions of the work, for the progress.
constexpr double kScreeningFraction = 0.15, kShortFraction = 0.25, kCoarseFraction = 0.3,
                 kFineFraction = 0.25;

/// Progress in phases, each of which is a fraction of the work, whatever its units.
class Meter {
 public:
    explicit Meter(SharedProgress& work) : work_(work) {}

    void begin(double fraction, double units) {
        work_.add(left_);
        left_ = fraction;
        unit_ = fraction / units;
    }
    void add(double units) {
        const std::lock_guard lock(mutex_);
        const double done = std::min(units * unit_, left_);
        left_ -= done;
        work_.add(done);
    }

 private:
    SharedProgress& work_;
    std::mutex mutex_;
    double left_ = 0, unit_ = 0;  // of the phase
};

double distance(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

void throw_if_stopped(const ColourModel& model) {
    if (model.stopped()) throw Stopped(kStopped);
}

struct Candidate {
    std::vector<double> x;
    double rms_delta_e = std::numeric_limits<double>::infinity();
};

std::vector<Candidate> screen(const ColourModel& model, std::vector<std::vector<double>> points,
                              Meter& meter) {
    std::vector<Candidate> candidates(points.size());
    meter.begin(kScreeningFraction, static_cast<double>(points.size()));
    parallel_for_ranges(0, points.size(), 1, [&](std::size_t i, std::size_t) {
        candidates[i].x = points[i];
        // Waiting for a solve, a thread must not begin another point.
        tbb::this_task_arena::isolate([&] {
            if (const auto seen = model.evaluate(points[i], Detail::screening)) {
                candidates[i].rms_delta_e = model.target().rms_delta_e(seen->values);
            }
        });
        meter.add(1);
    });
    throw_if_stopped(model);
    return candidates;
}

/// The first one, and the best of the others that are kMinStartDistance apart.
std::vector<std::vector<double>> choose_starts(std::vector<Candidate> candidates,
                                               std::size_t max_count) {
    std::vector<std::vector<double>> chosen = {candidates[0].x};
    std::stable_sort(
        candidates.begin(), candidates.end(),
        [](const Candidate& a, const Candidate& b) { return a.rms_delta_e < b.rms_delta_e; });
    for (const Candidate& candidate : candidates) {
        if (chosen.size() >= max_count || !std::isfinite(candidate.rms_delta_e)) break;
        if (std::all_of(chosen.begin(), chosen.end(), [&](const auto& other) {
                return distance(candidate.x, other) >= kMinStartDistance;
            })) {
            chosen.push_back(candidate.x);
        }
    }
    return chosen;
}

std::vector<Descent> descend_from(const ColourModel& model,
                                  const std::vector<std::vector<double>>& starts, Detail detail,
                                  const DescentLimits& limits, double fraction, Meter& meter) {
    std::vector<Descent> ends(starts.size());
    const double units = limits.max_steps + 1;
    meter.begin(fraction, units * static_cast<double>(starts.size()));
    parallel_for_ranges(0, starts.size(), 1, [&](std::size_t i, std::size_t) {
        tbb::this_task_arena::isolate(
            [&] { ends[i] = descend(model, starts[i], detail, limits, [&] { meter.add(1); }); });
        meter.add(units - ends[i].steps);
    });
    throw_if_stopped(model);
    std::stable_sort(ends.begin(), ends.end(), [](const Descent& a, const Descent& b) {
        return a.rms_delta_e < b.rms_delta_e;
    });
    return ends;
}

std::vector<Descent> distinct(const std::vector<Descent>& ends) {
    std::vector<Descent> kept;
    for (const Descent& end : ends) {
        if (!std::isfinite(end.rms_delta_e)) break;
        if (std::all_of(kept.begin(), kept.end(), [&](const Descent& other) {
                return distance(end.x, other.x) >= kSameMinimum;
            })) {
            kept.push_back(end);
        }
    }
    return kept;
}

/// Where short descents begin: at `start` and at the best of the screened points.
std::vector<std::vector<double>> short_starts(const ColourModel& model,
                                              const std::vector<double>& start, int starts,
                                              std::uint64_t seed, Meter& meter,
                                              SearchEffort& effort) {
    std::vector<std::vector<double>> points = {start};
    for (auto& point :
         halton_points(static_cast<std::size_t>(starts - 1) * points_per_start(start.size()),
                       start.size(), seed)) {
        points.push_back(std::move(point));
    }
    for (std::size_t i = 0; i < start.size(); ++i) {
        if (model.numbers()[i].bounds.lo > 0) continue;
        for (auto& point : points) point[i] = std::max(point[i], kMinStart);
    }
    effort.points = static_cast<int>(points.size());
    return choose_starts(screen(model, std::move(points), meter),
                         static_cast<std::size_t>(starts) * kShortDescentsPerStart);
}

std::vector<Descent> short_minima(const ColourModel& model,
                                  const std::vector<std::vector<double>>& starts, Meter& meter) {
    return distinct(
        descend_from(model, starts, Detail::screening, kShortLimits, kShortFraction, meter));
}

std::vector<Descent> coarse_minima(const ColourModel& model, const std::vector<double>& start,
                                   int starts, std::uint64_t seed, Meter& meter,
                                   SearchEffort& effort) {
    const auto begun = short_starts(model, start, starts, seed, meter, effort);
    std::vector<std::vector<double>> coarse_starts = {begun[0]};
    if (begun.size() > 1) {
        for (const Descent& end : short_minima(model, begun, meter)) {
            if (coarse_starts.size() < static_cast<std::size_t>(starts))
                coarse_starts.push_back(end.x);
        }
    }

    effort.descents = static_cast<int>(coarse_starts.size());
    std::vector<Descent> coarse = distinct(
        descend_from(model, coarse_starts, Detail::coarse, kCoarseLimits, kCoarseFraction, meter));
    if (coarse.empty()) throw Error(model.first_failure());
    return coarse;
}

}  // namespace

std::vector<Descent> short_search(const ColourModel& model, const std::vector<double>& start,
                                  int starts, std::uint64_t seed, SharedProgress& work) {
    Meter meter(work);
    SearchEffort effort;
    std::vector<Descent> ends =
        short_minima(model, short_starts(model, start, starts, seed, meter, effort), meter);
    if (ends.empty()) throw Error(model.first_failure());
    return ends;
}

Descent coarse_descent(const ColourModel& model, const std::vector<double>& start) {
    Descent end = descend(model, start, Detail::coarse, kCoarseLimits);
    throw_if_stopped(model);
    return end;
}

std::vector<Descent> search(const ColourModel& model, const std::vector<double>& start, int starts,
                            std::uint64_t seed, SharedProgress& work, SearchEffort& effort) {
    Meter meter(work);
    const std::vector<Descent> coarse = coarse_minima(model, start, starts, seed, meter, effort);
    std::vector<std::vector<double>> fine_starts;
    const double limit =
        coarse[0].rms_delta_e +
        (model.target().has_spectra() ? kFineStartDelta_e : kFineStartWithoutSpectra_delta_e);
    for (const Descent& end : coarse) {
        if (fine_starts.size() < kMaxFineStarts && end.rms_delta_e <= limit) {
            fine_starts.push_back(end.x);
        }
    }
    effort.finished = static_cast<int>(fine_starts.size());
    std::vector<Descent> fine =
        distinct(descend_from(model, fine_starts, Detail::fine, kFineLimits, kFineFraction, meter));
    if (fine.empty()) throw Error(model.first_failure());
    return fine;
}

}  // namespace nacre::fit
