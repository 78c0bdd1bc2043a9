#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "nacre/core/lanes.h"
#include "nacre/core/vec.h"
#include "nacre/solver/multiple_scattering.h"

// The smooth part of a paint on a grid, for evaluation in tens of nanoseconds: Fourier sums and
// polynomial interpolation cost microseconds.
//
// Coordinates that follow the lobes, so that few cells do, and that cover all pairs of directions
// without a hole. With x = tan(theta/2) in [0, 1] of the two directions outside,
//
//     a = max(x_i, x_o),   b = 1 - min(x_i, x_o)/a,   q = sin(phi'/2),
//
// phi' the azimuth from the mirror side: b and q lead away from the mirror direction. Grid lines
// are even in the square roots of all three, hence dense near the normal and the mirror direction,
// where the lobes are. A table in these coordinates is reciprocal by construction. What is stored
// is f_multiple without Fresnel factors times mu_i + mu_o (inside), which takes out the growth
// towards grazing angles of a paint without a coat.

namespace nacre::bsdf {

/// Number of grid lines in each coordinate.
struct SmoothGrid {
    int a = 0, b = 0, q = 0;

    std::size_t cells() const { return static_cast<std::size_t>(a) * b * q; }
};

/// Where a pair of directions falls into the grid: the lower corner of a cell and the fractions.
struct SmoothCell {
    int index;  // of the lower corner
    float fa, fb, fq;
};

/// wi and wo in the upper hemisphere, z up; s their sines, x the tangents of half their angles.
inline SmoothCell locate(const SmoothGrid& grid, Vec3f wi, Vec3f wo, float s_i, float s_o,
                         float x_i, float x_o) {
    const float a = std::min(std::max(x_i, x_o), 1.0f);
    const float b = a > 0 ? std::abs(x_i - x_o) / a : 0.0f;
    // sin^2(phi'/2) = |s_i wo + s_o wi|^2/(2 s_i s_o)^2 without cancellation near the mirror side.
    const float ux = s_i * wo.x + s_o * wi.x, uy = s_i * wo.y + s_o * wi.y;
    const float scale = 4 * s_i * s_i * s_o * s_o;
    const float q2 = scale > 0 ? std::min((ux * ux + uy * uy) / scale, 1.0f) : 0.0f;

    SmoothCell cell;
    const float ga = std::sqrt(a) * (grid.a - 1), gb = std::sqrt(b) * (grid.b - 1);
    const float gq = std::sqrt(std::sqrt(q2)) * (grid.q - 1);
    const int ia = std::min(static_cast<int>(ga), grid.a - 2);
    const int ib = std::min(static_cast<int>(gb), grid.b - 2);
    const int iq = std::min(static_cast<int>(gq), grid.q - 2);
    cell.index = (ia * grid.b + ib) * grid.q + iq;
    cell.fa = ga - ia;
    cell.fb = gb - ib;
    cell.fq = gq - iq;
    return cell;
}

/// Trilinear interpolation of lanes stored by cell.
inline FloatLanes interpolate(const SmoothGrid& grid, const FloatLanes* values,
                              const SmoothCell& cell) {
    const FloatLanes* p = values + cell.index;
    const int row = grid.q, slab = grid.b * grid.q;
    const auto line = [&](const FloatLanes* at) { return at[0] + cell.fq * (at[1] - at[0]); };
    const FloatLanes v00 = line(p), v01 = line(p + row);
    const FloatLanes v10 = line(p + slab), v11 = line(p + slab + row);
    const FloatLanes v0 = v00 + cell.fb * (v01 - v00), v1 = v10 + cell.fb * (v11 - v10);
    return v0 + cell.fa * (v1 - v0);
}

/// Has the corners of a cell brought into the cache, for an interpolate() that comes later.
inline void prefetch(const SmoothGrid& grid, const FloatLanes* values, const SmoothCell& cell) {
    const FloatLanes* const p = values + cell.index;
    for (const FloatLanes* line :
         {p, p + grid.q, p + grid.b * grid.q, p + grid.b * grid.q + grid.q}) {
        __builtin_prefetch(line);
        __builtin_prefetch(line + 1);
    }
}

/// Free list of the memory of one SmoothTable's bound tables: a picture binds one a pass, and fresh pages
/// cost more than filling them.
class SmoothTableMemory {
 public:
    struct GiveBack {
        std::shared_ptr<SmoothTableMemory> to;
        void operator()(FloatLanes* values) const;
    };

    /// @param cells  the same at each call
    /// @return values that nobody has written
    static std::unique_ptr<FloatLanes[], GiveBack> take(
        const std::shared_ptr<SmoothTableMemory>& from, std::size_t cells);

 private:
    std::mutex mutex_;
    std::size_t made_ = 0;
    std::vector<std::unique_ptr<FloatLanes[]>> free_;  // with room for all that were made
};

/// A SmoothTable at eight wavelengths: a value for each cell.
using BoundSmoothTable = std::unique_ptr<FloatLanes[], SmoothTableMemory::GiveBack>;

/// The table before it is bound to wavelengths: coefficients of the multiple scattering's spectral
/// basis.
class SmoothTable {
 public:
    /// Tabulates the sum of tensors on the same exit angles; `alpha` is the roughness of the
    /// narrowest lobe, `ior` the binder's mean index. The spectral bases stand one after the other.
    SmoothTable(std::span<const solver::MultipleScattering* const> tensors, double alpha,
                double ior);

    const SmoothGrid& grid() const { return grid_; }

    /// [cell][k], for programs that look them up themselves.
    std::span<const float> coefficients() const { return coefficient_; }
    int rank() const { return rank_; }

    /// Values at eight wavelengths: for each cell sum over k of basis[k] coefficient[first + k].
    /// @param basis  of rank() or less
    BoundSmoothTable bind(int first, std::span<const FloatLanes> basis) const;

 private:
    void tabulate(const solver::MultipleScattering& tensor, double ior, int first_rank);

    SmoothGrid grid_;
    int rank_ = 0;
    std::vector<float> coefficient_;  // [cell][k]
    std::shared_ptr<SmoothTableMemory> memory_ = std::make_shared<SmoothTableMemory>();
};

}  // namespace nacre::bsdf
