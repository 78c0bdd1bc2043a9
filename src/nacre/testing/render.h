#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/warp.h"
#include "nacre/core/estimate.h"
#include "nacre/render/builtin_scenes.h"
#include "nacre/render/mesh.h"
#include "nacre/render/render.h"
#include "nacre/render/scene.h"
#include "nacre/spectra/rgb.h"

// Only for tests: a coated paint in a few lines, with a specular lobe, a sharp lobe whose colour
// changes with angle, and a diffuse lobe: all that a renderer must cope with.

namespace nacre::render::testing {

inline double area_mm2(const Mesh& mesh) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        sum += 0.5 * length(cross(mesh.positions_mm[b] - mesh.positions_mm[a],
                                  mesh.positions_mm[c] - mesh.positions_mm[a]));
    }
    return sum;
}

class BoundGlossy final : public bsdf::BoundBsdf {
 public:
    BoundGlossy(const bsdf::Wavelengths& wavelengths_nm, float exponent, float specular,
                bool tells_specular = true)
        : nm_(make_lanes([&](int i) { return static_cast<float>(wavelengths_nm[i]); })),
          exponent_(exponent),
          specular_(specular),
          tells_specular_(tells_specular) {}

    float specular_probability(Vec3f) const override {
        return tells_specular_ ? probability_of_specular() : 0.0f;
    }
    FloatLanes eval(Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return FloatLanes{};
        const Vec3f h = normalize(wi + wo);
        const float cos_h = dot(wi, h);
        const float lobe = density(h) / (4 * cos_h * std::max(wi.z, wo.z));
        return (1 - specular_) * (lobe * colour(cos_h) + splat(0.1f * kInvPi));
    }
    std::optional<bsdf::BsdfSample> sample(Vec3f wi, float u_select, Vec2f u) const override {
        if (wi.z <= 0) return std::nullopt;
        const float p_specular = probability_of_specular();
        if (u_select < p_specular) {
            return bsdf::BsdfSample{{-wi.x, -wi.y, wi.z},
                                    splat(specular_ / p_specular),
                                    p_specular,
                                    bsdf::SampleKind::specular};
        }
        Vec3f wo;
        if ((u_select - p_specular) / (1 - p_specular) < kLobeFraction) {
            const float z = std::pow(u.x, 1 / (exponent_ + 2));
            const float r = std::sqrt(std::max(0.0f, 1 - z * z));
            const float angle = 2 * std::numbers::pi_v<float> * u.y;
            const Vec3f h{r * std::cos(angle), r * std::sin(angle), z};
            wo = 2 * dot(wi, h) * h - wi;
        } else {
            wo = bsdf::cosine_hemisphere(u);
        }
        if (wo.z <= 0) return std::nullopt;
        const float density = pdf(wi, wo);
        if (!(density > 0)) return std::nullopt;
        return bsdf::BsdfSample{wo, (wo.z / density) * eval(wi, wo), density};
    }
    float pdf(Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return 0;
        const Vec3f h = normalize(wi + wo);
        return (1 - probability_of_specular()) *
               (kLobeFraction * density(h) * h.z / (4 * dot(wi, h)) +
                (1 - kLobeFraction) * kInvPi * wo.z);
    }
    FloatLanes albedo(Vec3f wi) const override { return 0.8f * colour(wi.z); }

 private:
    static constexpr float kInvPi = std::numbers::inv_pi_v<float>;
    static constexpr float kLobeFraction = 0.7f;

    float probability_of_specular() const { return specular_ > 0 ? 0.1f : 0; }
    /// Normalised such that Int D cos(theta_h) d omega = 1.
    float density(Vec3f h) const {
        return (exponent_ + 2) * 0.5f * kInvPi * std::pow(std::max(h.z, 0.0f), exponent_);
    }
    /// A fringe that moves to shorter wavelengths with angle, as a film's does.
    FloatLanes colour(float cosine) const {
        return make_lanes([&](int i) {
            return 0.4f + 0.35f * std::cos(std::numbers::pi_v<float> * 1300 *
                                           (0.5f + 0.5f * cosine) / nm_[i]);
        });
    }

    FloatLanes nm_;
    float exponent_, specular_;
    bool tells_specular_;
};

class Glossy final : public bsdf::Bsdf {
 public:
    /// @param tells_specular  whether the renderer may trace the specular reflection besides
    explicit Glossy(float exponent = 60, float specular = 0.05f, bool tells_specular = true)
        : exponent_(exponent), specular_(specular), tells_specular_(tells_specular) {}
    std::unique_ptr<const bsdf::BoundBsdf> bind(const bsdf::Wavelengths& nm) const override {
        return std::make_unique<BoundGlossy>(nm, exponent_, specular_, tells_specular_);
    }

 private:
    float exponent_, specular_;
    bool tells_specular_;
};

