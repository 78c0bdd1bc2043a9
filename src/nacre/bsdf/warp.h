#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "nacre/core/progress.h"
#include "nacre/core/vec.h"

// Maps from the unit square to other domains that keep relative areas, and so the uniformity of a
// sampling pattern.

namespace nacre::bsdf {

/// From [0, 1)^2 to the unit disk, with constant density 1 / pi.
///                                                                    [shirley-1997-map, section 3]
inline Vec2f concentric_disk(Vec2f u) {
    const float a = 2 * u.x - 1;
    const float b = 2 * u.y - 1;
    if (a == 0 && b == 0) return {0, 0};
    constexpr float kQuarterPi = std::numbers::pi_v<float> / 4;
    const bool wide = std::abs(a) > std::abs(b);
    const float r = wide ? a : b;
    const float angle = wide ? kQuarterPi * (b / a) : 2 * kQuarterPi - kQuarterPi * (a / b);
    return {r * std::cos(angle), r * std::sin(angle)};
}

/// From [0, 1)^2 to the upper hemisphere, with density cos(theta) / pi per solid angle.
inline Vec3f cosine_hemisphere(Vec2f u) {
    const Vec2f d = concentric_disk(u);
    return {d.x, d.y, std::sqrt(std::max(0.0f, 1 - d.x * d.x - d.y * d.y))};
}

// Densities on the unit square that depend on two parameters, and the maps by their distribution
// functions, of which the adaptive parameterization is made.               [dupuy-jakob-2018]

/// The slices of a table that are mixed for an incident direction, and their weights; at most four.
struct SliceMix {
    std::array<int, 4> slice{};
    std::array<float, 4> weight{};
    int count = 0;
};

/// The nodes of both parameters; slices are numbered with the second parameter running fastest.
class SliceGrid {
 public:
    /// @param first, second  increasing, at least one each
    SliceGrid(std::vector<float> first, std::vector<float> second);
    /// Linear between nodes, constant beyond them.
    SliceMix locate(float first, float second) const;
    const std::vector<float>& first() const { return first_; }
    const std::vector<float>& second() const { return second_; }

 private:
    std::vector<float> first_, second_;
};

/// Where a point of the unit square lies among the nodes of a table: the lower node and the
/// fraction of the way to the next. Points outside are moved to the edge.
template <class T>
struct SquareCell {
    decltype(whole(T{})) row, column;
    T row_fraction, column_fraction;
};
template <class T>
SquareCell<T> locate_in_square(Vec2<T> point, int rows, int columns) {
    const auto place = [](T v, int nodes) {
        const T inside = v > 0 ? min_lanes(v, T{} + 1) : T{};  // NaN too
        return inside * static_cast<float>(nodes - 1);
    };
    const T x = place(point.x, columns), y = place(point.y, rows);
    const auto column = min_lanes(whole(x), whole(T{}) + (columns - 2));
    const auto row = min_lanes(whole(y), whole(T{}) + (rows - 2));
    return {row, column, y - to_float(row), x - to_float(column)};
}

/// One table per slice, each made a density (its bilinear interpolant integrates to 1; a slice of
/// zeros becomes the uniform density), mixed linearly.
///
/// The map of sample() is the inverse Rosenblatt transform: first y from its marginal, then x given
/// y, both of which the mixture's distribution functions give in closed form.
///                                                                  [rosenblatt-1952]
class SquareWarp {
 public:
    /// @param values  [slice][row][column], not negative
    /// @throws Stopped if `work`, which is asked where it is not null, says so
    SquareWarp(std::span<const float> values, int slices, int rows, int columns,
               SharedProgress* work = nullptr);

    struct Point {
        Vec2f at;
        float density;  ///< of the point in the square: in `at` for sample(), given for invert()
    };
    /// From uniform numbers in [0, 1]^2 to a point with the mixture's density.
    Point sample(const SliceMix& mix, Vec2f u) const;
    /// The uniform numbers that lead to a point.
    Point invert(const SliceMix& mix, Vec2f point) const;
    /// Of one point or of eight.
    template <class T>
    T density(const SliceMix& mix, Vec2<T> point) const;

 private:
    /// @param at  a place in a slice, or eight
    template <class Int>
    auto mixed(const std::vector<float>& table, std::size_t stride, const SliceMix& mix,
               Int at) const {
        decltype(to_float(at)) sum{};
        for (int k = 0; k < mix.count; ++k) {
            sum += mix.weight[k] * gather(&table[mix.slice[k] * stride], at);
        }
        return sum;
    }
    template <class Int>
    auto value(const SliceMix& mix, Int row, Int column) const {
        return mixed(density_, cells_, mix, row * columns_ + column);
    }
    /// Integral of a row up to a column; up to the last: the whole row.
    float along_row(const SliceMix& mix, int row, int column) const {
        return mixed(row_integral_, cells_, mix, row * columns_ + column);
    }
    /// Integral of everything below a row.
    float below(const SliceMix& mix, int row) const { return mixed(below_, rows_, mix, row); }

    int rows_, columns_;
    std::size_t cells_;
    std::vector<float> density_, row_integral_, below_;
};

template <class T>
T SquareWarp::density(const SliceMix& mix, Vec2<T> point) const {
    const SquareCell<T> cell = locate_in_square(point, rows_, columns_);
    const auto row_value = [&](auto row) {
        const T left = value(mix, row, cell.column), right = value(mix, row, cell.column + 1);
        return left + cell.column_fraction * (right - left);
    };
    const T lower = row_value(cell.row), upper = row_value(cell.row + 1);
    return lower + cell.row_fraction * (upper - lower);
}

}  // namespace nacre::bsdf
