#include "nacre/measure/difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "nacre/core/error.h"
#include "nacre/spectra/lab.h"
#include "nacre/spectra/rgb.h"

namespace nacre::measure {

namespace {

struct Pair {
    const Reading *standard, *sample;
};

std::vector<Pair> common_readings(const Measurement& standard, const Measurement& sample) {
    std::vector<Pair> pairs;
    for (const Reading& reading : standard.readings) {
        if (const Reading* nearest = find_reading(sample, reading.geometry)) {
            pairs.push_back({&reading, nearest});
        }
    }
    return pairs;
}

bool same_light(const Conditions& a, const Conditions& b) {
    return a.illuminant == b.illuminant && a.observer == b.observer;
}

/// CIELAB of a reading as it is, or from its spectrum where other conditions are asked for.
Vec3d lab_under(const Measurement& measurement, const Reading& reading,
                const Conditions& conditions) {
    if (same_light(measurement.conditions, conditions)) return reading.lab;
    return coloured(reading.geometry, measurement.wavelengths_nm, reading.reflectance_factor,
                    conditions)
        .lab;
}

/// Illuminant and observer of the comparison: the standard's if the sample can be restated under
/// them.
Conditions common_light(const Measurement& standard, const Measurement& sample,
                        const std::vector<Pair>& pairs) {
    const auto all = [&](const Reading* Pair::*side) {
        return std::all_of(pairs.begin(), pairs.end(),
                           [&](const Pair& p) { return !(p.*side)->reflectance_factor.empty(); });
    };
    if (same_light(standard.conditions, sample.conditions) || all(&Pair::sample)) {
        return standard.conditions;
    }
    if (all(&Pair::standard)) return sample.conditions;
    throw DomainError(fmt::format(
        "{} and {} are stated under different illuminants or observers, and neither has spectra at "
        "all angles to be converted",
        standard.name.empty() ? "the standard" : standard.name,
        sample.name.empty() ? "the sample" : sample.name));
}

double weight_of(const Pair& pair, const std::map<std::string, double>& weights) {
    for (const Reading* reading : {pair.standard, pair.sample}) {
        const auto found = weights.find(reading->geometry.name);
        if (found != weights.end()) return found->second;
    }
    return 1;
}

void check_weights(const std::vector<Pair>& pairs, const std::map<std::string, double>& weights) {
    std::set<std::string> names;
    for (const Pair& pair : pairs) {
        names.insert(pair.standard->geometry.name);
        names.insert(pair.sample->geometry.name);
    }
    for (const auto& [name, weight] : weights) {
        if (!names.contains(name)) {
            throw DomainError(
                fmt::format("weight of {}: the two have no geometry of that name in common", name));
        }
        if (!(weight >= 0 && std::isfinite(weight))) {
            throw DomainError(
                fmt::format("weight of {} = {}: must be a number >= 0", name, weight));
        }
    }
}

std::string display_colour(Vec3d rgb, double dimmed) {
    for (int c = 0; c < 3; ++c) {
        rgb[c] = spectra::srgb_encode(std::clamp(rgb[c] / dimmed, 0.0, 1.0));
    }
    return spectra::css_colour(rgb);
}

}  // namespace

DisplayPair display_pair(const AngleDifference& angle) {
    const Vec3d standard = spectra::lab_to_linear_rec709(angle.lab_standard),
                sample = spectra::lab_to_linear_rec709(angle.lab_sample);
    double brightest = 1;
    for (int c = 0; c < 3; ++c) brightest = std::max({brightest, standard[c], sample[c]});
    return {display_colour(standard, brightest), display_colour(sample, brightest), brightest};
}

double AngleDifference::delta_chroma() const { return chroma(lab_sample) - chroma(lab_standard); }

double AngleDifference::delta_hue() const {
    // 2 sqrt(C1 C2) sin((h2 - h1) / 2) without angles: by the half-angle formula its square is
    // 2 (C1 C2 - a1 a2 - b1 b2), and the cross product has its sign.         [cie-15-2018]
    const double a1 = lab_standard[1], b1 = lab_standard[2], a2 = lab_sample[1], b2 = lab_sample[2];
    const double product = std::hypot(a1, b1) * std::hypot(a2, b2), cosine = a1 * a2 + b1 * b2,
                 sine = a1 * b2 - a2 * b1;
    // C1 C2 - a1 a2 - b1 b2 = sine^2 / (C1 C2 + a1 a2 + b1 b2) loses no digits to a small angle, as
    // the difference itself loses none to a large one.
    if (cosine > 0) return std::sqrt(2 / (product + cosine)) * sine;
    return std::copysign(std::sqrt(2 * (product - cosine)), sine);
}

Difference difference(const Measurement& standard, const Measurement& sample,
                      const std::map<std::string, double>& weights) {
    const std::vector<Pair> pairs = common_readings(standard, sample);
    if (pairs.empty()) {
        throw DomainError("the standard and the sample have no geometry in common");
    }
    check_weights(pairs, weights);
    const Conditions light = common_light(standard, sample, pairs);

    Difference result;
    result.conditions = light;
    double sum = 0, sum_of_weights = 0;
    for (const Pair& pair : pairs) {
        AngleDifference angle;
        angle.geometry = pair.standard->geometry;
        angle.lab_standard = lab_under(standard, *pair.standard, light);
        angle.lab_sample = lab_under(sample, *pair.sample, light);
        for (int c = 0; c < 3; ++c) {
            angle.delta_lab[c] = angle.lab_sample[c] - angle.lab_standard[c];
        }
        angle.delta_e_2000 = spectra::delta_e_2000(angle.lab_standard, angle.lab_sample);
        angle.weight = weight_of(pair, weights);
        sum += angle.weight * angle.delta_e_2000;
        sum_of_weights += angle.weight;
        result.max_delta_e_2000 = std::max(result.max_delta_e_2000, angle.delta_e_2000);
        result.angles.push_back(std::move(angle));
    }
    if (!(sum_of_weights > 0)) throw DomainError("all weights are 0: there is no mean to take");
    result.mean_delta_e_2000 = sum / sum_of_weights;
    return result;
}

}  // namespace nacre::measure
