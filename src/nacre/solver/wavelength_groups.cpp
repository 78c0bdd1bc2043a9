#include "nacre/solver/wavelength_groups.h"

#include <algorithm>
#include <memory>

#include "nacre/core/parallel.h"
#include "nacre/solver/fourier_kernel.h"

namespace nacre::solver {

namespace {

// Everything the solution at one wavelength depends on.
std::vector<double> signature(const PaintMedium& medium, int w) {
    std::vector<double> s = {medium.ior[w], medium.clearcoat_depth[w],
                             medium.substrate_reflectance[w]};
    for (const LayerMedium& layer : medium.layers) {
        for (const FlakeMedium& flake : layer.flakes) {
            const int stride = flake.table.wavelength_count();
            for (int c = 0; c < flake.table.cosine_count(); ++c) {
                s.push_back(flake.table.chebyshev_reflectance()[c * stride + w]);
                s.push_back(flake.table.chebyshev_transmittance()[c * stride + w]);
            }
        }
        for (const PigmentMedium& pigment : layer.pigments) {
            s.push_back(pigment.scattering_per_um[w]);
            s.push_back(pigment.absorption_per_um[w]);
            if (!pigment.phase) continue;
            const std::vector<double>& series = pigment.phase->legendre()[w];
            s.push_back(static_cast<double>(series.size()));
            s.insert(s.end(), series.begin(), series.end());
        }
    }
    return s;
}

template <class T>
std::vector<T> pick(const std::vector<T>& from, const std::vector<int>& index) {
    std::vector<T> out;
    for (int i : index) out.push_back(from[i]);
    return out;
}

paint::FlakeTable pick_columns(const paint::FlakeTable& table, const std::vector<int>& columns) {
    std::vector<double> r, t;
    for (int c = 0; c < table.cosine_count(); ++c) {
        for (int w : columns) {
            r.push_back(table.chebyshev_reflectance()[c * table.wavelength_count() + w]);
            t.push_back(table.chebyshev_transmittance()[c * table.wavelength_count() + w]);
        }
    }
    return paint::FlakeTable::from_chebyshev(table.cosine_count(), static_cast<int>(columns.size()),
                                             r, t);
}

// All groups' values of one row, [wavelength].
void collect_row(const WavelengthGroups& groups, const std::vector<GroupSolution>& solutions,
                 std::vector<OrderValues> GroupSolution::*values, int l, int i, int j,
                 LaneBuffer& represented, double* row) {
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const WavelengthGroup& group = groups[g];
        const GroupSolution& s = solutions[g];
        const bool known = l < static_cast<int>((s.*values).size()) && j >= s.first[l];
        const DoubleLanes* at = nullptr;
        if (known) {
            const OrderValues& of_order = (s.*values)[l];
            const std::size_t blocks = of_order.size() / triangle(s.exit_angle.size() - s.first[l]);
            at = &of_order[(triangle(i - s.first[l]) + j - s.first[l]) * blocks];
            if (s.representatives && l >= s.represented_from) {
                represented.resize(paint::block_count(static_cast<int>(group.distinct.size())));
                s.representatives->at_all(at, represented.data());
                at = represented.data();
            }
        }
        for (std::size_t k = 0; k < group.members.size(); ++k) {
            const int w = group.solved_as[k];
            row[group.members[k]] = known ? at[w / kLanes][w % kLanes] : 0.0;
        }
    }
}

// Values [pair][wavelength] of all groups, pairs by order from first[order], and how many there are.
struct CollectedValues {
    std::unique_ptr<double[]> values;
    std::size_t count;
};

CollectedValues collect(const WavelengthGroups& groups, const std::vector<GroupSolution>& solutions,
                        const std::vector<int>& first,
                        std::vector<OrderValues> GroupSolution::*values) {
    std::size_t wavelengths = 0;
    for (const WavelengthGroup& group : groups) wavelengths += group.members.size();
    const int exits = static_cast<int>(solutions[0].exit_angle.size());
    std::vector<std::size_t> begin = {0};  // by order
    for (int f : first) begin.push_back(begin.back() + triangle(exits - f) * wavelengths);
    // Written by all threads, and not by one before them.
    CollectedValues all{std::make_unique_for_overwrite<double[]>(begin.back()), begin.back()};
    parallel_for(std::size_t{0}, first.size(), [&](std::size_t l) {
        LaneBuffer represented;
        double* row = all.values.get() + begin[l];
        for (int i = first[l]; i < exits; ++i) {
            for (int j = first[l]; j <= i; ++j, row += wavelengths) {
                collect_row(groups, solutions, values, static_cast<int>(l), i, j, represented, row);
            }
        }
    });
    return all;
}

}  // namespace

