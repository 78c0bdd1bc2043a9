#include "nacre/render/direct_light.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include "nacre/core/lanes.h"

namespace nacre::render {
namespace {

using bsdf::power_heuristic;

/// The sampler's vertices for the candidates, beyond those of any path.
constexpr std::uint32_t kCandidateVertex = 1u << 17;

/// What is added to a surface's density, per cosine, where it guesses what the surface reflects: so
/// that nothing is left out that the density does not know of.
constexpr float kMinGuess = 0.01f;

/// How light samples are weighed against those of the surface.
struct Weighing {
    bool combined;           ///< with samples of the surface
    float narrow_light_pdf;  ///< LocalSurface::narrow_light_pdf
    float many;              ///< as how many samples that of the lights counts

    bool applies(const LightDirection<float>& light) const {
        return combined && !light.delta && !(light.density > narrow_light_pdf);
    }
};

/// The light sample of those that were drawn.
struct Chosen {
    LightSample light;
    Vec3f wo;
    float scale;  ///< 1 / pdf of one candidate; of several, what takes its place
};

std::optional<Chosen> one_candidate(const CompiledScene& scene, const Pass& pass,
                                    const SurfaceInteraction& at, const LocalSurface& surface,
                                    const VertexNumbers& u, bool alone) {
    const auto light = scene.lights->sample(at.hit.position_mm, u.which_light, u.light,
                                            pass.emission.data(), alone);
    if (!light) return std::nullopt;
    const Vec3f wo = at.frame.to_local(light->direction);
    const bool behind = wo.z < 0;
    // An interpolated normal can take the light for one on the other side.
    if (wo.z == 0 || (dot(light->direction, at.hit.geometric_normal) <= 0) != behind) {
        return std::nullopt;
    }
    if (behind && !surface.bsdf.transmits()) return std::nullopt;
    return Chosen{*light, wo, 1 / light->pdf};
}

/// An order of the candidates in which neighbours lie side by side: light by light and, as their
/// places in the square are eight points of a (0,2)-sequence, one in each of 4 x 2 cells, to and
/// fro through these. All differ.
IntLanes order_of(const LightDirections& lights, const PathSampler::Threes& u) {
    constexpr IntLanes kLane{0, 1, 2, 3, 4, 5, 6, 7};
    const IntLanes column = whole(4 * u.x), row = whole(2 * u.y);
    const IntLanes cell = 4 * row + (row == 0 ? column : 3 - column);
    return ((lights.light * 8 + cell) * kLanes) + kLane;
}

/// The candidate at `target` of the running sum, in [0, sum). Numbers that are even over the samples
/// so give directions that are.
int choose(const FloatLanes& weight, const IntLanes& order, float target) {
    FloatLanes running{};
    for (int k = 0; k < kLanes; ++k) running += order >= order[k] ? weight[k] : FloatLanes{};
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const IntLanes possible = weight > 0;
    const FloatLanes beyond = (possible & (running > target)) ? running : splat(kInfinity);
    const float nearest = -lane_max(-beyond);
    if (nearest < kInfinity) return first_lane(beyond == nearest);
    // The last, where rounding puts all running sums below the target.
    const FloatLanes up_to = possible ? running : splat(-1.0f);
    return first_lane(up_to == lane_max(up_to));
}

std::optional<Chosen> best_of_eight(const CompiledScene& scene, const Pass& pass,
                                    const SurfaceInteraction& at, const LocalSurface& surface,
                                    const PathSampler::Threes& u, float which, bool alone,
                                    const Weighing& weighing) {
    const LightDirections lights = scene.lights->directions(
        at.hit.position_mm, u.choice, {u.x, u.y}, pass.emission.data(), alone);
    const Vec3Lanes wo = at.frame.to_local(lights.direction);
    const FloatLanes cosine = dot(lights.direction, splat(at.hit.geometric_normal));
    const FloatLanes slant = max_lanes(wo.z, -wo.z);
    IntLanes possible = (lights.pdf > 0) & ((wo.z > 0) & (cosine > 0));
    if (surface.bsdf.transmits()) possible |= (lights.pdf > 0) & ((wo.z < 0) & (cosine <= 0));
    if (!any(possible)) return std::nullopt;

    const FloatLanes pdf = surface.pdf_lanes(at.wi, wo);
    FloatLanes target = lights.brightness * (pdf + kMinGuess * slant);
    if (weighing.combined) {
        const FloatLanes ratio = pdf / (weighing.many * lights.pdf);
        const IntLanes alone_there = lights.delta | (lights.density > weighing.narrow_light_pdf);
        target = alone_there ? target : target / (1 + ratio * ratio);
    }
    const FloatLanes ratio = possible ? target / lights.pdf : FloatLanes{};
    const float sum = lane_sum(ratio);
    if (!(sum > 0)) return std::nullopt;
    const int chosen = choose(ratio, order_of(lights, u), which * sum);
    return Chosen{scene.lights->look_at(lights, chosen, pass.emission.data(), alone),
                  lane(wo, chosen), sum / (kLanes * target[chosen])};
}

}  // namespace

WithMean direct_light(const CompiledScene& scene, const Pass& pass, const SurfaceInteraction& at,
                      LocalSurface& surface, const VertexNumbers& u, const PathSampler& sampler,
                      int depth, DirectLight strategy) {
    const float many = surface.light_samples();
    const Weighing weighing{strategy == DirectLight::combined, surface.narrow_light_pdf, many};
    const bool alone = strategy == DirectLight::light_sampling;
    const std::optional<Chosen> chosen =
        surface.among_candidates
            ? best_of_eight(
                  scene, pass, at, surface,
                  sampler.draw_refined(kCandidateVertex + static_cast<std::uint32_t>(depth)),
                  u.which_candidate, alone, weighing)
            : one_candidate(scene, pass, at, surface, u, alone);
    if (!chosen) return {};
    const LightSample& light = chosen->light;
    const Vec3f wi = at.wi, wo = chosen->wo;
    const bool narrow = light.density > surface.narrow_light_pdf;
    const bool weighed = weighing.applies(light);
    if (surface.patch) surface.patch->narrow_light_pdf = narrow ? light.density : 0.0f;
    const bsdf::BsdfValue value =
        weighed ? surface.evaluate(wi, wo) : bsdf::BsdfValue{surface.eval(wi, wo)};
    const FloatLanes mean = surface.smooth_too ? surface.bsdf.eval(wi, wo) : value.f;
    const float weight = weighed ? power_heuristic(many * light.pdf, value.pdf) : 1.0f;
    WithMean reflected{weight * value.f, weight * mean};
    if (surface.flake_sample_weight > 0) {
        const float pdf = weighed ? light.pdf : std::numeric_limits<float>::infinity();
        reflected.shown +=
            surface.flake_sample_weight * surface.bsdf.flakes_at(*surface.patch, wi, wo, pdf);
    }
    if (surface.patch) surface.patch->narrow_light_pdf = 0;
    if (!(lane_max(reflected.shown) > 0 || lane_max(reflected.smooth) > 0)) return {};
    // Stop just short of the light, whose own rectangle is part of the scene.
    const FloatLanes arrives =
        scene.transmittance({wo.z < 0 ? at.hit.origin_behind() : at.hit.origin(), light.direction},
                            light.distance * 0.9999f, pass.surfaces);
    if (!(lane_max(arrives) > 0)) return {};
    const FloatLanes scale = (std::abs(wo.z) * chosen->scale) * arrives * light.radiance;
    return {scale * reflected.shown, scale * reflected.smooth};
}

}  // namespace nacre::render
