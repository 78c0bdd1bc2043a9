#pragma once

// Embree 3 (Debian 12) or 4 (Ubuntu 24.04): the include path and the arguments of a ray query are
// all that differs for us. For the folders that trace rays (nacre_use_embree() in CMake).

#include <string>

#include "nacre/core/error.h"

#if NACRE_EMBREE_VERSION == 4
#include <embree4/rtcore.h>
#elif NACRE_EMBREE_VERSION == 3
#include <embree3/rtcore.h>
#else
#error "NACRE_EMBREE_VERSION must be 3 or 4 (set by nacre_use_embree() in CMake)"
#endif

namespace nacre::embree {

/// Throws what Embree reports about `device`, if anything.
inline void check(RTCDevice device, const char* doing) {
    const RTCError error = rtcGetDeviceError(device);
    if (error != RTC_ERROR_NONE) {
        throw Error(std::string("Embree failed while ") + doing + " (error " +
                    std::to_string(static_cast<int>(error)) + ")");
    }
}

/// Finds the closest hit; `coherent` promises that neighbouring calls trace similar rays.
inline void intersect(RTCScene scene, RTCRayHit& ray, bool coherent) {
#if NACRE_EMBREE_VERSION == 4
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.flags = coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
    rtcIntersect1(scene, &ray, &arguments);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags =
        coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    rtcIntersect1(scene, &context, &ray);
#endif
}

/// Sets ray.tfar to -infinity where anything stands in the way.
inline void occluded(RTCScene scene, RTCRay& ray) {
#if NACRE_EMBREE_VERSION == 4
    rtcOccluded1(scene, &ray, nullptr);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
#endif
}

}  // namespace nacre::embree
