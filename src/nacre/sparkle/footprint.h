#pragma once

#include "nacre/core/vec.h"

// Parallelograms in the unit square over which an object is laid out.

namespace nacre::sparkle {

/// A box [u_lo, u_hi] x [v_lo, v_hi].
struct Box {
    double u_lo, v_lo, u_hi, v_hi;
};

/// How a box lies to a footprint.
enum class Overlap { none, partial, whole };

/// The parallelogram about (u, v) spanned by two edges, cut at the border of the unit square: what
/// a pixel sees of an object. Holds the points  centre + s edge_1 + t edge_2  with s and t in
/// [-1/2, 1/2): half-open, so that footprints that tile the square count each facet once.
class Footprint {
 public:
    /// Any finite numbers; area() is 0 for edges without area, for a footprint beside the square
    /// and for numbers that are not finite: such a footprint holds nothing.
    Footprint(double u, double v, Vec2f edge_1, Vec2f edge_2);

    /// Share of the unit square inside the footprint, after cutting.
    double area() const { return area_; }
    /// Bounding box, after cutting.
    const Box& bounds() const { return bounds_; }

    bool contains(double u, double v) const {
        const double s = s_.at(u - u_, v - v_), t = t_.at(u - u_, v - v_);
        return s >= -0.5 && s < 0.5 && t >= -0.5 && t < 0.5;
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

}  // namespace nacre::sparkle
