#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "nacre/core/lanes.h"
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

/// Increasing functions of the nodes 0, 1, ... of a table, one a row, each with another function of
/// the nodes, laid out so that mixtures of rows are searched eight nodes at a time and what is wanted
/// of the place that is found lies in the same line of the cache.
class NodeRows {
 public:
    NodeRows() = default;
    /// @param nodes  at least 2
    NodeRows(std::size_t rows, int nodes);
    /// @param increasing  one value a node, the first of them 0
    void set_row(std::size_t row, std::span<const float> increasing, std::span<const float> other);

    /// The increasing function and the other one, at a node or at eight.
    template <class Int>
    auto increasing(std::size_t row, Int node) const {
        return gather(in_row(row) + header_, place(node));
    }
    template <class Int>
    auto other(std::size_t row, Int node) const {
        return gather(in_row(row) + header_ + kLanes, place(node));
    }
    /// The same at one node of rows of their own, counted from `row` on.
    FloatLanes increasing(std::size_t row, IntLanes rows, IntLanes node) const {
        return gather(in_row(row) + header_, rows * static_cast<int>(stride()) + place(node));
    }
    FloatLanes other(std::size_t row, IntLanes rows, IntLanes node) const {
        return gather(in_row(row) + header_ + kLanes,
                      rows * static_cast<int>(stride()) + place(node));
    }
    float increasing(std::size_t row, int rows, int node) const {
        return increasing(row + rows, node);
    }
    float other(std::size_t row, int rows, int node) const { return other(row + rows, node); }

    /// The increasing function from a node on that is a multiple of eight. Beyond the last node it is
    /// very large.
    FloatLanes eight(std::size_t row, int first) const {
        return load_lanes(in_row(row) + header_ + 2 * first);
    }
    /// The same at the first nodes of eights, counted from `first` on, a multiple of eight.
    FloatLanes first_of_eights(std::size_t row, int first) const {
        return load_lanes(in_row(row) + first);
    }

 private:
    struct alignas(64) Line {
        std::array<float, 2 * kLanes> values;
    };
    // A row is the first nodes of its eights; then eight by eight the one function and the other.
    template <class Int>
    static Int place(Int node) {
        return node + (node & ~(kLanes - 1));
    }
    std::size_t stride() const { return lines_a_row_ * (2 * kLanes); }
    const float* in_row(std::size_t row) const { return lines_[row * lines_a_row_].values.data(); }

    std::size_t lines_a_row_ = 0, header_ = 0;
    std::vector<Line> lines_;
};

/// One table per slice, each made a density (its bilinear interpolant integrates to 1; a slice of
/// zeros becomes the uniform density), mixed linearly.
///
/// The map of sample() is the inverse Rosenblatt transform: first y from its marginal, then x given
/// y, both of which the mixture's distribution functions give in closed form.
///                                                                  [rosenblatt-1952]
class SquareWarp {
    /// Of two slices, nearly always, in which case the compiler is told; 0: as many as it says.
    template <int count>
    struct Mixture {
        const SliceMix& mix;

        /// The mixture of what value(slice) gives, a number or eight.
        template <class Value>
        auto operator()(const Value& value) const {
            decltype(value(std::size_t{})) sum{};
            for (int k = 0; k < (count ? count : mix.count); ++k) {
                sum += mix.weight[k] * value(static_cast<std::size_t>(mix.slice[k]));
            }
            return sum;
        }
    };
    template <class F>
    static auto by_count(const SliceMix& mix, const F& f) {
        return mix.count == 2 ? f(Mixture<2>{mix}) : f(Mixture<0>{mix});
    }

 public:
    /// @param values  [slice][row][column], not negative
    /// @throws Stopped if `work`, which may be null, asks to stop
    SquareWarp(std::span<const float> values, int slices, int rows, int columns,
               SharedProgress* work = nullptr);

