#include "nacre/solver/group_solver.h"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/solver/azimuthal_order.h"
#include "nacre/solver/order_interpolation.h"
#include "nacre/solver/representative_wavelengths.h"

namespace nacre::solver {

namespace {

// Orders that are solved before one looks whether the series has ended.
constexpr int kChunk = 4;
// Orders after which few wavelengths are looked for that tell all others.
constexpr int kFirstOrders = kChunk;
// Blocks of these. More take longer to find than most paints take to be solved.
constexpr int kMaxBlocksOfFew = 2;

// Making a block takes the time of about so many of its orders.
constexpr int kBlockWork = 10;

// Solves wavelengths that share one index of the binder.
class GroupSolver {
 public:
    // By order from 0 on, as members below.
    struct KnownOrders {
        std::vector<OrderValues> multiple, single;
    };

    GroupSolver(PaintMedium medium, const Resolution& resolution, InternalReflection internal,
                SharedProgress& work, KnownOrders known = {})
        : medium_(std::move(medium)),
          resolution_(resolution),
          internal_(internal),
          work_(work),
          directions_(
              make_directions(medium_.ior[0], resolution.exit_nodes, resolution.inner_nodes)),
          active_(directions_, resolution.lobe_alpha, resolution.orders),
          wavelengths_(medium_.wavelength_count()),
          workspaces_([this] { return OrderWorkspace(directions_.size()); }),
          known_(std::move(known)) {
        const bool rough = medium_.roughness > 0 && directions_.ior > 1;
        if (rough) {
            interface_ = rough_interface_operators(directions_, active_, medium_.roughness);
            // Kept for those who read the solution, who ask for it from all threads at once: each
            // would make it.
            rough_interface(directions_.ior, medium_.roughness);
        }
        const int lit = rough ? directions_.size() : directions_.exit_count;
        blocks_.resize(paint::block_count(wavelengths_));
        few_may_do_ = known_.multiple.empty() && may_be_few();
        make_kernels(few_may_do_ ? OrderRange{0, kFirstOrders} : OrderRange{});
        std::vector<std::vector<Losses>> losses;  // [layer][node]
        for (const LayerMedium& layer : medium_.layers) {
            std::vector<Losses>& by_node = losses.emplace_back(directions_.size());
            parallel_for(0, directions_.size(), [&](int i) {
                work_.throw_if_stopped(kSolving);
                by_node[i] =
                    solver::losses(layer, directions_.mu[i], 0, static_cast<int>(blocks_.size()));
            });
        }
        parallel_for(std::size_t{0}, blocks_.size(), [&](std::size_t b) {
            blocks_[b] =
                make_block(medium_, directions_, kernels_, losses, lit, static_cast<int>(b));
            if (internal == InternalReflection::lost) {
                std::fill(blocks_[b].returned.begin(), blocks_[b].returned.end(), DoubleLanes{});
            }
            work_.add(kBlockWork);
        });
        set_peaks();
        for (int l = 0; l < active_.orders() && active_.first(l) < directions_.exit_count; ++l) {
            first_.push_back(active_.first(l));
        }
    }

    // Solves orders until those omitted sum to less than `tolerance` of the peak.
    GroupSolution run(double tolerance) {
        GroupSolution out;
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
        const std::vector<int> sequence = solved_orders(static_cast<int>(first_.size()));
        double last_chunk = 0;
        const auto count = static_cast<int>(sequence.size());
        for (int from = 0; from < count; from += kChunk) {
            if (from == kFirstOrders && few_may_do_) {
                if (auto few = representatives(kFirstOrders - 1, tolerance)) {
                    return solve_few(std::move(*few), out.unresolved_scattering, tolerance);
                }
                make_kernels({.begin = kFirstOrders});
            }
            const auto chunk_orders =
                std::span(sequence).subspan(from, std::min(kChunk, count - from));
            solve_orders(chunk_orders);
            double chunk = 0;
            for (int l : chunk_orders) {
                // Each stands for those up to the next, too.
                const double stands_for = next_solved_order(l + 1) - l;
                raise_peaks(l, stands_for);
                chunk += 2 * stands_for * size_of(l, known_.multiple[l], known_.single[l]);
            }
            // Sum of the omitted orders, extrapolated as a geometric series from the last two
            // chunks.
            const double ratio = from > 0 ? chunk / std::max(last_chunk, 1e-300) : 1.0;
            out.azimuthal_tail = ratio < 1 ? chunk * ratio / (1 - ratio) : chunk;
            if (from > 0 && out.azimuthal_tail < tolerance) break;
            last_chunk = chunk;
        }
        interpolate_orders(tolerance);
        out.first.assign(first_.begin(), first_.begin() + orders());
        out.values = std::move(known_.multiple);
        if (interface_) out.single_values = std::move(known_.single);
        return out;
    }

