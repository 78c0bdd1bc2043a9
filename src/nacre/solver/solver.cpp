#include "nacre/solver/solver.h"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/memory.h"
#include "nacre/core/parallel.h"
#include "nacre/solver/azimuthal_order.h"
#include "nacre/solver/resolution.h"
#include "nacre/solver/wavelength_groups.h"

namespace nacre::solver {

namespace {

// Pairs of active exit nodes, of all orders.
std::size_t exit_pairs(const Directions& d, const ActiveNodes& active) {
    std::size_t pairs = 0;
    for (int l = 0; l < active.orders(); ++l) {
        pairs += triangle(std::max(0, d.exit_count - active.first(l)));
    }
    return pairs;
}

// What becomes of the light that a smooth interface sends back into the coat.
enum class InternalReflection { scattered, lost };

// Solves wavelengths that share one index of the binder.
class GroupSolver {
 public:
    GroupSolver(const PaintMedium& medium, const Resolution& resolution,
                InternalReflection internal, SharedProgress& work)
        : work_(work),
          directions_(
              make_directions(medium.ior[0], resolution.exit_nodes, resolution.inner_nodes)),
          active_(directions_, resolution.lobe_alpha, resolution.orders),
          wavelengths_(medium.wavelength_count()) {
        const bool rough = medium.roughness > 0 && directions_.ior > 1;
        if (rough) {
            interface_ = rough_interface_operators(directions_, active_, medium.roughness);
            // Kept for those who read the solution, who ask for it from all threads at once: each
            // would make it.
            rough_interface(directions_.ior, medium.roughness);
        }
        const int lit = rough ? directions_.size() : directions_.exit_count;
        blocks_.resize(paint::block_count(wavelengths_));
        std::vector<std::vector<Losses>> losses;  // [layer][node]
        kernels_.reserve(medium.layers.size());
        for (const LayerMedium& layer : medium.layers) {
            kernels_.emplace_back(layer, directions_, active_, static_cast<int>(blocks_.size()),
                                  &work_);
            std::vector<Losses>& by_node = losses.emplace_back(directions_.size());
            parallel_for(0, directions_.size(), [&](int i) {
                work_.require_going(kSolving);
                by_node[i] =
                    solver::losses(layer, directions_.mu[i], 0, static_cast<int>(blocks_.size()));
            });
        }
        parallel_for(std::size_t{0}, blocks_.size(), [&](std::size_t b) {
            blocks_[b] =
                make_block(medium, directions_, kernels_, losses, lit, static_cast<int>(b));
            if (internal == InternalReflection::lost) {
                std::fill(blocks_[b].returned.begin(), blocks_[b].returned.end(), DoubleLanes{});
            }
            work_.add(kBlockWork);
        });
        set_peaks(medium);
    }

    // Solves orders in parallel until those omitted sum to less than `tolerance` of the peak.
    GroupSolution run(double tolerance) {
        constexpr int kChunk = 4;
        GroupSolution out;
        out.wavelength_count = wavelengths_;
        out.exit_angle = directions_.exit_angle;
        out.inner_nodes = directions_.size() - directions_.exit_count;
        for (const PaintBlock& block : blocks_) {
            out.unresolved_scattering = std::max(out.unresolved_scattering, block.unresolved);
        }
        if (interface_) {
            // Held to a tenth of what flakes may leave unresolved: the BRDF errs by as much, not by
            // a fraction of it.
            out.unresolved_scattering =
                std::max(out.unresolved_scattering, 10 * interface_->asymmetry());
        }
        tbb::enumerable_thread_specific<OrderWorkspace> workspaces(
            [&] { return OrderWorkspace(directions_.size()); });
        const int blocks = static_cast<int>(blocks_.size());
        const std::size_t pairs = exit_pairs(directions_, active_);
        out.values.reserve(pairs * wavelengths_);
        if (interface_) out.single_values.reserve(pairs * wavelengths_);
        double last_chunk = 0;
        for (int from = 0; from < active_.orders(); from += kChunk) {
            const int count = std::min(kChunk, active_.orders() - from);
            std::vector<LaneBuffer> values(static_cast<std::size_t>(count) * blocks);
            parallel_for(0, count * blocks, [&](int task) {
                work_.require_going(kSolving);
                const int order = from + task / blocks;
                const int rows = directions_.exit_count - active_.first(order);
                if (rows <= 0) return;
                const PaintBlock& block = blocks_[task % blocks];
                OrderWorkspace& work = workspaces.local();
                const std::size_t pairs = triangle(rows);
                values[task].resize(interface_ ? 2 * pairs : pairs);
                DoubleLanes* const at = values[task].data();
                if (interface_) {
                    solve_rough_order(block, interface_->order(order), directions_, order, work,
                                      at + pairs, at);
                } else {
                    solve_order(block, directions_, active_, order, work, at);
                }
                work_.add();
            });
            double chunk = 0;
            for (int c = 0; c < count; ++c) {
                chunk += 2 * append_order(out, from + c, &values[c * blocks]);
            }
            // Sum of the omitted orders, extrapolated as a geometric series from the last two
            // chunks.
            const double ratio = from > 0 ? chunk / std::max(last_chunk, 1e-300) : 1.0;
            out.azimuthal_tail = ratio < 1 ? chunk * ratio / (1 - ratio) : chunk;
            if (from > 0 && out.azimuthal_tail < tolerance) break;
            last_chunk = chunk;
        }
        return out;
    }

