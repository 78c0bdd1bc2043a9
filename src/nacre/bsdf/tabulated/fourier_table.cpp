#include "nacre/bsdf/tabulated/fourier_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "nacre/bsdf/tabulated/table_pairs.h"
#include "nacre/core/error.h"
#include "nacre/solver/directions.h"
#include "nacre/spectra/rgb.h"

namespace nacre::bsdf {
namespace {

/// Of all flakes, by area, in linear Rec. 709.
std::vector<spectra::Rgb> flake_colours(const solver::SolvedPaint& paint) {
    const std::vector<Vec3d> weights = spectra::rec709_weights(paint.wavelengths_nm());
    std::vector<Vec3d> colours;
    Vec3d least{1, 1, 1};
    for (int k = 0; k <= FourierBrdfTable::kReflectanceIntervals; ++k) {
        const double cosine = static_cast<double>(k) / FourierBrdfTable::kReflectanceIntervals;
        Vec3d sum{};
        double area = 0;
        for (const solver::LayerMedium& layer : paint.medium.layers) {
            for (const solver::FlakeMedium& flake : layer.flakes) {
                const double part = flake.area_density_per_um * layer.thickness_um;
                area += part;
                for (std::size_t w = 0; w < weights.size(); ++w) {
                    const double R =
                        flake.table.reflectance(cosine, static_cast<int>(w / kLanes))[w % kLanes];
                    sum += part * R * weights[w];
                }
            }
        }
        Vec3d colour = area > 0 ? (1 / area) * sum : Vec3d{1, 1, 1};
        for (int c = 0; c < 3; ++c) least[c] = std::min(least[c], colour[c]);
        colours.push_back(colour);
    }
    std::vector<spectra::Rgb> out;
    for (Vec3d& colour : colours) {
        for (int c = 0; c < 3; ++c) {
            if (least[c] < FourierBrdfTable::kMinDivisor) colour[c] = 1;
        }
        out.push_back(to_float(colour));
    }
    return out;
}

spectra::Rgb reflectance_at(const std::vector<spectra::Rgb>& table, float cosine) {
    constexpr int kIntervals = FourierBrdfTable::kReflectanceIntervals;
    const float x = std::clamp(cosine, 0.0f, 1.0f) * kIntervals;
    const int row = std::min(static_cast<int>(x), kIntervals - 1);
    return table[row] + (x - static_cast<float>(row)) * (table[row + 1] - table[row]);
}

/// Samples in azimuth, and the cosines by which they become coefficients: [sample][order].
struct CosineTransform {
    std::vector<double> azimuths;
    std::vector<float> weights;
    int orders;

