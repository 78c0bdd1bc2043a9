#include "nacre/measure/tolerance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>

#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/spectra/lab.h"

namespace nacre::measure {

double DifferenceFormula::operator()(const Vec3d& lab_standard, const Vec3d& lab_sample) const {
    switch (kind) {
        case Kind::cielab:
            return std::hypot(lab_sample[0] - lab_standard[0], lab_sample[1] - lab_standard[1],
                              lab_sample[2] - lab_standard[2]);
        case Kind::ciede2000:
            return spectra::delta_e_2000(lab_standard, lab_sample);
        case Kind::cmc:
            return spectra::delta_e_cmc(lab_standard, lab_sample, l, c);
    }
    return 0;
}

std::string DifferenceFormula::name() const {
    switch (kind) {
        case Kind::cielab:
            return "cielab";
        case Kind::ciede2000:
            return "cie2000";
        case Kind::cmc:
            return fmt::format("cmc{}:{}", l, c);
    }
    return {};
}

DifferenceFormula parse_formula(const std::string& text) {
    using Kind = DifferenceFormula::Kind;
    const std::string name = lowercase(trimmed(text));
    if (name == "cielab") return {.kind = Kind::cielab};
    if (name == "cie2000") return {.kind = Kind::ciede2000};
    if (name == "cmc") return {.kind = Kind::cmc};
    if (name.starts_with("cmc")) {
        const std::vector<std::string_view> numbers = split(std::string_view(name).substr(3), ':');
        if (numbers.size() == 2) {
            const auto l = parse_number(numbers[0]), c = parse_number(numbers[1]);
            if (l && c && *l > 0 && *c > 0) return {.kind = Kind::cmc, .l = *l, .c = *c};
        }
    }
    throw DomainError(
        fmt::format("{}: must be cielab, cie2000, cmc (which is cmc2:1) or cmcL:C with "
                    "two numbers above 0, as in cmc1:1",
                    excerpt(text)));
}

bool Verdict::passes() const {
    return std::all_of(angles.begin(), angles.end(),
                       [](const AngleVerdict& angle) { return angle.passes(); });
}

Verdict judge(const Difference& difference, const Tolerance& tolerance) {
    const auto check = [](const std::string& what, double limit) {
        if (kToleranceLimit.contains(limit)) return;
        throw DomainError(
            fmt::format("{} = {}: must be in {}", what, limit, kToleranceLimit.text()));
    };
    if (tolerance.limit) check("tolerance", *tolerance.limit);
    std::set<std::string> known;
    for (const AngleDifference& angle : difference.angles) known.insert(angle.geometry.name);
    for (const auto& [name, limit] : tolerance.limits) {
        check("tolerance of " + name, limit);
        if (!known.contains(name)) {
            throw DomainError(fmt::format(
                "tolerance of {}: the two have no geometry of that name in common", name));
        }
    }
    Verdict verdict{tolerance, {}};
    for (const AngleDifference& angle : difference.angles) {
        const auto own = tolerance.limits.find(angle.geometry.name);
        verdict.angles.push_back(
            {tolerance.formula(angle.lab_standard, angle.lab_sample),
             own == tolerance.limits.end() ? tolerance.limit : std::optional(own->second)});
    }
    return verdict;
}

}  // namespace nacre::measure
