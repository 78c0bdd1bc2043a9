#pragma once

#include <memory>
#include <vector>

#include "nacre/bsdf/bsdf.h"

// The time of evaluating and sampling a surface on a patch, outside a renderer.

namespace nacre::study {

/// Squares in all directions, anywhere on a ball of 50 mm and on the unit square over which one is
/// laid out, so that surfaces of either layout can be asked.
///
/// @param area_mm2  of each on the ball, in [1e-12, 1e6]
/// @param fraction  of the unit square, in [1e-18, 0.25]
/// @throws DomainError naming the argument, its value and its range
std::vector<bsdf::Patch> square_patches(double area_mm2, double fraction, int count);

/// The queries of a renderer on a patch.
enum class QueryKind {
    value,             ///< BRDF and density towards a light
    value_and_sample,  ///< the same, and a direction to go on in: one vertex of a path
    repeated_value     ///< a further value on a patch whose flakes have been found
};

struct QueryCost {
    double nanoseconds;  ///< of processor time for each query
    double mean_answer;  ///< mean BRDF over queries and wavelengths, in 1/sr
};

/// A surface with directions as in a renderer: incident ones from all over the hemisphere, by
/// cosine, outgoing ones sampled by the surface's mean. Eight wavelengths.
class QuerySubject {
 public:
    /// @param queries  [1, 2^20]
    QuerySubject(const bsdf::Bsdf& surface, int queries);

    /// Asks about each patch once; with QueryKind::repeated_value about few patches many times.
    /// @param patches  as many as there are queries; empty: the surface's mean is asked for
    QueryCost measure(const std::vector<bsdf::Patch>& patches, QueryKind what) const;

 private:
    struct Query {
        Vec3f wi, wo;
        float u_select;
        Vec2f u;
    };
    std::unique_ptr<const bsdf::BoundBsdf> bound_;
    std::vector<Query> queries_;
};

}  // namespace nacre::study
