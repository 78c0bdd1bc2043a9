#include "nacre/render/integrator.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "nacre/bsdf/tilted_coat.h"

namespace nacre::render {
namespace {

using bsdf::power_heuristic;

/// What is added to a surface's density, per cosine, where it guesses what the surface reflects: so
/// that nothing is left out that the density does not know of.
constexpr float kLeastGuess = 0.01f;

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
    bool smooth_too = false;  ///< on a patch: the mean over the surface is wanted besides
    float asked_weight = 0;   ///< AskedPart::weight, where flakes are asked
    /// Beyond it light is left to light samples (BoundBsdf::narrow_light).
    float narrow_light = std::numeric_limits<float>::infinity();

    int light_samples = 1;  ///< candidates among which direct light is looked for
    /// Probability of the specular reflection where it is traced besides: what is drawn here, and
    /// the densities, are then of the rest alone.
    float specular = 0;

    bool shows_flakes() const {
        return patch && patch->flakes == bsdf::Patch::Flakes::shown && bsdf.tells_flakes_apart();
    }
    float pdf(Vec3f wi, Vec3f wo) const { return bsdf.pdf(wi, wo) / (1 - specular); }
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

/// A direction towards a light, of several among which one is chosen to be followed.
struct LightCandidate {
    LightSample light;
    Vec3f wo;
    float target = 0;  ///< roughly what the surface reflects of it, as it is weighed
};

WithMean direct_light(const CompiledScene& scene, const Pass& pass, const Hit& hit,
                      const Frame& frame, Vec3f wi, LocalSurface& surface, const VertexNumbers& u,
                      const PathSampler& sampler, std::uint32_t vertex, DirectLight strategy) {
    const int candidates = surface.light_samples;
    const bool combined = strategy == DirectLight::combined;
    const auto weighed = [&](const LightSample& light) {
        return combined && !light.delta && !(light.density > surface.narrow_light);
    };
    // Of a few candidates, drawn as evenly as if there were that many samples, one is chosen in
    // proportion to a guess of what it gives, over the density that it was drawn with. The mean of
    // those ratios takes the place of the one candidate's.                   [talbot-2005]
    LightCandidate chosen;
    float ratios = 0, rest = u.which_candidate;
    const auto many = static_cast<float>(candidates);
    for (int k = 0; k < candidates; ++k) {
        VertexNumbers at = u;
        if (candidates > 1) at = VertexNumbers(sampler.refined(candidates, k).draw(vertex));
        const auto light =
            scene.lights->sample(hit.position_mm, at.which_light, at.light, pass.emission.data(),
                                 strategy == DirectLight::light_sampling);
        if (!light) continue;
        const Vec3f wo = frame.to_local(light->direction);
        const bool behind = wo.z < 0;
        // An interpolated normal can take the light for one on the other side.
        if (wo.z == 0 || (dot(light->direction, hit.geometric_normal) <= 0) != behind) continue;
        if (behind && !surface.bsdf.transmits()) continue;
        float target = 1;
        if (candidates > 1) {
            const float pdf = surface.pdf(wi, wo);
            target = lane_sum(light->radiance) * (pdf + kLeastGuess * std::abs(wo.z));
            if (weighed(*light)) target *= power_heuristic(many * light->pdf, pdf);
        }
        const float ratio = target / light->pdf;
        if (!(ratio > 0)) continue;
        // One number chooses among all: what is left of it is as good as new.
        ratios += ratio;
        const float taken = ratio / ratios;
        if (rest < taken) {
            chosen = {*light, wo, target};
            rest /= taken;
        } else {
            rest = (rest - taken) / (1 - taken);
        }
    }
    if (!(ratios > 0)) return {};
    const LightSample& light = chosen.light;
    const Vec3f wo = chosen.wo;
    const bool behind = wo.z < 0;
    const bool narrow = light.density > surface.narrow_light;
    const bool weighted = weighed(light);
    if (surface.patch) surface.patch->narrow_light = narrow ? light.density : 0.0f;
    const bsdf::BsdfValue value =
        weighted ? surface.evaluate(wi, wo) : bsdf::BsdfValue{surface.eval(wi, wo)};
    const FloatLanes mean = surface.smooth_too ? surface.bsdf.eval(wi, wo) : value.f;
    const float weight = weighted ? power_heuristic(many * light.pdf, value.pdf) : 1.0f;
    WithMean reflected{weight * value.f, weight * mean};
    if (surface.asked_weight > 0) {
        const float pdf = weighted ? light.pdf : std::numeric_limits<float>::infinity();
        reflected.shown +=
            surface.asked_weight * surface.bsdf.flakes_at(*surface.patch, wi, wo, pdf);
    }
    if (surface.patch) surface.patch->narrow_light = 0;
    if (!(lane_max(reflected.shown) > 0 || lane_max(reflected.smooth) > 0)) return {};
    // Stop just short of the light, whose own rectangle is part of the scene.
    const FloatLanes arrives =
        scene.transmittance({behind ? hit.origin_behind() : hit.origin(), light.direction},
                            light.distance * 0.9999f, pass.surfaces);
    if (!(lane_max(arrives) > 0)) return {};
    const FloatLanes scale =
        (std::abs(wo.z) * ratios / (many * chosen.target)) * arrives * light.radiance;
    return {scale * reflected.shown, scale * reflected.smooth};
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
    }
}

namespace {

/// The first surface, counted from 1, at which Russian roulette may end the path.
constexpr int kRouletteFrom = 4;
/// The most over which a sun is spread in mirrors: a disk of 16 degrees in radius.
constexpr float kMaxSpread = 0.2434f;
/// Of a sample of a lobe, by its density.
float lobe_of(float pdf) { return std::min(1 / pdf, kMaxSpread); }
/// Fraction of the samples that choose a flake whatever light it sees.
constexpr float kBlind = 0.1f;
/// The sampler's vertex for the choice among flakes, beyond those of any path.
constexpr std::uint32_t kFlakeVertex = 1u << 16;
/// The same for the candidates of light samples.
constexpr std::uint32_t kCandidateVertex = 1u << 17;
/// The sampler's first vertex of the path that begins with a specular reflection traced besides.
constexpr std::uint32_t kSpecularVertex = 1u << 18;
/// How many there are where the camera looks; elsewhere one, as most of what is seen is seen there.
constexpr int kCandidates = 4;

/// A ray of a path, and what its light is worth.
struct Branch {
    Ray ray;
    int depth = 0;  ///< surfaces met before it
    /// Where neighbouring rays run; none after other than specular reflections.
    std::optional<RayDifferential> differential = {};
    WithMean throughput{splat(1.0f), splat(1.0f)};
    /// Density with which the last surface sampled the ray, if there is one. At the camera and
    /// after a specular reflection no light sample could have found the ray, and after a random
    /// walk the density is unknown: the light that the ray meets counts in full.
    float surface_pdf = 0;
    bool weighable = false;
    /// Light of a larger density has been left to the light samples of the last surface.
    float narrow_light = std::numeric_limits<float>::infinity();
    int light_samples = 1;           ///< as which those of the last surface are weighed
    std::uint32_t first_vertex = 1;  ///< of the sampler: vertex of depth 0
    /// Solid angle that samples of lobes, the widest since the camera, stood for.
    float lobe = 0;
    bool specular = false;  ///< the last reflection or refraction
    float straight_mm = 0;  ///< gone through panes since the last surface
    /// Probability with which it goes on at the next surface that it meets, if not at a light.
    float followed = 1;
};

class PathTracer {
 public:
    PathTracer(const CompiledScene& scene, const Pass& pass, const PathSampler& sampler,
               const CameraRay& camera_ray, const AskedPart& asked, const PathOptions& options,
               bsdf::PatchMemory& memory)
        : scene_(scene),
          pass_(pass),
          sampler_(sampler),
          camera_ray_(camera_ray),
          asked_(asked),
          options_(options),
          memory_(memory) {}

