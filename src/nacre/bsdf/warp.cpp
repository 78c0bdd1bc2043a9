#include "nacre/bsdf/warp.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/core/lanes.h"

namespace nacre::bsdf {

namespace {

/// Position between increasing nodes: the lower one and the fraction of the way to the next.
struct NodePosition {
    int lower;
    float fraction;
};
NodePosition locate_between(const std::vector<float>& nodes, float x) {
    if (!(x > nodes.front())) return {0, 0.0f};
    if (x >= nodes.back()) return {static_cast<int>(nodes.size()) - 1, 0.0f};
    const int lower =
        static_cast<int>(std::upper_bound(nodes.begin(), nodes.end(), x) - nodes.begin()) - 1;
    return {lower, (x - nodes[lower]) / (nodes[lower + 1] - nodes[lower])};
}

/// Beyond the last node of NodeRows: more than any integral of a density over a square with at most
/// so many nodes, and no infinity, of which a mixture would be none.
constexpr float kBeyond = 1e30f;

/// Largest index in [0, nodes - 2] at which an increasing function is at most x; 0 if there is none.
/// @param eight            its values from an index on
/// @param first_of_eights  likewise, of the indices 0, 8, 16, ...
template <class Eight, class Firsts>
int last_not_above(int nodes, float x, const Eight& eight, const Firsts& first_of_eights) {
    int eights = 0;
    for (int at = 0; at * kLanes < nodes - 1; at += kLanes) {
        const int found = count_lanes(first_of_eights(at) <= x);
        eights += found;
        if (found < kLanes) break;
    }
    const int first = std::max(eights - 1, 0) * kLanes;
    return std::clamp(first + count_lanes(eight(first) <= x) - 1, 0, nodes - 2);
}

/// The t in [0, 1] up to which a line from a to b has a given area below it.
float where_area_is(float a, float b, float area) {
    const float root = std::sqrt(std::max(0.0f, a * a + 2 * (b - a) * area));
    const float sum = a + root;  // no difference of like numbers, whichever of a and b is larger
    return sum > 0 ? std::clamp(2 * area / sum, 0.0f, 1.0f) : 0.0f;
}

std::size_t whole_eights(std::size_t count) { return (count + kLanes - 1) / kLanes * kLanes; }

}  // namespace

SliceGrid::SliceGrid(std::vector<float> first, std::vector<float> second)
    : first_(std::move(first)), second_(std::move(second)) {
    if (first_.empty() || second_.empty()) throw DomainError("a grid of slices has no nodes");
}

SliceMix SliceGrid::locate(float first, float second) const {
    const NodePosition a = locate_between(first_, first), b = locate_between(second_, second);
    SliceMix mix;
    const int width = static_cast<int>(second_.size());
    const auto add = [&](int i, int j, float weight) {
        if (weight <= 0) return;
        mix.slice[mix.count] = i * width + j;
        mix.weight[mix.count++] = weight;
    };
    add(a.lower, b.lower, (1 - a.fraction) * (1 - b.fraction));
    add(a.lower, b.lower + 1, (1 - a.fraction) * b.fraction);
    add(a.lower + 1, b.lower, a.fraction * (1 - b.fraction));
    add(a.lower + 1, b.lower + 1, a.fraction * b.fraction);
    return mix;
}

NodeRows::NodeRows(std::size_t rows, int nodes) {
    const std::size_t eights = whole_eights(nodes) / kLanes;
    // The last node is never the lower one of two, so that an eight of it alone need not be found.
    const std::size_t searched = whole_eights(nodes - 1) / kLanes;
    const std::size_t header_lines = (whole_eights(searched) / kLanes + 1) / 2;
    header_ = header_lines * (2 * kLanes);
    lines_a_row_ = header_lines + eights;
    Line beyond;
    beyond.values.fill(kBeyond);
    lines_.assign(rows * lines_a_row_, beyond);
}

void NodeRows::set_row(std::size_t row, std::span<const float> increasing,
                       std::span<const float> other) {
    Line* const lines = &lines_[row * lines_a_row_];
    const std::size_t header_lines = header_ / (2 * kLanes), nodes = increasing.size();
    for (std::size_t node = 0; node < nodes; ++node) {
        Line& line = lines[header_lines + node / kLanes];
        line.values[node % kLanes] = increasing[node];
        line.values[kLanes + node % kLanes] = other[node];
        if (node % kLanes == 0 && node + 1 < nodes) {
            lines[node / kLanes / (2 * kLanes)].values[node / kLanes % (2 * kLanes)] =
                increasing[node];
        }
    }
}

SquareWarp::SquareWarp(std::span<const float> values, int slices, int rows, int columns,
                       SharedProgress* work)
    : rows_(rows), columns_(columns) {
    const std::size_t cells = static_cast<std::size_t>(rows) * columns;
    if (rows < 2 || columns < 2 || slices < 1 || values.size() != slices * cells) {
        throw DomainError(fmt::format("{} values are no {} tables of {} x {}", values.size(),
                                      slices, rows, columns));
    }
    along_rows_ = NodeRows(static_cast<std::size_t>(slices) * rows, columns);
    over_rows_ = NodeRows(slices, rows);
    std::vector<double> along(cells), under(rows);
    std::vector<float> density(columns), so_far(columns), row_so_far(rows), whole_rows(rows);
    for (int s = 0; s < slices; ++s) {
        if (work) work->throw_if_stopped("preparing a measured BRDF");
        const std::span<const float> in = values.subspan(s * cells, cells);
        const auto integrate = [&](auto&& value) {
            for (int r = 0; r < rows; ++r) {
                double sum = 0;
                for (int c = 0; c < columns; ++c) {
                    const std::size_t at = static_cast<std::size_t>(r) * columns + c;
                    if (c > 0) sum += 0.5 * (value(at - 1) + value(at)) / (columns - 1);
                    along[at] = sum;
                }
                under[r] =
                    r == 0 ? 0.0
                           : under[r - 1] +
                                 0.5 * (along[static_cast<std::size_t>(r) * columns - 1] + sum) /
                                     (rows - 1);
            }
            return under.back();
        };
        const double all = integrate([&](std::size_t at) { return static_cast<double>(in[at]); });
        const bool empty = !(all > 0);
        if (empty) integrate([](std::size_t) { return 1.0; });
        const double scale = empty ? 1.0 : 1 / all;
        for (int r = 0; r < rows; ++r) {
            for (int c = 0; c < columns; ++c) {
                const std::size_t at = static_cast<std::size_t>(r) * columns + c;
                density[c] = static_cast<float>(empty ? 1.0 : in[at] * scale);
                so_far[c] = static_cast<float>(along[at] * scale);
            }
            along_rows_.set_row(static_cast<std::size_t>(s) * rows + r, so_far, density);
            row_so_far[r] = static_cast<float>(under[r] * scale);
            whole_rows[r] = so_far.back();
        }
        over_rows_.set_row(s, row_so_far, whole_rows);
    }
}

template <class Slices>
SquareWarp::Point SquareWarp::sample_of(const Slices& mix, Vec2f u) const {
    using warp_detail::mix_of;
    const int row = last_not_above(
        rows_, u.y,
        [&](int at) { return mix([&](std::size_t s) { return over_rows_.eight(s, at); }); },
        [&](int at) {
            return mix([&](std::size_t s) { return over_rows_.first_of_eights(s, at); });
        });
    const float r0 = whole_row(mix, row), r1 = whole_row(mix, row + 1);
    const float t = where_area_is(r0, r1, std::max(0.0f, u.y - below(mix, row)) * (rows_ - 1));

    const float target = u.x * mix_of(r0, r1, t);
    // Of both rows, mixed.
    const auto along = [&](const auto& of_row) {
        const auto lower = mix([&](std::size_t s) { return of_row(s * rows_ + row); });
        const auto upper = mix([&](std::size_t s) { return of_row(s * rows_ + row + 1); });
        return mix_of(lower, upper, decltype(lower){} + t);
    };
    const int column = last_not_above(
        columns_, target,
        [&](int at) { return along([&](std::size_t r) { return along_rows_.eight(r, at); }); },
        [&](int at) {
            return along([&](std::size_t r) { return along_rows_.first_of_eights(r, at); });
        });
    const float d0 = mix_of(value(mix, row, column), value(mix, row + 1, column), t);
    const float d1 = mix_of(value(mix, row, column + 1), value(mix, row + 1, column + 1), t);
    const float before = along([&](std::size_t r) { return along_rows_.increasing(r, column); });
    const float s = where_area_is(d0, d1, std::max(0.0f, target - before) * (columns_ - 1));
    return {{(column + s) / (columns_ - 1), (row + t) / (rows_ - 1)}, mix_of(d0, d1, s)};
}
template SquareWarp::Point SquareWarp::sample_of(const Mixture<2>&, Vec2f) const;
template SquareWarp::Point SquareWarp::sample_of(const Mixture<0>&, Vec2f) const;

}  // namespace nacre::bsdf
