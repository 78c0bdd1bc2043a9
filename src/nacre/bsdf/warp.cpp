#include "nacre/bsdf/warp.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"

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

/// Largest index in [0, size - 2] at which an increasing function is at most x; 0 if there is none.
template <class F>
int last_not_above(int size, float x, F&& function) {
    int low = 0, high = size - 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        (function(middle) <= x ? low : high) = middle;
    }
    return low;
}

/// Area below a line from a to b over [0, t], and the t in [0, 1] that has a given area.
float area_to(float a, float b, float t) { return t * (a + 0.5f * (b - a) * t); }
float where_area_is(float a, float b, float area) {
    const float root = std::sqrt(std::max(0.0f, a * a + 2 * (b - a) * area));
    const float sum = a + root;  // no difference of like numbers, whichever of a and b is larger
    return sum > 0 ? std::clamp(2 * area / sum, 0.0f, 1.0f) : 0.0f;
}

float mix_of(float a, float b, float t) { return a + t * (b - a); }

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

SquareWarp::SquareWarp(std::span<const float> values, int slices, int rows, int columns,
                       SharedProgress* work)
    : rows_(rows), columns_(columns), cells_(static_cast<std::size_t>(rows) * columns) {
    if (rows < 2 || columns < 2 || slices < 1 || values.size() != slices * cells_) {
        throw DomainError(fmt::format("{} values are no {} tables of {} x {}", values.size(),
                                      slices, rows, columns));
    }
    density_.resize(values.size());
    row_integral_.resize(values.size());
    below_.resize(static_cast<std::size_t>(slices) * rows);
    std::vector<double> along(cells_), under(rows);
    for (int s = 0; s < slices; ++s) {
        if (work) work->require_going("preparing a measured BRDF");
        const std::span<const float> in = values.subspan(s * cells_, cells_);
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
        for (std::size_t i = 0; i < cells_; ++i) {
            density_[s * cells_ + i] = static_cast<float>(empty ? 1.0 : in[i] * scale);
            row_integral_[s * cells_ + i] = static_cast<float>(along[i] * scale);
        }
        for (int r = 0; r < rows; ++r) {
            below_[static_cast<std::size_t>(s) * rows + r] = static_cast<float>(under[r] * scale);
        }
    }
}

SquareWarp::Point SquareWarp::sample(const SliceMix& mix, Vec2f u) const {
    const int row = last_not_above(rows_, u.y, [&](int r) { return below(mix, r); });
    const float r0 = along_row(mix, row, columns_ - 1), r1 = along_row(mix, row + 1, columns_ - 1);
    const float t = where_area_is(r0, r1, std::max(0.0f, u.y - below(mix, row)) * (rows_ - 1));

    const float target = u.x * mix_of(r0, r1, t);
    const auto along = [&](int c) {
        return mix_of(along_row(mix, row, c), along_row(mix, row + 1, c), t);
    };
    const int column = last_not_above(columns_, target, along);
    const float d0 = mix_of(value(mix, row, column), value(mix, row + 1, column), t);
    const float d1 = mix_of(value(mix, row, column + 1), value(mix, row + 1, column + 1), t);
    const float s = where_area_is(d0, d1, std::max(0.0f, target - along(column)) * (columns_ - 1));
    return {{(column + s) / (columns_ - 1), (row + t) / (rows_ - 1)}, mix_of(d0, d1, s)};
}

SquareWarp::Point SquareWarp::invert(const SliceMix& mix, Vec2f point) const {
    const SquareCell<float> cell = locate_in_square(point, rows_, columns_);
    const int row = cell.row, column = cell.column;
    const float t = cell.row_fraction, s = cell.column_fraction;
    const float r0 = along_row(mix, row, columns_ - 1), r1 = along_row(mix, row + 1, columns_ - 1);
    const float y = below(mix, row) + area_to(r0, r1, t) / (rows_ - 1);
    const float d0 = mix_of(value(mix, row, column), value(mix, row + 1, column), t);
    const float d1 = mix_of(value(mix, row, column + 1), value(mix, row + 1, column + 1), t);
    const float whole = mix_of(r0, r1, t);
    const float part = mix_of(along_row(mix, row, column), along_row(mix, row + 1, column), t) +
                       area_to(d0, d1, s) / (columns_ - 1);
    const float x = whole > 0 ? part / whole : point.x;
    return {{std::clamp(x, 0.0f, 1.0f), std::clamp(y, 0.0f, 1.0f)}, mix_of(d0, d1, s)};
}

}  // namespace nacre::bsdf
