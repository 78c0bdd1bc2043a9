#include "nacre/montecarlo/shell_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/montecarlo/events.h"
#include "nacre/montecarlo/free_flight.h"
#include "nacre/optics/fresnel.h"

namespace nacre::montecarlo {
namespace {

constexpr double kUmPerMm = 1e3;

class BoundShellWalk final : public BoundWalk {
 public:
    BoundShellWalk(std::shared_ptr<const WalkTables> tables, const VolumeModel& settings,
                   const bsdf::Wavelengths& wavelengths_nm)
        : BoundWalk(*tables, wavelengths_nm),
          settings_(settings),
          curvature_per_um_(1 / (kUmPerMm * settings.radius_mm)) {
        estimate_typical_weight();
    }

 private:
    std::optional<Escape> follow(const Entry& entry, RandomStream& random) const override {
        return ShellWalker(medium(), index(entry.lane), curvature_per_um_, settings_, random)
            .run(entry.travel, entry.weight);
    }

    VolumeModel settings_;
    double curvature_per_um_;
};

void check(const paint::Recipe& recipe, const VolumeModel& settings) {
    if (!kShellRadius.contains(settings.radius_mm)) {
        throw DomainError(
            fmt::format("radius_mm = {} is outside {}", settings.radius_mm, kShellRadius.text()));
    }
    if (!kSimpsonPanels.contains(settings.simpson_panels)) {
        throw DomainError(fmt::format("simpson_panels = {} is outside {}", settings.simpson_panels,
                                      kSimpsonPanels.text()));
    }
    if (recipe.clearcoat && recipe.clearcoat->roughness > 0) {
        throw DomainError(
            fmt::format("clearcoat.roughness = {}: the walk through a shell knows smooth "
                        "interfaces only; the position-free walk knows rough ones",
                        recipe.clearcoat->roughness));
    }
    paint::require_no_lean(recipe, "the walk through a shell is");
    const double thickness_um = recipe.thickness_um();
    // The substrate's radius must be above 0: a millionth of the outer one keeps its digits.
    constexpr double kMaxFraction = 1 - 1e-6;
    if (!(thickness_um < kMaxFraction * kUmPerMm * settings.radius_mm)) {
        throw DomainError(fmt::format("a paint of {} um does not fit on a sphere of radius {} mm",
                                      thickness_um, settings.radius_mm));
    }
}

}  // namespace

ShellWalk::ShellWalk(const paint::Recipe& recipe, const VolumeModel& settings,
                     const std::vector<double>& wavelengths_nm, const Progress& progress)
    : settings_(settings) {
    check(recipe, settings);  // before the work
    tables_ = std::make_shared<const WalkTables>(recipe, wavelengths_nm, progress);
}

ShellWalk::~ShellWalk() = default;

std::unique_ptr<const bsdf::BoundBsdf> ShellWalk::bind(
    const bsdf::Wavelengths& wavelengths_nm) const {
    return std::make_unique<BoundShellWalk>(tables_, settings_, wavelengths_nm);
}

std::optional<Escape> ShellWalker::run(const Vec3d& travel, const Lanes& weight) {
    start(travel, weight);
    position_ = Vec3d{};
    slab_top_um_ = 0;
    escape_.reset();
    for (std::uint64_t flights = 0; state_.alive; ++flights) {
        count_flight(flights);
        fly();
    }
    return escape_;
}

// The vector from the centre, over the outer radius: without cancellation, and for any curvature.
Vec3d ShellWalker::normal() const {
    return normalize(Vec3d{0, 0, 1} + outer_curvature_ * position_);
}

/// To the next candidate or to the edge of the slab, whichever comes first.
void ShellWalker::fly() {
    const Slab& slab = this->slab();
    const double depth_below_surface = slab_top_um_ + state_.depth_um;
    const RadialRay ray{outer_curvature_ / (1 - outer_curvature_ * depth_below_surface),
                        dot(state_.travel, normal())};
    const double outwards = ray.distance_outwards(state_.depth_um);
    const double inwards = ray.distance_inwards(slab.thickness_um - state_.depth_um);
    const bool down = inwards < outwards;
    const double to_edge = std::min(outwards, inwards);
    // In a flat slab only: light would stay in it for ever.
    if (outer_curvature_ == 0 && std::abs(ray.cosine) <= kHorizontal) {
        state_.alive = false;
        return;
    }
    const auto candidate = settings_.tracking == Tracking::delta
                               ? fly_delta(slab, ray, to_edge, random_)
                               : fly_simpson(slab, ray, to_edge, settings_.simpson_panels, random_);
    const double length = candidate ? candidate->distance_um : to_edge;
    position_ += length * state_.travel;
    absorb(slab, length);
    if (!state_.alive) return;
    if (candidate) {
        state_.depth_um = std::clamp(state_.depth_um - ray.rise(length), 0.0, slab.thickness_um);
        collide(slab, candidate->choice);
    } else if (down) {
        descend();
    } else {
        ascend();
    }
}

void ShellWalker::collide(const Slab& slab, double choice) {
    const double cosine = dot(state_.travel, normal());
    for (const Flakes& species : slab.flakes) {
        choice -= species.area_density_per_um * candidate_area(cosine, species.alpha);
        if (choice < 0) return collide_with_candidate(species);
    }
    collide_with_pigment(slab);
}

void ShellWalker::collide_with_candidate(const Flakes& species) {
    const Vec3d up = normal();
    const double cosine_up = dot(state_.travel, up);
    const Vec3d across_up = state_.travel - cosine_up * up;
    const double sine = length(across_up);
    const CandidateSlopes slopes = sample_candidate(cosine_up, sine, species.alpha, random_);
    const double upright =
        1 / std::sqrt(1 + slopes.along * slopes.along + slopes.across * slopes.across);
    if (random_.uniform() >= upright) return;  // not a real flake
    // Straight down any pair of axes will do.
    constexpr double kVertical = 1e-9;
    const Vec3d along = sine > kVertical ? across_up / sine : perpendicular(up);
    const Vec3d flake = upright * (up - slopes.along * along - slopes.across * cross(up, along));
    const double projection = dot(state_.travel, flake);
    const double cosine = std::abs(projection);
    if (collide_with_flake(species.optics.reflectance(cosine), species.optics.transmittance(cosine),
                           projection, flake) == FlakeEvent::absorbed)
        return;
    roulette();
}

void ShellWalker::descend() {
    if (state_.slab + 1 < medium_.slabs.size()) {
        slab_top_um_ += slab().thickness_um;
        ++state_.slab;
        state_.depth_um = 0;
        return;
    }
    state_.depth_um = slab().thickness_um;
    if (!reflect_off_substrate()) return;
    const Vec3d up = normal(), local = sample_lambert(random_);
    const Vec3d across = perpendicular(up);
    state_.travel = normalize(local.x * across + local.y * cross(up, across) + local.z * up);
    roulette();
}

void ShellWalker::ascend() {
    if (state_.slab > 0) {
        --state_.slab;
        state_.depth_um = slab().thickness_um;
        slab_top_um_ -= state_.depth_um;
        return;
    }
    state_.depth_um = 0;
    const Vec3d up = normal();
    const double cosine = std::max(0.0, dot(state_.travel, up));
    if (random_.uniform() < optics::dielectric_reflectance(index_, 1.0, cosine)) {
        state_.travel = specular_direction(state_.travel, cosine, up);
        return;
    }
    const Vec3d tangential = index_ * (state_.travel - cosine * up);
    const double cosine_outside = std::sqrt(std::max(0.0, 1 - dot(tangential, tangential)));
    escape_ = Escape{normalize(tangential + cosine_outside * up), position_, state_.weight};
    state_.alive = false;
}

namespace {

constexpr std::string_view kTrackingNames[] = {"delta", "simpson"};
constexpr bsdf::ModelOption kVolumeOptions[] = {
    bsdf::OptionFor<&VolumeModel::tracking>::choice(
        "--tracking", "volume: delta (unbiased) or simpson (the paper's integration along the ray)",
        kTrackingNames),
    bsdf::OptionFor<&VolumeModel::simpson_panels>::number(
        "--simpson-panels", "volume with --tracking simpson: panels per piece of ray",
        static_cast<int>(kSimpsonPanels.lo), static_cast<int>(kSimpsonPanels.hi))};

}  // namespace

constinit const bsdf::ModelInfo VolumeModel::info = {
    .name = "volume",
    .summary = "random walks through the paint as a volume that follows the surface",
    .source = "volumetric reference of Mir et al. 2022",
    .ingredients = bsdf::Ingredients::layers,
    .solution = bsdf::Solution::none,
    .can = {.goniochromism = true, .multiple_scattering = true, .reference_only = true},
    .standard = bsdf::standard_model<VolumeModel>,
    .options = kVolumeOptions};

std::string VolumeModel::text() const {
    return fmt::format("radius_mm={} tracking={} simpson_panels={}", radius_mm,
                       kTrackingNames[static_cast<int>(tracking)], simpson_panels);
}

std::shared_ptr<const bsdf::Bsdf> VolumeModel::make(const bsdf::ModelInput& input,
                                                    const Progress& progress) const {
    return std::make_shared<const ShellWalk>(input.recipe, *this, spectra::default_wavelengths_nm(),
                                             progress);
}

void VolumeModel::lie_on(const std::string& material, std::span<const bsdf::PaintedShape> shapes) {
    using Kind = bsdf::PaintedShape::Kind;
    constexpr double kFlat = std::numeric_limits<double>::infinity();
    std::optional<double> common;
    for (const bsdf::PaintedShape& shape : shapes) {
        if (shape.kind == Kind::other) {
            throw DomainError(
                fmt::format("the material {} is on a shape that is neither a sphere nor a flat "
                            "panel; --model {} goes on any shape",
                            material, WalkModel::info.name));
        }
        const double radius = shape.kind == Kind::sphere ? shape.radius_mm : kFlat;
        if (common && *common != radius) {
            throw DomainError(
                fmt::format("the material {} is on shapes of different radii", material));
        }
        common = radius;
    }
    radius_mm = common.value_or(kFlat);
}

}  // namespace nacre::montecarlo