    struct Point {
        Vec2f at;
        float density;  ///< of the point in the square: in `at` for sample(), given for invert()
    };
    /// From uniform numbers in [0, 1]^2 to a point with the mixture's density.
    Point sample(const SliceMix& mix, Vec2f u) const {
        return by_count(mix, [&](auto mixture) { return sample_of(mixture, u); });
    }
    /// The uniform numbers that lead to a point.
    Point invert(const SliceMix& mix, Vec2f point) const {
        const auto [at, density] = invert_at(mix, point);
        return {at, density};
    }
    /// Of one point or of eight.
    template <class T>
    struct Inverse {
        Vec2<T> at;
        T density;  ///< of the point given
    };
    template <class T>
    Inverse<T> invert_at(const SliceMix& mix, const Vec2<T>& point) const {
        return by_count(mix, [&](auto mixture) { return inverse_of(mixture, point); });
    }
    /// Of one point or of eight.
    template <class T>
    T density(const SliceMix& mix, const Vec2<T>& point) const {
        return by_count(mix, [&](auto mixture) { return density_of(mixture, point); });
    }

 private:
    template <class Slices>
    Point sample_of(const Slices& mix, Vec2f u) const;
    template <class Slices, class T>
    Inverse<T> inverse_of(const Slices& mix, const Vec2<T>& point) const;
    template <class Slices, class T>
    T density_of(const Slices& mix, const Vec2<T>& point) const;
    // Of one place or of eight.

    template <class Slices, class Int>
    auto value(const Slices& mix, Int row, Int column) const {
        return mix([&](std::size_t s) { return along_rows_.other(s * rows_, row, column); });
    }
    /// Integral of a row up to a column.
    template <class Slices, class Int>
    auto along_row(const Slices& mix, Int row, Int column) const {
        return mix([&](std::size_t s) { return along_rows_.increasing(s * rows_, row, column); });
    }
    template <class Slices, class Int>
    auto whole_row(const Slices& mix, Int row) const {
        return mix([&](std::size_t s) { return over_rows_.other(s, row); });
    }
    /// Integral of everything below a row.
    template <class Slices, class Int>
    auto below(const Slices& mix, Int row) const {
        return mix([&](std::size_t s) { return over_rows_.increasing(s, row); });
    }

    int rows_, columns_;
    NodeRows along_rows_;  // by slice and row: integrals up to a column, densities
    NodeRows over_rows_;   // by slice: integrals below a row, and of it
};

namespace warp_detail {

/// Area below a line from a to b over [0, t].
template <class T>
T area_to(const T& a, const T& b, const T& t) {
    return t * (a + 0.5f * (b - a) * t);
}
template <class T>
T mix_of(const T& a, const T& b, const T& t) {
    return a + t * (b - a);
}

}  // namespace warp_detail

template <class Slices, class T>
T SquareWarp::density_of(const Slices& mix, const Vec2<T>& point) const {
    const SquareCell<T> cell = locate_in_square(point, rows_, columns_);
    const auto row_value = [&](auto row) {
        const T left = value(mix, row, cell.column), right = value(mix, row, cell.column + 1);
        return left + cell.column_fraction * (right - left);
    };
    const T lower = row_value(cell.row), upper = row_value(cell.row + 1);
    return lower + cell.row_fraction * (upper - lower);
}

template <class Slices, class T>
SquareWarp::Inverse<T> SquareWarp::inverse_of(const Slices& mix, const Vec2<T>& point) const {
    using warp_detail::area_to;
    using warp_detail::mix_of;
    const SquareCell<T> cell = locate_in_square(point, rows_, columns_);
    const auto row = cell.row, column = cell.column;
    const T t = cell.row_fraction, s = cell.column_fraction;
    const T r0 = whole_row(mix, row), r1 = whole_row(mix, row + 1);
    const T y = below(mix, row) + area_to(r0, r1, t) / static_cast<float>(rows_ - 1);
    const T d0 = mix_of(value(mix, row, column), value(mix, row + 1, column), t);
    const T d1 = mix_of(value(mix, row, column + 1), value(mix, row + 1, column + 1), t);
    const T all = mix_of(r0, r1, t);
    const T part = mix_of(along_row(mix, row, column), along_row(mix, row + 1, column), t) +
                   area_to(d0, d1, s) / static_cast<float>(columns_ - 1);
    const T x = all > 0 ? part / all : point.x;
    const auto in_square = [](const T& v) { return min_lanes(max_lanes(v, T{}), T{} + 1); };
    return {{in_square(x), in_square(y)}, mix_of(d0, d1, s)};
}

}  // namespace nacre::bsdf
