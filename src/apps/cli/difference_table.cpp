#include "apps/cli/difference_table.h"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "apps/cli/options.h"
#include "apps/cli/text_table.h"
#include "nacre/core/csv.h"
#include "nacre/io/file_kind.h"
#include "nacre/spectra/observer.h"

namespace nacre::cli {

namespace {

/// Whether a verdict adds a column: another formula than the one that is always there.
bool has_own_formula(const std::optional<measure::Verdict>& verdict) {
    return verdict && verdict->tolerance.formula != measure::DifferenceFormula{};
}
bool has_limits(const std::optional<measure::Verdict>& verdict) {
    return verdict && verdict->tolerance.has_limits();
}

const char* word_of(const measure::AngleVerdict& angle) {
    return !angle.limit ? "" : angle.passes() ? "pass" : "fail";
}

}  // namespace

std::string difference_csv(const measure::Difference& difference,
                           const std::optional<measure::Verdict>& verdict) {
    std::string csv =
        "geometry,theta_i,aspecular_deg,L_standard,a_standard,b_standard,L_sample,a_sample,"
        "b_sample,dL,da,db,dC,dH,dE2000,weight";
    if (has_own_formula(verdict)) csv += ",dE_" + verdict->tolerance.formula.name();
    if (has_limits(verdict)) csv += ",tolerance,verdict";
    csv += "\n";
    for (std::size_t i = 0; i < difference.angles.size(); ++i) {
        const measure::AngleDifference& angle = difference.angles[i];
        const Vec3d &standard = angle.lab_standard, &sample = angle.lab_sample,
                    &delta = angle.delta_lab;
        csv += fmt::format(
            "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", csv_cell(angle.geometry.name),
            angle.geometry.theta_i_deg, angle.geometry.aspecular_deg, standard[0], standard[1],
            standard[2], sample[0], sample[1], sample[2], delta[0], delta[1], delta[2],
            angle.delta_chroma(), angle.delta_hue(), angle.delta_e_2000, angle.weight);
        if (has_own_formula(verdict)) csv += fmt::format(",{}", verdict->angles[i].delta_e);
        if (has_limits(verdict)) {
            const measure::AngleVerdict& judged = verdict->angles[i];
            csv += fmt::format(",{},{}", judged.limit ? fmt::format("{}", *judged.limit) : "",
                               word_of(judged));
        }
        csv += "\n";
    }
    return csv;
}

std::string difference_text(const measure::Difference& difference,
                            const std::optional<measure::Verdict>& verdict) {
    std::vector<std::vector<std::string>> rows = {
        {"angle", "dL*", "da*", "db*", "dC*", "dH*", "dE2000",
         has_own_formula(verdict) ? "dE " + verdict->tolerance.formula.name() : "", "tolerance",
         "verdict"}};
    for (std::size_t i = 0; i < difference.angles.size(); ++i) {
        const measure::AngleDifference& angle = difference.angles[i];
        std::vector<std::string> row = {angle.geometry.name};
        for (const double value : {angle.delta_lab[0], angle.delta_lab[1], angle.delta_lab[2],
                                   angle.delta_chroma(), angle.delta_hue()}) {
            row.push_back(rounded(value, 2, true));
        }
        row.push_back(rounded(angle.delta_e_2000, 2));
        row.push_back(has_own_formula(verdict) ? fmt::format("{:.2f}", verdict->angles[i].delta_e)
                                               : "");
        const bool limited = verdict && verdict->angles[i].limit;
        row.push_back(limited ? fmt::format("{:g}", *verdict->angles[i].limit) : "");
        row.push_back(verdict ? word_of(verdict->angles[i]) : "");
        rows.push_back(std::move(row));
    }
    return text_table(rows);
}

nlohmann::json difference_json(const measure::Difference& difference,
                               const std::optional<measure::Verdict>& verdict) {
    nlohmann::json angles = nlohmann::json::array();
    for (std::size_t i = 0; i < difference.angles.size(); ++i) {
        const measure::AngleDifference& angle = difference.angles[i];
        angles.push_back({{"geometry", angle.geometry.name},
                          {"theta_i_deg", angle.geometry.theta_i_deg},
                          {"aspecular_deg", angle.geometry.aspecular_deg},
                          {"lab_standard", angle.lab_standard},
                          {"lab_sample", angle.lab_sample},
                          {"delta_lab", angle.delta_lab},
                          {"delta_chroma", angle.delta_chroma()},
                          {"delta_hue", angle.delta_hue()},
                          {"delta_e_2000", angle.delta_e_2000},
                          {"weight", angle.weight}});
        if (!verdict) continue;
        angles.back()["delta_e"] = verdict->angles[i].delta_e;
        if (!verdict->angles[i].limit) continue;
        angles.back()["tolerance"] = *verdict->angles[i].limit;
        angles.back()["passes"] = verdict->angles[i].passes();
    }
    nlohmann::json document = {{"format", io::kDifferenceFormat},
                               {"illuminant", spectra::name(difference.conditions.illuminant)},
                               {"observer", spectra::name(difference.conditions.observer)},
                               {"angles", std::move(angles)},
                               {"mean_delta_e_2000", difference.mean_delta_e_2000},
                               {"max_delta_e_2000", difference.max_delta_e_2000}};
    if (verdict) document["formula"] = verdict->tolerance.formula.name();
    if (has_limits(verdict)) document["passes"] = verdict->passes();
    return document;
}

std::map<std::string, double> parse_weights(const std::string& text) {
    std::map<std::string, double> weights;
    if (text.empty()) return weights;
    for (const std::string_view part : split(text, ',')) {
        const std::size_t equals = part.rfind('=');
        if (equals == std::string::npos || equals == 0) {
            throw UsageError(
                fmt::format("--weights = {}: '{}' is not NAME=W, as in 45as15=2", text, part));
        }
        const double weight = parse_number("--weights", part.substr(equals + 1), {0, 1e9});
        if (!weights.emplace(part.substr(0, equals), weight).second) {
            throw UsageError(
                fmt::format("--weights = {}: {} appears twice", text, part.substr(0, equals)));
        }
    }
    return weights;
}

}  // namespace nacre::cli
