#pragma once

#include <cmath>

#include "nacre/core/vec.h"

namespace nacre::sparkle {

/// The piece of a surface over which one sample averages, in the millimetres of object space: of
/// the shape before it is turned and moved, so that what lies on the shape turns and moves with it.
/// A parallelogram about a point, tangent to the surface there.
struct ObjectSpaceFootprint {
    Vec3f position_mm;
    Vec3f normal{0, 0, 1};   ///< unit; of the frame of directions (shading normal)
    Vec3f tangent{1, 0, 0};  ///< unit; where the x axis of that frame points
    Vec3f edge_mm[2];        ///< perpendicular to the normal; both zero: the point alone
    /// How much more than the mean weight what lies at the end of each edge has, and what lies at
    /// its beginning less: linearly, so that patches beside each other may follow a pixel filter.
    float tilt[2] = {0, 0};  ///< in [-1, 1]
};

// Parallelograms in the unit square over which an object is laid out.

/// A box [u_lo, u_hi] x [v_lo, v_hi].
struct Box {
    double u_lo, v_lo, u_hi, v_hi;
};

/// How a box lies to a footprint.
enum class Overlap { none, partial, full };

/// The parallelogram about (u, v) spanned by two edges, cut at the border of the unit square: what
/// a pixel sees of an object. Holds the points  centre + s edge_1 + t edge_2  with s and t in
/// [-1/2, 1/2): half-open, so that footprints that tile the square count each facet once.
class Footprint {
 public:
    /// Any finite numbers; area() is 0 for edges without area, for a footprint beside the square
    /// and for numbers that are not finite: such a footprint holds nothing.
    Footprint(double u, double v, Vec2f edge_1, Vec2f edge_2);

    /// Fraction of the unit square inside the footprint, after cutting.
    double area() const { return area_; }
    /// Bounding box, after cutting.
    const Box& bounds() const { return bounds_; }

    bool contains(double u, double v) const {
        const double s = s_.at(u - u_, v - v_), t = t_.at(u - u_, v - v_);
        return s >= -0.5 && s < 0.5 && t >= -0.5 && t < 0.5;
    }

    /// contains() for points given as fractions of a box.
    struct Within {
        double s, s_du, s_dv, t, t_du, t_dv;

        /// All bits set in the lanes whose points lie inside.
        template <class V>
        auto contains(V u, V v) const {
            const V a = s + s_du * u + s_dv * v, b = t + t_du * u + t_dv * v;
            return (a >= -0.5) & (a < 0.5) & (b >= -0.5) & (b < 0.5);
        }
    };
    Within within(const Box& box) const {
        const double width = box.u_hi - box.u_lo, height = box.v_hi - box.v_lo;
        return {s_.at(box.u_lo - u_, box.v_lo - v_), s_.du * width, s_.dv * height,
                t_.at(box.u_lo - u_, box.v_lo - v_), t_.du * width, t_.dv * height};
    }

    /// Exact (by the separating axes of two parallelograms) up to rounding, which errs towards
    /// `partial`. For boxes inside the unit square.
    Overlap overlap(const Box& box) const;

    /// Area that a box shares with the footprint.
    double shared_area(const Box& box) const;

 private:
    struct Coordinate {  // linear in the offset from the centre
        double du = 0, dv = 0;
        double at(double u, double v) const { return du * u + dv * v; }
    };
    Coordinate s_, t_;
    double u_, v_, area_ = 0;
    Vec2f edge_1_, edge_2_;
    Box bounds_{};
};

inline Overlap Footprint::overlap(const Box& box) const {
    if (box.u_lo >= bounds_.u_hi || box.u_hi <= bounds_.u_lo || box.v_lo >= bounds_.v_hi ||
        box.v_hi <= bounds_.v_lo) {
        return Overlap::none;
    }
    const double half_u = 0.5 * (box.u_hi - box.u_lo), half_v = 0.5 * (box.v_hi - box.v_lo);
    const double u = box.u_lo + half_u - u_, v = box.v_lo + half_v - v_;
    const double s = std::abs(s_.at(u, v)), t = std::abs(t_.at(u, v));
    const double reach_s = std::abs(s_.du) * half_u + std::abs(s_.dv) * half_v;
    const double reach_t = std::abs(t_.du) * half_u + std::abs(t_.dv) * half_v;
    constexpr double kSlack = 1e-12;
    if (s > 0.5 + reach_s + kSlack || t > 0.5 + reach_t + kSlack) return Overlap::none;
    const bool full = s + reach_s < 0.5 - kSlack && t + reach_t < 0.5 - kSlack;
    return full ? Overlap::full : Overlap::partial;
}

}  // namespace nacre::sparkle
