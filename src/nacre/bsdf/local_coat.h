#pragma once

#include <optional>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/leaning_flakes.h"
#include "nacre/bsdf/tilted_coat.h"
#include "nacre/bsdf/varied_coat.h"

namespace nacre::bsdf {

/// By which a coat and what lies below it differ at one place from the surface that Bsdf::bind() gives;
/// in the local frame of that place.
struct CoatParameters {
    std::optional<float> deviation = {};  ///< of VariedCoat; none: it is even
    std::optional<Vec2f> lean = {};       ///< of LeaningFlakes; none: they lie flat
    std::optional<Vec2f> slope = {};      ///< of TiltedCoat; none: it is flat
};

/// A surface with what its coat is like at one place.
class LocalCoat {
 public:
    /// @param mean   must outlive this
    /// @param place  of the same frame as wi
    /// @param wi     the direction from which it is seen
    LocalCoat(const BoundBsdf& mean, const CoatParameters& place, Vec3f wi) : surface_(&mean) {
        if (place.deviation) surface_ = &varied_.emplace(*surface_, *place.deviation);
        if (place.lean) {
            surface_ = &leaning_.emplace(*surface_, LeaningFlakes::Lean(*place.lean), wi);
        }
        if (place.slope) surface_ = &tilted_.emplace(*surface_, *place.slope, wi);
    }
    LocalCoat(const LocalCoat&) = delete;
    LocalCoat& operator=(const LocalCoat&) = delete;

    const BoundBsdf& surface() const { return *surface_; }

 private:
    const BoundBsdf* surface_;
    std::optional<VariedCoat> varied_;
    std::optional<LeaningFlakes> leaning_;
    std::optional<TiltedCoat> tilted_;
};

}  // namespace nacre::bsdf
