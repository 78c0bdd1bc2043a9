#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "nacre/core/vec.h"

// Importance sampling of an environment by a piecewise constant density over the sphere.
//
// The sphere is cut by height z (equal areas) and by the "diamond" azimuth, y / (|x| + |y|) within
// each quadrant, whose maps in both directions need no trigonometry:
//     v = (1 - z) / 2,    u = (quadrant + y' / (x' + y')) / 4,
//     du dv / d omega = 1 / (8 (|cos phi| + |sin phi|)^2)

namespace nacre::render {

/// One, or eight.
template <class T>
struct DirectionSample {
    Vec3<T> direction;
    T pdf;         ///< per solid angle
    T brightness;  ///< of the cell, its mean
};

class DirectionDistribution {
 public:
    /// Density in proportion to the mean of `brightness` (finite, >= 0) over each of
    /// columns x rows cells, each count in [1, 65535]. Where it vanishes everywhere the density is
    /// uniform.
    DirectionDistribution(int columns, int rows, const std::function<float(Vec3f)>& brightness);
    /// @param brightness  as tabulated() has it
    DirectionDistribution(int columns, int rows, const std::vector<float>& brightness);
    /// The brightness at the points by which a density is made: kAcross of each cell both ways, row by row.
    static std::vector<float> tabulated(int columns, int rows,
                                        const std::function<float(Vec3f)>& brightness);

    DirectionSample<float> sample(Vec2f u) const { return sample_at(u); }
    DirectionSample<FloatLanes> sample(Vec2<FloatLanes> u) const { return sample_at(u); }
    template <class T>
    T pdf(const Vec3<T>& direction) const {
        return pdf_in(cell_of(direction), direction);
    }
    /// Of the cell, its mean.
    template <class T>
    T brightness(const Vec3<T>& direction) const {
        return brightness_in(cell_of(direction));
    }
    /// The same where the cell is known, as of tables with as many columns and rows.
    template <class T>
    auto cell_of(const Vec3<T>& direction) const -> decltype(whole(T{}));
    template <class Cell, class T>
    T pdf_in(const Cell& cell, const Vec3<T>& direction) const;
    template <class Cell>
    auto brightness_in(const Cell& cell) const {
        return gather(brightness_.data(), cell);
    }
    /// Mean of the brightness over the sphere.
    float mean_brightness() const { return mean_; }

    /// Of one direction or of eight.
    template <class T>
    static Vec2<T> to_square(const Vec3<T>& direction);
    template <class T>
    static Vec3<T> from_square(Vec2<T> square);

 private:
    static constexpr int kAcross = 3;

    template <class T>
    DirectionSample<T> sample_at(Vec2<T> u) const;

    int columns_, rows_;
    float mean_ = 0;
    // Where the search for a number may start: for the i-th of `count` equal steps of u, the cell
    // in which the step begins. It makes inversion a matter of one or two cells.  [chen-1974]
    using Guide = std::vector<std::uint16_t>;

    std::vector<float> density_;     // per cell, mean 1 over the square
    std::vector<float> brightness_;  // per cell, its mean
    std::vector<float> column_cdf_;  // per row: columns + 1 values
    std::vector<float> row_cdf_;     // rows + 1 values
    Guide column_guide_;             // per row: columns values
    Guide row_guide_;                // rows values
};

}  // namespace nacre::render
