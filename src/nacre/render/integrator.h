#pragma once

#include <memory>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/render/camera.h"
#include "nacre/render/compiled_scene.h"
#include "nacre/render/emission.h"
#include "nacre/render/sampler.h"

// Light along one path, at eight wavelengths.

namespace nacre::render {

/// Which estimators of direct light are used. All give the same mean; `combined` is the one to
/// render with, the others exist to test it against.
enum class DirectLight { combined, surface_sampling, light_sampling };

/// What depends on the wavelengths of a pass over the picture, worked out once for all its paths.
struct Pass {
    Pass(const CompiledScene& scene, std::uint32_t sample_index,
         const bsdf::Wavelengths& wavelengths_nm);

    std::uint32_t sample_index;
    bsdf::Wavelengths wavelengths_nm;
    XyzWeights xyz_weights;
    FloatLanes d65;  ///< of luminance 1
    std::vector<FloatLanes> emission;
    FloatLanes common_colour{};  ///< LightSet::common_colour()
    BoundMaterials surfaces;
    std::size_t patch_memory_bytes = 0;  ///< the most that one of them needs
};

struct PathLight {
    FloatLanes radiance{};
    /// What the same path would carry if every surface that varies showed its mean over the area
    /// instead: radiance - smooth is the light of single flakes. Only if asked for.
    FloatLanes smooth{};
    bool met_surface = false;  ///< by the camera ray
    Vec3f normal;              ///< of the surface that it met
    FloatLanes albedo{};       ///< likewise; only if asked for
};

struct PathOptions {
    int max_depth = 8;
    DirectLight direct_light = DirectLight::combined;
    bool albedo = false;
    bool smooth = false;  ///< PathLight::smooth is asked for
    /// Side of the patch over which one sample averages where a surface varies, in pixels.
    float footprint_pixels = 1;
    /// Whether the flakes of surfaces that sample them (BoundBsdf::samples_flakes) are at the first hit; else
    /// they are shown by each sample's own patch.
    bool sample_flakes = true;
};

/// The part of its pixel's footprint whose flakes one sample draws from.
///
/// These samples divide what the pixel sees between them, so that each flake is sampled once,
/// or once for each of the parts that it touches.
struct FlakeStratum {
    Vec2f place;         ///< of the sample in its pixel's filter, in pixels across and down
    Vec2f middle, size;  ///< of the part, its sides across and down
    Vec2f tilt;          ///< of the pixel filter over it (ObjectSpaceFootprint::tilt)
    /// Samples of the pixel for each of its strata: the weight of the light of the flakes that are
    /// sampled. 0: this sample draws from none.
    float samples_per_stratum = 0;
};

/// Follows a path from the camera: at each surface one sample of the lights, chosen among eight where
/// the camera looks [talbot-2005], and one of the surface, weighted by the power heuristic with
/// exponent 2 [veach-1997, eq. 9.13], then Russian roulette by throughput from the fourth surface on,
/// which keeps the mean. The specular reflection at the first surface is a path of its own where the
/// surface tells it from the rest (BoundBsdf::specular_probability).
///
/// Surfaces that vary are looked at through the footprint of the pixel as long as the path has met
/// specular reflections only; further on, where neighbouring paths run apart, their mean is taken.
///
/// At the first surface flakes are sampled one by one, where their light can be had apart, by the
/// samples that `stratum` says.                                          [docs/nacre-model.md, sparkle in pictures]
///
/// @param memory  of pass.patch_memory_bytes; what it held is lost
PathLight trace_path(const CompiledScene& scene, const Pass& pass, const PathSampler& sampler,
                     const CameraRay& camera_ray, const FlakeStratum& stratum,
                     const PathOptions& options, bsdf::PatchMemory& memory);

}  // namespace nacre::render
