#include "nacre/measure/table_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "nacre/bsdf/rgb_lanes.h"
#include "nacre/core/parallel.h"
#include "nacre/core/rng.h"
#include "nacre/measure/colour_of_brdf.h"

namespace nacre::measure {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kIncidences = 6, kSamples = 1024;

/// Positions of eight of the wavelengths, spread evenly.
std::array<std::size_t, kLanes> choose(std::size_t count) {
    std::array<std::size_t, kLanes> chosen;
    for (int i = 0; i < kLanes; ++i) chosen[i] = i * (count - 1) / (kLanes - 1);
    return chosen;
}

}  // namespace

TableError table_error(const bsdf::Bsdf& table, const Brdf& exact,
                       const std::vector<double>& wavelengths_nm, bool rgb) {
    const SpectrumColour colour(wavelengths_nm);
    const auto chosen = choose(wavelengths_nm.size());
    bsdf::Wavelengths eight;
    for (int i = 0; i < kLanes; ++i) eight[i] = wavelengths_nm[chosen[i]];
    const auto bound = table.bind(eight);
    const bsdf::RgbLanes spectrum(eight);
    const auto lanes = [&](const std::vector<double>& f) {
        if (!rgb) return make_lanes([&](int i) { return static_cast<float>(f[chosen[i]]); });
        const std::vector<double> c = colour.rgb(f);
        return spectrum(
            {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])});
    };
    std::array<TableError, kIncidences> errors;
    parallel_for(0, kIncidences, [&](std::size_t k) {
        const double theta_i = (5 + 15.0 * static_cast<double>(k)) * kDegree;
        const Vec3f wi = {static_cast<float>(std::sin(theta_i)), 0,
                          static_cast<float>(std::cos(theta_i))};
        Rng rng(hash_of(k));
        FloatLanes flux{}, wrong{}, peak{}, largest{};
        for (int n = 0; n < kSamples; ++n) {
            const auto s =
                bound->sample(wi, rng.uniform_float(), {rng.uniform_float(), rng.uniform_float()});
            if (!s || s->wo.z < 1e-4f) continue;
            // Rounding may leave z above 1.
            const double theta_o = std::acos(std::min(1.0, static_cast<double>(s->wo.z)));
            const FloatLanes wanted = lanes(exact(theta_i, theta_o, std::atan2(s->wo.y, s->wo.x)));
            const FloatLanes found = bound->eval(wi, s->wo);
            const FloatLanes difference = max_lanes(found - wanted, wanted - found);
            flux += wanted * (s->wo.z / s->pdf);
            wrong += difference * (s->wo.z / s->pdf);
            peak = max_lanes(peak, wanted * s->wo.z);
            largest = max_lanes(largest, difference * s->wo.z);
        }
        for (int i = 0; i < kLanes; ++i) {
            if (!(flux[i] > 0)) continue;  // black
            errors[k].flux += wrong[i] / flux[i] / (kLanes * kIncidences);
            errors[k].peak = std::max<double>(errors[k].peak, largest[i] / peak[i]);
        }
    });
    TableError all;
    for (const TableError& e : errors) {
        all.flux += e.flux;
        all.peak = std::max(all.peak, e.peak);
    }
    return all;
}

}  // namespace nacre::measure
