#include "nacre/render/integrator.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>

#include "nacre/bsdf/local_coat.h"
#include "nacre/render/direct_light.h"

namespace nacre::render {
namespace {

using bsdf::power_heuristic;

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

/// Of the numbers part(k) that are not 0, that in whose part of their sum `at` lies; none if all are
/// 0. Leaves in `at` where in that part.
template <class Part>
std::optional<std::size_t> chosen(std::size_t count, const Part& part, float& at) {
    std::optional<std::size_t> last;
    for (std::size_t k = 0; k < count; ++k) {
        const float of_this = part(k);
        if (of_this == 0) continue;
        last = k;
        if (at < of_this) break;
        at -= of_this;
    }
    return last;
}

/// A sample of a flake, by its group of eight and its lane.
struct FlakeAt {
    std::size_t group;
    int lane;
    float in(const std::vector<FloatLanes>& numbers) const { return numbers[group][lane]; }
};

/// The same among lanes and, of one of them, among groups: a list eight times as short.
/// @param sums  of the parts, by lane
std::optional<FlakeAt> chosen(const std::vector<FloatLanes>& parts, const FloatLanes& sums,
                              float at) {
    const auto lane = chosen(
        kLanes, [&](std::size_t l) { return sums[l]; }, at);
    if (!lane) return std::nullopt;
    const auto group = chosen(
        parts.size(), [&](std::size_t n) { return parts[n][*lane]; }, at);
    if (!group) return std::nullopt;
    return FlakeAt{*group, static_cast<int>(*lane)};
}

}  // namespace

Pass::Pass(const CompiledScene& scene, std::uint32_t index, const bsdf::Wavelengths& nm)
    : sample_index(index),
      wavelengths_nm(nm),
      xyz_weights(film_xyz_weights(wavelengths_nm)),
      emission(scene.emission.at(wavelengths_nm)) {
    static const spectra::Spectrum d65_spectrum = unit_illuminant(spectra::Illuminant::D65);
    common_colour = scene.lights->common_colour(emission.data());
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
/// Fraction of the samples that choose a second flake, whatever light it sees.
constexpr float kBlind = 0.125f;
/// The sampler's vertex for the choice among flakes, beyond those of any path.
constexpr std::uint32_t kFlakeVertex = 1u << 16;
/// The sampler's vertex for the path of the second one.
constexpr std::uint32_t kBlindFlakeVertex = 3u << 16;
/// The sampler's first vertex of the path that begins with a specular reflection traced besides.
constexpr std::uint32_t kSpecularVertex = 1u << 18;

/// A ray of a path, and its throughput.
struct Branch {
    Ray ray;
    int depth = 0;  ///< surfaces met before it
    /// Where neighbouring rays run; none after other than specular reflections.
    std::optional<RayDifferential> differential = {};
    WithMean throughput{splat(1.0f), splat(1.0f)};
    /// Of what it meets next: factors of its throughput for a light, and for a surface.
    float of_lights = 1, of_surfaces = 1;
    /// Density with which the last surface sampled the ray, if there is one. At the camera and
    /// after a specular reflection no light sample could have found the ray, and after a random
    /// walk the density is unknown: the light that the ray meets counts in full.
    float surface_pdf = 0;
    bool weighable = false;
    /// Light of a larger density has been left to the light samples of the last surface.
    float narrow_light_pdf = std::numeric_limits<float>::infinity();
    float light_samples = 1;         ///< as how many that of the last surface is weighed
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
               const CameraRay& camera_ray, const FlakeStratum& stratum, const PathOptions& options,
               bsdf::PatchMemory& memory)
        : scene_(scene),
          pass_(pass),
          sampler_(sampler),
          camera_ray_(camera_ray),
          stratum_(stratum),
          options_(options),
          memory_(memory) {}

    PathLight trace() {
        Branch camera{.ray = {camera_ray_.origin_mm, camera_ray_.direction},
                      .differential = camera_ray_.differential};
        follow(camera);
        if (flake_) follow(*flake_);
        if (blind_flake_) follow(*blind_flake_);
        if (specular_) follow(*specular_);
        return path_;
    }

 private:
    void follow(Branch& branch);
    /// @param here  the surface with what its coat is like there; must outlive what is returned
    LocalSurface surface_at(const Hit& hit, Vec3f wi, const Branch& branch,
                            const bsdf::BoundBsdf& here);
    void sample_flakes(const Hit& hit, const Frame& frame, Vec3f wi, const LocalSurface& surface);
    /// Extends the path along the sample and updates its throughput; false if it ends there.
    bool extend_path(Branch& branch, const Hit& hit, const Frame& frame, Vec3f wi,
                     const LocalSurface& surface, const bsdf::BsdfSample& sample,
                     float roulette) const;

    /// The surface as it is from the side on which the ray arrives.
    const bsdf::BoundBsdf& bound(const Hit& hit) const {
        const bsdf::BoundBsdf& front = *pass_.surfaces[hit.material];
        return hit.lit_side ? front : front.from_behind();
    }
    RayDifferential::Edges footprint(const Hit& hit, const Branch& branch) const {
        return branch.differential->at(branch.ray.direction, hit.distance_mm, hit.geometric_normal);
    }
    /// Solid angle that a specularly reflected ray stands for: light samples cannot find what it meets.
    std::optional<float> solid_angle_of_sample(const Branch& branch) const {
        if (!branch.specular) return std::nullopt;
        if (branch.lobe > 0) return branch.lobe;
        if (!branch.differential) return std::nullopt;
        // At a silhouette it is as large as one likes, or not a number.
        const float by_pixel = branch.differential->solid_angle();
        return by_pixel < kMaxSpread ? by_pixel : kMaxSpread;
    }
    /// Of light that rays meet, of what light samples find with density `pdf`.
    /// @param surface_pdf, narrow_light_pdf, light_samples  as of a Branch
    template <class T>
    T weight(const T& surface_pdf, float narrow_light_pdf, float light_samples,
             const LightPdfs<T>& pdf) const {
        switch (options_.direct_light) {
            case DirectLight::surface_sampling:
                return T{} + 1.0f;
            case DirectLight::light_sampling:
                return T{};
            default:
                return pdf.density > narrow_light_pdf
                           ? T{}
                           : power_heuristic(surface_pdf, T(light_samples * pdf.value()));
        }
    }
    float weight(const Branch& branch, const LightPdf& pdf) const {
        if (!branch.weighable) return 1.0f;
        return weight(branch.surface_pdf, branch.narrow_light_pdf, branch.light_samples, pdf);
    }
    void gather(const Branch& branch, const WithMean& light) {
        path_.radiance += branch.of_lights * branch.throughput.shown * light.shown;
        if (options_.smooth) {
            path_.smooth += branch.of_lights * branch.throughput.smooth * light.smooth;
        }
    }
    void gather(const Branch& branch, const FloatLanes& light) { gather(branch, {light, light}); }

    const CompiledScene& scene_;
    const Pass& pass_;
    const PathSampler& sampler_;
    const CameraRay& camera_ray_;
    const FlakeStratum& stratum_;
    const PathOptions& options_;
    bsdf::PatchMemory& memory_;
    PathLight path_;
    std::optional<Branch> flake_;  ///< the ray of the one that was chosen by the light it sees
    std::optional<Branch> blind_flake_;  ///< of one chosen whatever it sees
    std::optional<Branch> specular_;     ///< the reflection at the first surface, traced besides
};

LocalSurface PathTracer::surface_at(const Hit& hit, Vec3f wi, const Branch& branch,
                                    const bsdf::BoundBsdf& here) {
    LocalSurface surface{here, {}};
    const bsdf::SurfaceCoordinates by = scene_.materials[hit.material]->surface_coordinates();
    if (by == bsdf::SurfaceCoordinates::place_in_unit_square) {
        surface.patch = scene_.patch(hit, {}, {}, {});
        return surface;
    }
    if (!branch.differential || by == bsdf::SurfaceCoordinates::none) return surface;
    const RayDifferential::Edges edges = footprint(hit, branch);
    // Edge on the footprint is not bounded; the mean takes its place.
    if (!all_finite(edges)) return surface;
    const bool sampled =
        options_.sample_flakes && branch.depth == 0 && surface.bsdf.samples_flakes();
    if (sampled) {
        const Vec3f across = edges.edge_mm[0], down = edges.edge_mm[1];
        // Beside the plane of focus the samples share out what the lens blurs as well: as much
        // surface as the pixel's filter, of even weight, and the disc of the lens hold together.
        constexpr float kFilterSide = 1.5f;
        const float pixel_mm = length(hit.distance_mm * branch.differential->direction[0]);
        const float blur = camera_ray_.blur_mm(hit.distance_mm) / (kFilterSide * pixel_mm);
        const float widened = std::sqrt(1 + blur * blur);
        const Vec2f shift_mm = camera_ray_.lens_shift_mm(hit.distance_mm);
        const float x = widened * stratum_.middle.x - stratum_.place.x - shift_mm.x / pixel_mm;
        const float y = widened * stratum_.middle.y - stratum_.place.y - shift_mm.y / pixel_mm;
        surface.patch = scene_.patch(hit, x * across + y * down, widened * stratum_.size.x * across,
                                     widened * stratum_.size.y * down);
        surface.patch->flakes = stratum_.samples_per_stratum > 0 ? bsdf::Patch::Flakes::sampled
                                                                 : bsdf::Patch::Flakes::left_out;
        surface.patch->footprint.tilt[0] = stratum_.tilt.x / widened;
        surface.patch->footprint.tilt[1] = stratum_.tilt.y / widened;
        surface.flake_sample_weight = stratum_.samples_per_stratum;
        if (options_.direct_light == DirectLight::combined) {
            surface.narrow_light_pdf = surface.bsdf.narrow_light_pdf(wi);
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

// For each flake of the patch the light is looked up that lights alone would send along the direction
// in which it mirrors the eye. One is chosen by what it reflects of it, and its ray is followed: the choice
// adds no noise but that of what stands in between [talbot-2005], and of the colour of lights.
//
// Other surfaces reflect light as well, towards flakes that see no light themselves. So some samples
// follow a second ray, of a flake chosen by strength alone. What surfaces send along either is weighed
// against both choices by the balance heuristic [veach-1997, eq. 9.8]. What lights send counts along
// the first alone: a ray chosen by a mixture of both densities would meet it in most samples and miss
// it in some, which is noise.
void PathTracer::sample_flakes(const Hit& hit, const Frame& frame, Vec3f wi,
                               const LocalSurface& surface) {
    std::vector<bsdf::FlakeSamples>& flakes = memory_.flake_samples;
    const std::array<float, PathSampler::kNumbers> u = sampler_.draw(kFlakeVertex);
    surface.bsdf.sample_flakes(*surface.patch, wi,
                               static_cast<std::uint32_t>(u[0] * 0x1p24f) * 256u, flakes);
    // Of each flake, if it reflects to where the surface does.
    std::vector<FloatLanes>&brightness = memory_.brightness, &strength = memory_.strength;
    brightness.resize(flakes.size());
    strength.resize(flakes.size());
    FloatLanes reflected_by_lane{}, strengths_by_lane{}, of_flakes{};
    FloatLanes expected{};  // what all of them send, of light that is 1 at all wavelengths
    for (std::size_t n = 0; n < flakes.size(); ++n) {
        const Vec3Lanes direction = frame.to_world(flakes[n].wo);
        const FloatLanes light = scene_.lights->brightness(
            hit.position_mm, direction, [&](const LightPdfs<FloatLanes>& of_light) {
                return weight(flakes[n].pdf, surface.narrow_light_pdf, 1.0f, of_light);
            });
        const IntLanes leaves = dot(direction, splat(hit.geometric_normal)) > 0.0f;
        const FloatLanes of_each = leaves ? flakes[n].strength : FloatLanes{};
        // Not 0 times a light that is infinite.
        const FloatLanes reflected_here = of_each > 0.0f ? of_each * light : FloatLanes{};
        strength[n] = of_each;
        brightness[n] = reflected_here;
        reflected_by_lane += reflected_here;
        strengths_by_lane += of_each;
        // Directions of the same flakes follow each other.
        of_flakes += reflected_here;
        const bool others_follow = n + 1 == flakes.size() ||
                                   flakes[n + 1].number[0] != flakes[n].number[0] ||
                                   flakes[n + 1].species != flakes[n].species;
        if (!others_follow) continue;
        for (int lane = 0; lane < kLanes; ++lane)
            expected += of_flakes[lane] * flakes[n].colour[lane];
        of_flakes = FloatLanes{};
    }
    const float reflected = lane_sum(reflected_by_lane), strengths = lane_sum(strengths_by_lane);
    if (!(strengths > 0)) return;
    // Densities, in flakes, of both choices.
    const float blind = reflected > 0 ? kBlind : 1.0f;
    const auto by_light = [&](FlakeAt k) {
        return reflected > 0 ? k.in(brightness) / reflected : 0;
    };
    const auto by_strength = [&](FlakeAt k) { return blind * k.in(strength) / strengths; };
    const auto follow_flake = [&](std::optional<Branch>& ray, FlakeAt k, float density,
                                  float of_lights, float of_surfaces, std::uint32_t vertex) {
        const bsdf::FlakeSample flake = flakes[k.group].flake(k.lane);
        const FloatLanes throughput = (surface.flake_sample_weight / density) *
                                      surface.bsdf.flake_weight(*surface.patch, wi, flake);
        if (!(lane_max(throughput) > 0)) return;
        ray = Branch{.ray = {hit.origin(), frame.to_world(flake.wo)},
                     .depth = 1,
                     .throughput = {throughput, {}},
                     .of_lights = of_lights,
                     .of_surfaces = of_surfaces,
                     .surface_pdf = flake.pdf,
                     .weighable = true,
                     .narrow_light_pdf = surface.narrow_light_pdf,
                     .first_vertex = vertex + 1,
                     .lobe = lobe_of(flake.pdf)};
    };
    if (const auto k = chosen(brightness, reflected_by_lane, u[2] * reflected)) {
        // Flakes whose films differ have other colours: the one that is chosen would lend its own to all.
        // What is added has the mean 0, whatever the colours [veach-1997, section 2.5], and is of the light
        // that all lights have in common: where one has none, it would be noise.
        path_.radiance += surface.flake_sample_weight * pass_.common_colour *
                          (expected - reflected * flakes[k->group].colour[k->lane]);
        const float both = by_light(*k) + by_strength(*k);
        follow_flake(flake_, *k, by_light(*k), 1, by_light(*k) / both, kFlakeVertex);
    }
    if (u[1] >= blind) return;
    if (const auto k = chosen(strength, strengths_by_lane, u[1] / blind * strengths)) {
        const float both = by_light(*k) + by_strength(*k);
        follow_flake(blind_flake_, *k, both, 0, 1, kBlindFlakeVertex);
    }
}

void PathTracer::follow(Branch& branch) {
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
        branch.throughput.shown *= branch.of_surfaces;
        branch.throughput.smooth *= branch.of_surfaces;
        branch.of_lights = branch.of_surfaces = 1;
        if (bound(*hit).transmits()) {
            const FloatLanes left = bound(*hit).transmittance(hit->distance_mm);
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
        const bsdf::LocalCoat coat(bound(*hit),
                                   {.deviation = scene_.coat_deviation(*hit),
                                    .lean = scene_.flake_lean(*hit),
                                    .slope = scene_.coat_slope(*hit)},
                                   wi);
        LocalSurface surface = surface_at(*hit, wi, branch, coat.surface());
        surface.among_candidates = branch.differential.has_value();
        if (branch.depth == 0 && !surface.shows_flakes()) {
            surface.specular = surface.bsdf.specular_probability(wi);
        }

        if (options_.direct_light != DirectLight::surface_sampling && !scene_.lights->empty()) {
            gather(branch, direct_light(scene_, pass_, {*hit, frame, wi}, surface, u, sampler_,
                                        branch.depth, options_.direct_light));
        }
        if (surface.flake_sample_weight > 0) sample_flakes(*hit, frame, wi, surface);
        if (surface.specular > 0) {
            const auto sample = surface.sample_specular(wi);
            Branch& specular_branch = specular_.emplace(branch);
            if (sample &&
                extend_path(specular_branch, *hit, frame, wi, surface, *sample, u.roulette)) {
                ++specular_branch.depth;
                specular_branch.first_vertex = kSpecularVertex;
                // Lights are seen in it by every sample, other surfaces by as many as if it had
                // been drawn at random: following those costs much, and it reflects little.
                specular_branch.followed = surface.specular;
            } else {
                specular_.reset();
            }
        }
        const auto sample = surface.sample(wi, u.which_lobe, u.surface);
        if (!sample || !extend_path(branch, *hit, frame, wi, surface, *sample, u.roulette)) return;
    }
}

bool PathTracer::extend_path(Branch& branch, const Hit& hit, const Frame& frame, Vec3f wi,
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
    const bool use_roulette = branch.depth + 1 >= kRouletteFrom;
    WithMean& throughput = branch.throughput;
    throughput.shown *= sample.weight;
    bool survived = survives(throughput.shown, use_roulette, roulette);
    if (options_.smooth) {
        throughput.smooth *= surface.smooth_too && sample.kind == bsdf::SampleKind::density
                                 ? (sample.wo.z / sample.pdf) * surface.bsdf.eval(wi, sample.wo)
                                 : sample.weight;
        survived |= survives(throughput.smooth, use_roulette, roulette);
    }
    if (!survived) return false;
    if (sample.kind == bsdf::SampleKind::null) {
        // The last surface still knows with which density the ray was sampled.
        branch.straight_mm = hit.distance_mm;
        branch.ray.origin_mm = hit.origin_behind();
        return true;
    }
    const bool is_specular_reflection = sample.kind == bsdf::SampleKind::specular && !behind;
    if (is_specular_reflection && branch.differential) {
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
    branch.light_samples = surface.light_samples();
    branch.narrow_light_pdf = surface.narrow_light_pdf;
    branch.ray = {behind ? hit.origin_behind() : scene_.origin(hit, exit_mm), direction};
    return true;
}

}  // namespace

PathLight trace_path(const CompiledScene& scene, const Pass& pass, const PathSampler& sampler,
                     const CameraRay& camera_ray, const FlakeStratum& stratum,
                     const PathOptions& options, bsdf::PatchMemory& memory) {
    return PathTracer(scene, pass, sampler, camera_ray, stratum, options, memory).trace();
}

}  // namespace nacre::render