    // Of a group of `wavelengths`, in units of one order of one block.
    static double work(int wavelengths, const Resolution& resolution) {
        return paint::block_count(wavelengths) * (kBlockWork + resolution.orders);
    }

 private:
    // Making a block takes the time of about so many of its orders.
    static constexpr int kBlockWork = 10;

    // The scale of the tolerance: the BRDF in the specular direction of each exit node, by single
    // scattering alone, a lower bound.
    void set_peaks(const PaintMedium& medium) {
        peak_.assign(static_cast<std::size_t>(directions_.exit_count) * blocks_.size(),
                     DoubleLanes{});
        if (interface_) return;  // see add_to_peaks()
        for (std::size_t b = 0; b < blocks_.size(); ++b) {
            for (int i = 0; i < directions_.exit_count; ++i) {
                const double mu = directions_.mu[i];
                DoubleLanes sum{};
                for (std::size_t k = 0; k < medium.layers.size(); ++k) {
                    sum += backscattering(medium.layers[k], mu, mu, std::numbers::pi,
                                          static_cast<int>(b)) *
                           blocks_[b].layers[k].single_factor[triangle(i) + i] * (1 / (mu * mu));
                }
                peak_[b * directions_.exit_count + i] = sum;
            }
        }
    }

    // Under a rough interface: the sum of the orders so far in the specular direction.
    void add_to_peaks(int order, int first, const LaneBuffer* by_block) {
        const int rows = directions_.exit_count - first;
        for (std::size_t b = 0; b < blocks_.size(); ++b) {
            for (int i = 0; i < rows; ++i) {
                const std::size_t at = triangle(i) + i;
                peak_[b * directions_.exit_count + first + i] +=
                    (order ? 2.0 : 1.0) * (by_block[b][at] + by_block[b][triangle(rows) + at]);
            }
        }
    }

