#include "nacre/render/direction_distribution.h"

#include <algorithm>
#include <cmath>

#include "nacre/core/parallel.h"

namespace nacre::render {
namespace {

/// d u d v / d omega of the map to the square.
template <class T>
T jacobian(const Vec3<T>& d) {
    const T r2 = d.x * d.x + d.y * d.y;
    const T diamond = max_lanes(d.x, -d.x) + max_lanes(d.y, -d.y);
    // On the axis itself the azimuth is undefined; its limit along x is as good as any.
    return r2 > 0 ? 0.125f * r2 / (diamond * diamond) : T{} + 0.125f;
}

/// A number, or eight, within [low, high].
template <class T>
T clamped(T x, float low, float high) {
    return min_lanes(max_lanes(x, T{} + low), T{} + high);
}

/// The cell of a cumulative distribution of `count` cells in which u falls, and how far along it.
template <class T, class Int>
struct Inversion {
    Int cell;
    T offset;
};
/// @param cdf, guide  of all rows; `row` says which, or which of each
template <class T, class Int>
Inversion<T, Int> invert(const float* cdf, const std::uint16_t* guide, int count, Int row, T u) {
    const Int start = min_lanes(whole(u * static_cast<float>(count)), Int{} + (count - 1));
    Int cell = gather(guide, row * count + start);
    const Int first = row * (count + 1);
    const auto beyond = [&] { return (cell < count - 1) & (gather(cdf, first + cell + 1) <= u); };
    for (auto further = beyond(); any(further); further = beyond()) {
        cell += further ? Int{} + 1 : Int{};
    }
    const T below = gather(cdf, first + cell), width = gather(cdf, first + cell + 1) - below;
    return {cell, width > 0 ? clamped((u - below) / width, 0, 1) : T{} + 0.5f};
}

void fill_guide(const float* cdf, int count, std::uint16_t* guide) {
    int cell = 0;
    for (int i = 0; i < count; ++i) {
        // A little early, for invert() may round u up into this step.
        const float start = static_cast<float>(i) / static_cast<float>(count) - 0x1p-22f;
        while (cell < count - 1 && cdf[cell + 1] <= start) ++cell;
        guide[i] = static_cast<std::uint16_t>(cell);
    }
}

/// Running sums of the weights, normalised to end in exactly 1; uniform where all are zero.
/// Returns the total.
double accumulate(const std::vector<double>& weights, float* cdf) {
    double total = 0;
    for (double w : weights) total += w;
    double sum = 0;
    cdf[0] = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        sum += weights[i];
        cdf[i + 1] = static_cast<float>(total > 0 ? sum / total : (i + 1.0) / weights.size());
    }
    cdf[weights.size()] = 1;
    return total;
}

}  // namespace

std::vector<float> DirectionDistribution::tabulated(int columns, int rows,
                                                    const std::function<float(Vec3f)>& brightness) {
    const std::size_t across = std::size_t{kAcross} * columns, down = std::size_t{kAcross} * rows;
    std::vector<Vec2f> level(across);  // directions along the horizon
    for (std::size_t i = 0; i < across; ++i) {
        const Vec3f d = from_square(Vec2f{(i + 0.5f) / across, 0.5f});
        level[i] = {d.x, d.y};
    }
    std::vector<float> values(across * down);
    parallel_for(0, down, [&](std::size_t row) {
        const float z = 1 - 2 * ((row + 0.5f) / down), r = std::sqrt(1 - z * z);
        for (std::size_t i = 0; i < across; ++i) {
            values[row * across + i] = brightness(Vec3f{r * level[i].x, r * level[i].y, z});
        }
    });
    return values;
}

DirectionDistribution::DirectionDistribution(int columns, int rows,
                                             const std::function<float(Vec3f)>& brightness)
    : DirectionDistribution(columns, rows, tabulated(columns, rows, brightness)) {}