    explicit CosineTransform(int orders) : orders(orders) {
        const int samples = 2 * orders;
        for (int j = 0; j < samples; ++j) {
            const double phi = std::numbers::pi * (j + 0.5) / samples;
            azimuths.push_back(phi);
            for (int l = 0; l < orders; ++l) {
                weights.push_back(
                    static_cast<float>((l ? 2.0 : 1.0) / samples * std::cos(l * phi)));
            }
        }
    }
};

}  // namespace

std::size_t FourierBrdfTable::bytes() const {
    return std::visit([](const auto& table) { return table.bytes(); }, coefficients) +
           reflectance.size() * sizeof(spectra::Rgb);
}

namespace {

// Clenshaw's recurrence for sum_l a_l cos(l phi) of several series at once.   [clenshaw-1955]
// `coefficients(l)` points to the l-th of each.
template <std::size_t kMax, class Coefficients>
void sum_orders(int orders, int series, float cos_phi, const Coefficients& coefficients,
                std::array<float, kMax>& sum) {
    std::array<float, kMax> next{}, after{};
    const float twice = 2 * cos_phi;
    for (int l = orders - 1; l > 0; --l) {
        const float* a = coefficients(l);
        for (int k = 0; k < series; ++k) {
            const float here = a[k] + twice * next[k] - after[k];
            after[k] = next[k];
            next[k] = here;
        }
    }
    const float* a = coefficients(0);
    for (int k = 0; k < series; ++k) sum[k] = a[k] + cos_phi * next[k] - after[k];
}

spectra::Rgb sum_series(const RawBrdfTable& table, const BrdfCell& cell, float cos_phi) {
    const int m = table.grid.azimuths;
    std::array<const float*, 4> corner;
    for (int k = 0; k < 4; ++k) corner[k] = table.values.data() + 3 * cell.pair[k] * m;
    std::array<float, 3> order, sum;
    sum_orders(
        m, 3, cos_phi,
        [&](int l) {
            for (int c = 0; c < 3; ++c) {
                order[c] = 0;
                for (int k = 0; k < 4; ++k) {
                    order[c] += cell.pair_weight[k] * corner[k][3 * l + c];
                }
            }
            return order.data();
        },
        sum);
    return {sum[0], sum[1], sum[2]};
}

spectra::Rgb sum_series(const CompressedBrdfTable& table, const BrdfCell& cell, float cos_phi) {
    const int all = table.terms();
    std::array<float, 3 * CompressedBrdfTable::kMaxTerms> factor;
    sum_orders(
        table.grid.azimuths, all, cos_phi,
        [&](int l) { return table.right.data() + static_cast<std::size_t>(l) * all; }, factor);
    spectra::Rgb g;
    for (int corner = 0; corner < 4; ++corner) {
        const float* row = table.left.data() + cell.pair[corner] * all;
        int k = 0;
        for (int c = 0; c < 3; ++c) {
            float sum = 0;
            for (const int end = k + table.rank[c]; k < end; ++k) sum += row[k] * factor[k];
            g[c] += cell.pair_weight[corner] * sum;
        }
    }
    return g;
}

}  // namespace

spectra::Rgb FourierBrdfTable::interpolate(const BrdfCell& cell, float cos_phi, float cos_d) const {
    const spectra::Rgb sum = std::visit(
        [&](const auto& table) { return sum_series(table, cell, cos_phi); }, coefficients);
    const spectra::Rgb R = reflectance_at(reflectance, cos_d);
    return {R[0] * sum[0], R[1] * sum[1], R[2] * sum[2]};
}

FourierBrdfTable make_fourier_table(const solver::SolvedPaint& paint,
                                    const BrdfTableSettings& settings, const Progress& progress) {
    require_in_range(settings.azimuths, 8, BrdfGrid::kMaxAzimuths / 2,
                     "orders of a Fourier BRDF table");
    RawBrdfTable table;
    table.paint = paint.recipe.name;
    table.grid = make_grid(paint, settings);
    const std::vector<spectra::Rgb> reflectance = flake_colours(paint);
    const CosineTransform transform(settings.azimuths);
    BrdfGrid sampled = table.grid;
    sampled.azimuths = 2 * settings.azimuths;
    const BrdfTableRows rows(paint, sampled);

    const int orders = settings.azimuths;
    const double ior = table.grid.ior;
    set_pairs(table, "the Fourier BRDF table", progress, [&](int i) {
        return [&, theta_i = table.grid.angle(i), work = rows.make_workspace(i),
                values = std::vector<float>(3 * sampled.azimuths),
                sum = std::array<std::vector<float>, 3>()](int o, float* out) mutable {
            const double theta_o = table.grid.angle(o);
            work.azimuth = transform.azimuths;
            rows.evaluate_at_azimuths(work, o, values.data());
            for (auto& channel : sum) channel.assign(orders, 0.0f);
            const double cosines =
                solver::inside_cosine(ior, theta_i) * solver::inside_cosine(ior, theta_o);
            const double sines = std::sin(theta_i) * std::sin(theta_o) / (ior * ior);
            for (std::size_t j = 0; j < transform.azimuths.size(); ++j) {
                const double dot = cosines + sines * std::cos(transform.azimuths[j]);
                const spectra::Rgb R = reflectance_at(
                    reflectance, static_cast<float>(std::sqrt(std::max(0.0, (1 + dot) / 2))));
                const float* weights = transform.weights.data() + j * orders;
                for (int c = 0; c < 3; ++c) {
                    const float value = values[3 * j + c] / R[c];
                    for (int l = 0; l < orders; ++l) sum[c][l] += value * weights[l];
                }
            }
            for (int l = 0; l < orders; ++l) {
                for (int c = 0; c < 3; ++c) out[3 * l + c] = sum[c][l];
            }
        };
    });
    return {table.grid, reflectance, std::move(table)};
}

FourierBrdfTable compress(const FourierBrdfTable& table, const CompressionSettings& settings) {
    const auto* raw = std::get_if<RawBrdfTable>(&table.coefficients);
    if (!raw) throw DomainError("the Fourier BRDF table is compressed already");
    if (settings.clip_to_gamut) {
        throw DomainError("clip_to_gamut: Fourier coefficients below zero are no colours");
    }
    return {table.grid, table.reflectance, compress(*raw, settings)};
}

}  // namespace nacre::bsdf