/// Mean luminance of the whole picture, over `seeds` renders.
inline Estimate estimate_luminance(const Scene& scene, RenderOptions options,
                                   DirectLight direct_light, int seeds) {
    double sum = 0, squares = 0;
    for (int seed = 0; seed < seeds; ++seed) {
        options.seed = static_cast<std::uint64_t>(seed);
        const RenderResult r = render_with(scene, options, direct_light);
        double y = 0;
        for (std::size_t i = 0; i < r.rgb.size(); i += 3) {
            y += spectra::rec709_luminance<double>(r.rgb[i], r.rgb[i + 1], r.rgb[i + 2]);
        }
        y /= static_cast<double>(r.rgb.size() / 3);
        sum += y;
        squares += y * y;
    }
    return estimate_of_mean(sum, squares, seeds);
}

// Only for tests: a paint that varies with position, with a known mean.

/// Glossy, times a factor that depends on the position and on the half vector. It is sampled as its
/// mean is, so that both meet the same light. Keeps the position in the memory of the patch, and
/// counts where it finds another there.
class Speckled final : public bsdf::Bsdf {
 public:
    /// Of the position and the half vector, both in object space.
    using Factor = std::function<float(Vec3f position_mm, Vec3f half)>;

    explicit Speckled(Factor factor) : factor_(std::move(factor)) {}

    bsdf::SurfaceCoordinates surface_coordinates() const override {
        return bsdf::SurfaceCoordinates::object_space;
    }
    std::unique_ptr<const bsdf::BoundBsdf> bind(const bsdf::Wavelengths& nm) const override {
        return std::make_unique<Bound>(*this, mean_.bind(nm));
    }
    /// Number of calls that found another position in a patch's memory that was marked as filled.
    static inline thread_local long stale = 0;

 private:
    class Bound final : public bsdf::BoundBsdf {
     public:
        Bound(const Speckled& owner, std::unique_ptr<const bsdf::BoundBsdf> mean)
            : owner_(owner), mean_(std::move(mean)) {}

        FloatLanes eval(Vec3f wi, Vec3f wo) const override { return mean_->eval(wi, wo); }
        float pdf(Vec3f wi, Vec3f wo) const override { return mean_->pdf(wi, wo); }
        FloatLanes albedo(Vec3f wi) const override { return mean_->albedo(wi); }
        float specular_probability(Vec3f wi) const override {
            return mean_->specular_probability(wi);
        }
        std::optional<bsdf::BsdfSample> sample(Vec3f wi, float u_select, Vec2f u) const override {
            return mean_->sample(wi, u_select, u);
        }
        bsdf::BsdfValue evaluate_on(const bsdf::Patch& patch, Vec3f wi, Vec3f wo) const override {
            bsdf::BsdfValue value = mean_->evaluate(wi, wo);
            value.f *= factor(patch, wi, wo);
            return value;
        }
        std::optional<bsdf::BsdfSample> sample_on(const bsdf::Patch& patch, Vec3f wi,
                                                  float u_select, Vec2f u) const override {
            auto drawn = mean_->sample(wi, u_select, u);
            if (drawn && drawn->kind == bsdf::SampleKind::density)
                drawn->weight *= factor(patch, wi, drawn->wo);
            return drawn;
        }
        std::size_t patch_memory_bytes() const override { return sizeof(Vec3f); }

     private:
        float factor(const bsdf::Patch& patch, Vec3f wi, Vec3f wo) const {
            const sparkle::ObjectSpaceFootprint& footprint = patch.footprint;
            auto& kept = *reinterpret_cast<Vec3f*>(patch.memory->data());
            if (!patch.memory->filled) kept = footprint.position_mm;
            patch.memory->filled = true;
            stale += kept != footprint.position_mm;
            const Vec3f h = normalize(wi + wo);
            return owner_.factor_(footprint.position_mm,
                                  h.x * footprint.tangent +
                                      h.y * cross(footprint.normal, footprint.tangent) +
                                      h.z * footprint.normal);
        }

        const Speckled& owner_;
        std::unique_ptr<const bsdf::BoundBsdf> mean_;
    };

    Factor factor_;
    Glossy mean_;
};

inline SceneDescription diffuse_sphere(double reflectance) {
    SceneDescription scene;
    scene.materials["wall"] = DiffuseMaterial{reflectance};
    scene.shapes.push_back({Sphere{.radius_mm = 50}, "wall", {}});
    scene.camera = {.position_mm = {0, -300, 0}, .vertical_fov_deg = 30};
    return scene;
}

/// A built-in scene with the surface of Glossy.
inline Scene glossy_scene(const char* name = "sphere") {
    return Scene(builtin_scene(name), {{"paint", std::make_shared<Glossy>()}});
}

}  // namespace nacre::render::testing
