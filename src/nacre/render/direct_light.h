#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "nacre/bsdf/bsdf.h"
#include "nacre/render/compiled_scene.h"
#include "nacre/render/integrator.h"
#include "nacre/render/sampler.h"

// Light that reaches a surface straight from the lights of the scene: one sample of them, chosen
// among several where the camera looks.

namespace nacre::render {

/// How the numbers of one vertex are used: see PathSampler::draw.
struct VertexNumbers {
    Vec2f light, surface;
    float which_light, which_lobe, roulette, which_candidate;

    explicit VertexNumbers(const std::array<float, PathSampler::kNumbers>& u)
        : light{u[0], u[1]},
          surface{u[2], u[3]},
          which_light(u[4]),
          which_lobe(u[5]),
          roulette(u[6]),
          which_candidate(u[7]) {}
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
    bool smooth_too = false;        ///< on a patch: the mean over the surface is wanted besides
    float flake_sample_weight = 0;  ///< FlakeStratum::samples_per_stratum, where flakes are sampled
    /// Beyond it light is left to light samples (BoundBsdf::narrow_light_pdf).
    float narrow_light_pdf = std::numeric_limits<float>::infinity();

    /// Whether the light sample is chosen among several: where the camera looks, as most of what is
    /// seen is seen there.
    bool among_candidates = false;
    /// Probability of the specular reflection where it is traced besides: what is drawn here, and
    /// the densities, are then of the rest alone.
    float specular = 0;

    /// Sample count used for the light sample in the power heuristic. 5, not 8, for eight
    /// candidates, as the guess behind the choice ignores colour and shadowing.
    float light_samples() const { return among_candidates ? 5.0f : 1.0f; }
    bool shows_flakes() const {
        return patch && patch->flakes == bsdf::Patch::Flakes::shown && bsdf.samples_flakes();
    }
    FloatLanes pdf_lanes(Vec3f wi, const Vec3Lanes& wo) const {
        return bsdf.pdf_lanes(wi, wo) * (1 / (1 - specular));
    }
    bsdf::BsdfValue evaluate(Vec3f wi, Vec3f wo) const {
        bsdf::BsdfValue value = patch ? bsdf.evaluate_on(*patch, wi, wo) : bsdf.evaluate(wi, wo);
        value.pdf /= 1 - specular;
        return value;
    }
    FloatLanes eval(Vec3f wi, Vec3f wo) const {
        return patch ? bsdf.evaluate_on(*patch, wi, wo).f : bsdf.eval(wi, wo);
    }
    std::optional<bsdf::BsdfSample> sample(Vec3f wi, float u_select, Vec2f u) const {
        if (specular > 0) {
            u_select = std::min(specular + (1 - specular) * u_select, 0x1.fffffep-1f);
        }
        auto s = patch ? bsdf.sample_on(*patch, wi, u_select, u) : bsdf.sample(wi, u_select, u);
        if (s && specular > 0) {
            s->weight *= 1 - specular;
            s->pdf /= 1 - specular;
        }
        return s;
    }
    /// The reflection that is traced besides.
    std::optional<bsdf::BsdfSample> sample_specular(Vec3f wi) const {
        auto s = bsdf.sample(wi, 0, {});
        if (s) s->weight *= specular;
        return s;
    }
};

/// Where a path meets a surface.
struct SurfaceInteraction {
    const Hit& hit;
    const Frame& frame;
    Vec3f wi;
};

/// What the surface reflects of the light that one sample of the lights finds, weighed against
/// samples of the surface as `strategy` says.
///
/// Of eight candidates, drawn as evenly as if there were that many samples, one is chosen in
/// proportion to a guess of what it gives, over the density with which it was drawn. The mean of
/// those ratios takes the place of the one candidate's.                   [talbot-2005]
/// @param depth  surfaces met before
WithMean direct_light(const CompiledScene& scene, const Pass& pass, const SurfaceInteraction& at,
                      LocalSurface& surface, const VertexNumbers& u, const PathSampler& sampler,
                      int depth, DirectLight strategy);

}  // namespace nacre::render