 private:
    // Of the layers, in the place of those before, to which blocks point.
    void make_kernels(OrderRange orders) {
        kernels_.clear();
        kernels_.reserve(medium_.layers.size());
        for (const LayerMedium& layer : medium_.layers) {
            kernels_.emplace_back(layer, directions_, active_, static_cast<int>(blocks_.size()),
                                  &work_, orders);
        }
    }

    // The scale of the tolerance: the BRDF in the specular direction of each exit node, by single
    // scattering alone, a lower bound.
    void set_peaks() {
        peak_.assign(static_cast<std::size_t>(directions_.exit_count) * blocks_.size(),
                     DoubleLanes{});
        if (interface_) return;  // see raise_peaks()
        for (std::size_t b = 0; b < blocks_.size(); ++b) {
            for (int i = 0; i < directions_.exit_count; ++i) {
                const double mu = directions_.mu[i];
                DoubleLanes sum{};
                for (std::size_t k = 0; k < medium_.layers.size(); ++k) {
                    sum += backscattering(medium_.layers[k], mu, mu, std::numbers::pi,
                                          static_cast<int>(b)) *
                           blocks_[b].layers[k].single_factor[triangle(i) + i] * (1 / (mu * mu));
                }
                peak_[i * blocks_.size() + b] = sum;
            }
        }
    }

    // Order 0 of what is diffuse counts as peak too; under a rough interface, the sum of the orders
    // so far in the specular direction.
    void raise_peaks(int order, double stands_for) {
        const int first = first_[order], rows = directions_.exit_count - first;
        const std::size_t blocks = blocks_.size();
        std::size_t at = 0;
        for (int i = 0; i < rows; ++i) {
            DoubleLanes* const peak_i = peak_.data() + (first + i) * blocks;
            for (int j = 0; j <= i; ++j) {
                DoubleLanes* const peak_j = peak_.data() + (first + j) * blocks;
                for (std::size_t b = 0; b < blocks; ++b, ++at) {
                    DoubleLanes value = known_.multiple[order][at];
                    if (interface_) value += known_.single[order][at];
                    if (interface_ && i == j) peak_i[b] += (order ? 2 * stands_for : 1.0) * value;
                    if (order > 0) continue;
                    peak_i[b] = max_lanes(peak_i[b], value);
                    peak_j[b] = max_lanes(peak_j[b], value);
                }
            }
        }
    }

    // Of values of an order, relative to the peaks.
    double size_of(int order, const OrderValues& multiple, const OrderValues& single) const {
        const int first = first_[order], rows = directions_.exit_count - first;
        const std::size_t blocks = blocks_.size();
        DoubleLanes size{};
        std::size_t at = 0;
        for (int i = 0; i < rows; ++i) {
            const DoubleLanes* const peak_i = peak_.data() + (first + i) * blocks;
            for (int j = 0; j <= i; ++j) {
                const DoubleLanes* const peak_j = peak_.data() + (first + j) * blocks;
                for (std::size_t b = 0; b < blocks; ++b, ++at) {
                    DoubleLanes value = multiple[at];
                    if (interface_) value += single[at];
                    const DoubleLanes scale = min_lanes(peak_i[b], peak_j[b]);
                    // Beyond the last wavelength lanes repeat it.
                    size = max_lanes(
                        size, max_lanes(value, -value) / max_lanes(scale, splat(kBlackBrdf)));
                }
            }
        }
        return lane_max(size);
    }

    int max_blocks_of_few() const {
        return std::min(static_cast<int>(blocks_.size()) / 2, kMaxBlocksOfFew);
    }

    // Whether the spectra of what the paint is made of are so few that those of its orders may be.
    bool may_be_few() const {
        const int most = max_blocks_of_few();
        return most > 0 && may_be_represented(spectra_of(medium_), wavelengths_, most * kLanes);
    }

    // Wavelengths that tell all others in the known orders. They are chosen by order 0 and one more;
    // orders err less the higher they are.
    std::optional<RepresentativeWavelengths> representatives(int one_more, double tolerance) const {
        const LaneBuffer rows = scaled_rows({{0, one_more}});
        for (int few = 1; few <= max_blocks_of_few(); ++few) {
            if (!may_be_represented(rows, wavelengths_, few * kLanes)) continue;
            RepresentativeWavelengths found(rows, wavelengths_, few * kLanes);
            if (found.wavelengths().empty()) break;  // all is black
            std::vector<double> errors(orders());
            parallel_for(0, orders(), [&](int l) {
                OrderValues single;
                if (interface_) single = found.again(known_.single[l]);
                errors[l] = error_of(l, found.again(known_.multiple[l]), std::move(single));
            });
            const double error = *std::max_element(errors.begin(), errors.end());
            if (error < kRepresentativesFraction * tolerance) return found;
        }
        return {};
    }