    // Appends an order's values as [pair][wavelength]; returns its size relative to the peaks.
    double append_order(GroupSolution& out, int order, const LaneBuffer* by_block) {
        const int first = active_.first(order);
        if (first >= directions_.exit_count) return 0;
        const int rows = directions_.exit_count - first;
        out.first.push_back(first);
        if (interface_) add_to_peaks(order, first, by_block);
        DoubleLanes size{}, broken{};  // broken: 0, not a number where a result is not finite
        std::size_t pair = 0;
        const std::size_t pairs = triangle(rows);
        const auto append = [&](std::vector<double>& values, const DoubleLanes& lanes,
                                std::size_t b) {
            const double* const from = reinterpret_cast<const double*>(&lanes);
            const int left = wavelengths_ - static_cast<int>(b) * kLanes;
            values.insert(values.end(), from, from + std::min<int>(kLanes, left));
        };
        for (int i = 0; i < rows; ++i) {
            for (int j = 0; j <= i; ++j, ++pair) {
                for (std::size_t b = 0; b < blocks_.size(); ++b) {
                    DoubleLanes value = by_block[b][pair];
                    if (interface_) {
                        const DoubleLanes& single = by_block[b][pairs + pair];
                        append(out.single_values, single, b);
                        append(out.values, value, b);
                        value += single;
                    } else {
                        append(out.values, value, b);
                    }
                    broken += value - value;
                    DoubleLanes* peak = peak_.data() + b * directions_.exit_count + first;
                    // Order 0 of what is diffuse counts as peak too.
                    if (order == 0) {
                        peak[i] = max_lanes(peak[i], value);
                        peak[j] = max_lanes(peak[j], value);
                    }
                    const DoubleLanes scale = min_lanes(peak[i], peak[j]);
                    // Beyond the last wavelength lanes repeat it.
                    size = max_lanes(
                        size, max_lanes(value, -value) / max_lanes(scale, splat(kBlackBrdf)));
                }
            }
        }
        if (!(lane_sum(broken) == 0)) {
            throw Error(
                fmt::format("the solver broke down in azimuthal order {}: a result is not finite; "
                            "please report the recipe",
                            order));
        }
        return lane_max(size);
    }

    SharedProgress& work_;
    Directions directions_;
    ActiveNodes active_;
    std::shared_ptr<const RoughInterfaceOperators> interface_;  // if rough
    int wavelengths_;
    std::vector<FourierKernel> kernels_;  // by layer
    std::vector<PaintBlock> blocks_;
    LaneBuffer peak_;
};

// The peak of the memory that a solution takes, in bytes: the kernels of the group that is being
// solved, and the values of all groups three times (by group, together, and the residual of their
// compression).
std::size_t memory_of(const PaintMedium& medium, const WavelengthGroups& groups,
                      const Resolution& resolution) {
    const auto wavelengths = static_cast<std::size_t>(medium.wavelength_count());
    std::size_t kernels = 0, pairs = 0;
    for (const WavelengthGroup& group : groups) {
        const Directions d = make_directions(medium.ior[group.members[0]], resolution.exit_nodes,
                                             resolution.inner_nodes);
        const ActiveNodes active(d, resolution.lobe_alpha, resolution.orders);
        kernels =
            std::max(kernels, FourierKernel::bytes(d, active) * medium.layers.size() *
                                  paint::block_count(static_cast<int>(group.distinct.size())));
        pairs = std::max(pairs, exit_pairs(d, active));
    }
    const std::size_t tensors = medium.roughness > 0 ? 2 : 1;
    return std::max(kernels, 2 * tensors * pairs * wavelengths * sizeof(double)) +
           tensors * pairs * wavelengths * sizeof(double);
}

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
            total += GroupSolver::work(static_cast<int>(group.distinct.size()), resolution);
        }
        SharedProgress work(progress, total);
        solutions.clear();
        unresolved = tail = 0;
        for (const WavelengthGroup& group : groups) {
            GroupSolver solver(select_wavelengths(paint.medium, group.distinct), resolution,
                               internal, work);
            solutions.push_back(solver.run(settings.tolerance));
            unresolved = std::max(unresolved, solutions.back().unresolved_scattering);
            tail = std::max(tail, solutions.back().azimuthal_tail);
        }
    } while (refine(resolution, settings, unresolved, tail));
    merge_groups(groups, solutions, settings.tolerance, paint);
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
    asking.require_going(kSolving);
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
    // What flakes reflect does not matter: not computing it takes no time, and all wavelengths
    // count as different.
    paint::Recipe plain = recipe;
    for (paint::Layer& layer : plain.layers) {
        for (paint::FlakeSpecies& species : layer.flakes) {
            species.amount = paint::AreaDensity{species.area_density_per_um()};
            species.body = paint::PrescribedFlake{};
        }
    }
    const PaintMedium medium = make_medium(plain, wavelengths_nm, nullptr);
    WavelengthGroups groups = group_wavelengths(medium);
    for (WavelengthGroup& group : groups) group.distinct = group.members;
    return memory_of(medium, groups, choose_resolution(medium, settings));
}

}  // namespace nacre::solver