WavelengthGroups group_wavelengths(const PaintMedium& medium) {
    WavelengthGroups groups;
    std::vector<std::vector<std::vector<double>>> known;  // signatures, by group
    for (int w = 0; w < medium.wavelength_count(); ++w) {
        std::size_t g = 0;
        while (g < groups.size() && medium.ior[groups[g].members[0]] != medium.ior[w]) ++g;
        if (g == groups.size()) {
            groups.emplace_back();
            known.emplace_back();
        }
        auto s = signature(medium, w);
        const auto found = std::find(known[g].begin(), known[g].end(), s);
        groups[g].members.push_back(w);
        groups[g].solved_as.push_back(static_cast<int>(found - known[g].begin()));
        if (found == known[g].end()) {
            groups[g].distinct.push_back(w);
            known[g].push_back(std::move(s));
        }
    }
    return groups;
}

LaneBuffer spectra_of(const PaintMedium& medium) {
    const std::size_t blocks = paint::block_count(medium.wavelength_count());
    LaneBuffer rows;
    for (std::size_t lane = 0; lane < blocks * kLanes; ++lane) {
        const std::vector<double> numbers =
            signature(medium, std::min(static_cast<int>(lane), medium.wavelength_count() - 1));
        // Series of phase functions end where they may.
        rows.resize(std::max(rows.size(), numbers.size() * blocks), DoubleLanes{});
        for (std::size_t row = 0; row < numbers.size(); ++row)
            rows[row * blocks + lane / kLanes][lane % kLanes] = numbers[row];
    }
    return rows;
}

PaintMedium select_wavelengths(const PaintMedium& medium, const std::vector<int>& wavelengths) {
    if (static_cast<int>(wavelengths.size()) == medium.wavelength_count()) return medium;
    PaintMedium out = medium;
    out.wavelengths_nm = pick(medium.wavelengths_nm, wavelengths);
    out.ior = pick(medium.ior, wavelengths);
    out.clearcoat_depth = pick(medium.clearcoat_depth, wavelengths);
    out.substrate_reflectance = pick(medium.substrate_reflectance, wavelengths);
    for (LayerMedium& layer : out.layers) {
        for (FlakeMedium& flake : layer.flakes)
            flake.table = pick_columns(flake.table, wavelengths);
        for (PigmentMedium& pigment : layer.pigments) {
            pigment.scattering_per_um = pick(pigment.scattering_per_um, wavelengths);
            pigment.absorption_per_um = pick(pigment.absorption_per_um, wavelengths);
            if (pigment.phase) pigment.phase = pigment.phase->at(wavelengths);
        }
    }
    return out;
}

void merge_groups(const WavelengthGroups& groups, const std::vector<GroupSolution>& solutions,
                  double tolerance, SolvedPaint& paint) {
    // All groups share the exit angles; orders that one group did without are zero there. The
    // first active node can differ with the index: the smallest one holds them all.
    std::vector<int> first;
    for (const GroupSolution& s : solutions) {
        for (std::size_t l = 0; l < s.first.size(); ++l) {
            if (l == first.size()) first.push_back(s.first[l]);
            first[l] = std::min(first[l], s.first[l]);
        }
        SolverReport& report = paint.report;
        report.unresolved_scattering =
            std::max(report.unresolved_scattering, s.unresolved_scattering);
        report.inner_nodes = std::max(report.inner_nodes, s.inner_nodes);
        report.azimuthal_tail = std::max(report.azimuthal_tail, s.azimuthal_tail);
    }
    const int exits = static_cast<int>(solutions[0].exit_angle.size());
    paint.report.exit_nodes = exits;
    paint.report.orders = static_cast<int>(first.size());
    const auto merge = [&](std::vector<OrderValues> GroupSolution::*values) {
        const CollectedValues all = collect(groups, solutions, first, values);
        return compress(solutions[0].exit_angle, first, paint.medium.wavelength_count(),
                        {all.values.get(), all.count}, tolerance);
    };
    parallel_for(0, paint.medium.roughness > 0 ? 2 : 1, [&](int k) {
        if (k == 0) paint.multiple_scattering = merge(&GroupSolution::values);
        if (k == 1) paint.rough_single = merge(&GroupSolution::single_values);
    });
}

}  // namespace nacre::solver
