#include "nacre/solver/solver.h"

#include <fmt/format.h>

#include <algorithm>

#include "nacre/core/error.h"
#include "nacre/core/memory.h"
#include "nacre/solver/fourier_kernel.h"
#include "nacre/solver/group_solver.h"
#include "nacre/solver/resolution.h"
#include "nacre/solver/wavelength_groups.h"

namespace nacre::solver {

namespace {

// The peak of the memory that a solution takes, in bytes: the group that is being solved, and the
// values of all groups three times (by group, together, and the residual of their compression).
std::size_t memory_of(const PaintMedium& medium, const WavelengthGroups& groups,
                      const Resolution& resolution) {
    std::size_t solving = 0, values = 0;
    for (const WavelengthGroup& group : groups) {
        const GroupMemory memory = group_memory(
            medium, group.members[0], static_cast<int>(group.distinct.size()), resolution);
        solving = std::max(solving, memory.solving);
        values = std::max(values, memory.values);
    }
    values *= static_cast<std::size_t>(medium.wavelength_count());
    return std::max(solving, 2 * values) + values;
}

// Of a lobe by which values are divided between nodes (MultipleScattering::lobe_width), over that of
// the sine outside the coat of light that one flake reflects: some orders of scattering widen it.
constexpr double kLobeWidth = 6;

// Of the medium, with the settings.
void solve_medium(SolvedPaint& paint, const Progress& progress,
                  InternalReflection internal = InternalReflection::scattered) {
    const SolverSettings& settings = paint.settings;
    Resolution resolution = choose_resolution(paint.medium, settings);
    const WavelengthGroups groups = group_wavelengths(paint.medium);
    std::vector<GroupSolution> solutions;
    double unresolved, tail;
    do {
        require_memory(
            static_cast<double>(memory_of(paint.medium, groups, resolution)),
            fmt::format("solving {} wavelengths with {} + {} nodes and {} azimuthal orders",
                        paint.wavelengths_nm().size(), resolution.exit_nodes,
                        resolution.inner_nodes, resolution.orders),
            "solve fewer wavelengths at a time, or set fewer nodes and orders");
        double total = 0;
        for (const WavelengthGroup& group : groups) {
            total += group_work(static_cast<int>(group.distinct.size()), resolution);
        }
        SharedProgress work(progress, total);
        solutions.clear();
        unresolved = tail = 0;
        for (const WavelengthGroup& group : groups) {
            solutions.push_back(solve_group(select_wavelengths(paint.medium, group.distinct),
                                            resolution, internal, settings.tolerance, work));
            unresolved = std::max(unresolved, solutions.back().unresolved_scattering);
            tail = std::max(tail, solutions.back().azimuthal_tail);
        }
    } while (refine(resolution, settings, unresolved, tail));
    merge_groups(groups, solutions, settings.tolerance, paint);
    const double ior = paint.medium.ior[0];
    if (paint.medium.roughness == 0 || ior == 1) {
        paint.multiple_scattering.lobe_width = kLobeWidth * ior * resolution.lobe_alpha;
    }
}

}  // namespace

SolvedPaint solve(const paint::Recipe& recipe, const std::vector<double>& wavelengths_nm,
                  const SolverSettings& settings, FilmCache* films, const Progress& progress) {
    SolvedPaint paint;
    paint.recipe = recipe;
    paint.settings = settings;
    SharedProgress asking(progress, 1);  // how much there is to do is not known yet
    asking.add(0);
    paint.medium = make_medium(recipe, wavelengths_nm, films, &asking);
    asking.throw_if_stopped(kSolving);
    solve_medium(paint, progress);
    return paint;
}

SolvedPaint solve_with_coat(const SolvedPaint& paint, double factor, const Progress& progress) {
    SolvedPaint out;
    out.recipe = paint.recipe;
    out.settings = paint.settings;
    out.medium = paint.medium;
    if (out.recipe.clearcoat) {
        out.recipe.clearcoat->thickness_um *= factor;
        out.recipe.clearcoat->thickness_spread_um = 0;
    }
    for (double& depth : out.medium.clearcoat_depth) depth *= factor;
    solve_medium(out, progress);
    return out;
}

SolvedPaint solve_without_internal_reflection(const SolvedPaint& paint, const Progress& progress) {
    if (paint.medium.roughness > 0) {
        throw DomainError(fmt::format(
            "clearcoat.roughness = {}: must be 0 to leave out what the interface reflects "
            "from inside",
            paint.medium.roughness));
    }
    SolvedPaint out;
    out.recipe = paint.recipe;
    out.settings = paint.settings;
    out.medium = paint.medium;
    solve_medium(out, progress, InternalReflection::lost);
    return out;
}

PaintMedium without_ground(const PaintMedium& paint) {
    PaintMedium out = paint;
    while (!out.layers.empty() && out.layers.back().flakes.empty()) out.layers.pop_back();
    std::fill(out.substrate_reflectance.begin(), out.substrate_reflectance.end(), 0.0);
    return out;
}

SolvedPaint solve_without_ground(const SolvedPaint& paint, const Progress& progress) {
    SolvedPaint out;
    out.recipe = paint.recipe;
    out.settings = paint.settings;
    out.medium = without_ground(paint.medium);
    solve_medium(out, progress);
    return out;
}

std::size_t memory_to_solve(const paint::Recipe& recipe, const std::vector<double>& wavelengths_nm,
                            const SolverSettings& settings) {
    // What flakes reflect is not computed, which would take time: all wavelengths count as different,
    // and films as if they added as many nodes as they may.
    paint::Recipe plain = recipe;
    bool films = false;
    for (paint::Layer& layer : plain.layers) {
        for (paint::FlakeSpecies& species : layer.flakes) {
            films |= std::holds_alternative<optics::Platelet>(species.body);
            species.amount = paint::AreaDensity{species.area_density_per_um()};
            species.body = paint::PrescribedFlake{};
        }
    }
    const PaintMedium medium = make_medium(plain, wavelengths_nm, nullptr);
    WavelengthGroups groups = group_wavelengths(medium);
    for (WavelengthGroup& group : groups) group.distinct = group.members;
    Resolution resolution = choose_resolution(medium, settings);
    if (films && settings.exit_nodes == 0) {
        resolution.exit_nodes =
            std::min(resolution.exit_nodes + kMaxFilmNodes, SolverSettings::kMaxNodes);
    }
    return memory_of(medium, groups, resolution);
}

}  // namespace nacre::solver
