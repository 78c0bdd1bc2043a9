#include "apps/cli/tolerance_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

namespace nacre::cli {

void add_tolerance_options(CLI::App& command, ToleranceRequest& request) {
    command.add_option("--formula", request.formula,
                       "With --versus: cielab, cie2000, or cmc2:1 and the like, for the tolerance "
                       "[cie2000]");
    command.add_option("--tolerance", request.limits,
                       "With --versus: the largest colour difference that passes, as 1.5, or by "
                       "angle as 1.5,45as-15=3; status 4 if one fails");
}

std::optional<measure::Tolerance> parse_tolerance(const ToleranceRequest& request) {
    if (!request.asks()) return std::nullopt;
    measure::Tolerance tolerance;
    if (!request.formula.empty()) {
        try {
            tolerance.formula = measure::parse_formula(request.formula);
        } catch (const DomainError& error) {
            throw UsageError(fmt::format("--formula = {}", error.what()));
        }
    }
    if (request.limits.empty()) return tolerance;
    for (const std::string_view part : split(request.limits, ',')) {
        const std::size_t equals = part.rfind('=');
        const bool named = equals != std::string::npos && equals > 0;
        const double limit = parse_number("--tolerance", named ? part.substr(equals + 1) : part,
                                          measure::kToleranceLimit);
        const bool fresh = named ? tolerance.limits.emplace(part.substr(0, equals), limit).second
                                 : !tolerance.limit;
        if (!fresh) {
            throw UsageError(fmt::format(
                "--tolerance = {}: {} appears twice", request.limits,
                named ? std::string(part.substr(0, equals)) : "the limit for all angles"));
        }
        if (!named) tolerance.limit = limit;
    }
    return tolerance;
}

ExitStatus status_of(const CommonOptions& options, const std::optional<measure::Verdict>& verdict) {
    if (!verdict || verdict->passes()) return ExitStatus::ok;
    const auto failed = std::ranges::count_if(
        verdict->angles, [](const measure::AngleVerdict& angle) { return !angle.passes(); });
    say(options, fmt::format("does not pass: beyond the tolerance ({}) at {} of {} angles",
                             verdict->tolerance.formula.name(), failed, verdict->angles.size()));
    return ExitStatus::comparison_failed;
}

}  // namespace nacre::cli