    PathLight trace() {
        follow({.ray = {camera_ray_.origin_mm, camera_ray_.direction},
                .differential = camera_ray_.differential});
        if (flake_) follow(*flake_);
        if (specular_) follow(*specular_);
        return path_;
    }

 private:
    void follow(Branch branch);
    /// @param tilted  the surface where its coat is not flat; must outlive what is returned
    LocalSurface surface_at(const Hit& hit, Vec3f wi, const Branch& branch,
                            const std::optional<bsdf::TiltedCoat>& tilted);
    void ask_flakes(const Hit& hit, const Frame& frame, Vec3f wi, const LocalSurface& surface);
    /// Whether the branch goes on along the sample, with what it is worth there.
    bool go_on(Branch& branch, const Hit& hit, const Frame& frame, Vec3f wi,
               const LocalSurface& surface, const bsdf::BsdfSample& sample, float roulette) const;

    /// The surface as it is from the side on which the ray arrives.
    const bsdf::BoundBsdf& bound(const Hit& hit) const {
        const bsdf::BoundBsdf& front = *pass_.surfaces[hit.material];
        return hit.lit_side ? front : front.from_behind();
    }
    RayDifferential::Edges footprint(const Hit& hit, const Branch& branch) const {
        return branch.differential->at(branch.ray.direction, hit.distance_mm, hit.geometric_normal);
    }
    /// That a ray out of a mirror stands for, where light samples could not have found it.
    std::optional<float> solid_angle_of_sample(const Branch& branch) const {
        if (!branch.specular) return std::nullopt;
        if (branch.lobe > 0) return branch.lobe;
        if (!branch.differential) return std::nullopt;
        // At a silhouette it is as large as one likes, or not a number.
        const float by_pixel = branch.differential->solid_angle();
        return by_pixel < kMaxSpread ? by_pixel : kMaxSpread;
    }
    /// Of light that the ray meets, of what light samples find with density `pdf`.
    float weight(const Branch& branch, const LightPdf& pdf) const {
        if (!branch.weighable) return 1.0f;
        switch (options_.direct_light) {
            case DirectLight::surface_sampling:
                return 1.0f;
            case DirectLight::light_sampling:
                return 0.0f;
            default:
                return pdf.density > branch.narrow_light
                           ? 0.0f
                           : power_heuristic(
                                 branch.surface_pdf,
                                 static_cast<float>(branch.light_samples) * pdf.value());
        }
    }
    void gather(const Branch& branch, const WithMean& light) {
        path_.radiance += branch.throughput.shown * light.shown;
        if (options_.smooth) path_.smooth += branch.throughput.smooth * light.smooth;
    }
    void gather(const Branch& branch, const FloatLanes& light) { gather(branch, {light, light}); }

