#include "nacre/fit/minimise.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "nacre/core/error.h"

namespace nacre::fit {

namespace {

/// From half the sum of squares; infinite where there is none.
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
        std::copy(last_->residuals.begin(), last_->residuals.end(), residuals);
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
    mutable std::optional<ColourModel::Evaluation> last_;
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

std::string reason(const ceres::Solver::Summary& summary, int most_steps) {
    // Ceres explains itself with numbers and file names; what it means is one of these.
    const auto says = [&](const char* words) {
        return summary.message.find(words) != std::string::npos;
    };
    switch (summary.termination_type) {
        case ceres::CONVERGENCE:
            if (says("Gradient")) return "no number's change lessens the difference";
            if (says("Parameter")) return "steps have become too small to matter";
            return "further steps no longer lessen the difference";
        case ceres::NO_CONVERGENCE:
            return fmt::format("not converged after {} steps", most_steps);
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
    options.max_num_iterations = limits.most_steps;
    options.function_tolerance = limits.function_tolerance;
    options.parameter_tolerance = limits.parameter_tolerance;
    options.gradient_tolerance = 1e-8;
    AfterStep callback(model, limits.enough_delta_e, after_step);
    options.callbacks.push_back(&callback);

    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    descent.x = x;
    descent.steps = static_cast<int>(summary.iterations.size());
    descent.converged = summary.termination_type == ceres::CONVERGENCE ||
                        summary.termination_type == ceres::USER_SUCCESS;
    descent.ended = reason(summary, limits.most_steps);
    descent.rms_delta_e = summary.iterations.empty() ? std::numeric_limits<double>::infinity()
                                                     : rms_delta_e(model, summary.final_cost);
    return descent;
}

}  // namespace nacre::fit
