#include "nacre/paint/flake_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"

namespace nacre::paint {

namespace {

constexpr double kResolved = 1e-6;
constexpr int kFirstCosines = 33;

// Barycentric interpolation from Chebyshev-Lobatto points to the fine grid.
//                                                        [berrut-trefethen-2004, eq. 5.4]
std::vector<double> fine_grid(int count, int wavelengths, std::size_t stride, int intervals,
                              std::span<const double> values) {
    const std::vector<double> x = chebyshev_cosines(count);
    std::vector<double> fine((intervals + 1) * stride);
    constexpr std::size_t kGrain = 32;
    parallel_for_ranges(0, intervals + 1, kGrain, [&](std::size_t first, std::size_t last) {
        std::vector<double> weight(count);
        for (std::size_t g = first; g < last; ++g) {
            const double c = intervals ? static_cast<double>(g) / intervals : 1.0;
            double sum = 0;
            int hit = -1;
            for (int i = 0; i < count; ++i) {
                const double d = c - x[i];
                if (std::abs(d) < 1e-15) hit = i;
                weight[i] = (i % 2 ? -1.0 : 1.0) * (i == 0 || i == count - 1 ? 0.5 : 1.0) / d;
                sum += weight[i];
            }
            double* row = fine.data() + g * stride;
            if (hit >= 0) {
                for (int w = 0; w < wavelengths; ++w) row[w] = values[hit * wavelengths + w];
            } else {
                for (int i = 0; i < count; ++i) {
                    const double f = weight[i] / sum;
                    const double* from = values.data() + static_cast<std::size_t>(i) * wavelengths;
                    for (int w = 0; w < wavelengths; ++w) row[w] += f * from[w];
                }
                // The interpolant may leave the physical range by its own error, not by more.
                for (int w = 0; w < wavelengths; ++w) row[w] = std::clamp(row[w], 0.0, 1.0);
            }
            for (std::size_t w = wavelengths; w < stride; ++w) row[w] = row[wavelengths - 1];
        }
    });
    return fine;
}

// Largest of the upper eighth of the Chebyshev coefficients: an estimate of the interpolation
// error.
double unresolved(int count, int wavelengths, std::span<const double> values) {
    const int n = count - 1;
    double worst = 0;
    std::vector<double> coefficient(wavelengths);
    for (int k = n - n / 8; k <= n; ++k) {
        std::fill(coefficient.begin(), coefficient.end(), 0.0);
        for (int i = 0; i <= n; ++i) {
            const double end = i == 0 || i == n ? 0.5 : 1.0;
            const double factor = end * 2.0 / n * std::cos(std::numbers::pi * k * i / n);
            const double* value = values.data() + static_cast<std::size_t>(i) * wavelengths;
            for (int w = 0; w < wavelengths; ++w) coefficient[w] += factor * value[w];
        }
        for (double c : coefficient) worst = std::max(worst, std::abs(c));
    }
    return worst;
}

// Rows of `even` and `odd` alternately: the new points of a level lie between those of the one
// before.
std::vector<double> interleave(int wavelengths, const std::vector<double>& even,
                               const std::vector<double>& odd) {
    std::vector<double> all;
    all.reserve(even.size() + odd.size());
    for (std::size_t row = 0; row * wavelengths < even.size(); ++row) {
        const auto from = even.begin() + static_cast<std::ptrdiff_t>(row) * wavelengths;
        all.insert(all.end(), from, from + wavelengths);
        if (row * wavelengths < odd.size()) {
            const auto next = odd.begin() + static_cast<std::ptrdiff_t>(row) * wavelengths;
            all.insert(all.end(), next, next + wavelengths);
        }
    }
    return all;
}

}  // namespace

std::vector<double> chebyshev_cosines(int count) {
    std::vector<double> x(count, 1.0);
    for (int i = 1; i < count; ++i) {
        x[i] = 0.5 + 0.5 * std::cos(std::numbers::pi * i / (count - 1));
    }
    if (count > 1) x.back() = 0.0;
    return x;
}

FlakeTable FlakeTable::constant(std::span<const double> reflectance,
                                std::span<const double> transmittance) {
    return from_chebyshev(1, static_cast<int>(reflectance.size()), reflectance, transmittance);
}

FlakeTable FlakeTable::from_chebyshev(int cosine_count, int wavelength_count,
                                      std::span<const double> reflectance,
                                      std::span<const double> transmittance) {
    const auto expected = static_cast<std::size_t>(std::max(cosine_count, 0)) *
                          static_cast<std::size_t>(std::max(wavelength_count, 0));
    if (expected == 0 || reflectance.size() != expected || transmittance.size() != expected) {
        throw DomainError(
            fmt::format("flake table: {} cosines x {} wavelengths do not fit {} and "
                        "{} values",
                        cosine_count, wavelength_count, reflectance.size(), transmittance.size()));
    }
    for (std::size_t i = 0; i < expected; ++i) {
        // Sums of averaged transfer matrices round to a little above 1.
        require_in_range(reflectance[i], -1e-9, 1 + 1e-9, "flake reflectance");
        require_in_range(transmittance[i], -1e-9, 1 + 1e-9, "flake transmittance");
        require_in_range(reflectance[i] + transmittance[i], -1e-9, 1 + 1e-9, "flake R + T");
    }
    FlakeTable table;
    table.wavelength_count_ = wavelength_count;
    table.cosine_count_ = cosine_count;
    table.intervals_ = cosine_count == 1 ? 0 : kFineIntervals;
    table.stride_ = static_cast<std::size_t>(block_count(wavelength_count)) * kLanes;
    table.chebyshev_r_.assign(reflectance.begin(), reflectance.end());
    table.chebyshev_t_.assign(transmittance.begin(), transmittance.end());
    table.opaque_ = std::ranges::all_of(transmittance, [](double t) { return t == 0; });
    table.fine_r_ = fine_grid(cosine_count, wavelength_count, table.stride_, table.intervals_,
                              table.chebyshev_r_);
    if (table.opaque_) {
        table.fine_t_.assign(table.fine_r_.size(), 0.0);
    } else {
        table.fine_t_ = fine_grid(cosine_count, wavelength_count, table.stride_, table.intervals_,
                                  table.chebyshev_t_);
    }
    return table;
}

FlakeTable FlakeTable::of_platelet(const optics::Platelet& platelet, const optics::Material& binder,
                                   std::span<const double> wavelengths_nm, int max_cosines,
                                   SharedProgress* work) {
    const int wavelengths = static_cast<int>(wavelengths_nm.size());
    int count = kFirstCosines;
    auto table =
        optics::platelet_table(platelet, binder, chebyshev_cosines(count), wavelengths_nm, work);
    while (2 * count - 1 <= max_cosines &&
           (unresolved(count, wavelengths, table.reflectance) > kResolved ||
            unresolved(count, wavelengths, table.transmittance) > kResolved)) {
        count = 2 * count - 1;
        const std::vector<double> all = chebyshev_cosines(count);
        std::vector<double> added;
        for (int i = 1; i < count; i += 2) added.push_back(all[i]);
        const auto midpoints =
            optics::platelet_table(platelet, binder, added, wavelengths_nm, work);
        table.reflectance = interleave(wavelengths, table.reflectance, midpoints.reflectance);
        table.transmittance = interleave(wavelengths, table.transmittance, midpoints.transmittance);
    }
    return from_chebyshev(count, wavelengths, table.reflectance, table.transmittance);
}

}  // namespace nacre::paint
