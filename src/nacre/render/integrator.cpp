#include "nacre/render/integrator.h"

#include <algorithm>
#include <cmath>

namespace nacre::render {
namespace {

/// Weight of the strategy with density `own` where another has density `other`.
float power_heuristic(float own, float other) {
    // By the ratio: the squares of densities of a small sun and a sharp lobe could overflow.
    const float ratio = other / own;
    return 1 / (1 + ratio * ratio);
}

/// How the numbers of one vertex are used: see PathSampler::draw.
struct VertexNumbers {
    Vec2f light, surface;
    float which_light, which_lobe, roulette;

    explicit VertexNumbers(const std::array<float, PathSampler::kNumbers>& u)
        : light{u[0], u[1]},
          surface{u[2], u[3]},
          which_light(u[4]),
          which_lobe(u[5]),
          roulette(u[6]) {}
};

/// Radiance or throughput: as it is, and with the mean over its area in place of every surface that
/// varies. The second is valid only where it was asked for.
struct WithMean {
    FloatLanes shown{}, smooth{};
};

/// A surface at a hit: where it varies, with the patch over which the sample averages.
struct LocalSurface {
    const bsdf::BoundBsdf& bsdf;
    std::optional<bsdf::Patch> patch;
    bool smooth_too = false;  ///< on a patch: the mean over the surface is wanted besides