    const CompiledScene& scene_;
    const Pass& pass_;
    const PathSampler& sampler_;
    const CameraRay& camera_ray_;
    const AskedPart& asked_;
    const PathOptions& options_;
    bsdf::PatchMemory& memory_;
    PathLight path_;
    std::optional<Branch> flake_;     ///< the ray of the one that was chosen among those asked
    std::optional<Branch> specular_;  ///< the reflection at the first surface, traced besides
};

LocalSurface PathTracer::surface_at(const Hit& hit, Vec3f wi, const Branch& branch,
                                    const std::optional<bsdf::TiltedCoat>& tilted) {
    const bsdf::BoundBsdf& flat = bound(hit);
    LocalSurface surface{tilted ? *tilted : flat, {}};
    const bsdf::SurfaceCoordinates by = scene_.materials[hit.material]->surface_coordinates();
    if (by == bsdf::SurfaceCoordinates::place_in_unit_square) {
        surface.patch = scene_.patch(hit, {}, {}, {});
        return surface;
    }
    if (!branch.differential || by == bsdf::SurfaceCoordinates::none) return surface;
    const RayDifferential::Edges edges = footprint(hit, branch);
    // Edge on the footprint is not bounded; the mean takes its place.
    if (!all_finite(edges)) return surface;
    const bool apart =
        options_.ask_flakes && branch.depth == 0 && surface.bsdf.tells_flakes_apart();
    if (apart) {
        const Vec3f across = edges.edge_mm[0], down = edges.edge_mm[1];
        // Beside the plane of focus the samples share out what the lens blurs as well: as much
        // surface as the pixel's filter, of even weight, and the disc of the lens hold together.
        constexpr float kFilterSide = 1.5f;
        const float pixel_mm = length(hit.distance_mm * branch.differential->direction[0]);
        const float blur = camera_ray_.blur_mm(hit.distance_mm) / (kFilterSide * pixel_mm);
        const float widened = std::sqrt(1 + blur * blur);
        const Vec2f shift_mm = camera_ray_.lens_shift_mm(hit.distance_mm);
        const float x = widened * asked_.middle.x - asked_.place.x - shift_mm.x / pixel_mm;
        const float y = widened * asked_.middle.y - asked_.place.y - shift_mm.y / pixel_mm;
        surface.patch = scene_.patch(hit, x * across + y * down, widened * asked_.size.x * across,
                                     widened * asked_.size.y * down);
        surface.patch->flakes =
            asked_.weight > 0 ? bsdf::Patch::Flakes::apart : bsdf::Patch::Flakes::left_out;
        surface.patch->footprint.tilt[0] = asked_.tilt.x / widened;
        surface.patch->footprint.tilt[1] = asked_.tilt.y / widened;
        surface.asked_weight = asked_.weight;
        if (options_.direct_light == DirectLight::combined) {
            surface.narrow_light = surface.bsdf.narrow_light(wi);
        }
    } else {
        surface.patch = scene_.patch(hit, {}, options_.footprint_pixels * edges.edge_mm[0],
                                     options_.footprint_pixels * edges.edge_mm[1]);
    }
    surface.patch->memory = &memory_;
    surface.smooth_too = options_.smooth;
    memory_.forget();
    return surface;
}

// Each flake of the patch is asked for the light that lights alone would send along the direction
// in which it mirrors the eye. One is chosen by the answers, and its ray is followed: the choice
// adds no noise but that of what stands in between.         [talbot-2005]
void PathTracer::ask_flakes(const Hit& hit, const Frame& frame, Vec3f wi,
                            const LocalSurface& surface) {
    std::vector<bsdf::AskedFlake>& flakes = memory_.asked;
    const std::array<float, PathSampler::kNumbers> u = sampler_.draw(kFlakeVertex);
    surface.bsdf.ask_flakes(*surface.patch, wi, static_cast<std::uint32_t>(u[0] * 0x1p24f) * 256u,
                            flakes);
    const std::size_t count = flakes.size();
    if (count == 0) return;
    std::vector<float>& brightness = memory_.brightness;
    brightness.resize(count);
    float answers = 0, strengths = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const bsdf::AskedFlake& flake = flakes[k];
        const Vec3f direction = frame.to_world(flake.wo);
        brightness[k] = 0;
        if (dot(direction, hit.geometric_normal) > 0) {
            const Branch along{.ray = {},
                               .surface_pdf = flake.pdf,
                               .weighable = true,
                               .narrow_light = surface.narrow_light};
            brightness[k] =
                flake.strength *
                scene_.lights->brightness(hit.position_mm, direction,
                                          [&](const LightPdf& pdf) { return weight(along, pdf); });
        }
        answers += brightness[k];
        strengths += flake.strength;
    }
    // Some of the samples choose by strength alone: other surfaces reflect light as well.
    const float blind = answers > 0 ? kBlind : 1.0f;
    const bool by_strength = u[1] < blind;
    float rest = by_strength ? u[1] / blind * strengths : (u[1] - blind) / (1 - blind) * answers;
    std::optional<std::size_t> chosen;
    for (std::size_t k = 0; k < count; ++k) {
        const float part = by_strength ? flakes[k].strength : brightness[k];
        if (part == 0) continue;
        chosen = k;
        if (rest < part) break;
        rest -= part;
    }
    if (!chosen) return;
    const bsdf::AskedFlake& flake = flakes[*chosen];
    const float probability = blind * flake.strength / strengths +
                              (answers > 0 ? (1 - blind) * brightness[*chosen] / answers : 0.0f);
    if (!(probability > 0)) return;
    const Vec3f direction = frame.to_world(flake.wo);
    if (dot(direction, hit.geometric_normal) <= 0) return;
    const FloatLanes throughput =
        (surface.asked_weight / probability) * surface.bsdf.flake_weight(*surface.patch, wi, flake);
    if (!(lane_max(throughput) > 0)) return;
    flake_ = Branch{.ray = {hit.origin(), direction},
                    .depth = 1,
                    .throughput = {throughput, {}},
                    .surface_pdf = flake.pdf,
                    .weighable = true,
                    .narrow_light = surface.narrow_light,
                    .first_vertex = kFlakeVertex + 1,
                    .lobe = lobe_of(flake.pdf)};
}

void PathTracer::follow(Branch branch) {
    const FloatLanes* emission = pass_.emission.data();
    const auto light_weight = [&](const LightPdf& pdf) { return weight(branch, pdf); };
    for (;; ++branch.depth) {
        auto hit = scene_.intersect(branch.ray, branch.depth == 0);
        if (!hit) {
            const Vec3f direction = branch.ray.direction;
            const std::optional<float> spread = solid_angle_of_sample(branch);
            gather(branch, spread ? scene_.lights->escaped_spread(direction, *spread, emission)
                                  : scene_.lights->escaped(direction, emission, light_weight));
            return;
        }
        hit->distance_mm += branch.straight_mm;
        if (hit->rectangle >= 0) {
            if (!hit->lit_side) return;
            const LightPdf pdf = scene_.lights->rectangle_pdf(hit->rectangle, branch.ray.direction,
                                                              hit->distance_mm);
            gather(branch, weight(branch, pdf) *
                               scene_.lights->rectangle_radiance(hit->rectangle, emission));
            return;
        }
        const Frame frame = Frame::around(hit->shading_normal);
        const Vec3f wi = frame.to_local(-branch.ray.direction);
        if (bound(*hit).transmits()) {
            const FloatLanes left = bound(*hit).passed(hit->distance_mm);
            branch.throughput.shown *= left;
            branch.throughput.smooth *= left;
        }
        if (branch.depth == 0) {
            path_.met_surface = true;
            path_.normal = hit->shading_normal;
            if (options_.albedo) path_.albedo = bound(*hit).albedo(wi);
        }
        if (branch.depth >= options_.max_depth) return;
        const VertexNumbers u(
            sampler_.draw(branch.first_vertex + static_cast<std::uint32_t>(branch.depth)));
        if (branch.followed < 1) {
            if (u.roulette >= branch.followed) return;
            branch.throughput.shown *= 1 / branch.followed;
            branch.throughput.smooth *= 1 / branch.followed;
            branch.followed = 1;
        }
        std::optional<bsdf::TiltedCoat> tilted;
        if (const auto slope = scene_.coat_slope(*hit)) {
            tilted.emplace(*pass_.surfaces[hit->material], *slope, wi);
        }
        LocalSurface surface = surface_at(*hit, wi, branch, tilted);
        surface.light_samples = branch.differential ? kCandidates : 1;
        if (branch.depth == 0 && !surface.shows_flakes()) {
            surface.specular = surface.bsdf.specular_probability(wi);
        }

        if (options_.direct_light != DirectLight::surface_sampling && !scene_.lights->empty()) {
            gather(branch, direct_light(scene_, pass_, *hit, frame, wi, surface, u, sampler_,
                                        kCandidateVertex + static_cast<std::uint32_t>(branch.depth),
                                        options_.direct_light));
        }
        if (surface.asked_weight > 0) ask_flakes(*hit, frame, wi, surface);
        if (surface.specular > 0) {
            Branch mirrored = branch;
            const auto sample = surface.sample_specular(wi);
            if (sample && go_on(mirrored, *hit, frame, wi, surface, *sample, u.roulette)) {
                ++mirrored.depth;
                mirrored.first_vertex = kSpecularVertex;
                // Lights are seen in it by every sample, other surfaces by as many as if it had
                // been drawn by lot: following those costs much, and it reflects little.
                mirrored.followed = surface.specular;
                specular_ = mirrored;
            }
        }
        const auto sample = surface.sample(wi, u.which_lobe, u.surface);
        if (!sample || !go_on(branch, *hit, frame, wi, surface, *sample, u.roulette)) return;
    }
}

bool PathTracer::go_on(Branch& branch, const Hit& hit, const Frame& frame, Vec3f wi,
                       const LocalSurface& surface, const bsdf::BsdfSample& sample,
                       float roulette) const {
    const Vec3f direction = frame.to_world(sample.wo);
    // An interpolated normal can send light through the surface. Where light leaves a volume
    // elsewhere the surface has another normal.
    const Vec3f exit_mm = frame.to_world(sample.exit_mm);
    const bool behind = sample.wo.z < 0;
    if (dot(exit_mm, exit_mm) == 0 && (dot(direction, hit.geometric_normal) <= 0) != behind) {
        return false;
    }
    const bool by_lot = branch.depth + 1 >= kRouletteFrom;
    WithMean& throughput = branch.throughput;
    throughput.shown *= sample.weight;
    bool goes_on = survives(throughput.shown, by_lot, roulette);
    if (options_.smooth) {
        throughput.smooth *= surface.smooth_too && sample.kind == bsdf::SampleKind::density
                                 ? (sample.wo.z / sample.pdf) * surface.bsdf.eval(wi, sample.wo)
                                 : sample.weight;
        goes_on |= survives(throughput.smooth, by_lot, roulette);
    }
    if (!goes_on) return false;
    if (sample.kind == bsdf::SampleKind::straight) {
        // The last surface still knows with which density the ray was sampled.
        branch.straight_mm = hit.distance_mm;
        branch.ray.origin_mm = hit.origin_behind();
        return true;
    }
    const bool mirrored = sample.kind == bsdf::SampleKind::specular && !behind;
    if (mirrored && branch.differential) {
        const RayDifferential::Edges edges = footprint(hit, branch);
        branch.differential =
            branch.differential->reflected(branch.ray.direction, edges, hit.shading_normal,
                                           {scene_.normal_change(hit, edges.edge_mm[0]),
                                            scene_.normal_change(hit, edges.edge_mm[1])});
    } else {
        branch.differential.reset();
    }
    branch.straight_mm = 0;
    branch.specular = sample.kind == bsdf::SampleKind::specular;
    if (sample.kind == bsdf::SampleKind::density) {
        branch.lobe = std::max(branch.lobe, lobe_of(sample.pdf));
    } else if (!branch.specular) {
        branch.lobe = kMaxSpread;
    }
    branch.surface_pdf = sample.pdf;
    branch.weighable = sample.kind == bsdf::SampleKind::density;
    branch.light_samples = surface.light_samples;
    branch.narrow_light = surface.narrow_light;
    branch.ray = {behind ? hit.origin_behind() : scene_.origin(hit, exit_mm), direction};
    return true;
}

}  // namespace

PathLight trace_path(const CompiledScene& scene, const Pass& pass, const PathSampler& sampler,
                     const CameraRay& camera_ray, const AskedPart& asked,
                     const PathOptions& options, bsdf::PatchMemory& memory) {
    return PathTracer(scene, pass, sampler, camera_ray, asked, options, memory).trace();
}

}  // namespace nacre::render
