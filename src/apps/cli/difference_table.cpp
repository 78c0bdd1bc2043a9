#include "apps/cli/difference_table.h"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "apps/cli/options.h"
#include "nacre/core/csv.h"
#include "nacre/spectra/observer.h"

namespace nacre::cli {

std::string difference_csv(const measure::Difference& difference) {
    std::string csv =
        "geometry,theta_i,aspecular_deg,L_standard,a_standard,b_standard,L_sample,a_sample,"
        "b_sample,dL,da,db,dC,dH,dE2000,weight\n";
    for (const measure::AngleDifference& angle : difference.angles) {
        const Vec3d &standard = angle.lab_standard, &sample = angle.lab_sample,
                    &delta = angle.delta_lab;
        fmt::format_to(std::back_inserter(csv), "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                       csv_cell(angle.geometry.name), angle.geometry.theta_i_deg,
                       angle.geometry.aspecular_deg, standard[0], standard[1], standard[2],
                       sample[0], sample[1], sample[2], delta[0], delta[1], delta[2],
                       angle.delta_chroma(), angle.delta_hue(), angle.delta_e_2000, angle.weight);
    }
    return csv;
}

nlohmann::json difference_json(const measure::Difference& difference) {
    nlohmann::json angles = nlohmann::json::array();
    for (const measure::AngleDifference& angle : difference.angles) {
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
    }
    return {{"format", "nacre-difference"},
            {"illuminant", spectra::name(difference.conditions.illuminant)},
            {"observer", spectra::name(difference.conditions.observer)},
            {"angles", std::move(angles)},
            {"mean_delta_e_2000", difference.mean_delta_e_2000},
            {"max_delta_e_2000", difference.max_delta_e_2000}};
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
