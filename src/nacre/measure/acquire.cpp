#include "nacre/measure/acquire.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "nacre/bsdf/measured/rgl.h"
#include "nacre/bsdf/wavelength_lanes.h"
#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/core/parallel.h"
#include "nacre/core/random.h"
#include "nacre/measure/instrument.h"

namespace nacre::measure {

namespace {

/// Makes the values of a table, up to gigabytes, piece by piece.
template <class T>
void fill(std::vector<T>& values, std::size_t count, T value, SharedProgress& work) {
    constexpr std::size_t kPiece = 1 << 22;
    values.reserve(count);
    while (values.size() < count) {
        work.throw_if_stopped(kMeasuring);
        values.resize(std::min(count, values.size() + kPiece), value);
    }
}

}  // namespace

bsdf::MerlTable acquire_merl(const Brdf& brdf, const std::vector<double>& wavelengths_nm,
                             const MerlSettings& settings, const Progress& progress) {
    const auto check = [](int cells, const char* what) {
        require_in_range(cells, bsdf::kMinMerlCells, bsdf::kMaxMerlCells, what);
    };
    check(settings.half, "cells along theta_half");
    check(settings.difference, "cells along theta_difference");
    check(settings.azimuths, "cells along phi_difference");
    const double bytes =
        3.0 * sizeof(double) * settings.half * settings.difference * settings.azimuths;
    require_table_size(bytes, 2.5 * bytes);  // the copy is in single precision
    const SpectrumColour colour(wavelengths_nm);
    SharedProgress asking(progress, 1);  // before the rows that are counted
    asking.add(0);
    bsdf::MerlTable table{settings.half, settings.difference, settings.azimuths, {}};
    fill(table.values, 3 * table.cells(), -1.0, asking);
    for_each_row(table.half, progress, [&](int h, SharedProgress& counter) {
        for (int d = 0; d < table.difference; ++d) {
            // phi_d and pi - phi_d: the same by reciprocity and mirror symmetry.
            for (int a = 0; a < (table.azimuths + 1) / 2; ++a) {
                if (!counter.keep_going()) return;
                const bsdf::DirectionPair pair = bsdf::directions_of(table.middle(h, d, a));
                const auto &i = pair.wi, &o = pair.wo;
                if (i[2] <= 0 || o[2] <= 0) continue;
                const auto polar = [](const Vec3d& w) {
                    return std::min(std::atan2(std::hypot(w[0], w[1]), w[2]),
                                    0.5 * std::numbers::pi - 1e-9);
                };
                const std::vector<double> rgb = colour.rgb(
                    brdf(polar(i), polar(o), std::atan2(o[1], o[0]) - std::atan2(i[1], i[0])));
                for (const int twin : {a, table.azimuths - 1 - a}) {
                    for (int c = 0; c < 3; ++c) {
                        table.values[c * table.cells() + table.cell(h, d, twin)] =
                            rgb[c] / bsdf::MerlTable::kScale[c];
                    }
                }
            }
        }
    });
    bsdf::validate(table);
    return table;
}

namespace {

constexpr double kEvenFraction = 0.02;
/// Largest polar angle at which a BRDF is evaluated: its domain is open at the horizon.
constexpr double kMaxPolar = 0.5 * std::numbers::pi - 1e-4;

double polar_node(int k, int count) {
    const double x = static_cast<double>(k) / (count - 1);
    return 0.5 * std::numbers::pi * x * x;
}

/// Integral over the azimuth of the projected area of facets at polar angle b seen from a.
double ring_area(double a, double b) {
    const double along = std::cos(a) * std::cos(b), across = std::sin(a) * std::sin(b);
    if (along >= across) return 2 * std::numbers::pi * along;
    const double edge = std::acos(std::clamp(-along / across, -1.0, 1.0));
    return 2 * (along * edge + across * std::sin(edge));
}

/// Facets whose distribution does not depend on azimuth, by polar angle at the nodes of an ndf
/// table.
struct Facets {
    std::vector<double> density, area;  ///< D and sigma; the area of all from above is 1
};

/// Weights of an integral over the solid angle of polar angles times 1/(2 pi), by the trapezium
/// rule in x, theta = (pi/2) x^2.
std::vector<double> ring_weights(int count) {
    std::vector<double> weights(count);
    for (int k = 0; k < count; ++k) {
        const double x = static_cast<double>(k) / (count - 1);
        weights[k] = (k == 0 || k == count - 1 ? 0.5 : 1.0) / (count - 1) * std::numbers::pi * x *
                     std::sin(polar_node(k, count));
    }
    return weights;
}

std::vector<double> projected_areas(const std::vector<double>& density, SharedProgress& work) {
    const int count = static_cast<int>(density.size());
    const std::vector<double> weights = ring_weights(count);
    std::vector<double> area(count, 0.0);
    for (int a = 0; a < count; ++a) {
        work.throw_if_stopped(kMeasuring);
        for (int b = 0; b < count; ++b) {
            area[a] +=
                weights[b] * density[b] * ring_area(polar_node(a, count), polar_node(b, count));
        }
    }
    return area;
}

Facets find_facets(const Brdf& brdf, const SpectrumColour& colour, int count,
                   SharedProgress& work) {
    std::vector<double> retro(count);
    parallel_for(0, count, [&](std::size_t k) {
        work.throw_if_stopped(kMeasuring);
        const double theta = std::min(polar_node(static_cast<int>(k), count), kMaxPolar);
        retro[k] = colour.luminance(brdf(theta, theta, 0)) * std::cos(theta);
    });
    // Powers of a positive matrix lead to its one positive eigenvector.
    constexpr int kRounds = 32;
    std::vector<double> density(count, 1 / std::numbers::pi), area = projected_areas(density, work);
    for (int round = 0; round < kRounds; ++round) {
        std::vector<double> next(count);
        for (int k = 0; k < count; ++k) next[k] = retro[k] * area[k];
        std::vector<double> next_area = projected_areas(next, work);
        if (!(next_area[0] > 0)) break;  // black: facets stay uniform
        for (int k = 0; k < count; ++k) {
            density[k] = next[k] / next_area[0];
            area[k] = next_area[k] / next_area[0];
        }
    }
    for (double& d : density) d = (1 - kEvenFraction) * d + kEvenFraction / std::numbers::pi;
    return {density, projected_areas(density, work)};
}

bsdf::SquareTable same_at_every_azimuth(const std::vector<double>& values) {
    bsdf::SquareTable table{2, static_cast<int>(values.size()), {}};
    for (int row = 0; row < 2; ++row) {
        table.values.insert(table.values.end(), values.begin(), values.end());
    }
    return table;
}

/// How closely nodes of the table lie, by half vector: a density over the square for each incidence,
/// the same for all, so that nothing shifts between two of them. Nodes per angle fall with the cube
/// root of the facets' distribution D, which spends them where the integral of the error of a linear
/// interpolant is least [de-boor-2001, chapter XII], and never below an even part. Since x goes with
/// the square root of theta_m, a density that vanishes like x at the pole spaces nodes evenly in
/// theta_m there; one that followed visible facets, like x^3, would give the interpolant the slope of
/// a square root at the very peak. By azimuth, nodes are twice as close across the plane of incidence
/// as in it: there, at grazing incidence, the horizon crosses the rows.
void fill_spacing(bsdf::RglTable& table, const Facets& facets, SharedProgress& work) {
    constexpr double kEvenSpacing = 0.1;
    const int count = static_cast<int>(facets.density.size());
    const double even = kEvenFraction / std::numbers::pi;
    const double largest = *std::max_element(facets.density.begin(), facets.density.end()) - even;
    std::vector<double> along(table.vndf_columns);
    for (int column = 0; column < table.vndf_columns; ++column) {
        const double x = static_cast<double>(column) / (table.vndf_columns - 1);
        const double at = x * (count - 1);
        const int k = std::min(static_cast<int>(at), count - 2);
        const double d =
            facets.density[k] + (at - k) * (facets.density[k + 1] - facets.density[k]) - even;
        along[column] = x * (std::cbrt(std::max(0.0, d) / largest) + kEvenSpacing);
    }
    for (std::size_t slice = 0; slice < table.slices(); ++slice) {
        for (int row = 0; row < table.vndf_rows; ++row) {
            work.throw_if_stopped(kMeasuring);
            const double sine =
                std::sin((2.0 * row / (table.vndf_rows - 1) - 1) * std::numbers::pi);
            for (const double density : along) {
                table.vndf.push_back(static_cast<float>(density * (1 + sine * sine)));
            }
        }
    }
}

/// Polar angles of incidence from 0 to kMaxIncidence, the closer the nearer to grazing.
std::vector<float> incidences(int count) {
    std::vector<float> theta(count);
    for (int i = 0; i < count; ++i) {
        const double left = 1 - static_cast<double>(i) / (count - 1);
        theta[i] = static_cast<float>(kMaxIncidence * (1 - left * std::sqrt(left)));
    }
    return theta;
}

}  // namespace

bsdf::RglTable acquire_rgl(const std::string& description, const Brdf& brdf,
                           const std::vector<double>& wavelengths_nm, const RglSettings& settings,
                           const Progress& progress) {
    require_in_range(settings.resolution, RglSettings::kResolutionRange, "resolution");
    require_in_range(settings.incident, RglSettings::kIncidentRange, "incident angles");
    require_in_range(settings.ndf_resolution, 8, 4096, "resolution of the facets' distribution");
    const double layer = static_cast<double>(sizeof(float)) * settings.resolution *
                         settings.resolution * settings.incident;
    const double values = settings.rgb ? 3.0 : static_cast<double>(wavelengths_nm.size());
    // With luminance and visible facets, and what sampling needs of them.
    require_table_size(layer * values, 3.5 * layer * (values + 2));
    const SpectrumColour colour(wavelengths_nm);
    SharedProgress asking(progress, 1);  // before the rows that are counted
    asking.add(0);
    const Facets facets = find_facets(brdf, colour, settings.ndf_resolution, asking);

    bsdf::RglTable table;
    table.description = description;
    table.phi_i = {0.0f};
    table.theta_i = incidences(settings.incident);
    table.ndf = same_at_every_azimuth(facets.density);
    table.sigma = same_at_every_azimuth(facets.area);
    const int n = settings.resolution;
    table.vndf_rows = n;
    table.vndf_columns = n;
    fill_spacing(table, facets, asking);
    table.resolution = n;
    if (!settings.rgb) table.wavelengths.assign(wavelengths_nm.begin(), wavelengths_nm.end());
    const std::size_t square = static_cast<std::size_t>(n) * n, channels = table.channels();
    fill(table.luminance, table.slices() * square, 0.0f, asking);
    fill(table.spectra, table.slices() * channels * square, 0.0f, asking);

    const bsdf::RglMap map(table, &asking);
    for_each_row(settings.incident, progress, [&](int slice, SharedProgress& counter) {
        const double theta_i = table.theta_i[slice];
        const bsdf::RglIncident i = map.incident(
            {static_cast<float>(std::sin(theta_i)), 0, static_cast<float>(std::cos(theta_i))});
        for (int row = 0; row < (n + 1) / 2; ++row) {
            for (int column = 0; column < n; ++column) {
                if (!counter.keep_going()) return;
                const bsdf::RglPoint point = map.at(
                    i, {static_cast<float>(column) / (n - 1), static_cast<float>(row) / (n - 1)});
                const Vec3f wo = 2 * dot(i.direction, point.normal) * point.normal - i.direction;
                if (wo.z <= 0) continue;  // f cos(theta_o) goes to 0 there
                const double theta_o = std::min<double>(bsdf::polar_angle(wo), kMaxPolar);
                const std::vector<double> f = brdf(theta_i, theta_o, std::atan2(wo.y, wo.x));
                const double factor = wo.z / map.scale(i, point);
                const double nodes = map.solid_angle_density(i, point);
                const std::vector<double> values = settings.rgb ? colour.rgb(f) : f;
                for (const int twin : {row, n - 1 - row}) {
                    const std::size_t at = static_cast<std::size_t>(twin) * n + column;
                    // No node at the pole, and none of the light in its directions.
                    table.luminance[slice * square + at] =
                        nodes > 0 ? static_cast<float>(colour.luminance(f) * wo.z / nodes) : 0.0f;
                    for (std::size_t c = 0; c < channels; ++c) {
                        table.spectra[(slice * channels + c) * square + at] =
                            static_cast<float>(values[c] * factor);
                    }
                }
            }
        }
    });
    bsdf::validate(table);
    return table;
}

namespace {

constexpr int kIncidences = 6, kSamplesPerIncidence = 1024;

/// Indices of eight of the wavelengths, evenly spaced.
std::array<std::size_t, kLanes> choose(std::size_t count) {
    std::array<std::size_t, kLanes> chosen;
    for (int i = 0; i < kLanes; ++i) chosen[i] = i * (count - 1) / (kLanes - 1);
    return chosen;
}

}  // namespace

TableError table_error(const bsdf::Bsdf& table, const Brdf& exact,
                       const std::vector<double>& wavelengths_nm, bool rgb,
                       const Progress& progress) {
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
    SharedProgress work(progress, 1);
    work.add(0);
    parallel_for(0, kIncidences, [&](std::size_t k) {
        const double theta_i = (5 + 15.0 * static_cast<double>(k)) * kDegree;
        const Vec3f wi = {static_cast<float>(std::sin(theta_i)), 0,
                          static_cast<float>(std::cos(theta_i))};
        Rng rng(hash_of(k));
        FloatLanes flux{}, wrong{}, peak{}, largest{};
        const auto compare = [&](Vec3f wo, float area) {
            if (wo.z < 1e-4f) return;
            // Rounding may leave z above 1.
            const double theta_o = std::acos(std::min(1.0, static_cast<double>(wo.z)));
            const FloatLanes wanted = lanes(exact(theta_i, theta_o, std::atan2(wo.y, wo.x)));
            const FloatLanes found = bound->eval(wi, wo);
            const FloatLanes difference = max_lanes(found - wanted, wanted - found);
            flux += wanted * (wo.z * area);
            wrong += difference * (wo.z * area);
            peak = max_lanes(peak, wanted * wo.z);
            largest = max_lanes(largest, difference * wo.z);
        };
        for (int n = 0; n < kSamplesPerIncidence; ++n) {
            work.throw_if_stopped("comparing the table with the BRDF");
            const auto s =
                bound->sample(wi, rng.uniform_float(), {rng.uniform_float(), rng.uniform_float()});
            if (s) compare(s->wo, 1 / s->pdf);
            // Where the table has less light than the BRDF, its own samples seldom look.
            const float z = rng.uniform_float(), phi = 2 * kPiF * rng.uniform_float();
            const float r = std::sqrt(std::max(0.0f, 1 - z * z));
            compare({r * std::cos(phi), r * std::sin(phi), z}, 0);
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