    // Solves further orders at these wavelengths alone.
    GroupSolution solve_few(RepresentativeWavelengths few, double unresolved, double tolerance) {
        KnownOrders known;
        known.single.resize(known_.single.size());
        for (int l = 0; l < orders(); ++l) {
            known.multiple.push_back(few.chosen(known_.multiple[l]));
            if (interface_) known.single[l] = few.chosen(known_.single[l]);
        }
        GroupSolver solver(select_wavelengths(medium_, few.wavelengths()), resolution_, internal_,
                           work_, std::move(known));
        GroupSolution out = solver.run(tolerance);
        out.unresolved_scattering = std::max(out.unresolved_scattering, unresolved);
        out.representatives = std::move(few);
        out.represented_from = orders();
        std::move(known_.multiple.begin(), known_.multiple.end(), out.values.begin());
        if (interface_) {
            std::move(known_.single.begin(), known_.single.end(), out.single_values.begin());
        }
        return out;
    }

    // Values of orders, those of each pair over its largest peak: [row][block].
    LaneBuffer scaled_rows(const std::array<int, 2>& orders) const {
        const std::size_t blocks = blocks_.size();
        LaneBuffer rows;
        for (int l : orders) {
            std::size_t at = 0;
            for (int i = first_[l]; i < directions_.exit_count; ++i) {
                for (int j = first_[l]; j <= i; ++j, at += blocks) {
                    double scale = kBlackBrdf;
                    for (std::size_t b = 0; b < blocks; ++b) {
                        scale = std::max(scale, lane_max(min_lanes(peak_[i * blocks + b],
                                                                   peak_[j * blocks + b])));
                    }
                    const auto add = [&](const OrderValues& values) {
                        for (std::size_t b = 0; b < blocks; ++b)
                            rows.push_back(values[at + b] / scale);
                    };
                    add(known_.multiple[l]);
                    if (interface_) add(known_.single[l]);
                }
            }
        }
        return rows;
    }

    // By how much values of an order that is known err, relative to the peaks. `single` is empty but
    // under a rough interface.
    double error_of(int l, OrderValues multiple, OrderValues single) const {
        for (std::size_t k = 0; k < multiple.size(); ++k) multiple[k] -= known_.multiple[l][k];
        for (std::size_t k = 0; k < single.size(); ++k) single[k] -= known_.single[l][k];
        return size_of(l, multiple, single);
    }

    // In parallel, those that are not known.
    void solve_orders(std::span<const int> wanted) {
        std::vector<int> orders;
        for (int l : wanted) {
            if (l >= this->orders() || known_.multiple[l].empty()) orders.push_back(l);
        }
        if (orders.empty()) return;
        const std::size_t blocks = blocks_.size();
        const std::size_t needed = orders.back() + 1;
        known_.multiple.resize(std::max(known_.multiple.size(), needed));
        known_.single.resize(known_.multiple.size());
        for (int l : orders) {
            const std::size_t pairs = triangle(directions_.exit_count - first_[l]);
            known_.multiple[l].resize(pairs * blocks);
            if (interface_) known_.single[l].resize(pairs * blocks);
        }
        parallel_for(0, orders.size() * blocks, [&](std::size_t task) {
            work_.throw_if_stopped(kSolving);
            const int l = orders[task / blocks];
            const std::size_t b = task % blocks;
            const std::size_t pairs = known_.multiple[l].size() / blocks;
            OrderWorkspace& work = workspaces_.local();
            LaneBuffer values(interface_ ? 2 * pairs : pairs);
            if (interface_) {
                solve_rough_order(blocks_[b], interface_->order(l), directions_, l, work,
                                  values.data() + pairs, values.data());
            } else {
                solve_order(blocks_[b], directions_, active_, l, work, values.data());
            }
            DoubleLanes broken{};  // 0; not a number where a result is not finite
            for (const DoubleLanes& value : values) broken += value - value;
            if (!(lane_sum(broken) == 0)) {
                throw Error(fmt::format(
                    "the solver broke down in azimuthal order {}: a result is not finite; "
                    "please report the recipe",
                    l));
            }
            for (std::size_t pair = 0; pair < pairs; ++pair) {
                known_.multiple[l][pair * blocks + b] = values[pair];
                if (interface_) known_.single[l][pair * blocks + b] = values[pairs + pair];
            }
            work_.add();
        });
    }