DirectionDistribution::DirectionDistribution(int columns, int rows,
                                             const std::vector<float>& brightness)
    : columns_(columns),
      rows_(rows),
      density_(static_cast<std::size_t>(columns) * rows),
      brightness_(density_.size()),
      column_cdf_(static_cast<std::size_t>(columns + 1) * rows),
      row_cdf_(rows + 1),
      column_guide_(static_cast<std::size_t>(columns) * rows),
      row_guide_(rows) {
    const int points = columns * kAcross;
    // Solid angles of points but for a factor; those of a column of the map are alike.
    std::vector<double> angle(points);
    double all = 0, sphere = 0;  // their sum, and that of brightness times angle, for the mean
    for (int i = 0; i < points; ++i) {
        angle[i] = 1 / jacobian(from_square(Vec2f{(i + 0.5f) / static_cast<float>(points), 0.5f}));
        all += angle[i] * rows * kAcross;
    }
    // The points next to a cell in those around it count as well: an edge that comes into it less far
    // than its first points would have no density there, and light that only few samples of surfaces find.
    const auto sum_about = [&](int column, const auto& value) {
        double sum = 0;
        for (int i = column * kAcross - 1; i <= (column + 1) * kAcross; ++i) {
            sum += value((i + points) % points);
        }
        return sum;
    };
    std::vector<double> cell(density_.size()), lit(points);
    for (int row = 0; row < rows * kAcross; ++row) {
        const float* const values = &brightness[static_cast<std::size_t>(row) * points];
        for (int i = 0; i < points; ++i) {
            lit[i] = values[i] * angle[i];
            sphere += lit[i];
        }
        const int first = std::max((row - 1) / kAcross, 0),
                  last = std::min((row + 1) / kAcross, rows - 1);
        for (int c = 0; c < columns; ++c) {
            const double sum = sum_about(c, [&](int i) { return lit[i]; });
            for (int r = first; r <= last; ++r) {
                cell[static_cast<std::size_t>(r) * columns + c] += sum;
            }
        }
    }
    for (int r = 0; r < rows; ++r) {
        const int counted = kAcross + (r > 0) + (r + 1 < rows);  // rows of points
        for (int c = 0; c < columns; ++c) {
            const std::size_t at = static_cast<std::size_t>(r) * columns + c;
            const double angles = counted * sum_about(c, [&](int i) { return angle[i]; });
            brightness_[at] = static_cast<float>(cell[at] / angles);
        }
    }
    mean_ = static_cast<float>(sphere / all);
    std::vector<double> weights(columns), row_total(rows);
    for (int r = 0; r < rows; ++r) {
        std::copy_n(cell.begin() + static_cast<std::ptrdiff_t>(r) * columns, columns,
                    weights.begin());
        row_total[r] =
            accumulate(weights, &column_cdf_[static_cast<std::size_t>(r) * (columns + 1)]);
    }
    accumulate(row_total, row_cdf_.data());
    for (int r = 0; r < rows; ++r) {
        fill_guide(&column_cdf_[static_cast<std::size_t>(r) * (columns + 1)], columns,
                   &column_guide_[static_cast<std::size_t>(r) * columns]);
    }
    fill_guide(row_cdf_.data(), rows, row_guide_.data());
    // The density is that of the rounded distributions, so that samples and pdf agree exactly.
    for (int r = 0; r < rows; ++r) {
        const float row = (row_cdf_[r + 1] - row_cdf_[r]) * rows;
        const float* cdf = &column_cdf_[static_cast<std::size_t>(r) * (columns + 1)];
        for (int c = 0; c < columns; ++c) {
            density_[static_cast<std::size_t>(r) * columns + c] =
                row * (cdf[c + 1] - cdf[c]) * columns;
        }
    }
}

template <class T>
Vec2<T> DirectionDistribution::to_square(const Vec3<T>& d) {
    const T sum = max_lanes(d.x, -d.x) + max_lanes(d.y, -d.y);
    const T t = d.y / sum;
    const T right = d.y >= 0 ? t : 4 + t;
    const T quarter_turns = d.x >= 0 ? right : 2 - t;  // [0, 4]
    return {sum > 0 ? 0.25f * quarter_turns : T{}, clamped(0.5f * (1 - d.z), 0, 1)};
}
template Vec2f DirectionDistribution::to_square(const Vec3f&);
template Vec2<FloatLanes> DirectionDistribution::to_square(const Vec3Lanes&);

template <class T>
Vec3<T> DirectionDistribution::from_square(Vec2<T> square) {
    const T quarter_turns = 4 * square.x;
    const auto quadrant = min_lanes(whole(quarter_turns), whole(T{}) + 3);
    const T t = quarter_turns - to_float(quadrant);
    const T norm = 1 / sqrt_lanes(t * t + (1 - t) * (1 - t));
    const T z = 1 - 2 * square.y;
    const T r = sqrt_lanes(max_lanes(1 - z * z, T{}));
    const T a = r * (1 - t) * norm;  // along the quadrant's first axis
    const T b = r * t * norm;
    const T x = (quadrant & 1) == 0 ? a : b, y = (quadrant & 1) == 0 ? b : a;
    return {((quadrant + 1) & 2) != 0 ? -x : x, quadrant > 1 ? -y : y, z};
}
template Vec3f DirectionDistribution::from_square(Vec2f);

template <class T>
DirectionSample<T> DirectionDistribution::sample_at(Vec2<T> u) const {
    const auto row = invert(row_cdf_.data(), row_guide_.data(), rows_, whole(T{}), u.y);
    const auto column = invert(column_cdf_.data(), column_guide_.data(), columns_, row.cell, u.x);
    const Vec3<T> direction =
        from_square(Vec2<T>{(to_float(column.cell) + column.offset) / static_cast<float>(columns_),
                            (to_float(row.cell) + row.offset) / static_cast<float>(rows_)});
    const auto cell = row.cell * columns_ + column.cell;
    return {direction, gather(density_.data(), cell) * jacobian(direction),
            gather(brightness_.data(), cell)};
}
template DirectionSample<float> DirectionDistribution::sample_at(Vec2f) const;
template DirectionSample<FloatLanes> DirectionDistribution::sample_at(Vec2<FloatLanes>) const;

template <class T>
auto DirectionDistribution::cell_of(const Vec3<T>& direction) const -> decltype(whole(T{})) {
    const Vec2<T> square = to_square(direction);
    const auto below = [](const T& x, int count) {
        return min_lanes(whole(x * static_cast<float>(count)), whole(T{}) + (count - 1));
    };
    return below(square.y, rows_) * columns_ + below(square.x, columns_);
}

template int DirectionDistribution::cell_of(const Vec3f&) const;
template IntLanes DirectionDistribution::cell_of(const Vec3Lanes&) const;

template <class Cell, class T>
T DirectionDistribution::pdf_in(const Cell& cell, const Vec3<T>& direction) const {
    return gather(density_.data(), cell) * jacobian(direction);
}
template float DirectionDistribution::pdf_in(const int&, const Vec3f&) const;
template FloatLanes DirectionDistribution::pdf_in(const IntLanes&, const Vec3Lanes&) const;

}  // namespace nacre::render