    bsdf::BsdfValue evaluate(Vec3f wi, Vec3f wo) const {
        return patch ? bsdf.evaluate_on(*patch, wi, wo) : bsdf.evaluate(wi, wo);
    }
    FloatLanes eval(Vec3f wi, Vec3f wo) const {
        return patch ? bsdf.evaluate_on(*patch, wi, wo).f : bsdf.eval(wi, wo);
    }
    std::optional<bsdf::BsdfSample> sample(Vec3f wi, float u_select, Vec2f u) const {
        return patch ? bsdf.sample_on(*patch, wi, u_select, u) : bsdf.sample(wi, u_select, u);
    }
};

WithMean direct_light(const CompiledScene& scene, const Pass& pass, const Hit& hit,
                      const Frame& frame, Vec3f wi, const LocalSurface& surface,
                      const VertexNumbers& u, DirectLight strategy) {
    const auto light =
        scene.lights->sample(hit.position_mm, u.which_light, u.light, pass.emission.data());
    if (!light || dot(light->direction, hit.geometric_normal) <= 0) return {};
    const Vec3f wo = frame.to_local(light->direction);
    if (wo.z <= 0) return {};
    const bool weighted = !light->delta && strategy == DirectLight::combined;
    const bsdf::BsdfValue value =
        weighted ? surface.evaluate(wi, wo) : bsdf::BsdfValue{surface.eval(wi, wo)};
    const FloatLanes smooth = surface.smooth_too ? surface.bsdf.eval(wi, wo) : value.f;
    if (!(lane_max(value.f) > 0 || lane_max(smooth) > 0)) return {};
    const float weight = weighted ? power_heuristic(light->pdf, value.pdf) : 1.0f;
    // Stop just short of the light, whose own rectangle is part of the scene.
    if (scene.occluded({hit.origin(), light->direction}, light->distance * 0.9999f)) return {};
    const float scale = weight * wo.z / light->pdf;
    return {scale * value.f * light->radiance, scale * smooth * light->radiance};
}

bool all_finite(const RayDifferential::Edges& edges) {
    const Vec3f sum = edges.edge_mm[0] + edges.edge_mm[1];
    return std::isfinite(sum.x + sum.y + sum.z);
}

/// Whether a throughput survives: not if it is black, nor, under Russian roulette, with the
/// probability 1 - brightness; those that survive are divided by brightness. Each throughput of a
/// path is decided on its own with the same number, so that asking for the second does not change
/// the first.
bool survives(FloatLanes& throughput, bool roulette, float number) {
    const float brightness = lane_max(throughput);
    const bool lost = !(brightness > 0) || (roulette && number >= brightness);
    if (lost) {
        throughput = FloatLanes{};
    } else if (roulette && brightness < 1) {
        throughput *= 1 / brightness;
    }
    return !lost;
}

}  // namespace

Pass::Pass(const CompiledScene& scene, std::uint32_t index)
    : sample_index(index),
      wavelengths_nm(film_wavelengths(index)),
      xyz_weights(film_xyz_weights(wavelengths_nm)),
      emission(scene.emission.at(wavelengths_nm)) {
    static const spectra::Spectrum d65_spectrum = unit_illuminant(spectra::Illuminant::D65);
    d65 = make_lanes([&](int i) { return static_cast<float>(d65_spectrum(wavelengths_nm[i])); });
    surfaces.reserve(scene.materials.size());
    for (const auto& material : scene.materials) {
        surfaces.push_back(material->bind(wavelengths_nm));
        patch_memory_bytes = std::max(patch_memory_bytes, surfaces.back()->patch_memory_bytes());
        has_varying_surfaces |= material->varies_over_surface();
    }
}

PathLight trace_path(const CompiledScene& scene, const Pass& pass, const PathSampler& sampler,
                     const CameraRay& camera_ray, const PathOptions& options,
                     bsdf::PatchMemory& memory) {
    // The first surface, counted from 1, at which Russian roulette may end the path.
    constexpr int kRouletteFrom = 4;
    const FloatLanes* emission = pass.emission.data();
    PathLight path;
    Ray ray{camera_ray.origin_mm, camera_ray.direction};
    std::optional<RayDifferential> differential = camera_ray.differential;
    WithMean throughput{splat(1.0f), splat(1.0f)};
    const auto gather = [&](const FloatLanes& shown, const FloatLanes& smooth) {
        path.radiance += throughput.shown * shown;
        if (options.smooth) path.smooth += throughput.smooth * smooth;
    };
    // Density with which the last surface sampled the ray, if there is one. At the camera and after
    // a specular reflection no light sample could have found the ray, and after a random walk the
    // density is unknown: the light that the ray meets counts in full.
    float surface_pdf = 0;
    bool weighable = false;
    const auto weight = [&](float light_pdf) {
        if (!weighable) return 1.0f;
        switch (options.direct_light) {
            case DirectLight::surface_sampling:
                return 1.0f;
            case DirectLight::light_sampling:
                return 0.0f;
            default:
                return power_heuristic(surface_pdf, light_pdf);
        }
    };

    for (int depth = 0;; ++depth) {
        const auto hit = scene.intersect(ray, depth == 0);
        if (!hit) {
            const FloatLanes light = scene.lights->escaped(ray.direction, emission, weight);
            gather(light, light);
            break;
        }
        if (hit->rectangle >= 0) {
            if (hit->lit_side) {
                const float pdf =
                    scene.lights->rectangle_pdf(hit->rectangle, ray.direction, hit->distance_mm);
                const FloatLanes light =
                    weight(pdf) * scene.lights->rectangle_radiance(hit->rectangle, emission);
                gather(light, light);
            }
            break;
        }
        LocalSurface surface{*pass.surfaces[hit->material], {}};
        const Frame frame = Frame::around(hit->shading_normal);
        const Vec3f wi = frame.to_local(-ray.direction);
        if (depth == 0) {
            path.met_surface = true;
            path.normal = hit->shading_normal;
            if (options.albedo) path.albedo = surface.bsdf.albedo(wi);
        }
        if (depth >= options.max_depth) break;
        const auto footprint = [&] {
            return differential->at(ray.direction, hit->distance_mm, hit->geometric_normal);
        };
        if (differential && scene.materials[hit->material]->varies_over_surface()) {
            const RayDifferential::Edges edges = footprint();
            // Edge on the footprint is not bounded; the mean takes its place.
            if (all_finite(edges)) {
                surface.patch = scene.patch(*hit, options.footprint_pixels * edges.edge_mm[0],
                                            options.footprint_pixels * edges.edge_mm[1]);
                surface.patch->memory = &memory;
                surface.smooth_too = options.smooth;
                memory.forget();
            }
        }

        const VertexNumbers u(sampler.draw(static_cast<std::uint32_t>(depth) + 1));
        if (options.direct_light != DirectLight::surface_sampling && !scene.lights->empty()) {
            const WithMean light =
                direct_light(scene, pass, *hit, frame, wi, surface, u, options.direct_light);
            gather(light.shown, light.smooth);
        }
        const auto sample = surface.sample(wi, u.which_lobe, u.surface);
        if (!sample) break;
        const Vec3f direction = frame.to_world(sample->wo);
        // An interpolated normal can send light through the surface. Where light leaves a volume
        // elsewhere the surface has another normal.
        const Vec3f exit_mm = frame.to_world(sample->exit_mm);
        if (dot(exit_mm, exit_mm) == 0 && dot(direction, hit->geometric_normal) <= 0) break;
        const bool roulette = depth + 1 >= kRouletteFrom;
        throughput.shown *= sample->weight;
        bool goes_on = survives(throughput.shown, roulette, u.roulette);
        if (options.smooth) {
            throughput.smooth *=
                surface.smooth_too && sample->kind == bsdf::SampleKind::density
                    ? (sample->wo.z / sample->pdf) * surface.bsdf.eval(wi, sample->wo)
                    : sample->weight;
            goes_on |= survives(throughput.smooth, roulette, u.roulette);
        }
        if (!goes_on) break;
        surface_pdf = sample->pdf;
        weighable = sample->kind == bsdf::SampleKind::density;
        const bool specular = sample->kind == bsdf::SampleKind::specular;
        if (specular && differential && pass.has_varying_surfaces) {
            differential = differential->reflected(footprint(), hit->geometric_normal);
        } else {
            differential.reset();
        }
        ray = {scene.origin(*hit, exit_mm), direction};
    }
    return path;
}

}  // namespace nacre::render