    OrderValues interpolated(int l, const std::vector<OrderValues>& known) const {
        return interpolate_order(l, known, first_, directions_.exit_count,
                                 static_cast<int>(blocks_.size()));
    }

    // Orders that were left out: first those at the largest distance from their neighbours, from
    // which the others are interpolated then. Of each stretch one is solved too, to see whether this
    // paint is as smooth as flakes are; if not, all.
    void interpolate_orders(double tolerance) {
        const std::vector<int> probes = probe_orders(orders());
        for (auto probe = probes.rbegin(); probe != probes.rend(); ++probe) {
            const int distance = *probe & -*probe;
            OrderValues multiple = interpolated(*probe, known_.multiple), single;
            if (interface_) single = interpolated(*probe, known_.single);
            solve_orders({&*probe, 1});
            std::vector<int> left_out;
            for (int l = *probe; l < std::min(2 * (*probe - distance), orders()); ++l) {
                if (known_.multiple[l].empty()) left_out.push_back(l);
            }
            const double error = 2.0 * static_cast<double>(left_out.size() + 1) *
                                 error_of(*probe, std::move(multiple), std::move(single));
            if (error > kInterpolationFraction * tolerance) solve_orders(left_out);
            std::vector<int> between;
            for (int l = distance; l < orders(); l += 2 * distance) {
                if (known_.multiple[l].empty()) between.push_back(l);
            }
            parallel_for(0, between.size(), [&](std::size_t k) {
                const int l = between[k];
                OrderValues values = interpolated(l, known_.multiple);
                if (interface_) known_.single[l] = interpolated(l, known_.single);
                known_.multiple[l] = std::move(values);
            });
        }
    }

    // What interpolation between orders may add to the error, of the tolerance.
    static constexpr double kInterpolationFraction = 0.1;
    // By how much representative wavelengths may err in each order, of the tolerance: a thousandth of
    // what compress() may, as at dark angles the errors of all orders show.
    static constexpr double kRepresentativesFraction = 1e-4;

    int orders() const { return static_cast<int>(known_.multiple.size()); }

    PaintMedium medium_;
    Resolution resolution_;
    InternalReflection internal_;
    SharedProgress& work_;
    Directions directions_;
    ActiveNodes active_;
    std::shared_ptr<const RoughInterfaceOperators> interface_;  // if rough
    int wavelengths_;
    std::vector<FourierKernel> kernels_;  // by layer
    std::vector<PaintBlock> blocks_;
    LaneBuffer peak_;  // [exit node][block]
    tbb::enumerable_thread_specific<OrderWorkspace> workspaces_;
    std::vector<int> first_;  // by order: the first active node
    bool few_may_do_ = false;
    // By order; empty where it is not known. The second under a rough interface.
    KnownOrders known_;
};

// Pairs of active exit nodes, of all orders.
std::size_t exit_pairs(const Directions& d, const ActiveNodes& active) {
    std::size_t pairs = 0;
    for (int l = 0; l < active.orders(); ++l) {
        pairs += triangle(std::max(0, d.exit_count - active.first(l)));
    }
    return pairs;
}

}  // namespace

GroupSolution solve_group(PaintMedium medium, const Resolution& resolution,
                          InternalReflection internal, double tolerance, SharedProgress& work) {
    return GroupSolver(std::move(medium), resolution, internal, work).run(tolerance);
}

double group_work(int wavelengths, const Resolution& resolution) {
    const std::size_t orders = solved_orders(resolution.orders).size();
    return paint::block_count(wavelengths) * static_cast<double>(kBlockWork + orders);
}

GroupMemory group_memory(const PaintMedium& paint, int first_wavelength, int wavelengths,
                         const Resolution& resolution) {
    const Directions d =
        make_directions(paint.ior[first_wavelength], resolution.exit_nodes, resolution.inner_nodes);
    const ActiveNodes active(d, resolution.lobe_alpha, resolution.orders);
    const std::size_t tensors = paint.roughness > 0 ? 2 : 1;
    const std::size_t pairs = tensors * exit_pairs(d, active);
    const std::size_t blocks = paint::block_count(wavelengths);
    const std::size_t of_representatives = blocks / 2;
    const std::size_t a_block =
        FourierKernel::bytes(d, active) * paint.layers.size() + pairs * sizeof(DoubleLanes);
    return {(blocks + of_representatives) * a_block, pairs * sizeof(double)};
}

}  // namespace nacre::solver
